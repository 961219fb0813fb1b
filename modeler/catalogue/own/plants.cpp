// Plants: pots, stems, leaves. They look the same from all sides.

#include <algorithm>

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/shapes.h"
#include "plans/random.h"

namespace enfilade::modeler::own {
namespace {

/// A pot on z = 0 with earth in it.
void pot(Shaper& s, double foot, double rim, double height, const Paint& paint) {
    const double wall = 0.07 * rim + 0.003;
    const Vec profile[] = {{0, 0, 0},
                           {foot, 0, 0},
                           {mix(foot, rim, 0.06), 0, 0.01 * height},
                           {mix(foot, rim, 0.55), 0, 0.45 * height},
                           {mix(foot, rim, 0.95), 0, 0.82 * height},
                           {rim, 0, 0.84 * height},
                           {rim, 0, 0.98 * height},
                           {rim - 0.3 * wall, 0, height},
                           {rim - 0.8 * wall, 0, height},
                           {rim - wall, 0, 0.98 * height},
                           {rim - 1.2 * wall, 0, 0.88 * height},
                           {0, 0, 0.86 * height}};
    lathe(s, profile, paint, 28);
    const auto earth = s.inside(move(0, 0, 0.86 * height));
    ball(s, {}, {rim - 1.3 * wall, rim - 1.3 * wall, 0.035 * height + 0.004}, soil, 20);
}

struct LeafShape {
    double length = 0.2;
    double half_width = 0.05;
    double droop = 0.4;   ///< how far its tip sinks, in lengths
    double widest = 0.4;  ///< where along the rib
    double fold = 0.25;
    int steps = 5;
};

/// A leaf from `base` in the direction `out`.
void grow_leaf(Shaper& s, Vec base, Vec out, const LeafShape& shape, const Paint& paint) {
    const int steps = s.fine(shape.steps);
    std::vector<Vec> rib;
    std::vector<double> widths;
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        rib.push_back(base + (t * shape.length) * out - Vec{0, 0, shape.droop * shape.length * t * t});
        const double at = t < shape.widest ? t / shape.widest : (1 - t) / (1 - shape.widest);
        widths.push_back(k == 0 || k == steps
                             ? 0.0
                             : shape.half_width * std::pow(std::sin(at * pi / 2), t < shape.widest ? 0.7 : 1.1));
    }
    const Vec up = std::abs(out.z) > 0.95 ? Vec{0.3, 0.2, 1} : Vec{0, 0, 1};
    leaf(s, rib, widths, up, shape.fold, 0.0025 + 0.01 * shape.half_width, paint);
    if (s.detail() < 3 || shape.half_width < 0.02) return;
    std::vector<Vec> line;  // the midrib
    for (int k = 0; k < steps; ++k) line.push_back(rib[k] - Vec{0, 0, 0.001});
    tube(s, line, 0.0012 + 0.012 * shape.half_width, pale_leaf, 3);
}

Vec direction(double turn, double rise) {
    return {std::cos(degrees(turn)) * std::cos(degrees(rise)), std::sin(degrees(turn)) * std::cos(degrees(rise)),
            std::sin(degrees(rise))};
}

/// Large leaves on bent stalks from the middle of the pot.
void broad_plant(Shaper& s) {
    pot(s, 0.13, 0.18, 0.32, white);
    plans::Random random({0x11u});
    for (int k = 0; k < 19; ++k) {
        const double share = k / 18.0, turn = 137.5 * k + random.uniform(-12, 12);
        const double reach = mix(0.34, 0.1, share) * random.uniform(0.85, 1.1),
                     rise = mix(0.42, 0.95, share) * random.uniform(0.92, 1.06);
        const Vec out = direction(turn, 0);
        const Vec foot = 0.04 * out + Vec{0, 0, 0.27}, tip = reach * out + Vec{0, 0, rise};
        const Vec stalk[] = {foot, mix(foot, tip, 0.5) + Vec{0, 0, 0.12 * (1 - share)} - 0.03 * out, tip};
        tube(s, curve(stalk, s.fine(3)), 0.005, stem, 6);
        const LeafShape shape{mix(0.27, 0.22, share), mix(0.095, 0.065, share), 0.45, 0.36, 0.22, 7};
        grow_leaf(s, tip, unit(out + Vec{0, 0, mix(0.05, 0.8, share)}), shape,
                  k % 5 == 4 ? pale_leaf : (k % 2 == 0 ? leaf_green : dark_leaf));
    }
}

/// A small tree with a crown of many leaves.
void fig_tree(Shaper& s) {
    pot(s, 0.15, 0.19, 0.34, wicker);
    plans::Random random({0x12u});
    const Vec trunk[] = {{0, 0, 0.28}, {0.015, 0.01, 0.6}, {-0.012, -0.01, 0.95}, {0.01, 0.0, 1.25}};
    const double thick[] = {0.022, 0.021, 0.02, 0.019, 0.018, 0.017, 0.016, 0.015, 0.014, 0.013};
    tube(s, curve(trunk, s.fine(3)), thick, bark, 10);
    const Vec second[] = {{0.02, -0.01, 0.28}, {0.03, -0.02, 0.55}, {-0.02, 0.02, 0.85}, {-0.06, 0.03, 1.15}};
    tube(s, curve(second, s.fine(3)), 0.011, bark, 8);
    for (int branch = 0; branch < 20; ++branch) {
        const double share = branch / 19.0, turn = 137.5 * branch;
        const Vec from{random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015), mix(0.85, 1.22, share)};
        const Vec out = direction(turn, mix(18, 70, share));
        const double reach = mix(0.3, 0.34, share) * random.uniform(0.8, 1.1);
        const Vec tip = from + reach * out;
        const Vec way[] = {from, mix(from, tip, 0.5) - Vec{0, 0, 0.02}, tip};
        const double thin[] = {0.007, 0.006, 0.005, 0.004};
        tube(s, curve(way, s.fine(2)), thin, bark, 5);
        for (int k = 0; k < 10; ++k) {
            const double along = mix(0.25, 1.0, k / 9.0);
            const Vec aside = direction(turn + (k % 2 == 0 ? 62 : -62) * (1.05 - along) + random.uniform(-25, 25),
                                        random.uniform(-15, 40));
            const double size = random.uniform(0.75, 1.1);
            grow_leaf(s, mix(from, tip, along) - (k < 9 ? Vec{0, 0, 0.012} : Vec{}), aside,
                      {0.125 * size, 0.031 * size, 0.5, 0.42, 0.3, 3},
                      random.chance(0.25) ? pale_leaf : (random.chance(0.5) ? leaf_green : dark_leaf));
        }
    }
}

