#include "tools/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enfilade::tools {

namespace {

constexpr double metered_share = 0.97;  ///< of the lit pixels, that are to be no brighter than white

double luminance(const float* rgb) {
    return 0.2126 * double{rgb[0]} + 0.7152 * double{rgb[1]} + 0.0722 * double{rgb[2]};
}

}  // namespace

double white_luminance(double ev) { return 1.2 * std::exp2(ev); }
double exposure_value(double white_luminance) { return std::log2(white_luminance / 1.2); }

double metered_ev(std::span<const render::Image> images, double usual) {
    std::vector<double> lit;
    for (const render::Image& image : images)
        for (std::size_t p = 0; p < image.rgb.size(); p += 3) {
            const double value = luminance(&image.rgb[p]);
            if (value > 0 && std::isfinite(value)) lit.push_back(value);
        }
    if (lit.empty()) return usual;
    const auto rank = std::min(lit.size() - 1, std::size_t(metered_share * double(lit.size())));
    std::ranges::nth_element(lit, lit.begin() + std::ptrdiff_t(rank));
    // Tenths: so that what is said can be asked for, and pictures a hair apart are exposed alike.
    const double ev = std::round(10 * exposure_value(lit[rank])) / 10;
    return std::clamp(ev, darkest_ev, brightest_ev);
}

render::Camera small_camera(render::Camera camera, int side) {
    const int longer = std::max(camera.width, camera.height);
    if (longer <= side) return camera;
    camera.width = std::max(1, camera.width * side / longer);
    camera.height = std::max(1, camera.height * side / longer);
    return camera;
}

}  // namespace enfilade::tools
