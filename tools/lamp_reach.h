#pragma once
// How good lists of lamps are: how many of a cell's lamps are truly seen from some place of it.

#include <cstddef>

#include "accel/lights/light_trees.h"

namespace enfilade::tools {

struct LampReach {
    std::size_t listed = 0;   ///< pairs of a cell and a lamp of its list
    std::size_t reached = 0;  ///< of these: a ray from the lamp, walked in double precision, comes into the cell
    std::size_t missed = 0;   ///< cells into which a lamp's ray came that do not list it
    /// At least 1; how many times too long the lists are at most.
    [[nodiscard]] double ratio() const { return reached == 0 ? 1 : double(listed) / double(reached); }
};

/// Sends `rays_a_lamp` rays from each lamp in all directions; then into each beam that none has gone through, at places
/// that lie on the inner side of all its planes. \pre lamps stand in cells of the scene
[[nodiscard]] LampReach lamp_reach(const accel::SceneView& scene, const accel::LightTreesView& trees,
                                   std::size_t rays_a_lamp);

}  // namespace enfilade::tools
