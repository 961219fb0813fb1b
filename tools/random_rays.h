#pragma once
// Rays for benchmarks: spread over the cells of a scene, or in the families where tracers go wrong.

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "accel/scene.h"
#include "render/trace_rays.h"

namespace enfilade::tools {

enum class RayFamily {
    Random,         ///< any direction
    AxisParallel,   ///< along x, y or z, either way
    TowardsVertex,  ///< exactly at a corner of a face
    AlongWall,      ///< in the vertical plane of a wall, or at a hair's breadth from it
    Level           ///< horizontal, on a height at which faces end
};
inline constexpr std::array ray_families = {RayFamily::Random, RayFamily::AxisParallel, RayFamily::TowardsVertex,
                                            RayFamily::AlongWall, RayFamily::Level};
[[nodiscard]] const char* name_of(RayFamily family);

/// The same seed gives the same rays, on every machine.
class RandomRays {
public:
    RandomRays(const accel::SceneView& scene, std::uint64_t seed) : scene_(&scene), random_(seed) {}

    /// A ray that starts inside a cell, at positions and in directions that float holds exactly.
    [[nodiscard]] render::RayQuery next(RayFamily family = RayFamily::Random);
    /// `count` of them.
    [[nodiscard]] std::vector<render::RayQuery> take(std::size_t count, RayFamily family = RayFamily::Random);

private:
    double uniform(double low, double high);
    std::size_t below(std::size_t count) { return std::size_t(random_() % count); }
    render::Vec3d point_in(const accel::Cell& cell);
    render::Vec3d direction(RayFamily family, const accel::Cell& cell, render::Vec3d& origin);

    const accel::SceneView* scene_;
    std::mt19937_64 random_;
};

}  // namespace enfilade::tools
