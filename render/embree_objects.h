#pragma once
// Inside of render: objects answered by Embree (object_tracer.h).

#include <memory>
#include <vector>

#include "render/object_tracer.h"

namespace enfilade::render::detail {

/// How Embree builds.
struct EmbreeObjectOptions {
    /// On the average, at most, unless all trees are small. Trees that hold their triangles take some 67 and are 10 to
    /// 40 % faster than those that hold indices, which take some 36 (README.md, "Objects"): the former for as many
    /// meshes as the budget allows, those first that stand in most places for their size.
    double bytes_a_triangle = 58;
};

/// used: [mesh count], meshes that need a structure. \throws IoError if Embree fails
[[nodiscard]] std::unique_ptr<ObjectAccel> build_embree_objects(const accel::SceneView& scene,
                                                                const std::vector<bool>& used,
                                                                const accel::Executor& executor,
                                                                const EmbreeObjectOptions& options = {});

}  // namespace enfilade::render::detail
