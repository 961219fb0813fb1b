#include <algorithm>
#include <functional>
#include <map>
#include <memory>

#include "tools/gpu/bench.h"
#include "tools/gpu/device_contest.h"
#include "tools/gpu/frame_ways.h"
#include "tools/gpu/inside_tracers.h"
#include "tools/gpu/prepared_scene.h"
#include "tools/gpu/ray_batch.h"
#include "tools/gpu/stream_ways.h"

namespace enfilade::tools::gpu {

namespace {

/// A competitor's name and seconds for one batch.
struct Result {
    std::string way;
    bool is_ours;
    std::optional<double> seconds;
};

/// The fastest of ours or of the baselines; nullptr where none was measured.
const Result* best(const std::vector<Result>& results, bool ours) {
    const Result* found = nullptr;
    for (const Result& result : results)
        if (result.is_ours == ours && result.seconds && (found == nullptr || *result.seconds < *found->seconds))
            found = &result;
    return found;
}

/// least_seconds: by the limits. bytes: of the way's structures
void add_rows(const std::string& scene, const std::string& what, std::uint64_t rays,
              std::optional<double> least_seconds, const std::vector<Result>& results,
              const std::vector<std::size_t>& bytes, MarkdownTable& table) {
    const Result* reference = best(results, false);
    for (std::size_t k = 0; k < results.size(); ++k) {
        const std::optional<double> seconds = results[k].seconds;
        std::optional<double> rate, above, ratio;
        if (seconds) rate = static_cast<double>(rays) / *seconds / 1e6;
        if (seconds && least_seconds) above = *seconds / *least_seconds;
        if (seconds && reference != nullptr) ratio = *reference->seconds / *seconds;
        table.add({scene, what, results[k].way, grouped(rays), measured(rate), measured(ratio), measured(above),
                   bytes_text(bytes[k])});
    }
}

/// What the issue asks of a kind of batch of a scene; where it asks nothing `least` is 0.
void add_goal(const std::string& what, const std::string& scene, double least, const std::vector<Result>& results,
              Report& report) {
    const Result *ours = best(results, true), *others = best(results, false);
    GoalRow goal = {what + ", " + scene, least, std::nullopt, "-"};
    if (ours != nullptr && others != nullptr) {
        goal.ratio = *others->seconds / *ours->seconds;
        goal.of = ours->way + " against " + others->way;
    }
    report.add_goal(std::move(goal));
}

MarkdownTable batch_table() {
    return MarkdownTable({"scene", "what", "by", "rays", "Mrays/s", "against the best baseline",
                          "times the least that the card allows", "memory"});
}

/// Rays of a picture of so many pixels that a launch costs nothing.
void bench_pictures(render::cuda::Device& device, const PreparedScene& scene, const Limits& limits,
                    const BenchOptions& options, const accel::Executor& executor, MarkdownTable& table,
                    Report& report) {
    const std::vector<TriedView>& views = scene.tried().views;
    const std::vector<TriedView> one = {views[views.size() / 2]};
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(options.large_side) * static_cast<unsigned>(options.large_side);
    for (const FrameTask& task : frame_tasks()) {
        if (!scene.has(task) || task.lamps == render::LampSearch::Naive) continue;
        if (options.is_late(report, "large pictures of " + scene.tried().name + ", " + task.name)) continue;
        report.progress("large pictures of " + scene.tried().name + ": " + task.name);
        std::vector<std::unique_ptr<FrameMaker>> makers;
        std::vector<Result> results;
        for (const FrameWay& way : frame_ways())
            if (auto maker = way.open(device, scene.frames(), task, executor)) {
                makers.push_back(std::move(maker));
                results.push_back({way.name, way.is_ours, std::nullopt});
            }
        std::vector<std::function<void()>> competitors;
        std::vector<std::size_t> bytes;
        for (const auto& maker : makers) {
            maker->set_views(one, options.large_side);
            competitors.push_back([m = maker.get()] { m->draw(0); });
        }
        const DeviceContest contest(device, options.rounds, competitors, 2);
        for (std::size_t k = 0; k < results.size(); ++k) {
            results[k].seconds = contest.seconds(k);
            bytes.push_back(makers[k]->bytes());
        }
        add_rows(scene.tried().name, task.name, pixels, limits.large_image, results, bytes, table);
        if (task.name == "Lambert" && !scene.tried().has_objects())
            add_goal("empty floor, primary + Lambert", scene.tried().name, 5, results, report);
        if (task.lamps == render::LampSearch::Tree && !task.with_objects && !scene.tried().has_objects())
            add_goal("empty floor, lit by trees", scene.tried().name, 5, results, report);
        if (task.name == "objects")
            add_goal("furnished floor, primary + Lambert", scene.tried().name, 2, results, report);
    }
}

/// Streams of one scene, bare or furnished.
class StreamBench {
public:
    StreamBench(render::cuda::Device& device, const TriedScene& scene, bool with_objects, const Limits& limits,
                const BenchOptions& options, const accel::Executor& executor, MarkdownTable& table, Report& report)
        : device_(device),
          scene_(scene),
          with_objects_(with_objects),
          limits_(limits),
          options_(options),
          table_(table),
          report_(report) {
        for (const StreamWay& way : stream_ways())
            if (auto maker = way.open(device, scene.view(), with_objects, executor)) {
                makers_.push_back(std::move(maker));
                ways_.push_back(&way);
            }
    }

