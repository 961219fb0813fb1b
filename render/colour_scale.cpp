#include "render/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enfilade::render {
namespace {

constexpr double darkest = 0.24, lightest = 0.93;  // OKLab lightness
constexpr double first_hue = 300, last_hue = 105;  // degrees, downwards: violet, blue, teal, green, yellow
constexpr double most_chroma = 0.15;
constexpr Vec3f no_number = {0.18f, 0.18f, 0.18f};

/// OKLab to linear sRGB.
Vec3d linear_of(double lightness, double chroma, double hue) {
    const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
    const double l = lightness + 0.3963377774 * a + 0.2158037573 * b;
    const double m = lightness - 0.1055613458 * a - 0.0638541728 * b;
    const double s = lightness - 0.0894841775 * a - 1.2914855480 * b;
    const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
    return {4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3,
            -1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3,
            -0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3};
}

bool is_shown(Vec3d c) { return std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1; }

}  // namespace

Vec3f scale_colour(double t) {
    if (std::isnan(t)) return no_number;
    t = std::clamp(t, 0.0, 1.0);
    const double lightness = darkest + t * (lightest - darkest);
    const double hue = (first_hue + t * (last_hue - first_hue)) * std::numbers::pi / 180;
    double low = 0, high = most_chroma;
    if (is_shown(linear_of(lightness, high, hue))) low = high;
    for (int k = 0; k < 24 && low < high; ++k) {
        const double middle = (low + high) / 2;
        (is_shown(linear_of(lightness, middle, hue)) ? low : high) = middle;
    }
    return vec_cast<float>(linear_of(lightness, low, hue));
}

double oklab_lightness(Vec3f c) {
    const double l = std::cbrt(0.4122214708 * double{c.x} + 0.5363325363 * double{c.y} + 0.0514459929 * double{c.z});
    const double m = std::cbrt(0.2119034982 * double{c.x} + 0.6806995451 * double{c.y} + 0.1073969566 * double{c.z});
    const double s = std::cbrt(0.0883024619 * double{c.x} + 0.2817188376 * double{c.y} + 0.6299787005 * double{c.z});
    return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

}  // namespace enfilade::render
