// Lists of lamps and light trees: how tight, how long they take, how large they are, and how that grows.

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "render/executor.h"
#include "tools/bench_lights.h"
#include "tools/lamp_judge.h"
#include "tools/lamp_reach.h"

namespace enfilade::tools {

namespace {

BenchRow on(const LitScene& scene, BenchRow row) {
    row.scene = scene.name;
    return row;
}

std::size_t beam_count(const LitScene& scene) { return scene.trees.view().beams.size(); }

void add_build(Bench& bench, const LitScene& scene, double most_seconds) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    const int runs = bench.quick() ? 1 : 3;
    accel::LightTrees trees;
    const auto build = [&](bool has_trees) {
        return median_seconds(runs,
                              [&] { trees = accel::build_light_trees(scene.view, {.trees = has_trees}, *cores); });
    };
    const unsigned threads = one_and_all_cores().back().threads;
    bench.add(on(scene, {.row = "lists and trees, build",
                         .threads = threads,
                         .value = build(true),
                         .unit = "s",
                         .goal = value_at_most(most_seconds)}));
    bench.add(on(scene, {.row = "lists alone, build", .threads = threads, .value = build(false), .unit = "s"}));
    const auto lamps = double(scene.lamps.size()), beams = double(beam_count(scene));
    bench.add(on(scene, {.row = "lists and trees", .value = double(scene.trees.bytes()) / lamps, .unit = "B a lamp"}));
    bench.add(on(scene, {.row = "beams", .value = beams / lamps, .unit = "a lamp"}));
    bench.add(on(scene, {.row = "lists and trees, of each beam",
                         .value = beams > 0 ? double(scene.trees.bytes()) / beams : 0,
                         .unit = "B a beam"}));
    bench.add(on(scene, {.row = "planes that a beam asks",
                         .value = beams > 0 ? double(scene.trees.view().planes.size()) / beams : 0,
                         .unit = "planes"}));
    bench.add(
        on(scene, {.row = "lamps without tree", .value = double(scene.trees.lamps_without_tree()), .unit = "lamps"}));
}

void add_missed(Bench& bench, const LitScene& scene) {
    constexpr std::uint64_t chunk = 20'000;
    const std::size_t chunks = bench.quick() ? 2 : 50;
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    std::vector<LampPairs> tallies(chunks);
    cores->run(chunks, [&](std::size_t k) {
        tallies[k] = judge_lamp_pairs(scene.view, scene.trees.view(), nullptr, k, chunk);
    });
    LampPairs all;
    for (const LampPairs& one : tallies) all += one;
    bench.add(on(scene, {.row = "random places that see a random lamp",
                         .value = 100 * double(all.seen) / double(std::max<std::uint64_t>(1, all.pairs)),
                         .unit = "%"}));
    bench.add(on(scene, {.row = "random places and lamps: missed by lists",
                         .value = double(all.missed),
                         .unit = "of " + grouped(all.pairs),
                         .goal = value_at_most(0)}));
    bench.add(on(scene, {.row = "other light than by walks in double",
                         .value = 1e6 * double(all.others) / double(std::max<std::uint64_t>(1, all.pairs)),
                         .unit = "per million"}));
    bench.add(on(scene, {.row = "of these: no edge near",
                         .value = double(all.outside_band),
                         .unit = "lamps",
                         .goal = value_at_most(0)}));
}

struct Grown {
    double beams, listed, seconds;
};

/// The trees of a floor of so many rooms with `a_room` lamps in each.
Grown grown_floor(Bench& bench, std::uint32_t rooms, std::size_t a_room) {
    const modeler::Building building = modeler::convexify(modeler::build(plans::generate({.rooms = rooms})));
    const accel::Scene scene = modeler::export_scene(building, modeler::check(building), "{}");
    const LitScene lit(grouped(rooms) + " rooms", scene.view(), a_room * rooms, LampPlaces::Rooms);
    const accel::SerialExecutor one;
    accel::LightTrees trees;
    const double seconds =
        median_seconds(rooms > 2000 ? 1 : 3, [&] { trees = accel::build_light_trees(lit.view, {}, one); });
    const auto beams = double(beam_count(lit)), lamps = double(lit.lamps.size());
    const auto add = [&](const char* row, double value, const char* unit) {
        bench.add(on(lit, {.row = std::string("growth: ") + row, .value = value, .unit = unit}));
    };
    add("build on one thread", seconds, "s");
    add("beams", beams / lamps, "a lamp");
    add("time", 1e9 * seconds / beams, "ns a beam");
    add("cells that a lamp may see", double(lit.lists.lamps.size()) / lamps, "cells");
    add("lists and trees", double(lit.trees.bytes()) / 1e6, "MB");
    return {beams, double(lit.lists.lamps.size()), seconds};
}

}  // namespace

void bench_lamp_lists(Bench& bench, const LitScene& scene, double most_seconds) {
    add_build(bench, scene, most_seconds);
    const LampReach reach = lamp_reach(scene.view, scene.trees.view(), bench.quick() ? 1'000 : 10'000);
    bench.add(on(scene, {.row = "lamps in lists, of those that are seen",
                         .value = reach.ratio(),
                         .unit = "times",
                         .goal = value_at_most(1.3)}));
    bench.add(on(scene, {.row = "cells that rays of lamps find unlisted",
                         .value = double(reach.missed),
                         .unit = "cells",
                         .goal = value_at_most(0)}));
    add_missed(bench, scene);
}

void bench_lamp_growth(Bench& bench) {
    std::vector<std::uint32_t> sizes = {46, 135, 1'000};
    if (!bench.quick()) sizes.push_back(10'000);
    std::vector<std::array<double, 2>> points;
    for (const std::uint32_t rooms : sizes) {
        const Grown grown = grown_floor(bench, rooms, 1);
        points.push_back({grown.beams, grown.seconds});
    }
    bench.add({.row = "growth: time over what is visible",
               .scene = grouped(sizes.front()) + " to " + grouped(sizes.back()) + " rooms",
               .value = growth_exponent(points),
               .unit = "exponent",
               .goal = value_at_most(1.1)});
    if (!bench.quick()) (void)grown_floor(bench, 10'000, 10);
}

}  // namespace enfilade::tools
