// The dial: what each value of each option costs in time and memory, and what it errs. Errors are measured on the same
// rays, in the frame of the plan, against the finest value of the option.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "accel/locate.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "tools/bench_dial.h"
#include "tools/contest.h"
#include "tools/convexifiers.h"
#include "tools/cut_building.h"
#include "tools/random_rays.h"

namespace enfilade::tools {

namespace {

using render::Vec3d;

struct Built {
    accel::Scene scene;
    double seconds = 0;
    double moved_mm = 0;  ///< largest distance that a wall was moved by rounding
};

Built build_scene(const plans::Plan& plan, const plans::ArrangeOptions& arrange,
                  modeler::Convexifier convexifier = modeler::Convexifier::Sah) {
    Built built;
    built.seconds = median_seconds(3, [&] {
        modeler::BuildOptions options;
        options.arrange = arrange;
        const modeler::Building building =
            modeler::convexify(modeler::build(plan, options), {.convexifier = convexifier});
        built.moved_mm = building.max_deviation * building.frame.unit * 1000;
        built.scene = modeler::export_scene(building, modeler::check(building), "{}");
    });
    return built;
}

Vec3d origin_of(const accel::SceneView& scene) { return {scene.origin[0], scene.origin[1], scene.origin[2]}; }

/// What a ray of the plan's frame sees.
struct Seen {
    std::string space;
    accel::Surface surface = accel::Surface::Sky;
    double distance = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the ray starts in a wall
};

Seen see(const accel::SceneView& scene, Vec3d origin, Vec3d direction) {
    const Vec3d local = origin - origin_of(scene);
    const std::optional<accel::CellId> cell = accel::locate(scene, {local.x, local.y, local.z});
    if (!cell) return {};
    const render::RayHit hit = render::trace_ray(scene, {local, direction, *cell}, render::Precision::Double);
    if (hit.status != render::WalkStatus::Hit) return {};
    const accel::SourceFace& face = scene.source_faces[index(hit.source_face)];
    return {std::string(scene.string(scene.spaces[index(face.space)].id)), face.surface, hit.distance};
}

/// How far two scenes of one plan differ for the same rays.
struct Error {
    double wrong_per_million = 0;  ///< rays that see another space or another kind of surface
    double median_mm = 0;          ///< of the distances of the others
    double worst_mm = 0;           ///< of 99 % of them
};

Error error_between(const accel::SceneView& scene, const accel::SceneView& reference, std::size_t count) {
    RandomRays rays(reference, 5);
    std::vector<double> errors;
    std::size_t wrong = 0;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const render::RayQuery ray = rays.next();
        const Vec3d origin = ray.origin + origin_of(reference);
        const Seen right = see(reference, origin, ray.direction);
        const Seen seen = see(scene, origin, ray.direction);
        if (std::isnan(right.distance) || std::isnan(seen.distance)) continue;
        ++compared;
        if (seen.space != right.space || seen.surface != right.surface) ++wrong;
        else errors.push_back(std::abs(seen.distance - right.distance) * 1000);
    }
    std::sort(errors.begin(), errors.end());
    Error error;
    if (compared == 0 || errors.empty()) return error;
    error.wrong_per_million = double(wrong) * 1e6 / double(compared);
    error.median_mm = errors[errors.size() / 2];
    error.worst_mm = errors[errors.size() * 99 / 100];
    return error;
}

std::string label(const char* option, double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %.4g", option, value);
    return text;
}

/// The rows of one value of an option.
void add_rows(Bench& bench, const std::string& setting, const std::string& scene, const Built& built,
              const Error& error) {
    const auto add = [&](const char* what, double value, const char* unit) {
        bench.add({.row = setting + ": " + what, .scene = scene, .value = value, .unit = unit});
    };
    add("time", built.seconds, "s");
    add("memory", double(built.scene.bytes().size()) / 1e6, "MB");
    add("cells", double(built.scene.view().cells.size()), "cells");
    add("moved", built.moved_mm, "mm");
    add("other surface", error.wrong_per_million, "per million");
    add("distance, median", error.median_mm, "mm");
    add("distance, 99 of 100", error.worst_mm, "mm");
}

/// The ways to cut rooms. Errors are against Hertel and Mehlhorn's: rays see the same, however rooms are cut.
void dial_convexify(Bench& bench, const plans::Plan& plan, const std::string& name, std::size_t rays) {
    std::vector<Built> built;
    std::vector<const accel::SceneView*> scenes;
    std::size_t reference = 0;
    for (const NamedConvexifier& method : named_convexifiers) {
        if (method.convexifier == modeler::Convexifier::HertelMehlhorn) reference = built.size();
        built.push_back(build_scene(plan, {}, method.convexifier));
    }
    for (const Built& one : built) scenes.push_back(&one.scene.view());
    SameRays same(scenes, bench.quick() ? 50'000 : 1'000'000, 0, 1);
    const Contest contest(bench.quick() ? 3 : 9, same.random());
    for (std::size_t k = 0; k < built.size(); ++k) {
        const std::string setting = std::string("convexify ") + named_convexifiers[k].name;
        add_rows(bench, setting, name, built[k], error_between(*scenes[k], *scenes[reference], rays));
        BenchRow speed{.row = setting + ": speed",
                       .scene = name,
                       .value = double(same.ray_count()) / contest.median_of(k) / 1e6,
                       .unit = "Mrays/s"};
        if (k != reference) {
            speed.reference = named_convexifiers[reference].name;
            speed.reference_value = double(same.ray_count()) / contest.median_of(reference) / 1e6;
            speed.ratio = contest.faster(k, reference);
        }
        bench.add(std::move(speed));
    }
}

void dial_snap(Bench& bench, const plans::Plan& plan, const std::string& name, std::size_t rays) {
    plans::ArrangeOptions finest;
    finest.snap_mm = 1000.0 / 65536;
    const Built reference = build_scene(plan, finest);
    for (int power = 15; power >= 5; power -= bench.quick() ? 4 : 2) {
        plans::ArrangeOptions arrange;
        arrange.snap_mm = std::ldexp(1000.0, -power);
        arrange.snap_fixed = true;
        const Built built = build_scene(plan, arrange);
        add_rows(bench, label("snap_mm", arrange.snap_mm), name, built,
                 error_between(built.scene.view(), reference.scene.view(), rays));
    }
}

void dial_sagitta(Bench& bench, const plans::Plan& plan, const std::string& name, std::size_t rays) {
    plans::ArrangeOptions finest;
    finest.sagitta_mm = 0.05;
    const Built reference = build_scene(plan, finest);
    std::vector<double> values = {0.5, 2, 8, 32};
    if (!bench.quick()) values = {0.2, 0.5, 1, 2, 4, 8, 16, 32, 64};
    for (const double sagitta : values) {
        plans::ArrangeOptions arrange;
        arrange.sagitta_mm = sagitta;
        const Built built = build_scene(plan, arrange);
        add_rows(bench, label("sagitta_mm", sagitta), name, built,
                 error_between(built.scene.view(), reference.scene.view(), rays));
    }
}

}  // namespace

void bench_dial(Bench& bench) {
    const OneCore one_core;
    const plans::Plan plan = plans::generate({.rooms = 46, .curved = 0.25, .oblique = 0.25});
    const std::string name = "46 rooms, 1/4 curved";
    const std::size_t rays = bench.quick() ? 20'000 : 500'000;
    dial_snap(bench, plan, name, rays);
    dial_sagitta(bench, plan, name, rays);
    dial_convexify(bench, plan, name, rays);
    const Built rooms = build_scene(plan, {});
    dial_tracers(bench, rooms.scene.view(), name);
    dial_objects(bench);
    dial_octrees(bench);
    dial_lights(bench);
    dial_device(bench, rooms.scene.view(), name);
}

}  // namespace enfilade::tools
