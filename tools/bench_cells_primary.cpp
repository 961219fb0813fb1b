// Pictures with Lambert's shading into the same framebuffer: every tracer against Embree's single rays and packets.

#include "render/trace.h"
#include "tools/bench_cells.h"
#include "tools/examples.h"
#include "tools/fill_limit.h"
#include "tools/view_file.h"

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

/// The pictures of all views by whoever draws them, on some cores.
class Pictures {
public:
    Pictures(const TracedBuilding& building, const std::vector<PreparedView>& views, const Cores& cores)
        : building_(&building), views_(&views), cores_(&cores) {}

    [[nodiscard]] Competitor ours(render::Tracer tracer) {
        return {name_of(tracer), [this, tracer] {
                    for (const PreparedView& view : *views_)
                        render::trace_lambert(building_->scene.view(), view.frame, view.start, {.tracer = tracer},
                                              *cores_->executor, image_);
                }};
    }
    [[nodiscard]] Competitor embree(render::EmbreeWay way) {
        return {"Embree rtcIntersect" + text(way), [this, way] {
                    for (const PreparedView& view : *views_)
                        building_->embree.trace_lambert(view.frame, way, *cores_->executor, image_);
                }};
    }
    [[nodiscard]] Competitor limit() {
        return {"fill limit", [this] {
                    for (const PreparedView& view : *views_)
                        fill_limit(building_->scene.view(), view, *cores_->executor, image_);
                }};
    }
    [[nodiscard]] RayContest contest(int rounds, std::vector<Competitor> competitors) const {
        return {rounds, double(side) * side * double(views_->size()), std::move(competitors), cores_->clock};
    }
    [[nodiscard]] BenchRow row(const RayContest& contest, const std::string& who, std::size_t k,
                               std::size_t reference) const {
        BenchRow row = contest.row(who + ", primary rays and Lambert", k, reference);
        row.scene = building_->name;
        row.threads = cores_->threads;
        return row;
    }
    [[nodiscard]] BenchRow row(const RayContest& contest, const std::string& who, std::size_t k, std::size_t reference,
                               double goal) const {
        BenchRow with_goal = row(contest, who, k, reference);
        with_goal.goal = ratio_at_least(goal);
        return with_goal;
    }

private:
    const TracedBuilding* building_;
    const std::vector<PreparedView>* views_;
    const Cores* cores_;
    render::Framebuffer image_{side, side};
};

/// The tour that is saved beside an example, as somebody walks it: through doors, most of the way.
void bench_tour(Bench& bench, const TracedBuilding& building, render::EmbreeWay packets) {
    const auto file = example_file(building.name + ".views.json");
    if (!file) return;
    std::vector<PreparedView> views;
    for (SavedView& view : read_views(*file, building.scene.view()).views) {
        view.camera.width = view.camera.height = side;
        views.push_back({render::make_frame(view.camera), view.cell});
    }
    const Cores& one_thread = one_and_all_cores().front();
    Pictures pictures(building, views, one_thread);
    const RayContest contest = pictures.contest(
        bench.quick() ? 1 : 5,
        {pictures.ours(render::Tracer::Simd), pictures.ours(render::Tracer::Packet), pictures.embree(packets)});
    const std::string of_tour = ", tour of " + std::to_string(views.size()) + " views";
    bench.add(pictures.row(contest, "simd" + of_tour, 0, 2));
    bench.add(pictures.row(contest, "packet" + of_tour, 1, 2));
}

}  // namespace

void bench_primary(Bench& bench, const TracedBuilding& building) {
    const accel::SceneView& scene = building.scene.view();
    const std::vector<PreparedView> views = prepared(scene, floor_views(scene, view_count, side));
    const BestWays best = best_ways(bench, building, views);
    for (const Cores& cores : one_and_all_cores()) {
        Pictures pictures(building, views, cores);
        // Single rays take ten times as long as all others together: they have a contest of their own.
        const int rounds = bench.quick() ? 1 : 3;
        const RayContest slow =
            pictures.contest(rounds, {pictures.ours(render::Tracer::Scalar), pictures.embree(best.single)});
        bench.add(pictures.row(slow, "scalar", 0, 1, 8));
        std::vector<Competitor> competitors = {pictures.ours(render::Tracer::Simd),
                                               pictures.ours(render::Tracer::Packet), pictures.embree(best.packets)};
        if (has_fill_limit()) competitors.push_back(pictures.limit());
        const RayContest fast = pictures.contest(5 * rounds, std::move(competitors));
        bench.add(pictures.row(fast, "simd", 0, 2, 8));
        bench.add(pictures.row(fast, "packet", 1, 2, 30));
        if (has_fill_limit()) bench.add(pictures.row(fast, "packet against the fill limit", 1, 3, 0.6));
    }
    bench_tour(bench, building, best.packets);
}

}  // namespace enfilade::tools
