// What of a way of cutting decides the time of a ray: times of rays that visit many or few cells, with many or few
// sections, are laid beside what these rays meet. From that come the constants of `modeler::CutCost`; and whether the
// sum that the cutter minimises, from the areas of cells alone, tells the time.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "modeler/build.h"
#include "plans/generate.h"
#include "tools/bench_convexify.h"
#include "tools/contest.h"
#include "tools/convexifiers.h"
#include "tools/counting_walk.h"
#include "tools/cut_building.h"
#include "tools/least_squares.h"
#include "tools/real_plans.h"

namespace enfilade::tools {

namespace {

using modeler::Convexifier;
using modeler::CutCost;

struct Study {
    std::string name;
    plans::Plan plan;
};

std::vector<Study> studies(const Bench& bench) {
    std::vector<Study> plans;
    plans.push_back({"46 rooms, 1/2 curved", plans::generate({.rooms = 46, .curved = 0.5})});
    plans.push_back({"46 rooms, 1/2 oblique", plans::generate({.rooms = 46, .oblique = 0.5})});
    if (bench.quick()) return plans;
    plans.push_back(
        {"135 rooms, 1/4 curved, 1/4 oblique", plans::generate({.rooms = 135, .curved = 0.25, .oblique = 0.25})});
    for (const RealPlan& real : real_plans(bench.data()))
        for (const char* wanted : {"andijcr_ristrutturazione_default.sh3d", "rtreffer_home_xml.sh3d",
                                   "skymakerolof_floorplan.dxf", "floorspace_largeShatteredPlan.json"})
            if (real.name == wanted) plans.push_back({real.name, plans::read(real.file, real.options)});
    return plans;
}

/// Ways to cut that differ as much as possible.
std::vector<modeler::ConvexifyOptions> variants() {
    std::vector<modeler::ConvexifyOptions> all = {{.convexifier = Convexifier::HertelMehlhorn},
                                                  {.convexifier = Convexifier::Diagonals}};
    for (const CutCost& cost : {CutCost{1, 0, 0}, CutCost{}, CutCost{1, 0.3, 0.1}, CutCost{1, 1, 0.5}})
        all.push_back({.convexifier = Convexifier::Sah, .cost = cost});
    return all;
}

/// Rays that meet alike, in one scene.
struct Batch {
    std::vector<render::RayQuery> rays;
    WalkCount count;
};

constexpr std::size_t groups = 6, parts = 4;  ///< by visits, then by sections a visit

std::vector<Batch> batches_of(const accel::SceneView& scene, const std::vector<render::RayQuery>& rays) {
    std::vector<WalkCount> counts;
    for (const render::RayQuery& ray : rays) counts.push_back(counted_walk(scene, ray));
    std::vector<std::uint32_t> order(rays.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return counts[a].visits < counts[b].visits; });
    std::vector<Batch> batches;
    for (std::size_t g = 0; g < groups; ++g) {
        const auto begin = order.begin() + std::ptrdiff_t(g * rays.size() / groups);
        const auto end = order.begin() + std::ptrdiff_t((g + 1) * rays.size() / groups);
        std::stable_sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            return counts[a].sections * counts[b].visits < counts[b].sections * counts[a].visits;
        });
        const std::size_t size = std::size_t(end - begin);
        for (std::size_t p = 0; p < parts; ++p) {
            Batch batch;
            for (auto at = begin + std::ptrdiff_t(p * size / parts);
                 at != begin + std::ptrdiff_t((p + 1) * size / parts); ++at) {
                batch.rays.push_back(rays[*at]);
                batch.count = batch.count + counts[*at];
            }
            batches.push_back(std::move(batch));
        }
    }
    return batches;
}

/// One variant on one plan.
struct Sample {
    CutFigures figures;
    std::vector<Batch> batches;
    std::vector<double> wide, narrow;  ///< [batch] seconds: as `trace_rays` walks, and one section at a time
    /// Nanoseconds a ray.
    [[nodiscard]] double time() const {
        std::size_t rays = 0;
        for (const Batch& batch : batches) rays += batch.rays.size();
        return std::accumulate(wide.begin(), wide.end(), 0.0) * 1e9 / double(rays);
    }
};
using Samples = std::vector<Sample>;  ///< all variants on one plan

Samples measure(const Bench& bench, const plans::Plan& plan) {
    const modeler::Building whole = modeler::build(plan);
    std::vector<CutBuilding> cuts;
    for (const modeler::ConvexifyOptions& options : variants()) cuts.push_back(cut_building(whole, options));
    std::vector<const accel::SceneView*> scenes;
    for (const CutBuilding& cut : cuts) scenes.push_back(&cut.scene.view());
    const SameRays rays(scenes, bench.quick() ? 12'000 : 60'000, 0, 1);
    Samples samples(cuts.size());
    std::vector<render::RayHit> hits(rays.ray_count());
    std::vector<std::function<void()>> competitors;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        samples[k].figures = cuts[k].figures;
        samples[k].batches = batches_of(*scenes[k], rays.rays(k));
        for (const Batch& batch : samples[k].batches) {
            competitors.emplace_back(
                [&hits, &batch, scene = scenes[k]] { render::trace_rays(*scene, batch.rays, hits); });
            competitors.emplace_back([&batch, scene = scenes[k]] { narrow_walks(*scene, batch.rays); });
        }
    }
    const Contest contest(bench.quick() ? 5 : 21, competitors);
    std::size_t at = 0;
    for (Sample& sample : samples)
        for (std::size_t b = 0; b < sample.batches.size(); ++b) {
            sample.wide.push_back(contest.median_of(at++));
            sample.narrow.push_back(contest.median_of(at++));
        }
    return samples;
}

