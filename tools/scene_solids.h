#pragma once
// The solids that a scene's model group knows.

#include "accel/scene.h"
#include "render/solids.h"

namespace enfilade::tools {

/// Walls, slabs and ground as prisms in the scene's frame, with the scene's spaces as their names; none where the scene
/// was stripped. Throws InputError where its model is damaged.
[[nodiscard]] render::Solids solids_of(const accel::Scene& scene);

}  // namespace enfilade::tools
