#pragma once
// Rotations by the rows of their matrix.

#include <array>
#include <cmath>
#include <cstddef>

namespace enfilade::plans {

/// Rows of length 1 at right angles, up to what seven digits round away; reflections pass, too: models come with them.
[[nodiscard]] inline bool is_rotation(const std::array<double, 9>& rows) {
    constexpr double tolerance = 1e-3;
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t s = r; s < 3; ++s) {
            double product = 0;
            for (std::size_t k = 0; k < 3; ++k) product += rows[3 * r + k] * rows[3 * s + k];
            if (!(std::abs(product - (r == s ? 1 : 0)) <= tolerance)) return false;
        }
    return true;
}

}  // namespace enfilade::plans
