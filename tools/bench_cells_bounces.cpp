// Diffuse bounces: one ray from each point that pictures see, in the order of the image and shuffled.

#include <algorithm>

#include "tools/bench_cells.h"
#include "tools/secondary_rays.h"

namespace enfilade::tools {

namespace {

constexpr int side = 1024;
constexpr std::size_t view_count = 8;

/// Our ways to trace a stream: each tracer in each order. Streams have no packets.
std::vector<Competitor> our_ways(const accel::SceneView& scene, const OwnedRays& rays, const render::HitColumns& hits,
                                 const Cores& cores) {
    std::vector<Competitor> ours;
    for (const render::Tracer tracer : {render::Tracer::Scalar, render::Tracer::Simd})
        for (const render::StreamOrder order : {render::StreamOrder::Coherent, render::StreamOrder::Any}) {
            std::string name = name_of(tracer);
            if (order == render::StreamOrder::Any) name += ", sorted by cell";
            ours.push_back({std::move(name), [&, tracer, order] {
                                render::nearest(scene, rays.view(), hits,
                                                {.tracer = tracer, .order = order, .executor = cores.executor});
                            }});
        }
    return ours;
}

void bench_stream(Bench& bench, const TracedBuilding& building, const OwnedRays& rays, const std::string& what,
                  double goal) {
    const accel::SceneView& scene = building.scene.view();
    std::vector<float> distance(rays.size());
    std::vector<accel::SourceFaceId> face(rays.size());
    const render::HitColumns hits = {distance, face, {}, {}};
    const accel::SerialExecutor one;
    const render::RayColumns sample = first_of(rays.view(), 100'000);
    const render::EmbreeWay way = fastest_way(render::embree_ways, 2, [&](render::EmbreeWay asked) {
        building.embree.nearest(sample, hits, asked, one, skin);
    });
    for (const Cores& cores : one_and_all_cores()) {
        std::vector<Competitor> competitors = our_ways(scene, rays, hits, cores);
        const std::size_t embree = competitors.size();
        competitors.push_back({"Embree rtcIntersect" + text(way),
                               [&] { building.embree.nearest(rays.view(), hits, way, *cores.executor, skin); }});
        const int rounds = bench.quick() ? 3 : cores.threads == 1 ? 9 : 5;
        const RayContest contest(rounds, double(rays.size()), std::move(competitors), cores.clock);
        const std::size_t best = contest.fastest(0, embree);
        for (std::size_t k = 0; k < embree; ++k) {
            BenchRow row = contest.row(contest.name(k) + ", " + what, k, embree);
            row.scene = building.name;
            row.threads = cores.threads;
            if (k == best) row.goal = ratio_at_least(goal);
            bench.add(std::move(row));
        }
    }
}

}  // namespace

void bench_bounces(Bench& bench, const TracedBuilding& building) {
    const accel::SceneView& scene = building.scene.view();
    const std::vector<PreparedView> views = prepared(scene, floor_views(scene, view_count, side));
    const OwnedRays rays = bounces(seen_points(scene, views, side, bench.quick() ? 32 : 16));
    bench_stream(bench, building, rays, "diffuse bounces in image order", 9);
    bench_stream(bench, building, shuffled(rays), "diffuse bounces, shuffled", 6.5);
}

}  // namespace enfilade::tools