/// Upright blades.
void snake_plant(Shaper& s) {
    pot(s, 0.1, 0.13, 0.22, charcoal);
    plans::Random random({0x13u});
    for (int k = 0; k < 16; ++k) {
        const double turn = 137.5 * k, r = 0.075 * std::sqrt(k / 16.0),
                     height = mix(0.62, 0.34, k / 15.0) * random.uniform(0.9, 1.1);
        const Vec out = direction(turn, 0);
        const int steps = s.fine(6);
        std::vector<Vec> rib;
        std::vector<double> widths;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            rib.push_back(r * out + (0.1 * t * t + 0.02 * t) * out + Vec{0, 0, 0.17 + t * height});
            widths.push_back(i == steps ? 0 : 0.026 * std::min(1.0, 0.55 + 1.2 * t) * std::pow(1 - t * t * t, 0.8));
        }
        leaf(s, rib, widths, direction(turn + 90 + random.uniform(-40, 40), 20), 0.35, 0.005, dark_leaf);
        for (double& w : widths) w = std::max(0.0, w + (w > 0 ? 0.0035 : 0));  // its pale rim
        leaf(s, rib, widths, direction(turn + 90 + random.uniform(-3, 3), 20), 0.35, 0.002, pale_leaf);
    }
}

/// Fronds of narrow leaflets.
void palm(Shaper& s) {
    pot(s, 0.14, 0.185, 0.33, terracotta);
    plans::Random random({0x14u});
    for (int k = 0; k < 11; ++k) {
        const double share = k / 10.0, turn = 137.5 * k, reach = mix(0.52, 0.16, share), rise = mix(1.05, 1.6, share);
        const Vec out = direction(turn, 0), foot = 0.03 * out + Vec{0, 0, 0.28};
        const Vec way[] = {foot, 0.35 * reach * out + Vec{0, 0, 0.25 + 0.72 * rise * 0.8},
                           reach * out + Vec{0, 0, rise}, 1.3 * reach * out + Vec{0, 0, rise - 0.12 * (1 - share)}};
        const std::vector<Vec> spine = curve(way, s.fine(3));
        std::vector<double> thin;
        for (std::size_t i = 0; i < spine.size(); ++i)
            thin.push_back(mix(0.009, 0.002, static_cast<double>(i) / static_cast<double>(spine.size() - 1)));
        tube(s, spine, thin, stem, 5);
        const int pairs = 11;
        for (int i = 0; i < pairs; ++i) {
            const double t =
                mix(0.42, 0.99, static_cast<double>(i) / (pairs - 1)) * static_cast<double>(spine.size() - 1);
            const auto at = std::min(static_cast<std::size_t>(t), spine.size() - 2);
            const Vec base = mix(spine[at], spine[at + 1], t - static_cast<double>(at));
            const Vec along = unit(spine[at + 1] - spine[at]), aside = unit(cross(along, Vec{0.01, 0.013, 1}));
            for (const double side : {-1.0, 1.0}) {
                const double size = 0.26 * (1 - 0.55 * std::abs(i / (pairs - 1.0) - 0.35)) * random.uniform(0.9, 1.1);
                grow_leaf(s, base, unit(0.75 * along + side * 1.0 * aside + Vec{0, 0, 0.15}),
                          {size, 0.0135, 0.32, 0.35, 0.5, 3}, i % 3 == 0 ? pale_leaf : leaf_green);
            }
        }
    }
}

