#include "tools/gpu/check_streams.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>

#include "accel/lights/light_trees.h"
#include "tools/gpu/baselines.h"
#include "tools/gpu/inside_tracers.h"
#include "tools/gpu/ray_batch.h"
#include "tools/gpu/stream_ways.h"
#include "tools/random_rays.h"

namespace enfilade::tools::gpu {

namespace {

/// What a device said of one ray.
struct Answer {
    float distance;
    accel::SourceFaceId face;
    accel::ObjectId object;
    std::uint32_t triangle;
};

std::string words(const RayBatch& rays, std::size_t i, const render::RayHit& want, const Answer& got) {
    std::array<char, 400> text;
    std::snprintf(text.data(), text.size(),
                  "ray %zu from (%a, %a, %a) along (%a, %a, %a) in cell %zu: face %d, object %d, triangle %d at %.9g m "
                  "instead of face %d, object %d, triangle %d at %.9g m",
                  i, double{rays.origin[0][i]}, double{rays.origin[1][i]}, double{rays.origin[2][i]},
                  double{rays.direction[0][i]}, double{rays.direction[1][i]}, double{rays.direction[2][i]},
                  index(rays.cell[i]), static_cast<int>(index(got.face)), static_cast<int>(index(got.object)),
                  static_cast<int>(got.triangle), double{got.distance}, static_cast<int>(index(want.source_face)),
                  static_cast<int>(index(want.object)), static_cast<int>(want.triangle), want.distance);
    return text.data();
}

bool names_the_same(const render::RayHit& want, const Answer& got) {
    const bool is_object = want.status == render::WalkStatus::Object;
    return is_object ? got.object == want.object && got.triangle == want.triangle
                     : got.object == none<accel::ObjectId> && got.face == want.source_face;
}

/// Compares the answers that lie on the device. skin: metres in which whoever answered sees nothing
void judge(const RayBatch& rays, const std::vector<render::RayHit>& expected, const RaysOnDevice& there,
           bool with_objects, bool must_be_exact, float skin, Agreement& row) {
    const std::vector<float> distance = there.distance.read();
    const std::vector<accel::SourceFaceId> face = there.face.read();
    std::vector<accel::ObjectId> object(rays.size(), none<accel::ObjectId>);
    std::vector<std::uint32_t> triangle(rays.size(), render::no_triangle);
    if (with_objects) {
        object = there.object.read();
        triangle = there.triangle.read();
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const render::RayHit& want = expected[i];
        const Answer got = {distance[i], face[i], object[i], triangle[i]};
        bool is_same = names_the_same(want, got);
        const double error = std::abs(double{got.distance} - want.distance);
        if (is_same) row.distance_error = std::max(row.distance_error, error);
        is_same = is_same && (must_be_exact ? got.distance == static_cast<float>(want.distance)
                                            : error <= distance_slack_m + distance_share * want.distance);
        row.same += is_same ? 1 : 0;
        if (!is_same && want.distance < 2 * skin) {
            ++row.explained;
            continue;
        }
        if (got.face == none<accel::SourceFaceId> && got.object == none<accel::ObjectId> &&
            want.status != render::WalkStatus::Refused && want.status != render::WalkStatus::Leak)
            ++row.leaks;
        if (!is_same && row.fault.empty()) row.fault = words(rays, i, want, got);
    }
}

void judge(const SegmentBatch& segments, const std::vector<std::uint8_t>& expected, const SegmentsOnDevice& there,
           Agreement& row) {
    const std::vector<std::uint8_t> visible = there.visible.read();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (visible[i] == expected[i]) {
            ++row.same;
        } else if (row.fault.empty()) {
            row.fault = "segment " + std::to_string(i) + (visible[i] != 0 ? " is seen" : " is not seen") + " through";
        }
    }
}

RayBatch trying_rays(const accel::SceneView& scene, std::size_t count) {
    RayBatch rays("trying", count);
    RandomRays random(scene, 9);
    for (std::size_t i = 0; i < count; ++i) {
        const render::RayQuery ray = random.next(ray_families[i % ray_families.size()]);
        rays.set(i, render::vec_cast<float>(ray.origin), render::vec_cast<float>(ray.direction), ray.cell);
    }
    return rays;
}

std::vector<std::uint8_t> expected_visible(const accel::SceneView& scene, const SegmentBatch& s,
                                           const render::ObjectTracer* objects, const accel::Executor& executor) {
    std::vector<std::uint8_t> visible(s.size());
    render::StreamOptions options;
    options.tracer = render::Tracer::Scalar;
    options.objects = objects;
    options.executor = &executor;
    render::visible(scene, {s.from[0], s.from[1], s.from[2], s.to[0], s.to[1], s.to[2], s.from_cell, s.to_cell},
                    visible, options);
    return visible;
}

/// Checks of one scene, bare or furnished.
class StreamCheck {
public:
    /// inside: nullptr: rooms are bare. Baselines are built once; trying rays are none of theirs.
    StreamCheck(render::cuda::Device& device, const TriedScene& scene, const InsideTracers* inside,
                const accel::Executor& executor)
        : device_(device), scene_(scene), inside_(inside), executor_(executor) {
        for (const StreamWay& way : stream_ways())
            if (auto maker = way.open(device, scene.view(), inside != nullptr, executor))
                makers_.emplace_back(&way, std::move(maker));
    }

