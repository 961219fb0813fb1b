#pragma once
// Inside of the study of exits: an object of no size in particular somewhere, and rays to it.

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "accel/octree/octree.h"

namespace enfilade::tools {

inline constexpr double study_size = 0.9;  ///< of the object: no power of two, so that scaling rounds

/// offset: in sizes of the object
inline accel::OctreeFrame study_frame(std::uint32_t depth, double offset) {
    accel::OctreeFrame frame;
    frame.depth = depth;
    const double away = offset * study_size;
    frame.low = {static_cast<float>(away), static_cast<float>(-0.7 * away), static_cast<float>(0.4 * away)};
    frame.cells_a_unit.fill(static_cast<float>(double{frame.side()} / study_size));
    return frame;
}

class StudyRandom {
public:
    explicit StudyRandom(std::uint64_t seed) : random_(seed) {}
    double next() { return static_cast<double>(random_() >> 11) * 0x1p-53; }  ///< [0, 1)
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() * static_cast<double>(n)); }

private:
    std::mt19937_64 random_;
};

struct StudyRay {
    std::array<float, 3> origin, direction;
};

/// From a sphere about the object, 1.5 sizes from its middle, to a place of the lattice: as near as floats come.
inline StudyRay study_ray(const accel::OctreeFrame& frame, const std::array<double, 3>& to, StudyRandom& random) {
    std::array<double, 3> on_ball;
    double square;
    do {
        square = 0;
        for (double& x : on_ball) {
            x = 2 * random.next() - 1;
            square += x * x;
        }
    } while (square > 1 || square < 1e-3);
    StudyRay ray;
    for (std::size_t k = 0; k < 3; ++k) {
        const double middle = frame.low[k] + 0.5 * study_size;
        ray.origin[k] = static_cast<float>(middle + 1.5 * study_size * on_ball[k] / std::sqrt(square));
        const double place = double{frame.low[k]} + to[k] / double{frame.cells_a_unit[k]};
        ray.direction[k] = static_cast<float>(place - double{ray.origin[k]});
    }
    return ray;
}

}  // namespace enfilade::tools
