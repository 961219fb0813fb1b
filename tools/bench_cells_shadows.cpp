// Shadow rays: from each point that pictures see to the lamps that may shine there.

#include <algorithm>

#include "tools/bench_cells.h"
#include "tools/room_lamps.h"

namespace enfilade::tools {

namespace {

constexpr int side = 1024;
constexpr std::size_t view_count = 8;

void add_lamp_rows(Bench& bench, const TracedBuilding& building, const RoomLamps& lamps, std::size_t points,
                   std::size_t segments) {
    const std::string of_lamps = "of " + std::to_string(lamps.places.x.size());
    bench.add({.row = "lamps that a point may see",
               .scene = building.name,
               .value = double(segments) / double(points),
               .unit = of_lamps});
}

}  // namespace

void bench_shadows(Bench& bench, const TracedBuilding& building) {
    const accel::SceneView& scene = building.scene.view();
    const std::vector<PreparedView> views = prepared(scene, floor_views(scene, view_count, side));
    const SurfacePoints seen = seen_points(scene, views, side, bench.quick() ? 64 : 16);
    const RoomLamps lamps = room_lamps(scene, 4096);
    const OwnedSegments segments = shadow_rays(seen.points, lamps);
    if (segments.size() == 0) {
        bench.remark(building.name + " has no lamps: no shadow rays.");
        return;
    }
    add_lamp_rows(bench, building, lamps, seen.points.x.size(), segments.size());
    std::vector<std::uint8_t> ours(segments.size()), others(segments.size());
    const accel::SerialExecutor one;
    const render::EmbreeWay way = fastest_way(render::embree_ways, 1, [&](render::EmbreeWay asked) {
        building.embree.visible(segments.view(), others, asked, one, skin);
    });
    for (const Cores& cores : one_and_all_cores()) {
        std::vector<Competitor> competitors;
        for (const render::Tracer tracer : {render::Tracer::Scalar, render::Tracer::Simd})
            competitors.push_back({name_of(tracer), [&, tracer] {
                                       render::visible(scene, segments.view(), ours,
                                                       {.tracer = tracer, .executor = cores.executor});
                                   }});
        competitors.push_back({"Embree rtcOccluded" + text(way),
                               [&] { building.embree.visible(segments.view(), others, way, *cores.executor, skin); }});
        const int rounds = bench.quick() ? 3 : cores.threads == 1 ? 9 : 5;
        const RayContest contest(rounds, double(segments.size()), std::move(competitors), cores.clock);
        for (std::size_t k = 0; k < 2; ++k) {
            BenchRow row = contest.row(contest.name(k) + ", shadow rays to points", k, 2);
            row.scene = building.name;
            row.threads = cores.threads;
            if (k == 1) row.goal = ratio_at_least(10);
            bench.add(std::move(row));
        }
    }
    std::size_t differ = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) differ += ours[i] != others[i] ? 1 : 0;
    bench.add({.row = "shadow rays to points: other answer than Embree's",
               .scene = building.name,
               .value = 1e6 * double(differ) / double(ours.size()),
               .unit = "per million"});
}

}  // namespace enfilade::tools
