#include <algorithm>

#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {

Ring rounded_rectangle(Vec centre, double half_x, double half_y, double radius, int corner_steps, int side_steps) {
    radius = std::clamp(radius, 0.0, std::min(half_x, half_y));
    Ring ring;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double sx = quarter == 0 || quarter == 3 ? 1 : -1, sy = quarter < 2 ? 1 : -1;
        const Vec corner = centre + Vec{sx * (half_x - radius), sy * (half_y - radius), 0};
        for (int k = 0; k <= corner_steps; ++k) {
            const double angle = (quarter + static_cast<double>(k) / corner_steps) * pi / 2;
            const Vec p = corner + radius * Vec{std::cos(angle), std::sin(angle), 0};
            if (k == 0 && !ring.empty()) {
                const Vec before = ring.back();
                for (int s = 1; s < side_steps; ++s)
                    ring.push_back(mix(before, p, static_cast<double>(s) / side_steps));
            }
            ring.push_back(p);
        }
    }
    const Vec last = ring.back(), first = ring.front();
    for (int s = 1; s < side_steps; ++s) ring.push_back(mix(last, first, static_cast<double>(s) / side_steps));
    return ring;
}

Ring ellipse(Vec centre, double radius_x, double radius_y, int sides) {
    Ring ring;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * pi * k / sides;
        ring.push_back(centre + Vec{radius_x * std::cos(angle), radius_y * std::sin(angle), 0});
    }
    return ring;
}

std::vector<Vec> curve(std::span<const Vec> points, int steps) {
    std::vector<Vec> path;
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    const auto at = [&](std::ptrdiff_t k) {
        if (k < 0) return 2 * points[0] - points[1];
        if (k >= count) return 2 * points[count - 1] - points[count - 2];
        return points[k];
    };
    for (std::ptrdiff_t k = 0; k + 1 < count; ++k) {
        const Vec a = at(k - 1), b = at(k), c = at(k + 1), d = at(k + 2);
        for (int s = 0; s < steps; ++s) {
            const double t = static_cast<double>(s) / steps;
            path.push_back(0.5 * (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) +
                                  t * t * t * (3 * b - a - 3 * c + d)));
        }
    }
    path.push_back(points[count - 1]);
    return path;
}

}  // namespace enfilade::modeler::own
