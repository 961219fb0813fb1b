#pragma once
// Inside of render: octrees in the paper's layout behind object_tracer.h.

#include <memory>
#include <vector>

#include "accel/octree/octree.h"
#include "render/object_tracer.h"

namespace enfilade::render::detail {

/// used: [mesh] whether anybody asks for it. options: balanced or not, boxes stored or not, walked in float or double.
[[nodiscard]] std::unique_ptr<ObjectAccel> build_rope_objects(const accel::SceneView& scene,
                                                              const std::vector<bool>& used,
                                                              const accel::OctreeOptions& options,
                                                              const accel::Executor& executor);

}  // namespace enfilade::render::detail
