// Pictures with Lambert's shading into the same framebuffer: every tracer against Embree's single rays and packets.

#include "render/trace.h"
#include "tools/bench_cells.h"
#include "tools/fill_limit.h"

namespace enfilade::tools {

namespace {

constexpr int side = 1024;
constexpr std::size_t view_count = 8;

/// Embree's best at single rays and at coherent packets, by the first of the views.
struct BestWays {
    render::EmbreeWay single, packets;
};

BestWays best_ways(const Bench& bench, const TracedBuilding& building, const std::vector<PreparedView>& views) {
    render::Framebuffer image(side, side);
    const accel::SerialExecutor one;
    const auto fastest = [&](const auto& passes, std::size_t count) {
        return fastest_way(ways_where(passes), bench.quick() ? 1 : 3, [&](render::EmbreeWay way) {
            for (std::size_t k = 0; k < count; ++k) building.embree.trace_lambert(views[k].frame, way, one, image);
        });
    };
    return {fastest([](render::EmbreeWay way) { return way.lanes == 1; }, 1),
            fastest([](render::EmbreeWay way) { return way.lanes > 1 && way.coherent; }, bench.quick() ? 2 : 4)};
}

}  // namespace

void bench_primary(Bench& bench, const TracedBuilding& building) {
    const accel::SceneView& scene = building.scene.view();
    const std::vector<PreparedView> views = prepared(scene, floor_views(scene, view_count, side));
    const BestWays best = best_ways(bench, building, views);
    render::Framebuffer image(side, side);
    for (const Cores& cores : one_and_all_cores()) {
        std::vector<Competitor> competitors;
        for (const render::Tracer tracer : tracers)
            competitors.push_back({name_of(tracer), [&, tracer] {
                                       for (const PreparedView& view : views)
                                           render::trace_lambert(scene, view.frame, view.start, {.tracer = tracer},
                                                                 *cores.executor, image);
                                   }});
        for (const render::EmbreeWay way : {best.single, best.packets})
            competitors.push_back({"Embree rtcIntersect" + text(way), [&, way] {
                                       for (const PreparedView& view : views)
                                           building.embree.trace_lambert(view.frame, way, *cores.executor, image);
                                   }});
        if (has_fill_limit())
            competitors.push_back({"fill limit", [&] {
                                       for (const PreparedView& view : views)
                                           fill_limit(scene, view, *cores.executor, image);
                                   }});
        const RayContest contest(bench.quick() ? 3 : 9, double(side) * side * double(view_count),
                                 std::move(competitors), cores.clock);
        const auto add = [&](const std::string& who, std::size_t k, std::size_t reference, double goal) {
            BenchRow row = contest.row(who + ", primary rays and Lambert", k, reference);
            row.scene = building.name;
            row.threads = cores.threads;
            row.goal = ratio_at_least(goal);
            bench.add(std::move(row));
        };
        const std::size_t single = 3, packets = 4, limit = 5;
        add("scalar", 0, single, 8);
        add("simd", 1, packets, 8);
        add("packet", 2, packets, 30);
        if (has_fill_limit()) add("packet against the fill limit", 2, limit, 0.6);
    }
}

}  // namespace enfilade::tools
