#pragma once
// Inside of render: objects answered by Embree (object_tracer.h).

#include <memory>
#include <vector>

#include "render/object_tracer.h"

namespace enfilade::render::detail {

/// How Embree builds; the defaults are what `build_object_accel` takes (README.md, "Objects").
struct EmbreeObjectOptions {
    bool compact = true;
    bool robust = false;
    bool high_quality = false;
};

/// used: [mesh count], meshes that need a structure. \throws IoError if Embree fails
[[nodiscard]] std::unique_ptr<ObjectAccel> build_embree_objects(const accel::SceneView& scene,
                                                                const std::vector<bool>& used,
                                                                const accel::Executor& executor,
                                                                const EmbreeObjectOptions& options = {});

}  // namespace enfilade::render::detail
