// From a plan to a scene: seconds on one core, peak memory, and how both grow with the number of rooms.

#include <cmath>
#include <string>

#include "accel/scene.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "tools/bench.h"

namespace enfilade::tools {

namespace {

/// What is known of one run of the pipeline.
struct StageSeconds {
    double build = 0;
    double convexify = 0;
    double check = 0;
    double export_scene = 0;
    [[nodiscard]] double total() const { return build + convexify + check + export_scene; }
};

/// Everything that `enfilade build` does between reading and writing.
StageSeconds run_pipeline(const plans::Plan& plan) {
    StageSeconds seconds;
    modeler::Building convex;
    {
        modeler::Building whole;
        seconds.build = seconds_of([&] { whole = modeler::build(plan); });
        seconds.convexify = seconds_of([&] { convex = modeler::convexify(whole); });
    }
    modeler::CheckReport report;
    seconds.check = seconds_of([&] { report = modeler::check(convex); });
    accel::Scene scene;
    seconds.export_scene = seconds_of([&] { scene = modeler::export_scene(convex, report, "{}"); });
    return seconds;
}

/// The run with the median total.
StageSeconds median_run(const plans::Plan& plan, int runs) {
    std::vector<StageSeconds> all;
    for (int run = 0; run < runs; ++run) all.push_back(run_pipeline(plan));
    std::sort(all.begin(), all.end(),
              [](const StageSeconds& a, const StageSeconds& b) { return a.total() < b.total(); });
    return all[all.size() / 2];
}

void add_stages(Bench& bench, const std::string& scene, const StageSeconds& seconds) {
    const auto add = [&](const char* name, double value) {
        bench.add({.row = name, .scene = scene, .value = value, .unit = "s"});
    };
    add("arrange, stack and raise", seconds.build);
    add("cut into convex cells", seconds.convexify);
    add("check", seconds.check);
    add("lay out the scene", seconds.export_scene);
}

}  // namespace

void bench_build(Bench& bench) {
    const OneCore one_core;
    std::vector<std::uint32_t> sizes = {100, 135, 200, 500, 1000};
    if (!bench.quick()) sizes.insert(sizes.end(), {2000, 5000, 10000});

    std::vector<std::array<double, 2>> points;
    for (const std::uint32_t rooms : sizes) {
        const plans::Plan plan = plans::generate({.rooms = rooms});
        const std::string scene = std::to_string(rooms) + " rooms";
        reset_peak_memory();
        const StageSeconds seconds = median_run(plan, rooms <= 200 ? 5 : rooms <= 1000 ? 3 : 1);
        const double peak = peak_memory();

        BenchRow time{.row = "plan to scene", .scene = scene, .value = seconds.total(), .unit = "s"};
        if (rooms == 135) time.goal = value_at_most(0.3);
        if (rooms == 5000) time.goal = value_at_most(15);
        bench.add(time);
        if (rooms == 135 || rooms == sizes.back()) add_stages(bench, scene, seconds);
        BenchRow memory{.row = "peak memory of the program", .scene = scene, .value = peak / 1e9, .unit = "GB"};
        if (rooms == 5000) memory.goal = value_at_most(2);
        bench.add(memory);
        points.push_back({double(rooms), seconds.total()});
    }
    // n log n between the ends: log(n1 log n1 / n0 log n0) / log(n1 / n0).
    const double first = points.front()[0];
    const double last = points.back()[0];
    const double n_log_n = std::log(last * std::log(last) / (first * std::log(first))) / std::log(last / first);
    bench.add({.row = "exponent of growth (n log n has the goal's)",
               .scene = std::to_string(sizes.front()) + "-" + std::to_string(sizes.back()) + " rooms",
               .value = growth_exponent(points),
               .unit = "1",
               .goal = value_at_most(n_log_n)});
}

}  // namespace enfilade::tools
