#include "render/embree_reference.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "base/error.h"
#include "render/embree_loops.h"
#include "render/embree_mesh.h"
#include "render/shade.h"

namespace enfilade::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int tile_side = 64;
constexpr std::size_t chunk_rays = 1 << 13;

void remember_error(void* text, RTCError code, const char* message) {
    if (code != RTC_ERROR_NONE) *static_cast<std::string*>(text) = message != nullptr ? message : "unknown error";
}

/// Denormal numbers as zero on the calling thread while it lives, as Embree advises.
class ZeroDenormals {
public:
    ZeroDenormals() {
#if defined(__SSE2__)
        saved_ = _mm_getcsr();
        _mm_setcsr(saved_ | 0x8040u);
#endif
    }
    ~ZeroDenormals() {
#if defined(__SSE2__)
        _mm_setcsr(saved_);
#endif
    }
    ZeroDenormals(const ZeroDenormals&) = delete;
    ZeroDenormals& operator=(const ZeroDenormals&) = delete;

private:
    unsigned saved_ = 0;
};

RTCIntersectContext context_of(const detail::EmbreeScene& embree) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = embree.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

Vec3f lambert(const detail::PrimitiveLook& primitive, const Look& look, Vec3f normal, Vec3f direction) {
    if ((primitive.source_face & detail::sky_bit) != 0) return sky_colour(look, direction);
    const float cosine = magnitude(dot(normal, direction)) / root(dot(normal, normal) * dot(direction, direction));
    return cosine * Vec3f{primitive.red, primitive.green, primitive.blue};
}

void trace_tile(const detail::EmbreeTile& job) {
    RTCIntersectContext context = context_of(job.embree);
    const CameraFrame camera = *job.camera;
    const Vec3f o = camera.origin;
    for (int y = job.y0; y < job.y1; ++y) {
        for (int x = job.x0; x < job.x1; ++x) {
            const Vec3f d = camera.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            RTCRayHit query;
            query.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, infinity, ~0u, 0, 0};
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(job.embree.scene, &context, &query);
            Vec3f colour = {1, 0, 1};
            if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID)
                colour = lambert(job.embree.looks[query.hit.primID], *job.look,
                                 {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z}, d);
            job.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x] = encoded(colour);
        }
    }
}

void trace_columns(const detail::EmbreeRays& job) {
    RTCIntersectContext context = context_of(job.embree);
    for (std::uint64_t i = job.begin; i < job.end; ++i) {
        const Vec3f d = {job.direction[0][i], job.direction[1][i], job.direction[2][i]};
        const float metres = length(d);
        const bool is_limited = job.max_distance != nullptr && job.max_distance[i] < 1e30f;
        RTCRayHit query;
        query.ray = {job.origin[0][i],
                     job.origin[1][i],
                     job.origin[2][i],
                     job.skin / metres,
                     d.x,
                     d.y,
                     d.z,
                     0,
                     is_limited ? job.max_distance[i] / metres : infinity,
                     ~0u,
                     0,
                     0};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(job.embree.scene, &context, &query);
        const bool is_hit = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        if (job.distance != nullptr) job.distance[i] = query.ray.tfar * metres;
        if (job.source_face != nullptr)
            job.source_face[i] = static_cast<accel::SourceFaceId>(
                is_hit ? job.embree.looks[query.hit.primID].source_face & ~detail::sky_bit : ~0u);
        if (job.status != nullptr)
            job.status[i] = is_hit ? WalkStatus::Hit : (is_limited ? WalkStatus::Reached : WalkStatus::Leak);
    }
}

void trace_segments(const detail::EmbreeSegments& job) {
    RTCIntersectContext context = context_of(job.embree);
    for (std::uint64_t i = job.begin; i < job.end; ++i) {
        const Vec3f p = {job.from[0][i], job.from[1][i], job.from[2][i]};
        const Vec3f d = Vec3f{job.to[0][i], job.to[1][i], job.to[2][i]} - p;
        const float skin = job.skin / length(d);
        RTCRay ray = {p.x, p.y, p.z, skin, d.x, d.y, d.z, 0, 1 - skin, ~0u, 0, 0};
        rtcOccluded1(job.embree.scene, &context, &ray);
        job.visible[i] = ray.tfar >= 0 ? 1 : 0;
    }
}

/// One of Embree's scenes, and what its primitives look like.
class BuiltScene {
public:
    BuiltScene(RTCDevice device, const accel::SceneView& view, EmbreeFaces faces) : scene_(rtcNewScene(device)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_NONE);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        detail::EmbreeMesh mesh = detail::embree_mesh(view, faces);
        const bool has_quads = faces == EmbreeFaces::Quads;
        const std::size_t corners = has_quads ? 4 : 3;
        RTCGeometry geometry = rtcNewGeometry(device, has_quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 sizeof(accel::Vertex), mesh.vertices.size());
        void* indices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, has_quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3,
                                    corners * sizeof(std::uint32_t), mesh.corners.size() / corners);
        if (vertices != nullptr && indices != nullptr) {
            std::ranges::copy(mesh.vertices, static_cast<accel::Vertex*>(vertices));
            std::ranges::copy(mesh.corners, static_cast<std::uint32_t*>(indices));
            rtcCommitGeometry(geometry);
            rtcAttachGeometry(scene_, geometry);
            rtcCommitScene(scene_);
        }
        rtcReleaseGeometry(geometry);
        looks_ = std::move(mesh.looks);
    }
    ~BuiltScene() { rtcReleaseScene(scene_); }
    BuiltScene(const BuiltScene&) = delete;
    BuiltScene& operator=(const BuiltScene&) = delete;

    [[nodiscard]] detail::EmbreeScene asked(bool coherent) const { return {scene_, looks_.data(), coherent}; }

