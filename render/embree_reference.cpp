#include "render/embree_reference.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <vector>

#include "render/embree_device.h"
#include "render/embree_faces.h"
#include "render/embree_jobs.h"
#include "render/embree_lamps.h"

namespace enfilade::render {
namespace {

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
                nullptr,
                nullptr,
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
        looks_ = detail::attach_faces(device, scene_, view, faces, 0);
        rtcCommitScene(scene_);
    }
    ~BuiltScene() { rtcReleaseScene(scene_); }
    BuiltScene(const BuiltScene&) = delete;
    BuiltScene& operator=(const BuiltScene&) = delete;

    [[nodiscard]] detail::EmbreeScene asked(bool coherent) const {
        return {scene_, looks_.data(), nullptr, 0, false, coherent};
    }

private:
    RTCScene scene_;
    std::vector<detail::PrimitiveLook> looks_;
};

}  // namespace

std::string text(EmbreeWay way) {
    return std::to_string(way.lanes) + (way.coherent ? ", coherent" : "") +
           (way.faces == EmbreeFaces::Quads ? ", quads" : ", triangles");
}

struct EmbreeReference::State {
    detail::EmbreeDevice device;
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
    detail::embree_picture(state_->asked(way), frame, way.lanes, executor, image);
}

void EmbreeReference::trace_lit(const CameraFrame& frame, const EmbreeLamps& lamps, const EmbreeLitWay& way,
                                const accel::Executor& executor, Framebuffer& image) const {
    detail::embree_lit_picture(state_->asked(way.primary), frame, lamps, way, executor, image);
}

SeenPlaces EmbreeReference::seen_places(const CameraFrame& frame, int width, int height,
                                        const accel::Executor& executor) const {
    return detail::embree_places(state_->asked({.lanes = 16}), frame, width, height, executor);
}

void EmbreeReference::nearest(const RayColumns& rays, const HitColumns& hits, EmbreeWay way,
                              const accel::Executor& executor, float skin) const {
    detail::embree_nearest(state_->asked(way), rays, hits, way.lanes, executor, skin);
}

void EmbreeReference::visible(const SegmentColumns& segments, std::span<std::uint8_t> visible, EmbreeWay way,
                              const accel::Executor& executor, float skin) const {
    detail::embree_visible(state_->asked(way), segments, visible, way.lanes, executor, skin);
}

}  // namespace enfilade::render
