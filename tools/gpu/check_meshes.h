#pragma once
// Whether a device meets the triangles of a single mesh that the scalar walk meets.

#include <vector>

#include "accel/parallel_for.h"
#include "render/cuda/device.h"
#include "tools/gpu/agreement.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// Rays through the pixels of the views, and diffuse ones from what they meet, by every octree, layout and schedule. An
/// answer is the same if it names the same triangle within `distance_share` of the distance; on the host those of exact
/// ways are the same bits. \pre scene.is_single_mesh()
[[nodiscard]] std::vector<Agreement> check_meshes(render::cuda::Device& device, const TriedScene& scene,
                                                  const CheckOptions& options, const accel::Executor& executor);

}  // namespace enfilade::tools::gpu
