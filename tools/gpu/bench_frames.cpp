#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string_view>

#include "tools/gpu/bench.h"
#include "tools/gpu/device_contest.h"
#include "tools/gpu/frame_ways.h"
#include "tools/gpu/prepared_scene.h"

namespace enfilade::tools::gpu {

namespace {

/// Frames a second of the paper on a GeForce GTX 680, its tables 2 and 3; for its MAISON stands our house of 9 rooms.
struct PaperFigure {
    std::string_view rooms, task;
    double frames;
};
constexpr std::array<PaperFigure, 21> paper = {{
    {"9", "Lambert", 1389.16},
    {"46", "Lambert", 1064.71},
    {"135", "Lambert", 1125.19},
    {"9", "mirror floor", 1035.71},
    {"46", "mirror floor", 723.81},
    {"135", "mirror floor", 730.58},
    {"9", "lamps, naive", 134.45},
    {"46", "lamps, naive", 12.39},
    {"135", "lamps, naive", 4.4},
    {"9", "lamps, PVS", 274.36},
    {"46", "lamps, PVS", 83.24},
    {"135", "lamps, PVS", 99.36},
    {"9", "lamps, trees", 439.47},
    {"46", "lamps, trees", 156.77},
    {"135", "lamps, trees", 163.35},
    {"9", "objects", 191.39},
    {"46", "objects", 245.77},
    {"135", "objects", 230.47},
    {"9", "objects and lamps, PVS", 58.28},
    {"46", "objects and lamps, PVS", 28.13},
    {"135", "objects and lamps, PVS", 27.43},
}};

/// Names of scenes begin with what stands there and end with their rooms: "bare-135".
std::string paper_frames(const std::string& scene, const std::string& task) {
    const std::string_view rooms = std::string_view(scene).substr(scene.find('-') + 1);
    for (const PaperFigure& figure : paper)
        if (figure.rooms == rooms && figure.task == task) return three_digits(figure.frames);
    return "-";
}

/// Somebody who makes the frames of one task.
struct Entry {
    const FrameWay* way;
    std::unique_ptr<FrameMaker> maker;
    int passes = 1;  ///< over all views a round, so that a round is long enough to be measured
};

void draw_all(const Entry& entry, std::size_t views) {
    for (int pass = 0; pass < entry.passes; ++pass)
        for (std::size_t view = 0; view < views; ++view) entry.maker->draw(view);
}

/// Enough passes for two milliseconds.
int passes_for(render::cuda::Device& device, const Entry& entry, std::size_t views) {
    if (!device.is_card()) return 1;
    draw_all(entry, views);
    const double seconds = device.seconds_of([&] { draw_all(entry, views); });
    return std::clamp(static_cast<int>(std::ceil(2e-3 / std::max(seconds, 1e-6))), 1, 64);
}

/// One task of one scene by all ways that have it.
void bench_task(render::cuda::Device& device, const PreparedScene& scene, const FrameTask& task, const Limits& limits,
                const BenchOptions& options, const accel::Executor& executor, MarkdownTable& table,
                MarkdownTable& memory) {
    const std::vector<TriedView>& views = scene.tried().views;
    std::vector<Entry> entries;
    for (const FrameWay& way : frame_ways())
        if (auto maker = way.open(device, scene.frames(), task, executor)) entries.push_back({&way, std::move(maker)});
    std::vector<std::function<void()>> competitors;
    for (Entry& entry : entries) {
        entry.maker->set_views(views, options.side);
        entry.passes = passes_for(device, entry, views.size());
        competitors.push_back([&] { draw_all(entry, views.size()); });
    }
    const DeviceContest contest(device, options.rounds, competitors, 1.5);
    const double pixels = static_cast<double>(options.side) * options.side;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const std::optional<double> waited = seconds_with_waiting(device, 9, [&] { entries[k].maker->draw(0); });
        std::optional<double> frames, above, spread = contest.spread(k);
        if (const auto seconds = contest.seconds(k)) {
            frames = static_cast<double>(views.size()) * entries[k].passes / *seconds;
            above = 1 / (*frames * *limits.image);
        }
        table.add({scene.tried().name, task.name, entries[k].way->name, measured(frames),
                   measured(frames ? std::optional(*frames * pixels / 1e6) : std::nullopt),
                   measured(waited ? std::optional(*waited * 1e6) : std::nullopt), measured(above),
                   measured(spread ? std::optional(100 * *spread) : std::nullopt, " %"),
                   paper_frames(scene.tried().name, task.name)});
        memory.add({scene.tried().name, task.name, entries[k].way->name, bytes_text(entries[k].maker->bytes())});
    }
}

/// What asking for a frame costs that has one pixel: a launch, and a graph that is started again.
void bench_launches(render::cuda::Device& device, const PreparedScene& scene, const BenchOptions& options,
                    const accel::Executor& executor, Report& report) {
    constexpr int frames = 1000;
    std::vector<Entry> entries;
    std::vector<std::function<void()>> competitors;
    for (const FrameWay& way : frame_ways())
        if (way.is_ours)
            if (auto maker = way.open(device, scene.frames(), frame_tasks()[0], executor))
                entries.push_back({&way, std::move(maker), device.is_card() ? frames : 1});
    for (Entry& entry : entries) {
        entry.maker->set_views({scene.tried().views[0]}, 1);
        competitors.push_back([&] { draw_all(entry, 1); });
    }
    const DeviceContest contest(device, options.rounds, competitors, 1.5);
    MarkdownTable table({"by", "one after the other, us", "waited for each time, us"});
    for (std::size_t k = 0; k < entries.size(); ++k) {
        std::optional<double> queued = contest.seconds(k);
        if (queued) *queued *= 1e6 / frames;
        std::optional<double> waited = seconds_with_waiting(device, 99, [&] { entries[k].maker->draw(0); });
        if (waited) *waited *= 1e6;
        table.add({entries[k].way->name, measured(queued), measured(waited)});
    }
    report.section("Launches", "Frames of a single pixel: what it costs to ask for a frame, apart from its rays.");
    report.table(table);
}

}  // namespace

void bench_frames(render::cuda::Device& device, const std::vector<TriedScene>& scenes, const Limits& limits,
                  const BenchOptions& options, const accel::Executor& executor, Report& report) {
    MarkdownTable table({"scene", "what", "by", "frames/s", "million pixels/s", "one frame, waited for, us",
                         "times the writing of the image", "spread", "paper's frames/s (GTX 680)"});
    MarkdownTable memory({"scene", "what", "by", "memory"});
    for (const TriedScene& scene : scenes) {
        if (scene.is_single_mesh()) continue;
        report.guarded("frames of " + scene.name, [&] {
            const PreparedScene prepared(scene, executor);
            if (&scene == &scenes[0]) bench_launches(device, prepared, options, executor, report);
            for (const FrameTask& task : frame_tasks()) {
                const std::string what = "frames of " + scene.name + ", " + task.name;
                if (!prepared.has(task) || options.is_late(report, what)) continue;
                report.progress(what);
                bench_task(device, prepared, task, limits, options, executor, table, memory);
            }
        });
    }
    report.section("Frames of " + std::to_string(options.side) + " x " + std::to_string(options.side) + " pixels",
                   "One ray a pixel, and what follows from it. Frames of all views of a scene are asked for one after "
                   "the other without waiting, so a launch is hidden where the frame before takes longer; \"waited "
                   "for\" has it in full. The paper's scenes had as many rooms and lamps, not the same ones.");
    report.table(table);
    report.section("Memory of frames", "On the card: the scene, its trees, and one image.");
    report.table(memory);
}

}  // namespace enfilade::tools::gpu
