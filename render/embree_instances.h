#pragma once
// Embree over a whole furnished scene: faces of cells and objects in one structure of its own. What the cells with
// objects inside are compared with.

#include <cstddef>
#include <memory>
#include <span>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/embree_reference.h"

namespace enfilade::render {

/// How Embree's scene holds what stands in rooms.
enum class EmbreeObjects {
    Instanced,  ///< each mesh is a scene of its own, objects are instances of it beside the faces
    OneLevel,   ///< the same, and the faces are an instance, too: one structure at the top
    Flattened   ///< every triangle of every object in one structure: the most memory
};

/// Embree 3 on faces and objects, given its best as EmbreeReference is: BVHs of the highest quality at both levels,
/// packets of 4 x 4 pixels, rays and shading in lanes. Objects are seen wherever they are, also where they poke through
/// walls. Glass is no obstacle to it.
class EmbreeInstances {
public:
    /// Builds on all cores one scene whose faces are triangles, and one whose faces are quads; Flattened: of
    /// triangles alone. The view's memory may go. \throws IoError if Embree fails
    EmbreeInstances(const accel::SceneView& scene, EmbreeObjects objects);
    ~EmbreeInstances();
    EmbreeInstances(EmbreeInstances&&) noexcept;
    EmbreeInstances& operator=(EmbreeInstances&&) noexcept;

    /// The picture of `render::trace_lambert` with objects. \pre image has the camera's size, a multiple of 4 both ways
    void trace_lambert(const CameraFrame& frame, EmbreeWay way, const accel::Executor& executor,
                       Framebuffer& image) const;

    /// The picture of `trace_lambert` with lamps: the same lists, the same light. \pre as above
    void trace_lit(const CameraFrame& frame, const EmbreeLamps& lamps, const EmbreeLitWay& way,
                   const accel::Executor& executor, Framebuffer& image) const;

    /// What each pixel of a picture shows. \pre width and height are multiples of 4
    [[nodiscard]] SeenPlaces seen_places(const CameraFrame& frame, int width, int height,
                                         const accel::Executor& executor) const;

    /// What `render::nearest` asks, without cells. What lies within `skin` (metres) of an origin is not hit.
    void nearest(const RayColumns& rays, const HitColumns& hits, EmbreeWay way, const accel::Executor& executor,
                 float skin = 0) const;

    /// What `render::visible` asks, without cells. Through instances rays are never said to be coherent.
    void visible(const SegmentColumns& segments, std::span<std::uint8_t> visible, EmbreeWay way,
                 const accel::Executor& executor, float skin = 0) const;

    /// What Embree holds for these scenes, buffers included.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace enfilade::render
