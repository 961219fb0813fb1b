#pragma once
// Embree over the same source faces, for tests and benchmarks: the general ray tracer that the cells are compared with.

#include <array>
#include <memory>
#include <span>
#include <string>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/camera.h"
#include "render/face_mesh.h"
#include "render/framebuffer.h"
#include "render/ray_stream.h"
#include "render/trace_rays.h"

namespace enfilade::render {

/// What Embree's scene is made of.
using EmbreeFaces = FaceShapes;

/// How Embree is asked.
struct EmbreeWay {
    int lanes = 1;         ///< rays a call: 1, 8 or 16
    bool coherent = true;  ///< RTC_INTERSECT_CONTEXT_FLAG_COHERENT
    EmbreeFaces faces = EmbreeFaces::Quads;
};
/// "16, coherent, quads".
[[nodiscard]] std::string text(EmbreeWay way);

/// Every way to ask; which one is fastest differs from scene to scene.
inline constexpr std::array embree_ways = {
    EmbreeWay{1, false, EmbreeFaces::Triangles},  EmbreeWay{1, true, EmbreeFaces::Triangles},
    EmbreeWay{1, false, EmbreeFaces::Quads},      EmbreeWay{1, true, EmbreeFaces::Quads},
    EmbreeWay{8, false, EmbreeFaces::Triangles},  EmbreeWay{8, true, EmbreeFaces::Triangles},
    EmbreeWay{8, false, EmbreeFaces::Quads},      EmbreeWay{8, true, EmbreeFaces::Quads},
    EmbreeWay{16, false, EmbreeFaces::Triangles}, EmbreeWay{16, true, EmbreeFaces::Triangles},
    EmbreeWay{16, false, EmbreeFaces::Quads},     EmbreeWay{16, true, EmbreeFaces::Quads}};

struct EmbreeLamps;
struct EmbreeLitWay;
struct SeenPlaces;

/// Embree 3 scenes of the faces of all cells, tagged with their source faces. Embree is given its best: BVHs of the
/// highest quality, neither robust nor compact, denormal numbers as zero while it traces, packets of 4 x 4 or 4 x 2
/// pixels, rays and shading in as many lanes as the machine has. Glass is no obstacle to it.
class EmbreeReference {
public:
    /// Builds a scene of triangles and one of quads on all cores. \throws IoError if Embree fails.
    explicit EmbreeReference(const accel::SceneView& scene);
    ~EmbreeReference();
    EmbreeReference(EmbreeReference&&) noexcept;
    EmbreeReference& operator=(EmbreeReference&&) noexcept;

    /// rtcIntersect1 for each ray; hits: [rays.size()]. Status Leak where nothing is hit. Sections and cells are not
    /// set.
    void trace(std::span<const RayQuery> rays, std::span<RayHit> hits) const;

    /// The picture of `trace_lambert`: same rays, same shading, same framebuffer. Glass does not tint.
    /// \pre image has the camera's size, a multiple of 4 both ways
    void trace_lambert(const CameraFrame& frame, EmbreeWay way, const accel::Executor& executor,
                       Framebuffer& image) const;

    /// The picture of `trace_lambert` with lamps: the same lists, the same light. \pre as above
    void trace_lit(const CameraFrame& frame, const EmbreeLamps& lamps, const EmbreeLitWay& way,
                   const accel::Executor& executor, Framebuffer& image) const;

    /// What each pixel of a picture shows. \pre width and height are multiples of 4
    [[nodiscard]] SeenPlaces seen_places(const CameraFrame& frame, int width, int height,
                                         const accel::Executor& executor) const;

    /// What `render::nearest` asks, without cells: hits.cell stays as it is. What lies within `skin` (metres) of a
    /// ray's origin is not hit: Embree's rays must be kept off the faces on which they start.
    void nearest(const RayColumns& rays, const HitColumns& hits, EmbreeWay way, const accel::Executor& executor,
                 float skin = 0) const;

    /// What `render::visible` asks, without cells.
    void visible(const SegmentColumns& segments, std::span<std::uint8_t> visible, EmbreeWay way,
                 const accel::Executor& executor, float skin = 0) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace enfilade::render
