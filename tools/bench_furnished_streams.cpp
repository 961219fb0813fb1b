// Rays that go on from what pictures of furnished floors show: diffuse bounces and shadow rays.

#include <algorithm>

#include "tools/bench_furnished.h"
#include "tools/room_lamps.h"
#include "tools/secondary_rays.h"

namespace enfilade::tools {

namespace {

constexpr int side = 1024;
constexpr std::size_t view_count = 8;

/// Answers of one side.
struct Answers {
    std::vector<float> distance;
    std::vector<accel::ObjectId> object;

    explicit Answers(std::size_t count) : distance(count), object(count) {}
    [[nodiscard]] render::HitColumns columns() { return {distance, {}, {}, {}, object, {}}; }
};

/// Of a million rays, those whose answers differ by more than the skin and rounding explain.
double others_per_million(const Answers& a, const Answers& b) {
    std::size_t others = 0;
    for (std::size_t i = 0; i < a.distance.size(); ++i)
        others += std::abs(a.distance[i] - b.distance[i]) > 4e-3f ? 1 : 0;
    return 1e6 * double(others) / double(a.distance.size());
}

void bench_bounces_of(Bench& bench, const TracedFloor& traced, const TracedFloor& octrees, const OwnedRays& rays,
                      render::StreamOrder order, const std::string& what) {
    Answers ours(rays.size()), through(rays.size()), others(rays.size());
    const accel::SerialExecutor one;
    const render::RayColumns sample = first_of(rays.view(), 50'000);
    const render::EmbreeWay way = fastest_way(render::embree_ways, 1, [&](render::EmbreeWay asked) {
        traced.embree->nearest(sample, others.columns(), asked, one, skin);
    });
    std::vector<Competitor> competitors;
    for (const render::Tracer tracer : {render::Tracer::Scalar, render::Tracer::Simd})
        competitors.push_back({name_of(tracer), [&, tracer] {
                                   render::nearest(traced.scene(), rays.view(), ours.columns(),
                                                   {.tracer = tracer, .order = order, .objects = &traced.objects});
                               }});
    competitors.push_back({"simd through octrees", [&] {
                               render::nearest(traced.scene(), rays.view(), through.columns(),
                                               {.order = order, .objects = &octrees.objects});
                           }});
    competitors.push_back({"Embree instanced, " + text(way),
                           [&] { traced.embree->nearest(rays.view(), others.columns(), way, one, skin); }});
    const RayContest contest(3, double(rays.size()), std::move(competitors), Clock::Thread);
    for (std::size_t k = 0; k < 3; ++k) {
        BenchRow row = contest.row(contest.name(k) + ", " + what, k, 3);
        row.scene = traced.name();
        bench.add(std::move(row));
    }
    bench.add({.row = what + ": other distance than Embree's",
               .scene = traced.name(),
               .value = others_per_million(ours, others),
               .unit = "per million"});
}

void bench_shadows_of(Bench& bench, const TracedFloor& traced, const SurfacePoints& seen) {
    const RoomLamps lamps = room_lamps(traced.scene(), 4096);
    const OwnedSegments segments = shadow_rays(seen.points, lamps);
    if (segments.size() == 0) {
        bench.remark(traced.name() + " has no lamps: no shadow rays.");
        return;
    }
    std::vector<std::uint8_t> ours(segments.size()), others(segments.size());
    const accel::SerialExecutor one;
    // Through instances shadow rays are never said to be coherent.
    const std::vector<render::EmbreeWay> ways = ways_where([](render::EmbreeWay asked) { return !asked.coherent; });
    const render::EmbreeWay way = fastest_way(
        ways, 1, [&](render::EmbreeWay asked) { traced.embree->visible(segments.view(), others, asked, one, skin); });
    std::vector<Competitor> competitors;
    for (const render::Tracer tracer : {render::Tracer::Scalar, render::Tracer::Simd})
        competitors.push_back({name_of(tracer), [&, tracer] {
                                   render::visible(traced.scene(), segments.view(), ours,
                                                   {.tracer = tracer, .objects = &traced.objects});
                               }});
    competitors.push_back(
        {"Embree instanced, " + text(way), [&] { traced.embree->visible(segments.view(), others, way, one, skin); }});
    const RayContest contest(3, double(segments.size()), std::move(competitors), Clock::Thread);
    for (std::size_t k = 0; k < 2; ++k) {
        BenchRow row = contest.row(contest.name(k) + ", shadow rays to points", k, 2);
        row.scene = traced.name();
        bench.add(std::move(row));
    }
    std::size_t differ = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) differ += ours[i] != others[i] ? 1 : 0;
    bench.add({.row = "shadow rays to points: other answer than Embree's",
               .scene = traced.name(),
               .value = 1e6 * double(differ) / double(ours.size()),
               .unit = "per million"});
}

}  // namespace

void bench_furnished_streams(Bench& bench, const TracedFloor& traced, const TracedFloor& octrees) {
    const accel::SceneView& scene = traced.scene();
    const std::vector<PreparedView> views = prepared(scene, floor_views(scene, view_count, side));
    const SurfacePoints seen = seen_points(scene, views, side, bench.quick() ? 128 : 32, &traced.objects);
    const OwnedRays rays = bounces(seen);
    bench_bounces_of(bench, traced, octrees, rays, render::StreamOrder::Coherent, "diffuse bounces in image order");
    bench_bounces_of(bench, traced, octrees, shuffled(rays), render::StreamOrder::Any, "diffuse bounces, shuffled");
    bench_shadows_of(bench, traced, seen);
}

}  // namespace enfilade::tools
