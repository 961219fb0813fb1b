#pragma once
// Embree over the same source faces, for tests and benchmarks: the general ray tracer that the cells are compared with.

#include <memory>
#include <span>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/framebuffer.h"
#include "render/trace_rays.h"

namespace enfilade::render {

/// An Embree 3 scene of the faces of all cells: triangles and quads tagged with their source face.
class EmbreeReference {
public:
    /// Builds with Embree's high-quality BVH on all cores. \throws IoError if Embree fails.
    explicit EmbreeReference(const accel::SceneView& scene);
    ~EmbreeReference();
    EmbreeReference(EmbreeReference&&) noexcept;
    EmbreeReference& operator=(EmbreeReference&&) noexcept;

    /// rtcIntersect1 for each ray; hits: [rays.size()]. Status Leak where nothing is hit. Sections and cells are not
    /// set.
    void trace(std::span<const RayQuery> rays, std::span<RayHit> hits) const;

    /// The picture of `trace_lambert`: same rays, same shading, same framebuffer; one rtcIntersect1 a pixel on the
    /// calling thread. Glass is no obstacle to it and does not tint. \pre image has the camera's size
    void trace_lambert(const CameraFrame& frame, Framebuffer& image) const;

    /// The same with rtcIntersect16 and coherent packets of 4 x 4 pixels: Embree's best.
    /// \pre width and height are multiples of 4
    void trace_lambert_packets(const CameraFrame& frame, Framebuffer& image) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace enfilade::render
