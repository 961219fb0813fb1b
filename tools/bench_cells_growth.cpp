// What a primary ray from inside costs in a large building and in a small one.

#include "render/trace.h"
#include "tools/bench_cells.h"

namespace enfilade::tools {

namespace {
constexpr int side = 512;
constexpr std::size_t view_count = 32;
}  // namespace

void bench_growth(Bench& bench, const TracedBuilding& small, const TracedBuilding& large) {
    const std::array buildings = {&small, &large};
    std::array<std::vector<PreparedView>, 2> views;
    for (std::size_t b = 0; b < 2; ++b)
        views[b] = prepared(buildings[b]->scene.view(), floor_views(buildings[b]->scene.view(), view_count, side));
    render::Framebuffer image(side, side);
    const accel::SerialExecutor one;
    std::vector<Competitor> competitors;
    for (const render::Tracer tracer : tracers)
        for (std::size_t b = 0; b < 2; ++b)
            competitors.push_back({name_of(tracer) + (", in " + buildings[b]->name), [&, b, tracer] {
                                       for (const PreparedView& view : views[b])
                                           render::trace_lambert(buildings[b]->scene.view(), view.frame, view.start,
                                                                 {.tracer = tracer}, one, image);
                                   }});
    const render::EmbreeWay way = {.lanes = 16};
    for (std::size_t b = 0; b < 2; ++b)
        competitors.push_back({"Embree rtcIntersect" + text(way) + ", in " + buildings[b]->name, [&, b] {
                                   for (const PreparedView& view : views[b])
                                       buildings[b]->embree.trace_lambert(view.frame, way, one, image);
                               }});
    const RayContest contest(bench.quick() ? 3 : 9, double(side) * side * double(view_count), std::move(competitors),
                             Clock::Thread);
    for (std::size_t k = 0; k < 2 * tracers.size() + 2; k += 2) {
        BenchRow row = contest.row("primary rays, 512x512, 32 views: " + contest.name(k + 1), k + 1, k);
        row.scene = large.name;
        if (k < 2 * tracers.size()) row.goal = ratio_at_least(0.9);
        bench.add(std::move(row));
    }
}

}  // namespace enfilade::tools
