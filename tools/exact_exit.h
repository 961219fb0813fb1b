#pragma once
// By which faces a ray leaves a cube of an octree's lattice, in twice the precision of double: what the tables of
// render/rope_exit.h are held against.

#include <array>
#include <cmath>
#include <cstdint>

#include "accel/octree/rope_octree.h"

namespace enfilade::tools {

/// a + b as a sum whose second part is what the first has lost.
struct Pair {
    double high, low;
};
inline Pair exact_sum(double a, double b) {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}
inline Pair exact_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// A ray of floats, in an octree's lattice without rounding. Cells have to be as wide along all axes.
class ExactRay {
public:
    ExactRay(const accel::OctreeFrame& frame, const std::array<float, 3>& origin,
             const std::array<float, 3>& direction) {
        for (std::size_t k = 0; k < 3; ++k) {
            // Differences of floats that are of use here are exact in double.
            origin_[k] = exact_product(double{origin[k]} - double{frame.low[k]}, frame.cells_a_unit[k]);
            direction_[k] = direction[k];
            scale_ = frame.cells_a_unit[k];
        }
    }

    /// Rounded to double.
    [[nodiscard]] double origin(std::size_t axis) const { return origin_[axis].high; }
    [[nodiscard]] double direction(std::size_t axis) const { return direction_[axis] * scale_; }

    /// Whether the ray leaves the cube by that face; of faces that it leaves by at once, by each of them.
    [[nodiscard]] bool leaves_by(const accel::RopeCube& cube, std::uint32_t face) const {
        const auto axis = static_cast<std::size_t>(accel::axis_of(face));
        if (direction_[axis] == 0 || accel::is_high(face) != (direction_[axis] > 0)) return false;
        for (std::size_t k = 0; k < 3; ++k)
            if (k != axis && direction_[k] != 0 && comes_before(cube, k, axis)) return false;
        return true;
    }

    /// One of those faces. \pre the direction is not 0
    [[nodiscard]] std::uint32_t exit(const accel::RopeCube& cube) const {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t face = accel::face_at(k, direction_[static_cast<std::size_t>(k)] > 0);
            if (leaves_by(cube, face)) return face;
        }
        return accel::rope_faces;
    }

private:
    /// The ray's origin seen from the plane by which it leaves along an axis.
    [[nodiscard]] Pair from_plane(const accel::RopeCube& cube, std::size_t axis) const {
        const double plane = cube.low[axis] + (direction_[axis] > 0 ? double{1} * cube.width : 0.0);
        const Pair difference = exact_sum(origin_[axis].high, -plane);
        return exact_sum(difference.high, difference.low + origin_[axis].low);
    }

    /// Whether the plane of axis a comes before that of axis b: -w_a / d_a < -w_b / d_b.
    [[nodiscard]] bool comes_before(const accel::RopeCube& cube, std::size_t a, std::size_t b) const {
        const Pair at_a = from_plane(cube, a), at_b = from_plane(cube, b);
        const Pair first = exact_product(direction_[a], at_b.high), second = exact_product(direction_[b], at_a.high);
        const Pair difference = exact_sum(first.high, -second.high);
        const double rest =
            (first.low - second.low) + (direction_[a] * at_b.low - direction_[b] * at_a.low) + difference.low;
        const double sum = difference.high + rest;  // d_a d_b (t_a - t_b)
        return (direction_[a] > 0) == (direction_[b] > 0) ? sum < 0 : sum > 0;
    }

    std::array<Pair, 3> origin_;
    std::array<double, 3> direction_;
    double scale_ = 1;
};

}  // namespace enfilade::tools