/// A rosette of thick leaves.
void succulent(Shaper& s) {
    pot(s, 0.045, 0.062, 0.085, terracotta);
    for (int k = 0; k < 30; ++k) {
        const double share = k / 29.0, rise = mix(8, 82, share), length = mix(0.07, 0.03, share);
        const Vec out = direction(137.5 * k, rise);
        const int steps = s.fine(4);
        std::vector<Vec> rib;
        std::vector<double> widths;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            rib.push_back(Vec{0, 0, 0.083 + 0.02 * share} + (t * length) * out + Vec{0, 0, 0.02 * t * t});
            widths.push_back(i == 0 ? 0.004
                             : i == steps
                                 ? 0
                                 : 0.016 * std::pow(std::sin(pi * std::pow(t, 0.8) * 0.98), 0.7) * mix(1, 0.6, share));
        }
        leaf(s, rib, widths, {0.01, 0.02, 1}, 0.35, 0.008, k % 6 == 0 ? pale_leaf : sage);
    }
}

/// Vines that hang over the rim of their pot.
void ivy(Shaper& s) {
    pot(s, 0.055, 0.075, 0.12, white);
    plans::Random random({0x16u});
    for (int vine = 0; vine < 11; ++vine) {
        const double turn = 137.5 * vine, spread = random.uniform(0.8, 1.15);
        const Vec out = direction(turn, 0);
        const Vec way[] = {0.02 * out + Vec{0, 0, 0.1}, 0.06 * out + Vec{0, 0, 0.16 + 0.06 * random.uniform()},
                           0.105 * spread * out + Vec{0, 0, 0.14},
                           0.12 * spread * out + Vec{0, 0, random.uniform(0.05, 0.1)}};
        const std::vector<Vec> path = curve(way, s.fine(3));
        tube(s, path, 0.0013, stem, 4);
        for (int k = 0; k < 9; ++k) {
            const Vec base =
                path[static_cast<std::size_t>((0.15 + 0.85 * k / 8.0) * static_cast<double>(path.size() - 1))];
            grow_leaf(
                s, base, direction(turn + (k % 2 == 0 ? 55 : -55) + random.uniform(-20, 20), random.uniform(5, 45)),
                {random.uniform(0.035, 0.05), 0.016, 0.4, 0.35, 0.3, 3}, random.chance(0.4) ? pale_leaf : leaf_green);
        }
    }
}

}  // namespace

void add_plants(Pieces& pieces) {
    pieces.push_back(piece<"own/plant", Size{1.12, 1.06, 0.98}>("Broad-leaved plant", "plant", "Plants",
                                                                [](Shaper& s, const Size&) { broad_plant(s); }));
    pieces.push_back(piece<"own/plant-fig", Size{0.67, 0.76, 1.58}>("Fig tree", "plant", "Plants",
                                                                    [](Shaper& s, const Size&) { fig_tree(s); }));
    pieces.push_back(piece<"own/plant-palm", Size{1.36, 1.235, 1.69}>("Palm", "plant", "Plants",
                                                                      [](Shaper& s, const Size&) { palm(s); }));
    pieces.push_back(piece<"own/plant-snake", Size{0.35, 0.36, 0.78}>("Snake plant", "plant", "Plants",
                                                                      [](Shaper& s, const Size&) { snake_plant(s); }));
    pieces.push_back(piece<"own/small-plant", Size{0.28, 0.3, 0.235}>("Ivy", "small_plant", "Plants",
                                                                      [](Shaper& s, const Size&) { ivy(s); }));
    pieces.push_back(piece<"own/small-plant-succulent", Size{0.131, 0.127, 0.154}>(
        "Succulent", "small_plant", "Plants", [](Shaper& s, const Size&) { succulent(s); }));
}

}  // namespace enfilade::modeler::own