private:
    RTCScene scene_;
    std::vector<detail::PrimitiveLook> looks_;
};

class Device {
public:
    Device() : device_(rtcNewDevice(nullptr)) {
        if (device_ == nullptr) throw IoError("Embree cannot be started on this machine");
        rtcSetDeviceErrorFunction(device_, remember_error, &error_);
    }
    ~Device() { rtcReleaseDevice(device_); }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] RTCDevice get() const { return device_; }
    void require_success() const {
        if (!error_.empty()) throw IoError("Embree cannot build the scene: " + error_);
    }

private:
    RTCDevice device_;
    std::string error_;
};

}  // namespace

std::string text(EmbreeWay way) {
    return std::to_string(way.lanes) + (way.coherent ? ", coherent" : "") +
           (way.faces == EmbreeFaces::Quads ? ", quads" : ", triangles");
}

struct EmbreeReference::State {
    Device device;
    BuiltScene triangles;
    BuiltScene quads;

    explicit State(const accel::SceneView& scene)
        : triangles(device.get(), scene, EmbreeFaces::Triangles), quads(device.get(), scene, EmbreeFaces::Quads) {
        device.require_success();
    }
    [[nodiscard]] detail::EmbreeScene asked(EmbreeWay way) const {
        return (way.faces == EmbreeFaces::Quads ? quads : triangles).asked(way.coherent);
    }
};

EmbreeReference::EmbreeReference(const accel::SceneView& scene) : state_(std::make_unique<State>(scene)) {}
EmbreeReference::~EmbreeReference() = default;
EmbreeReference::EmbreeReference(EmbreeReference&&) noexcept = default;
EmbreeReference& EmbreeReference::operator=(EmbreeReference&&) noexcept = default;

void EmbreeReference::trace(std::span<const RayQuery> rays, std::span<RayHit> hits) const {
    const detail::EmbreeScene embree = state_->asked({.lanes = 1, .coherent = false, .faces = EmbreeFaces::Triangles});
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3f o = vec_cast<float>(rays[i].origin), d = vec_cast<float>(rays[i].direction);
        const auto limit = static_cast<float>(std::min(rays[i].max_distance, 3e38));
        WalkStatus status = WalkStatus::Leak;
        accel::SourceFaceId face = {};
        float distance = 0;
        trace_columns({embree, {&o.x, &o.y, &o.z}, {&d.x, &d.y, &d.z}, &limit, 0, &distance, &face, &status, 0, 1});
        hits[i] = {};
        hits[i].status = status;
        hits[i].throughput = {1, 1, 1};
        if (status != WalkStatus::Hit) continue;
        hits[i].source_face = face;
        hits[i].distance = double{distance};
    }
}

void EmbreeReference::trace_lambert(const CameraFrame& frame, EmbreeWay way, const accel::Executor& executor,
                                    Framebuffer& image) const {
    const Look look;
    const int columns = (image.width + tile_side - 1) / tile_side;
    const int rows = (image.height + tile_side - 1) / tile_side;
    executor.run(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), [&](std::size_t tile) {
        const ZeroDenormals zero_denormals;
        const int x = static_cast<int>(tile) % columns * tile_side, y = static_cast<int>(tile) / columns * tile_side;
        const detail::EmbreeTile job = {state_->asked(way),
                                        &frame,
                                        &look,
                                        image.rgba.data(),
                                        image.width,
                                        x,
                                        y,
                                        std::min(x + tile_side, image.width),
                                        std::min(y + tile_side, image.height)};
        way.lanes == 1 ? trace_tile(job) : detail::embree_tile(job, way.lanes);
    });
}

void EmbreeReference::nearest(const RayColumns& rays, const HitColumns& hits, EmbreeWay way,
                              const accel::Executor& executor, float skin) const {
    const auto column_of = [](auto span) { return span.empty() ? nullptr : span.data(); };
    accel::parallel_for(executor, rays.origin_x.size(), chunk_rays, [&](std::size_t begin, std::size_t end) {
        const ZeroDenormals zero_denormals;
        const detail::EmbreeRays job = {state_->asked(way),
                                        {rays.origin_x.data(), rays.origin_y.data(), rays.origin_z.data()},
                                        {rays.direction_x.data(), rays.direction_y.data(), rays.direction_z.data()},
                                        column_of(rays.max_distance),
                                        skin,
                                        column_of(hits.distance),
                                        column_of(hits.source_face),
                                        column_of(hits.status),
                                        begin,
                                        end};
        way.lanes == 1 ? trace_columns(job) : detail::embree_rays(job, way.lanes);
    });
}

void EmbreeReference::visible(const SegmentColumns& segments, std::span<std::uint8_t> visible, EmbreeWay way,
                              const accel::Executor& executor, float skin) const {
    accel::parallel_for(executor, segments.from_x.size(), chunk_rays, [&](std::size_t begin, std::size_t end) {
        const ZeroDenormals zero_denormals;
        const detail::EmbreeSegments job = {state_->asked(way),
                                            {segments.from_x.data(), segments.from_y.data(), segments.from_z.data()},
                                            {segments.to_x.data(), segments.to_y.data(), segments.to_z.data()},
                                            skin,
                                            visible.data(),
                                            begin,
                                            end};
        way.lanes == 1 ? trace_segments(job) : detail::embree_segments(job, way.lanes);
    });
}

}  // namespace enfilade::render
