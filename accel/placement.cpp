#include "accel/placement.h"

#include <algorithm>
#include <cmath>

namespace enfilade::accel {

std::optional<std::array<double, 12>> inverse_of(const std::array<double, 12>& m) {
    const auto cofactor = [&](std::size_t r, std::size_t c) {
        const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        return m[4 * r1 + c1] * m[4 * r2 + c2] - m[4 * r1 + c2] * m[4 * r2 + c1];
    };
    const double determinant = m[0] * cofactor(0, 0) + m[1] * cofactor(0, 1) + m[2] * cofactor(0, 2);
    if (!(std::abs(determinant) > 0)) return {};
    std::array<double, 12> inverse{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) inverse[4 * r + c] = cofactor(c, r) / determinant;
        inverse[4 * r + 3] = -(inverse[4 * r] * m[3] + inverse[4 * r + 1] * m[7] + inverse[4 * r + 2] * m[11]);
    }
    for (const double number : inverse)
        if (!(std::abs(number) < 1e30)) return {};
    return inverse;
}

void bound(const ObjectMesh& mesh, PlacedObject& object) {
    const bool is_empty = !(mesh.low[0] <= mesh.high[0]);
    for (std::size_t k = 0; k < 3; ++k) {
        const float* row = object.scene_from_object.rows.data() + 4 * k;
        double low = row[3], high = row[3], size = std::abs(row[3]);
        for (std::size_t c = 0; c < 3 && !is_empty; ++c) {
            const double a = double(row[c]) * mesh.low[c], b = double(row[c]) * mesh.high[c];
            low += std::min(a, b);
            high += std::max(a, b);
            size += std::max(std::abs(a), std::abs(b));
        }
        const double margin = 8e-7 * size;  // a dozen roundings
        object.low[k] = static_cast<float>(low - margin);
        object.high[k] = static_cast<float>(high + margin);
    }
}

}  // namespace enfilade::accel