/// What is laid beside the times.
struct Model {
    const char* name;
    bool wide;
    std::vector<std::pair<const char*, std::uint64_t WalkCount::*>> parts;
};

const std::vector<Model>& models() {
    static const std::vector<Model> all = {
        {"8 sections at once",
         true,
         {{"a cell", &WalkCount::visits}, {"a section", &WalkCount::sections}, {"a face", &WalkCount::faces}}},
        {"8 sections at once, counted so",
         true,
         {{"a cell", &WalkCount::visits}, {"8 sections", &WalkCount::eights}, {"a face asked", &WalkCount::tested}}},
        {"one section at a time",
         false,
         {{"a cell", &WalkCount::visits}, {"a section", &WalkCount::sections}, {"a face", &WalkCount::faces}}},
    };
    return all;
}

/// Nanoseconds a ray: a constant, and one for each part of the model.
Fit fit_of(std::span<const Samples> studied, const Model& model) {
    std::vector<Measurement> measurements;
    for (const Samples& samples : studied)
        for (const Sample& sample : samples)
            for (std::size_t b = 0; b < sample.batches.size(); ++b) {
                const double rays = double(sample.batches[b].rays.size());
                const double y = (model.wide ? sample.wide : sample.narrow)[b] * 1e9 / rays;
                Measurement measurement{{1}, y, y};
                for (const auto& [name, count] : model.parts)
                    measurement.x.push_back(double(sample.batches[b].count.*count) / rays);
                measurements.push_back(std::move(measurement));
            }
    return fit_constants(measurements);
}

/// Says the fit, and adds its rows where it is over all plans.
void add_fit(Bench& bench, const Model& model, const Fit& fit, const std::string& scene, bool with_rows) {
    std::string text = std::string(model.name) + ": " + scene;
    char number[96];
    std::snprintf(number, sizeof number, ": %.1f ns a ray", fit.constants[0]);
    text += number;
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        const double constant = fit.constants[i + 1];
        std::snprintf(number, sizeof number, ", %.2f (+-%.2f) %s", constant, fit.standard_errors[i + 1],
                      model.parts[i].first);
        text += number;
        if (!with_rows) continue;
        bench.add_silently({.row = std::string("objective, ") + model.name + ": " + model.parts[i].first,
                            .scene = scene,
                            .value = constant,
                            .unit = "ns",
                            .reference = model.parts[0].first,
                            .reference_value = fit.constants[1]});
    }
    std::snprintf(number, sizeof number, "; half of the times within %.1f %%", fit.median_residual * 100);
    bench.remark(text + number);
}

/// How well a figure of a way of cutting tells the time of a ray: both as logarithms, against their mean on the plan.
template <class Figure>
void add_correlation(Bench& bench, const std::vector<Samples>& studied, const char* name, Figure&& figure) {
    std::vector<double> times, figures;
    for (const Samples& samples : studied) {
        double mean_time = 0, mean_figure = 0;
        for (const Sample& sample : samples) {
            mean_time += std::log(sample.time()) / double(samples.size());
            mean_figure += std::log(figure(sample.figures)) / double(samples.size());
        }
        for (const Sample& sample : samples) {
            times.push_back(std::log(sample.time()) - mean_time);
            figures.push_back(std::log(figure(sample.figures)) - mean_figure);
        }
    }
    bench.add({.row = std::string("objective: correlation of time and ") + name,
               .scene = "ways to cut " + counted(studied.size(), "plan"),
               .value = correlation(figures, times),
               .unit = "1"});
}

}  // namespace

void bench_cut_objective(Bench& bench) {
    std::vector<Samples> studied;
    for (const Study& study : studies(bench)) {
        studied.push_back(measure(bench, study.plan));
        for (const Model& model : models())
            add_fit(bench, model, fit_of({&studied.back(), 1}, model), study.name, false);
    }
    const std::string scene =
        counted(studied.size(), "plan") + ", " + std::to_string(variants().size()) + " ways to cut";
    for (const Model& model : models()) add_fit(bench, model, fit_of(studied, model), scene, true);
    const Fit fit = fit_of(studied, models().front());
    const CutCost fitted = {fit.constants[1], fit.constants[2], fit.constants[3]};
    add_correlation(bench, studied, "SAH sum, constants as fitted",
                    [&](const CutFigures& figures) { return figures.sah_sum(fitted); });
    add_correlation(bench, studied, "SAH sum, constants as built in",
                    [](const CutFigures& figures) { return figures.sah_sum({}); });
    add_correlation(bench, studied, "visits alone (surface of the cells)", [](const CutFigures& figures) {
        return figures.sah_sum({1, 0, 0});
    });
    add_correlation(bench, studied, "area of virtual portals",
                    [](const CutFigures& figures) { return std::max(figures.portal_area, 1e-9); });
    add_correlation(bench, studied, "number of cells", [](const CutFigures& figures) { return double(figures.cells); });
}

}  // namespace enfilade::tools
