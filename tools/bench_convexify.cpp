// The ways to cut rooms into cells: how few cells, how dear to a ray, how soon done, and how fast rays then are.

#include "tools/bench_convexify.h"

#include <cmath>

#include "base/error.h"
#include "modeler/build.h"
#include "plans/generate.h"
#include "tools/contest.h"
#include "tools/convexifiers.h"
#include "tools/counting_walk.h"
#include "tools/cut_building.h"
#include "tools/real_plans.h"

namespace enfilade::tools {

namespace {

using modeler::Convexifier;

constexpr std::size_t method_count = named_convexifiers.size();
constexpr std::size_t sah = 0, hertel_mehlhorn = 1;  ///< into named_convexifiers
static_assert(named_convexifiers[sah].convexifier == Convexifier::Sah &&
              named_convexifiers[hertel_mehlhorn].convexifier == Convexifier::HertelMehlhorn);

struct Input {
    std::string name;
    plans::Plan plan;
    bool generated = true;
    bool curved = false;
};

std::vector<Input> generated_inputs() {
    std::vector<Input> inputs;
    const auto add = [&inputs](std::uint32_t rooms, double curved, double oblique, const std::string& kind) {
        inputs.push_back({grouped(rooms) + " rooms" + kind,
                          plans::generate({.rooms = rooms, .curved = curved, .oblique = oblique}), true, curved > 0});
    };
    for (const std::uint32_t rooms : {46u, 135u, 500u}) add(rooms, 0, 0, "");
    add(135, 0.25, 0, ", 1/4 curved");
    add(135, 0.5, 0, ", 1/2 curved");
    add(135, 0, 0.25, ", 1/4 oblique");
    add(135, 0, 0.5, ", 1/2 oblique");
    add(135, 0.25, 0.25, ", 1/4 curved, 1/4 oblique");
    return inputs;
}

/// How many rays and rounds the times are taken over.
struct Effort {
    std::size_t rays;
    std::size_t views;
    int side;
    int rounds;
};

Effort effort_for(const Bench& bench, const Input& input) {
    if (bench.quick()) return {20'000, 4, 128, 3};
    return input.generated ? Effort{400'000, 32, 512, 7} : Effort{200'000, 32, 256, 7};
}

/// What the methods made of one plan.
struct Comparison {
    std::array<CutBuilding, method_count> cuts;
    std::array<double, method_count> cut_seconds = {};
    std::array<double, method_count> convexify_seconds = {};
    std::array<double, method_count> random_rate = {};    ///< rays a second
    std::array<double, method_count> random_faster = {};  ///< than Hertel-Mehlhorn
    std::array<double, method_count> primary_rate = {};
    std::array<double, method_count> primary_faster = {};
    std::array<SameRays::Agreement, method_count> agreement = {};
    std::array<double, method_count> cells_a_ray = {};
    double wholes_a_ray = 0;  ///< cells a ray if nothing were cut
    std::size_t rays = 0;
    std::size_t pixels = 0;
};

void time_cutting(const modeler::Building& whole, int rounds, Comparison& result) {
    std::vector<std::function<void()>> cutters, convexifiers;
    for (const NamedConvexifier& method : named_convexifiers) {
        cutters.emplace_back([&whole, &method] {
            const accel::SerialExecutor one_thread;
            const modeler::CutOptions options{.convex = true, .convexifier = method.convexifier};
            (void)modeler::join_cuts(whole.stack, modeler::cut_regions(whole.stack, options, one_thread));
        });
        convexifiers.emplace_back(
            [&whole, &method] { (void)modeler::convexify(whole, {.convexifier = method.convexifier}); });
    }
    const Contest cutting(rounds, cutters), convexifying(rounds, convexifiers);
    for (std::size_t k = 0; k < method_count; ++k) {
        result.cut_seconds[k] = cutting.median_of(k);
        result.convexify_seconds[k] = convexifying.median_of(k);
    }
}

void time_rays(const Effort& effort, Comparison& result) {
    std::vector<const accel::SceneView*> scenes;
    for (const CutBuilding& cut : result.cuts) scenes.push_back(&cut.scene.view());
    SameRays rays(scenes, effort.rays, effort.views, effort.side);
    result.rays = rays.ray_count();
    result.pixels = rays.pixel_count();
    const Contest random(effort.rounds, rays.random()), primary(effort.rounds, rays.primary());
    for (std::size_t k = 0; k < method_count; ++k) {
        result.random_rate[k] = double(rays.ray_count()) / random.median_of(k);
        result.random_faster[k] = random.faster(k, hertel_mehlhorn);
        result.primary_rate[k] = double(rays.pixel_count()) / primary.median_of(k);
        result.primary_faster[k] = primary.faster(k, hertel_mehlhorn);
        result.agreement[k] = rays.agreement(k, hertel_mehlhorn);
        WalkCount count;
        for (const render::RayQuery& ray : rays.rays(k))
            count = count + counted_walk(*scenes[k], ray, result.cuts[k].parents);
        result.cells_a_ray[k] = double(count.visits) / double(result.rays);
        if (k == hertel_mehlhorn) result.wholes_a_ray = double(count.wholes) / double(result.rays);
    }
}

Comparison compare(const Bench& bench, const Input& input) {
    const Effort effort = effort_for(bench, input);
    const modeler::Building whole = modeler::build(input.plan);
    Comparison result;
    for (std::size_t k = 0; k < method_count; ++k)
        result.cuts[k] = cut_building(whole, {.convexifier = named_convexifiers[k].convexifier});
    time_cutting(whole, effort.rounds, result);
    if (result.cuts[sah].figures.cells > 0) time_rays(effort, result);
    return result;
}

/// Adds the rows of one method on one plan.
class MethodRows {
public:
    MethodRows(Bench& bench, const Input& input, const Comparison& result, std::size_t method)
        : bench_(bench), input_(input), result_(result), method_(method) {}

    void add() {
        const CutBuilding& cut = result_.cuts[method_];
        const CutFigures& figures = cut.figures;
        const auto goal = [this](const Goal& wanted) {
            return method_ == sah && input_.generated ? std::optional(wanted) : std::nullopt;
        };
        value("cells", double(figures.cells), "cells");
        value("cells a room", figures.cells_a_room(), "cells", goal(value_at_most(10)));
        value("SAH sum", figures.sah_sum({}), "visits");
        value("virtual portals", figures.portal_area, "m2");
        value("sections a cell", figures.sections_a_cell(), "sections");
        value("faces a section", figures.faces_a_section(), "faces");
        value("bytes a cell", figures.bytes_a_cell(), "B", goal(value_at_most(300)));
        value("bytes a cell, names and outlines included", figures.all_bytes_a_cell(), "B");
        value("cut", result_.cut_seconds[method_] * 1e3, "ms");
        value("convexify", result_.convexify_seconds[method_] * 1e3, "ms");
        if (cut.rooms.rooms > 0) {
            value("pieces of rooms without holes, over ceil(r/2)+1", cut.rooms.ratio(), "1", goal(value_at_most(1.15)));
            value("pieces of rooms without holes, over the bound", cut.rooms.ratio_to_least(), "1",
                  goal(value_at_most(1.15)));
        }
        if (method_ == sah) {
            value("cuts moved to keep off corners", double(cut.moved), "cuts");
            value("rooms spoilt by rounding and cut again", double(cut.fallen_back), "rooms");
        }
        if (result_.rays > 0) add_rays();
    }

private:
    void add_rays() {
        rate("random rays", result_.random_rate, result_.random_faster);
        if (result_.pixels > 0) rate("primary rays and Lambert", result_.primary_rate, result_.primary_faster);
        value("cells a ray", result_.cells_a_ray[method_], "cells");
        if (method_ == hertel_mehlhorn) value("cells a ray, if nothing were cut", result_.wholes_a_ray, "cells");
        const SameRays::Agreement& agreement = result_.agreement[method_];
        value("leaks", double(agreement.leaks), "of " + grouped(result_.rays), value_at_most(0));
        if (method_ != hertel_mehlhorn)
            value("other surface than under hertel-mehlhorn", double(agreement.differ) * 1e6 / double(result_.rays),
                  "per million");
    }
    void value(const std::string& what, double number, const std::string& unit, const std::optional<Goal>& goal = {}) {
        bench_.add_silently(
            {.row = prefix() + what, .scene = input_.name, .value = number, .unit = unit, .goal = goal});
    }
    void rate(const char* what, const std::array<double, method_count>& rates,
              const std::array<double, method_count>& faster) {
        BenchRow row{.row = prefix() + what, .scene = input_.name, .value = rates[method_] / 1e6, .unit = "Mrays/s"};
        if (method_ != hertel_mehlhorn) {
            row.reference = named_convexifiers[hertel_mehlhorn].name;
            row.reference_value = rates[hertel_mehlhorn] / 1e6;
            row.ratio = faster[method_];
        }
        if (method_ == sah && input_.generated && input_.curved) row.goal = ratio_at_least(1.3);
        bench_.add_silently(std::move(row));
    }
    [[nodiscard]] std::string prefix() const { return std::string(named_convexifiers[method_].name) + ": "; }

    Bench& bench_;
    const Input& input_;
    const Comparison& result_;
    std::size_t method_;
};

constexpr const char* heading =
    "                                             cells  a room  sect  faces    SAH  portals  B/cell   cut ms  pieces"
    "  a ray  random  ratio  primary  ratio";

/// The console's line of a method on a plan.
std::string line_of(const Input& input, const Comparison& result, std::size_t k) {
    const CutFigures& figures = result.cuts[k].figures;
    char text[256];
    std::snprintf(text, sizeof text,
                  "%-26.26s %-15s %7llu %7.2f %5.2f %6.2f %6.2f %8.0f %7.0f %8.2f %7.3f %6.2f %7.2f %6.2f %8.2f %6.2f",
                  input.name.c_str(), named_convexifiers[k].name, static_cast<unsigned long long>(figures.cells),
                  figures.cells_a_room(), figures.sections_a_cell(), figures.faces_a_section(), figures.sah_sum({}),
                  figures.portal_area, figures.bytes_a_cell(), result.cut_seconds[k] * 1e3,
                  result.cuts[k].rooms.ratio(), result.cells_a_ray[k], result.random_rate[k] / 1e6,
                  result.random_faster[k], result.primary_rate[k] / 1e6, result.primary_faster[k]);
    return text;
}

Comparison report(Bench& bench, const Input& input) {
    Comparison result = compare(bench, input);
    for (std::size_t k = 0; k < method_count; ++k) {
        bench.remark(line_of(input, result, k));
        MethodRows(bench, input, result, k).add();
    }
    return result;
}

/// Sums over several plans.
struct Totals {
    RoomPieces rooms;
    std::uint64_t cells = 0, spaces = 0, bytes = 0;
    double log_random = 0, log_primary = 0;
    std::size_t random_count = 0, primary_count = 0;

    void add(const Comparison& result, std::size_t k) {
        const CutFigures& figures = result.cuts[k].figures;
        rooms = rooms + result.cuts[k].rooms;
        cells += figures.cells;
        spaces += figures.rooms;
        bytes += figures.walk_bytes;
        if (result.rays > 0) log_random += std::log(result.random_faster[k]), ++random_count;
        if (result.pixels > 0) log_primary += std::log(result.primary_faster[k]), ++primary_count;
    }
};

void add_totals(Bench& bench, const std::string& scene, const std::array<Totals, method_count>& totals) {
    for (std::size_t k = 0; k < method_count; ++k) {
        const Totals& total = totals[k];
        if (total.cells == 0) return;
        const auto add = [&](const char* what, double value, const char* unit, std::optional<Goal> goal = {}) {
            if (k != sah) goal.reset();
            bench.add({.row = std::string(named_convexifiers[k].name) + ": " + what,
                       .scene = scene,
                       .value = value,
                       .unit = unit,
                       .goal = goal});
        };
        if (total.spaces > 0) add("cells a room", double(total.cells) / double(total.spaces), "cells");
        add("bytes a cell", double(total.bytes) / double(total.cells), "B", value_at_most(300));
        add("pieces of rooms without holes, over ceil(r/2)+1", total.rooms.ratio(), "1", value_at_most(1.15));
        add("pieces of rooms without holes, over the bound", total.rooms.ratio_to_least(), "1", value_at_most(1.15));
        if (k == hertel_mehlhorn) continue;
        add("random rays, ratio (mean)", std::exp(total.log_random / double(total.random_count)), "1");
        add("primary rays, ratio (mean)", std::exp(total.log_primary / double(total.primary_count)), "1");
    }
}

void bench_generated_plans(Bench& bench) {
    std::array<Totals, method_count> totals;
    for (const Input& input : generated_inputs()) {
        const Comparison result = report(bench, input);
        for (std::size_t k = 0; k < method_count; ++k) totals[k].add(result, k);
    }
    add_totals(bench, "all generated plans", totals);
}

void bench_real_plans(Bench& bench) {
    const std::vector<RealPlan> plans = real_plans(bench.data());
    if (plans.empty())
        bench.remark("There are no real plans in " + bench.data().string() +
                     ": their rows are left out (--data names another folder).");
    std::array<Totals, method_count> totals;
    for (const RealPlan& real : plans) {
        Input input{.name = real.name, .plan = {}, .generated = false};
        try {
            input.plan = plans::read(real.file, real.options);
        } catch (const InputError& error) {
            bench.remark(real.name + " is left out: " + error.what());
            continue;
        }
        const Comparison result = report(bench, input);
        for (std::size_t k = 0; k < method_count; ++k) totals[k].add(result, k);
    }
    add_totals(bench, "all real plans", totals);
}

}  // namespace

void bench_convexify(Bench& bench) {
    const OneCore one_core;
    bench.remark(heading);
    bench_generated_plans(bench);
    bench_real_plans(bench);
    bench_cut_growth(bench);
    bench_cut_objective(bench);
}

}  // namespace enfilade::tools
