#pragma once
// Moving through the building as light does: through portals, never through walls.

#include "accel/scene.h"
#include "render/vec.h"

namespace enfilade::render {

/// A place in the building and the cell that holds it.
struct Place {
    Vec3d point;  ///< metres, scene frame
    accel::CellId cell;
};

/// Moves by `step`, as far as solid faces and panes of glass let it: the walk with a maximal distance (Maria et al.
/// 2013, section 4.1), so no search for the cell is needed. Stops `clearance` metres before what is in the way. \pre
/// the place's cell holds its point
[[nodiscard]] Place move_camera(const accel::SceneView& scene, const Place& from, Vec3d step, double clearance = 0.05);

}  // namespace enfilade::render
