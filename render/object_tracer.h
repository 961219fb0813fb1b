#pragma once
// What is inside of objects: the nearest triangle of a mesh, asked by rays in the mesh's own space. Whoever answers (a
// BVH, an octree) is behind these few functions; the walk through cells asks them where it comes to a cell with
// objects (object_walk.h).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "accel/octree/octree.h"
#include "accel/parallel_for.h"
#include "accel/scene.h"

namespace enfilade::render {

inline constexpr std::uint32_t no_triangle = 0xffffffffu;

/// Sixteen rays in a mesh's own space, by columns. Directions are not of length 1: distances count in them, and are the
/// same numbers in the scene.
struct alignas(64) ObjectRays {
    static constexpr int count = 16;
    float origin_x[count], origin_y[count], origin_z[count];
    float near[count];  ///< hits nearer than this do not count
    float direction_x[count], direction_y[count], direction_z[count];
    float time[count];           ///< of nobody's use
    float far[count];            ///< nor do hits farther than this; the distance of the hit, once there is one
    std::uint32_t mask[count];   ///< all ones
    std::uint32_t id[count];     ///< of nobody's use
    std::uint32_t flags[count];  ///< 0
    float normal_x[count], normal_y[count], normal_z[count];  ///< of what was hit, of any length, on any side of it
    float u[count], v[count];
    std::uint32_t triangle[count];  ///< of the mesh; no_triangle: none was hit
    std::uint32_t geometry[count];  ///< of nobody's use
    std::uint32_t instance[count];  ///< of nobody's use
};

/// One such ray.
struct alignas(16) ObjectRay {
    float origin_x, origin_y, origin_z;
    float near;
    float direction_x, direction_y, direction_z;
    float time;
    float far;
    std::uint32_t mask, id, flags;
    float normal_x, normal_y, normal_z;
    float u, v;
    std::uint32_t triangle, geometry, instance;
};

/// Who answers. Plain pointers, safe to copy into jobs; calls may come from any number of threads.
struct ObjectTracer {
    const void* state = nullptr;
    /// The nearest triangle in [near, far], both of its sides seen; nothing is written but `far`, the normal, u, v and
    /// `triangle` of rays that hit. \pre triangle is no_triangle or a hit at `far`; the ray's numbers are finite
    void (*nearest)(const void* state, accel::MeshId mesh, ObjectRay& ray) = nullptr;
    /// The same for those of sixteen rays whose `valid` is -1 (the others have 0). valid: [16], aligned to 64 bytes
    void (*nearest16)(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) = nullptr;
    /// As nearest16, the faster for rays that are strangers to each other; nearest16 is for neighbours.
    void (*nearest16_apart)(const void* state, accel::MeshId mesh, const std::int32_t* valid,
                            ObjectRays& rays) = nullptr;
    /// Whether any triangle lies in [near, far].
    bool (*blocked)(const void* state, accel::MeshId mesh, const ObjectRay& ray) = nullptr;
    /// The same for sixteen neighbours: bit i is set where ray i is valid and blocked. `far` and what lies behind
    /// `flags` need not be what they were afterwards; nothing is read there but `far`. valid: as of nearest16
    std::uint32_t (*blocked16)(const void* state, accel::MeshId mesh, const std::int32_t* valid,
                               ObjectRays& rays) = nullptr;
};

enum class ObjectAccelKind {
    Automatic,  ///< what is fastest here: Embree's trees where it was built with it, else octrees
    Bvh,        ///< Embree's where it was built with it, else as Plain
    Plain,      ///< our own binary tree of boxes, one ray at a time
    Octree      ///< our own octree, leaf by leaf
};

class OctreeCounter;

/// A structure for each mesh of a scene that some object uses.
class ObjectAccel {
public:
    virtual ~ObjectAccel() = default;
    [[nodiscard]] virtual ObjectTracer tracer() const = 0;
    [[nodiscard]] virtual std::string_view name() const = 0;  ///< "embree", "plain" or "octree"
    [[nodiscard]] virtual std::size_t bytes() const = 0;      ///< what it takes, without the scene's own arrays
    /// Where octrees were built: what is in them, and what rays do there (octree_counter.h); else nullptr.
    [[nodiscard]] virtual const OctreeCounter* octrees() const { return nullptr; }
};

/// Builds it on the cores of `executor`. The view's memory must outlive it. Meshes without triangles, and triangles
/// without area or with corners that are no numbers, are never hit. octrees: where such are built. \throws IoError if
/// Embree fails
[[nodiscard]] std::unique_ptr<ObjectAccel> build_object_accel(const accel::SceneView& scene, ObjectAccelKind kind,
                                                              const accel::Executor& executor,
                                                              const accel::OctreeOptions& octrees = {});

}  // namespace enfilade::render
