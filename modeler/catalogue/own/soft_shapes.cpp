#include <algorithm>

#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {

void cushion(Shaper& shaper, Vec centre, Vec half, double corner, double softness, const Paint& paint) {
    const int corner_steps = shaper.fine(3), side_steps = shaper.fine(2), rows = 2 * shaper.fine(5);
    std::vector<Ring> rings;
    for (int k = 0; k <= rows; ++k) {
        const double angle = pi * (static_cast<double>(k) / rows - 0.5);
        const bool is_pole = k == 0 || k == rows;
        const double share = is_pole ? 0 : std::pow(std::cos(angle), softness);
        const double z = std::copysign(std::pow(std::abs(std::sin(angle)), softness), angle);
        rings.push_back(rounded_rectangle(centre + Vec{0, 0, half.z * z}, half.x * share, half.y * share,
                                          corner * share, corner_steps, side_steps));
    }
    shaper.skin(rings, paint);
}

void pillow(Shaper& shaper, Vec centre, Vec half, const Paint& paint) {
    const int across = shaper.fine(8);
    // Rings along x: each a slice of the pillow, upper side one way, lower side back.
    std::vector<Ring> rings;
    const auto outline = [&](double u, double v) {  // the sides are drawn in between the corners
        return Vec{half.x * u * (1 - 0.07 * (1 - v * v)), half.y * v * (1 - 0.09 * (1 - u * u)), 0};
    };
    for (int i = 0; i <= across; ++i) {
        const double u = -std::cos(pi * i / across);
        Ring& ring = rings.emplace_back();
        for (int k = 0; k < 2 * across; ++k) {
            const double v = -std::cos(pi * k / across), side = k < across ? 1 : -1;
            const double full = std::pow(std::max(0.0, (1 - u * u) * (1 - v * v)), 0.38);
            // The short seams are a little thick: were all corners on one line, both sides would share a triangle
            // there.
            const bool is_seam = k == 0 || k == across, is_end = i == 0 || i == across;
            const double thick = is_seam ? 0 : is_end ? 0.06 : full;
            ring.push_back(centre + outline(u, v) + Vec{0, 0, side * half.z * thick});
        }
    }
    shaper.skin(rings, paint);
}

void leaf(Shaper& shaper, std::span<const Vec> rib, std::span<const double> half_widths, Vec up, double fold,
          double thickness, const Paint& paint) {
    const std::size_t count = rib.size();
    const int across = std::max(1, shaper.detail());  // strips on each side of the rib
    std::vector<Ring> rings;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec along = unit(rib[std::min(k + 1, count - 1)] - rib[k > 0 ? k - 1 : 0]);
        const Vec side = unit(cross(along, up)), above = cross(side, along);
        Ring& ring = rings.emplace_back();
        const double half_width = half_widths[k];
        const auto point = [&](double share, double height) {  // share: -1 ... 1 across
            const double lift = fold * half_width * std::abs(share);
            return rib[k] + (share * half_width) * side + (lift + height) * above;
        };
        // Thin at the edges, as thick as it gets along the rib.
        for (int s = -across; s < across; ++s) {
            const double share = static_cast<double>(s) / across;
            ring.push_back(point(share, 0.5 * thickness * (1 - std::abs(share)) * (half_width > 0 ? 1 : 0)));
        }
        for (int s = across; s > -across; --s) {
            const double share = static_cast<double>(s) / across;
            ring.push_back(point(share, -0.5 * thickness * (1 - std::abs(share)) * (half_width > 0 ? 1 : 0)));
        }
    }
    shaper.skin(rings, paint);
}

}  // namespace enfilade::modeler::own
