#pragma once
// Inside of render: octrees behind object_tracer.h.

#include <memory>
#include <vector>

#include "accel/octree/octree.h"
#include "render/object_tracer.h"

namespace enfilade::render::detail {

/// used: [mesh] whether anybody asks for it.
[[nodiscard]] std::unique_ptr<ObjectAccel> build_octree_objects(const accel::SceneView& scene,
                                                                const std::vector<bool>& used,
                                                                const accel::OctreeOptions& options,
                                                                const accel::Executor& executor);

}  // namespace enfilade::render::detail
