#pragma once
// What the walk is compared with on the same card: general ray tracers over the same triangles, with objects as
// instances. They know nothing of cells.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/camera.h"
#include "render/cuda/bvh_job.h"
#include "render/cuda/bvh_schedule.h"
#include "render/cuda/device.h"
#include "render/cuda/streams.h"
#include "render/framebuffer.h"
#include "render/lamp_lists.h"

namespace enfilade::render::cuda {

enum class BvhKind {
    Binary,  ///< Aila and Laine's
    Wide     ///< compressed, eight children a node: Ylitie, Karras and Laine's
};

struct BvhBaselineOptions {
    BvhKind kind = BvhKind::Wide;
    TriangleTest test = TriangleTest::Fast;
    bool with_objects = true;           ///< else rooms are bare
    std::optional<accel::MeshId> mesh;  ///< this mesh alone, in its own space, instead of the scene
    float split_share = 2;  ///< so many more boxes than triangles faces are split into (triangle_entries); 0: none
    float mesh_split_share = 0.3f;  ///< the same of meshes, whose triangles are small
    float skin = 0;  ///< metres: hits nearer to a ray's origin, or to the ends of a segment, do not count
    BvhSchedule schedule;
};

/// A scene's triangles on a device in a tree of boxes. The device must outlive it, the scene's memory may go. What is
/// asked is done in order; columns and pictures lie in the device's memory.
class BvhBaseline {
public:
    /// Builds the trees on `executor` and uploads them. \throws CudaError; IoError for more than 2^30 triangles
    BvhBaseline(Device& device, const accel::SceneView& scene, const BvhBaselineOptions& options,
                const accel::Executor& executor);
    BvhBaseline(const BvhBaseline&) = delete;
    BvhBaseline& operator=(const BvhBaseline&) = delete;
    ~BvhBaseline();

    /// Asks for the frame that Pictures draws, `Shading::Lambert`, into the device's image, whose size it changes where
    /// it must.
    void draw(const CameraFrame& frame, int width, int height);
    /// The lamps that each cell's places ask for. \pre the lists have the scene's cells
    void set_lamps(const accel::SceneView& scene, const LampLists& lists, float exposure);
    /// Asks for the frame by lamps: what each pixel sees first, then a shadow ray to each lamp of its cell's list.
    /// cells: [width * height] in the device's memory: the cell of what each pixel sees, given as it is to Embree;
    /// where nothing is seen, any cell. from_lamps: shadow rays start at lamps. \pre set_lamps
    void draw_lit(const CameraFrame& frame, int width, int height, const std::uint32_t* cells, bool from_lamps);
    /// The device's image: rows from the top, as Framebuffer has them.
    [[nodiscard]] const std::uint32_t* image() const;
    /// A copy of it; waits for what was asked for.
    void read(Framebuffer& framebuffer) const;

    /// As DeviceStream: rays' cells are not read, hits' cells not written. Status Leak where a ray without limit meets
    /// nothing.
    void nearest(const DeviceRays& rays, const DeviceHits& hits);
    void visible(const DeviceSegments& segments, std::uint8_t* visible);
    /// Rays of one mesh's space, as octrees are asked (octree_rays.h). rays, answers: [count] in the device's memory.
    /// \pre options.mesh
    void nearest(const OctreeRay* rays, OctreeAnswer* answers, std::uint64_t count);

    void set_schedule(const BvhSchedule& schedule);
    /// Of nodes, triangles, instances, looks and lamps in the device's memory.
    [[nodiscard]] std::size_t bytes() const;
    /// Of nodes and triangles alone.
    [[nodiscard]] std::size_t tree_bytes() const;
    /// Triangles in the trees, parts of split ones each.
    [[nodiscard]] std::size_t record_count() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace enfilade::render::cuda
