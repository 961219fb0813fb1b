#pragma once
// Whether a line meets boxes: those of the point locator and of solids.

#include <algorithm>
#include <array>

#include "render/ray.h"

namespace enfilade::render::detail {

/// A line, ready to be asked for many boxes.
class LineBoxes {
public:
    explicit LineBoxes(const Ray<double>& ray)
        : origin_{ray.origin.x, ray.origin.y, ray.origin.z},
          inverse_{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z},
          is_level_{ray.direction.x == 0, ray.direction.y == 0, ray.direction.z == 0} {}

    /// Whether it meets the box between its parameters `from` and `to`. Boxes need a margin of some roundings.
    [[nodiscard]] bool meets(const std::array<double, 3>& low, const std::array<double, 3>& high, double from,
                             double to) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (is_level_[k]) {
                if (!(origin_[k] >= low[k] && origin_[k] <= high[k])) return false;
                continue;
            }
            const double a = (low[k] - origin_[k]) * inverse_[k], b = (high[k] - origin_[k]) * inverse_[k];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        return from <= to;
    }

private:
    std::array<double, 3> origin_, inverse_;
    std::array<bool, 3> is_level_;
};

}  // namespace enfilade::render::detail
