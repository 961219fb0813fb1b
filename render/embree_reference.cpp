#include "render/embree_reference.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <string>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "base/error.h"
#include "render/embree_loops.h"
#include "render/embree_mesh.h"

namespace enfilade::render {
namespace {

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

/// Single rays as columns, and their answers.
class Block {
public:
    static constexpr std::size_t size = 64;

    /// \pre no more than `size` of them
    explicit Block(std::span<const RayQuery> rays) : count_(rays.size()) {
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec3f o = vec_cast<float>(rays[i].origin), d = vec_cast<float>(rays[i].direction);
            for (std::size_t k = 0; k < 3; ++k) {
                origin_[k][i] = k == 0 ? o.x : k == 1 ? o.y : o.z;
                direction_[k][i] = k == 0 ? d.x : k == 1 ? d.y : d.z;
            }
            limit_[i] = static_cast<float>(std::min(rays[i].max_distance, 3e38));
        }
    }
    [[nodiscard]] detail::EmbreeRays job(const detail::EmbreeScene& embree) {
        return {embree,
                {origin_[0], origin_[1], origin_[2]},
                {direction_[0], direction_[1], direction_[2]},
                limit_,
                0,
                distance_,
                face_,
                status_,
                0,
                count_};
    }
    void answer(std::span<RayHit> hits) const {
        for (std::size_t i = 0; i < count_; ++i) {
            hits[i] = {};
            hits[i].status = status_[i];
            hits[i].throughput = {1, 1, 1};
            if (status_[i] != WalkStatus::Hit) continue;
            hits[i].source_face = face_[i];
            hits[i].distance = double{distance_[i]};
        }
    }

private:
    std::size_t count_;
    float origin_[3][size], direction_[3][size], limit_[size], distance_[size];
    accel::SourceFaceId face_[size];
    WalkStatus status_[size];
};

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
    for (std::size_t begin = 0; begin < rays.size(); begin += Block::size) {
        Block block(rays.subspan(begin, std::min(Block::size, rays.size() - begin)));
        detail::embree_rays(block.job(embree), 1);
        block.answer(hits.subspan(begin));
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
        detail::embree_tile(job, way.lanes);
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
        detail::embree_rays(job, way.lanes);
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
        detail::embree_segments(job, way.lanes);
    });
}

}  // namespace enfilade::render
