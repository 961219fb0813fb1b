#pragma once
// Rays whose places do not depend on how a building is cut into cells.

#include <cstdint>
#include <span>
#include <vector>

#include "accel/scene.h"
#include "render/trace_rays.h"

namespace enfilade::tools {

/// `count` rays in any direction from places spread evenly over the rooms' volume (over all cells where there is no
/// room), at numbers that float holds exactly. The same seed gives the same rays, on every machine.
/// \pre the scene has cells
[[nodiscard]] std::vector<render::RayQuery> even_rays(const accel::SceneView& scene, std::size_t count,
                                                      std::uint64_t seed);

/// The same rays in each of several scenes of one building, each starting in the scene's own cell. Rays that start
/// within rounding of a wall, so that some scene has no cell there, are left out of all of them. [scene][ray]
[[nodiscard]] std::vector<std::vector<render::RayQuery>> rays_in_all(std::span<const accel::SceneView* const> scenes,
                                                                     std::span<const render::RayQuery> rays);

}  // namespace enfilade::tools
