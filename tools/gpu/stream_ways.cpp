#include "tools/gpu/stream_ways.h"

#include "tools/gpu/baselines.h"

namespace enfilade::tools::gpu {

namespace {

using render::cuda::Device;
using render::cuda::DeviceHits;
using render::cuda::DeviceRays;
using render::cuda::DeviceSegments;
using render::cuda::DeviceStreamOptions;
using render::cuda::InsideKind;

/// Our own streams.
class Walks : public StreamMaker {
public:
    Walks(Device& device, const accel::SceneView& scene, const DeviceStreamOptions& options)
        : stream_(device, scene, options) {}

    void nearest(const DeviceRays& rays, const DeviceHits& hits) override { stream_.nearest(rays, hits); }
    void visible(const DeviceSegments& segments, std::uint8_t* visible) override { stream_.visible(segments, visible); }
    std::size_t bytes() const override { return stream_.bytes(); }

private:
    render::cuda::DeviceStream stream_;
};

class Baseline : public StreamMaker {
public:
    Baseline(Device& device, const accel::SceneView& scene, const render::cuda::BvhBaselineOptions& options,
             const accel::Executor& executor)
        : bvh_(device, scene, options, executor) {}

    void nearest(const DeviceRays& rays, const DeviceHits& hits) override { bvh_.nearest(rays, hits); }
    void visible(const DeviceSegments& segments, std::uint8_t* visible) override { bvh_.visible(segments, visible); }
    std::size_t bytes() const override { return bvh_.bytes(); }

private:
    render::cuda::BvhBaseline bvh_;
};

StreamWay baseline(const BaselineWay& way) {
    const auto open = [way](Device& device, const accel::SceneView& scene, bool with_objects,
                            const accel::Executor& executor) -> std::unique_ptr<StreamMaker> {
        render::cuda::BvhBaselineOptions options = way.options;
        options.with_objects = with_objects;
        options.skin = baseline_skin;
        return std::make_unique<Baseline>(device, scene, options, executor);
    };
    return {way.name, false, false, render::ObjectAccelKind::Plain, open};
}

/// Where a schedule is at home.
enum class In { BareAndFurnished, Furnished };

StreamWay walks(const std::string& name, In rooms, InsideKind inside, DeviceStreamOptions options) {
    const auto open = [=](Device& device, const accel::SceneView& scene, bool with_objects,
                          const accel::Executor& executor) -> std::unique_ptr<StreamMaker> {
        if (!with_objects && rooms == In::Furnished) return nullptr;
        DeviceStreamOptions asked = options;
        if (with_objects) asked.inside = inside;
        asked.executor = &executor;
        return std::make_unique<Walks>(device, scene, asked);
    };
    const auto kind = inside == InsideKind::Octree ? render::ObjectAccelKind::Octree : render::ObjectAccelKind::Plain;
    return {name, true, true, kind, open};
}

std::vector<StreamWay> all_ways() {
    using render::cuda::RayOrder;
    using render::cuda::SectionLayout;
    using render::cuda::StreamSchedule;
    constexpr InsideKind octree = InsideKind::Octree, bvh = InsideKind::Bvh;
    std::vector<StreamWay> ways = {
        walks("cells: whole", In::BareAndFurnished, octree, {.schedule = StreamSchedule::Whole}),
        walks("cells: deferred", In::BareAndFurnished, octree, {.schedule = StreamSchedule::Deferred}),
        walks("cells: deferred, lines by columns", In::BareAndFurnished, octree,
              {.schedule = StreamSchedule::Deferred, .layout = SectionLayout::Columns}),
        walks("cells: deferred, lines by points", In::BareAndFurnished, octree,
              {.schedule = StreamSchedule::Deferred, .layout = SectionLayout::Points}),
        walks("cells: deferred, sorted by cell", In::BareAndFurnished, octree,
              {.order = RayOrder::ByCell, .schedule = StreamSchedule::Deferred}),
        walks("cells: deferred, along a Morton curve", In::BareAndFurnished, octree,
              {.order = RayOrder::Morton, .schedule = StreamSchedule::Deferred}),
        walks("cells: deferred, 67 million at once", In::BareAndFurnished, octree,
              {.schedule = StreamSchedule::Deferred, .rays_at_once = 1u << 26}),
        walks("cells: persistent", In::BareAndFurnished, octree, {.schedule = StreamSchedule::Persistent}),
        walks("cells: persistent, refilled at 4", In::BareAndFurnished, octree,
              {.schedule = StreamSchedule::Persistent, .refill = 4}),
        walks("cells: persistent, refilled at 24", In::BareAndFurnished, octree,
              {.schedule = StreamSchedule::Persistent, .refill = 24}),
        walks("cells: compacted", In::Furnished, octree, {.schedule = StreamSchedule::Compacted}),
        walks("cells: compacted, questions unsorted", In::Furnished, octree,
              {.schedule = StreamSchedule::Compacted, .sorts_questions = false}),
        walks("cells: deferred, BVHs inside", In::Furnished, bvh, {.schedule = StreamSchedule::Deferred}),
        walks("cells: persistent, BVHs inside", In::Furnished, bvh, {.schedule = StreamSchedule::Persistent}),
        walks("cells: compacted, BVHs inside", In::Furnished, bvh, {.schedule = StreamSchedule::Compacted}),
    };
    for (const BaselineWay& way : baseline_ways()) ways.push_back(baseline(way));
    return ways;
}

}  // namespace

const std::vector<StreamWay>& stream_ways() {
    static const std::vector<StreamWay> ways = all_ways();
    return ways;
}

}  // namespace enfilade::tools::gpu
