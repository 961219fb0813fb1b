#pragma once
// A lamp of a building: what shines, from where and how bright.

#include <array>
#include <cstdint>
#include <string>

#include "plans/plan.h"

namespace enfilade::modeler {

/// From the plan or by rule. Metres, in the frame of the building's plan (not of its grid).
struct Lamp {
    std::string id;  ///< its own: no other lamp has it
    std::string name;
    std::uint32_t storey = UINT32_MAX;           ///< into Building::storeys; UINT32_MAX: of the site
    std::array<double, 3> position = {0, 0, 0};  ///< z as storeys' elevations
    double radius = 0;                           ///< of the sphere that shines; 0: a point
    plans::Colour colour = {1, 1, 1};            ///< linear RGB; only the ratios count
    double lumen = 0;                            ///< luminous flux over the whole sphere
    std::string carrier;                         ///< id of the object that carries it, if there is such a one
    bool by_rule = false;
    friend bool operator==(const Lamp&, const Lamp&) = default;
};

/// Luminance of linear RGB (Rec. 709 primaries).
[[nodiscard]] constexpr double luminance(const plans::Colour& colour) {
    return 0.2126 * double(colour[0]) + 0.7152 * double(colour[1]) + 0.0722 * double(colour[2]);
}

/// Luminous intensity by linear RGB, candela: lumen / (4 pi) in all directions, as the colour whose luminance that is.
/// So 800 lumen are 800 lumen whatever their colour, and what a lamp meter shows is the luminance of a picture's lux.
/// Zero where the lamp has no power, a black colour, or one of both is no number.
[[nodiscard]] std::array<float, 3> candela(const Lamp& lamp);

}  // namespace enfilade::modeler