    void bench(const RayBatch& rays) {
        const RaysOnDevice there(device_, rays);
        run(rays.name, rays.size(), with_objects_ ? 44 : 36,
            [&](StreamMaker& maker) { maker.nearest(there.rays(), there.hits(with_objects_)); });
    }
    void bench(const SegmentBatch& segments) {
        const SegmentsOnDevice there(device_, segments);
        run(segments.name, segments.size(), 33,
            [&](StreamMaker& maker) { maker.visible(there.segments(), there.visible.data()); });
    }

private:
    /// bytes: that a ray and its answer take, at least
    template <class Ask>
    void run(const std::string& name, std::size_t rays, double bytes_a_ray, const Ask& ask) {
        if (options_.is_late(report_, "streams of " + scene_.name + ", " + name)) return;
        report_.progress("streams of " + scene_.name + ": " + name + (with_objects_ ? ", objects" : ""));
        std::vector<std::function<void()>> competitors;
        std::vector<std::size_t> bytes;
        std::vector<Result> results;
        for (std::size_t k = 0; k < makers_.size(); ++k) {
            competitors.push_back([&, k] { ask(*makers_[k]); });
            results.push_back({ways_[k]->name, ways_[k]->is_ours, std::nullopt});
        }
        const DeviceContest contest(device_, options_.rounds, competitors, 2);
        for (std::size_t k = 0; k < results.size(); ++k) {
            results[k].seconds = contest.seconds(k);
            bytes.push_back(makers_[k]->bytes());
        }
        std::optional<double> least;
        if (limits_.copy) least = static_cast<double>(rays) * bytes_a_ray / *limits_.copy;
        add_rows(scene_.name, name + (with_objects_ ? " rays, objects" : " rays"), rays, least, results, bytes, table_);
    }

    render::cuda::Device& device_;
    const TriedScene& scene_;
    bool with_objects_;
    const Limits& limits_;
    const BenchOptions& options_;
    MarkdownTable& table_;
    Report& report_;
    std::vector<const StreamWay*> ways_;
    std::vector<std::unique_ptr<StreamMaker>> makers_;
};

void bench_streams(render::cuda::Device& device, const TriedScene& scene, const Limits& limits,
                   const BenchOptions& options, const accel::Executor& executor, MarkdownTable& table, Report& report) {
    const bool with_objects = scene.has_objects();
    const accel::SceneView view = scene.view();
    std::unique_ptr<InsideTracers> inside;
    if (with_objects) inside = std::make_unique<InsideTracers>(view, executor);
    const render::ObjectTracer* objects = with_objects ? inside->of(render::ObjectAccelKind::Plain) : nullptr;
    StreamBench bench(device, scene, with_objects, limits, options, executor, table, report);
    const RayBatch primary = primary_rays(scene, options.rays, executor);
    bench.bench(primary);
    {
        const RayBatch diffuse = diffuse_rays(scene, primary, objects, executor);
        bench.bench(diffuse);
        bench.bench(shuffled(diffuse, 3, executor));
    }
    if (!scene.has_lamps()) return;
    const accel::LightTrees lists = build_light_trees(view, {.trees = false, .objects = false}, executor);
    bench.bench(shadow_segments(scene, primary, lists.view(), objects, options.rays, executor));
}

/// The two largest bare ones and the largest furnished one: smaller ones tell nothing new.
std::vector<const TriedScene*> for_batches(const std::vector<TriedScene>& scenes) {
    std::vector<const TriedScene*> largest, taken;
    for (const TriedScene& scene : scenes)
        if (!scene.is_single_mesh()) largest.push_back(&scene);
    std::stable_sort(largest.begin(), largest.end(), [](const TriedScene* a, const TriedScene* b) {
        return a->view().cells.size() > b->view().cells.size();
    });
    std::size_t bare = 0, furnished = 0;
    for (const TriedScene* scene : largest)
        if (scene->has_objects() ? furnished++ < 1 : bare++ < 2) taken.push_back(scene);
    return taken;
}

}  // namespace

void bench_batches(render::cuda::Device& device, const std::vector<TriedScene>& scenes, const Limits& limits,
                   const BenchOptions& options, const accel::Executor& executor, Report& report) {
    MarkdownTable pictures = batch_table(), streams = batch_table();
    for (const TriedScene* scene : for_batches(scenes)) {
        report.guarded("large pictures of " + scene->name, [&] {
            bench_pictures(device, PreparedScene(*scene, executor), limits, options, executor, pictures, report);
        });
        report.guarded("streams of " + scene->name,
                       [&] { bench_streams(device, *scene, limits, options, executor, streams, report); });
    }
    report.section("Pictures as batches",
                   "One picture of " + std::to_string(options.large_side) + " x " + std::to_string(options.large_side) +
                       " pixels, a primary ray each; with lamps or mirrors the rays that follow are not counted. The "
                       "least that the card allows is the writing of the image.");
    report.table(pictures);
    report.section("Streams",
                   "Rays that lie in the card's memory, and answers that are left there: the distance and the face, of "
                   "furnished rooms the object and its triangle, too; of shadow rays whether the lamp is seen. The "
                   "least that the card allows is the reading and writing of those numbers.");
    report.table(streams);
}

}  // namespace enfilade::tools::gpu