    void check(const RayBatch& rays, std::vector<Agreement>& rows, bool ours_alone = false) {
        std::map<render::ObjectAccelKind, std::vector<render::RayHit>> expected;
        const RaysOnDevice there(device_, rays);
        for (auto& [way, maker] : makers_) {
            if (ours_alone && !way->is_ours) continue;
            std::vector<render::RayHit>& wanted = expected[way->inside];
            if (wanted.empty()) wanted = expected_hits(scene_.view(), rays, objects_of(*way), executor_);
            maker->nearest(there.rays(), there.hits(inside_ != nullptr));
            Agreement& row = rows.emplace_back(begun(*way, rays.name, rays.size()));
            judge(rays, wanted, there, inside_ != nullptr, must_be_exact(*way), way->is_ours ? 0 : baseline_skin, row);
            end(*way, row);
        }
    }
    void check(const SegmentBatch& segments, std::vector<Agreement>& rows) {
        std::map<render::ObjectAccelKind, std::vector<std::uint8_t>> expected;
        SegmentsOnDevice there(device_, segments);
        for (auto& [way, maker] : makers_) {
            std::vector<std::uint8_t>& wanted = expected[way->inside];
            if (wanted.empty()) wanted = expected_visible(scene_.view(), segments, objects_of(*way), executor_);
            there.visible.clear();
            maker->visible(there.segments(), there.visible.data());
            Agreement& row = rows.emplace_back(begun(*way, segments.name, segments.size()));
            judge(segments, wanted, there, row);
            end(*way, row);
        }
    }

private:
    [[nodiscard]] const render::ObjectTracer* objects_of(const StreamWay& way) const {
        return inside_ == nullptr ? nullptr : inside_->of(way.inside);
    }
    [[nodiscard]] bool must_be_exact(const StreamWay& way) const { return way.is_exact && !device_.is_card(); }
    [[nodiscard]] Agreement begun(const StreamWay& way, const std::string& what, std::size_t asked) const {
        Agreement row;
        row.scene = scene_.name;
        row.what = what + (inside_ != nullptr ? " rays, objects" : " rays");
        row.way = way.name;
        row.asked = asked;
        row.bound = must_be_exact(way) ? "the same bits" : "1e-5 of the distance and 1e-5 m";
        return row;
    }
    void end(const StreamWay& way, Agreement& row) const {
        row.is_right = (row.leaks == 0 || !way.is_ours) &&
                       row.asked - row.same - row.explained <=
                           (must_be_exact(way) ? 0 : allowed_to_differ(row.asked, way.is_ours));
    }

    render::cuda::Device& device_;
    const TriedScene& scene_;
    const InsideTracers* inside_;
    const accel::Executor& executor_;
    std::vector<std::pair<const StreamWay*, std::unique_ptr<StreamMaker>>> makers_;
};

}  // namespace

std::vector<Agreement> check_streams(render::cuda::Device& device, const TriedScene& scene, const CheckOptions& options,
                                     const accel::Executor& executor) {
    const accel::SceneView view = scene.view();
    std::optional<accel::LightTrees> lists;
    if (scene.has_lamps()) lists = build_light_trees(view, {.trees = false, .objects = false}, executor);
    const RayBatch primary = primary_rays(scene, options.rays, executor);

    const InsideTracers inside(view, executor);

    std::vector<Agreement> rows;
    for (const bool with_objects : {false, true}) {
        if (with_objects && !scene.has_objects()) continue;
        StreamCheck check(device, scene, with_objects ? &inside : nullptr, executor);
        const render::ObjectTracer* objects = with_objects ? inside.of(render::ObjectAccelKind::Plain) : nullptr;
        check.check(primary, rows);
        const RayBatch diffuse = diffuse_rays(scene, primary, objects, executor);
        check.check(diffuse, rows);
        check.check(shuffled(diffuse, 3, executor), rows);
        check.check(trying_rays(view, options.rays / 4), rows, true);
        if (lists) check.check(shadow_segments(scene, primary, lists->view(), objects, options.rays, executor), rows);
    }
    return rows;
}

}  // namespace enfilade::tools::gpu
