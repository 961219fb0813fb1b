// The study of wrong exits: how often rounding names the wrong face, and that no walk is lost by it.

#include <cmath>
#include <cstdint>
#include <cstdio>

#include "render/executor.h"
#include "tools/bench_octree.h"
#include "tools/exit_study.h"

namespace enfilade::tools {

namespace {

std::string place_of(std::uint32_t depth, double offset) {
    char text[64];
    std::snprintf(text, sizeof text, "exits, depth %u, offset %.0f", depth, offset);
    return text;
}

void add_rates(Bench& bench, const accel::Executor& cores) {
    const std::vector<ExitRate> rates = exit_rates(bench.quick() ? 10'000 : 500'000, 1, cores);
    const ExitRate* corner = nullptr;
    const ExitRate* origin = nullptr;
    for (const ExitRate& rate : rates) {
        const std::string form = std::string(rate.is_double ? "double" : "float") +
                                 (rate.is_about_origin ? " about the origin" : " about the leaf's corner");
        const std::string start = place_of(rate.depth, rate.offset) + ": " + form;
        bench.add_silently({.row = start + ", wrong",
                            .scene = "single crossings",
                            .value = rate.wrong_a_million(),
                            .unit = "per million"});
        bench.add_silently({.row = start + ", invalid",
                            .scene = "single crossings",
                            .value = rate.invalid_a_million(),
                            .unit = "per million"});
        if (rate.is_double || rate.depth != 16) continue;
        if (!rate.is_about_origin && rate.offset == 0) corner = &rate;
        if (rate.is_about_origin && rate.offset == 1e3) origin = &rate;
    }
    if (corner == nullptr || origin == nullptr) return;
    char text[512];
    std::snprintf(
        text, sizeof text,
        "Leaving a leaf of level 16 by the paper's signs of single edges, in float: counted from the leaf's own "
        "corner (ours) %.0f exits of a million name a wrong face and %.0f none at all; counted from an origin "
        "1000 mesh sizes away %.0f and %.0f.",
        corner->wrong_a_million(), corner->invalid_a_million(), origin->wrong_a_million(), origin->invalid_a_million());
    bench.remark(text);
}

void add_walks(Bench& bench, const accel::Executor& cores) {
    std::uint64_t rays = 0, unrecovered = 0, wrong = 0;
    for (const WalkRecovery& walk : walk_recoveries(bench.quick() ? 100 : 2'000, 1, cores)) {
        const std::string start =
            place_of(walk.depth, walk.offset) + ": " + std::string(walk.is_double ? "double" : "float");
        const double crossings = double(std::max<std::uint64_t>(1, walk.crossings));
        const auto add = [&](const char* what, double value, const char* unit) {
            bench.add_silently({.row = start + ", " + what,
                                .scene = walk.is_balanced ? "walks, balanced" : "walks, free",
                                .value = value,
                                .unit = unit});
        };
        add("wrong", 1e6 * double(walk.wrong) / crossings, "per million");
        add("invalid", 1e6 * double(walk.invalid) / crossings, "per million");
        add("came back", 1e6 * double(walk.came_back) / crossings, "per million");
        add("unrecovered", double(walk.unrecovered), "rays");
        rays += walk.rays;
        wrong += walk.wrong + walk.invalid;
        unrecovered += walk.unrecovered;
    }
    bench.add({.row = "exits: walks not recovered",
               .scene = grouped(rays) + " walks",
               .value = double(unrecovered),
               .unit = "rays",
               .goal = value_at_most(0)});
    bench.remark("On these walks the signs named a wrong face, or none, " + grouped(wrong) +
                 " times; the walk noticed and went on where it should, but for the rays counted above.");
}

}  // namespace

void bench_octree_exits(Bench& bench) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    add_rates(bench, *cores);
    add_walks(bench, *cores);
}

}  // namespace enfilade::tools
