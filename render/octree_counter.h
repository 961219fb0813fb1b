#pragma once
// What rays do inside of octrees, counted; for pictures of it, not for speed.

#include <cstdint>

#include "accel/octree/octree_figures.h"
#include "render/object_tracer.h"

namespace enfilade::render {

/// What one ray did, or several. Events of octree_walk.h and rope_walk.h.
struct OctreeWork {
    std::uint64_t leaves = 0;     ///< entered
    std::uint64_t blocks = 0;     ///< of up to accel::OctreeCost::block_size triangles, tested in them
    std::uint64_t triangles = 0;  ///< in these blocks

    void entered_leaf(std::uint32_t /*leaf*/, std::uint32_t count) {
        ++leaves;
        blocks += accel::OctreeCost::blocks(count);
        triangles += count;
    }
    void descended(std::uint32_t /*levels*/) {}
};

/// The octrees of an ObjectAccel.
class OctreeCounter {
public:
    virtual ~OctreeCounter() = default;
    /// As ObjectTracer::nearest, ray by ray, and adds what that does to `work`.
    virtual void nearest_counted(accel::MeshId mesh, ObjectRay& ray, OctreeWork& work) const = 0;
    [[nodiscard]] virtual accel::OctreeFigures figures() const = 0;
};

}  // namespace enfilade::render
