#pragma once
// The scalar tracer's structures inside of objects, for whoever is compared with it: distances to triangles round as
// the structure that found them asks, so each way is compared with its own.

#include <memory>

#include "render/object_tracer.h"

namespace enfilade::tools::gpu {

/// Built where a scene has objects. The view's memory must outlive it.
class InsideTracers {
public:
    InsideTracers(const accel::SceneView& scene, const accel::Executor& executor) {
        if (!scene.has_objects()) return;
        bvhs_ = build_object_accel(scene, render::ObjectAccelKind::Plain, executor);
        octrees_ = build_object_accel(scene, render::ObjectAccelKind::Octree, executor);
        of_bvhs_ = bvhs_->tracer();
        of_octrees_ = octrees_->tracer();
    }
    /// kind: Plain or Octree. nullptr where the scene has no objects.
    [[nodiscard]] const render::ObjectTracer* of(render::ObjectAccelKind kind) const {
        if (bvhs_ == nullptr) return nullptr;
        return kind == render::ObjectAccelKind::Octree ? &of_octrees_ : &of_bvhs_;
    }

private:
    std::unique_ptr<render::ObjectAccel> bvhs_, octrees_;
    render::ObjectTracer of_bvhs_, of_octrees_;
};

}  // namespace enfilade::tools::gpu
