#pragma once
// Our own tree of boxes over the triangles of one mesh, for machines without Embree and for comparisons.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/bvh_walk.h"

namespace enfilade::render {

/// A binary tree built by the surface area heuristic over 16 bins an axis (Wald 2007). However the triangles lie, no
/// path is longer than `largest_bvh_depth`, and there are no more nodes than triangles. The tree does not depend on the
/// executor.
class PlainBvh {
public:
    PlainBvh() = default;
    /// Cost: about 0.5 us a triangle and core. The scene's memory must outlive it.
    PlainBvh(const accel::SceneView& scene, accel::MeshId mesh, const accel::Executor& executor);

    /// Valid while this object lives and does not change; moving it keeps its views.
    [[nodiscard]] BvhView view() const;
    /// A view of copies in another memory. copy: T const* copy(T const* values, count). places, triangles: the mesh's
    /// there, as BvhView has them
    template <class Copy>
    [[nodiscard]] BvhView copied(const Copy& copy, const float* places, const accel::MeshTriangle* triangles) const {
        BvhView copied = view();
        copied.nodes = nodes_.empty() ? nullptr : copy(nodes_.data(), nodes_.size());
        copied.order = copy(order_.data(), order_.size());
        copied.places = places;
        copied.triangles = triangles;
        return copied;
    }
    [[nodiscard]] std::size_t bytes() const {
        return nodes_.size() * sizeof(BvhNode) + order_.size() * sizeof(std::uint32_t);
    }

private:
    std::vector<BvhNode> nodes_;
    std::vector<std::uint32_t> order_;
    const float* places_ = nullptr;
    const accel::MeshTriangle* triangles_ = nullptr;
    float low_[3] = {0, 0, 0}, high_[3] = {0, 0, 0};
};

}  // namespace enfilade::render
