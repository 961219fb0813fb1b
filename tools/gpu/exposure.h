#pragma once
// How bright lit pictures of a scene are made.

#include "accel/lights/light_trees.h"
#include "accel/parallel_for.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// The largest power of two with which no more than 3 % of the pixels of small pictures from the scene's views are
/// white (render::LampOptions::exposure): differences in the dark and in the light are seen then. trees: of the scene
[[nodiscard]] float picture_exposure(const TriedScene& scene, const accel::LightTreesView& trees,
                                     const accel::Executor& executor);

}  // namespace enfilade::tools::gpu
