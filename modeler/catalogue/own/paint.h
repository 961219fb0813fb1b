#pragma once
// What our pieces are made of: a restrained palette, diffuse reflectance in linear RGB.

#include <array>

namespace enfilade::modeler::own {

struct Paint {
    const char* name;
    std::array<float, 3> colour;
    float mirror = 0;   ///< share of the light that goes on as from a mirror
    float through = 0;  ///< and straight through
};

// Woods.
inline constexpr Paint oak{"oak", {0.50f, 0.345f, 0.20f}};
inline constexpr Paint light_oak{"light oak", {0.62f, 0.47f, 0.30f}};
inline constexpr Paint walnut{"walnut", {0.20f, 0.115f, 0.065f}};
inline constexpr Paint beech{"beech", {0.60f, 0.41f, 0.25f}};
inline constexpr Paint birch{"birch", {0.70f, 0.58f, 0.41f}};
inline constexpr Paint dark_wood{"dark wood", {0.075f, 0.045f, 0.03f}};
// Lacquers, plastics, ceramics, stone.
inline constexpr Paint white{"white lacquer", {0.78f, 0.775f, 0.755f}};
inline constexpr Paint off_white{"off-white", {0.68f, 0.66f, 0.61f}};
inline constexpr Paint grey{"grey lacquer", {0.36f, 0.365f, 0.37f}};
inline constexpr Paint light_grey{"light grey", {0.56f, 0.56f, 0.56f}};
inline constexpr Paint charcoal{"charcoal", {0.065f, 0.067f, 0.072f}};
inline constexpr Paint black{"black", {0.022f, 0.022f, 0.024f}};
inline constexpr Paint porcelain{"porcelain", {0.82f, 0.82f, 0.80f}};
inline constexpr Paint stone{"stone", {0.25f, 0.245f, 0.24f}};
inline constexpr Paint marble{"marble", {0.70f, 0.69f, 0.66f}};
inline constexpr Paint deep_blue{"deep blue", {0.075f, 0.135f, 0.22f}};
inline constexpr Paint sage_lacquer{"sage lacquer", {0.34f, 0.41f, 0.32f}};
// Metals and glass, as far as a diffuse colour goes.
inline constexpr Paint steel{"brushed steel", {0.50f, 0.505f, 0.51f}};
inline constexpr Paint chrome{"chrome", {0.64f, 0.65f, 0.66f}};
inline constexpr Paint brass{"brass", {0.56f, 0.40f, 0.16f}};
inline constexpr Paint copper{"copper", {0.52f, 0.25f, 0.15f}};
inline constexpr Paint iron{"black iron", {0.04f, 0.04f, 0.042f}};
inline constexpr Paint glass{"frosted glass", {0.60f, 0.68f, 0.69f}, 0, 0.55f};
inline constexpr Paint mirror_glass{"mirror glass", {0.66f, 0.72f, 0.75f}, 0.9f};
inline constexpr Paint screen{"screen", {0.015f, 0.02f, 0.028f}};
inline constexpr Paint glow{"lamp glass", {0.90f, 0.86f, 0.75f}};
inline constexpr Paint shade_cloth{"lamp shade", {0.80f, 0.73f, 0.60f}};
// Cloth and leather.
inline constexpr Paint linen{"linen", {0.60f, 0.55f, 0.46f}};
inline constexpr Paint cotton{"white cotton", {0.80f, 0.79f, 0.76f}};
inline constexpr Paint wool{"grey wool", {0.27f, 0.275f, 0.285f}};
inline constexpr Paint dark_wool{"dark wool", {0.10f, 0.105f, 0.115f}};
inline constexpr Paint petrol{"petrol cloth", {0.055f, 0.185f, 0.205f}};
inline constexpr Paint sage{"sage cloth", {0.27f, 0.345f, 0.25f}};
inline constexpr Paint terracotta_cloth{"terracotta cloth", {0.47f, 0.18f, 0.10f}};
inline constexpr Paint mustard{"mustard cloth", {0.58f, 0.355f, 0.075f}};
inline constexpr Paint rose{"rose cloth", {0.55f, 0.31f, 0.28f}};
inline constexpr Paint navy{"navy cloth", {0.055f, 0.085f, 0.165f}};
inline constexpr Paint leather{"tan leather", {0.36f, 0.165f, 0.075f}};
inline constexpr Paint rubber{"rubber", {0.03f, 0.03f, 0.03f}};
// What grows, and what it grows in.
inline constexpr Paint leaf_green{"leaf", {0.095f, 0.23f, 0.06f}};
inline constexpr Paint dark_leaf{"dark leaf", {0.045f, 0.145f, 0.05f}};
inline constexpr Paint pale_leaf{"pale leaf", {0.22f, 0.34f, 0.12f}};
inline constexpr Paint stem{"stem", {0.20f, 0.22f, 0.09f}};
inline constexpr Paint bark{"bark", {0.17f, 0.115f, 0.07f}};
inline constexpr Paint soil{"soil", {0.055f, 0.038f, 0.026f}};
inline constexpr Paint terracotta{"terracotta", {0.48f, 0.20f, 0.115f}};
inline constexpr Paint wicker{"wicker", {0.50f, 0.36f, 0.20f}};
// Paper, and books.
inline constexpr Paint paper{"paper", {0.78f, 0.745f, 0.66f}};
inline constexpr Paint cardboard{"cardboard", {0.47f, 0.325f, 0.19f}};
inline constexpr Paint book_covers[] = {{"book red", {0.37f, 0.075f, 0.06f}},    {"book blue", {0.075f, 0.14f, 0.27f}},
                                        {"book green", {0.085f, 0.19f, 0.115f}}, {"book ochre", {0.55f, 0.36f, 0.12f}},
                                        {"book grey", {0.25f, 0.26f, 0.28f}},    {"book cream", {0.66f, 0.60f, 0.47f}},
                                        {"book black", {0.035f, 0.035f, 0.04f}}, {"book teal", {0.06f, 0.24f, 0.25f}},
                                        {"book plum", {0.19f, 0.07f, 0.13f}}};

}  // namespace enfilade::modeler::own
