#include "tools/lit_pictures.h"

#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "plans/number_text.h"
#include "tools/bench.h"
#include "tools/console.h"
#include "tools/exposure.h"

namespace enfilade::tools {

namespace {

constexpr double usual_ev = 6;         ///< where nothing in a picture is lit: a room in the evening
constexpr int metered_side = 128;      ///< pixels
constexpr double ambient_share = 0.1;  ///< of white, that a white face in the open has of no lamp

render::Vec3f scaled(double s, render::Vec3f v) { return static_cast<float>(s) * v; }

}  // namespace

LitPictures::LitPictures(const accel::SceneView& scene, const LightChoice& choice, std::span<const Shot> shots,
                         render::TraceOptions how, bool is_linear)
    : choice_(choice), cell_count_(scene.cells.size()), is_linear_(is_linear) {
    if (!choice.search || scene.lights.size() == 0) return;
    lamp_count_ = scene.lights.size();
    for (const accel::Light& light : scene.lights) walled_ += light.cell == none<accel::CellId> ? 1 : 0;
    if (*choice.search != render::LampSearch::Naive)
        seconds_ = seconds_of([&] {
            trees_ = accel::build_light_trees(
                scene, {.trees = *choice.search == render::LampSearch::Tree, .balls = choice.are_balls}, *how.executor);
        });
    if (choice.cluster_error)
        cluster_seconds_ = seconds_of([&] {
            clusters_ = accel::cluster_lights(scene, trees_.view(), {.error = *choice.cluster_error}, *how.executor);
        });
    ev_ = choice.exposure_ev.value_or(usual_ev);
    if (!choice.exposure_ev) meter(lit(scene), shots, how);
}

accel::SceneView LitPictures::lit(accel::SceneView scene) const {
    if (clusters_) scene.lights = clusters_->lights();
    return scene;
}

accel::LightTreesView LitPictures::lists() const { return clusters_ ? clusters_->lists(trees_.view()) : trees_.view(); }

void LitPictures::meter(const accel::SceneView& scene, std::span<const Shot> shots, const render::TraceOptions& how) {
    std::vector<render::Image> small;
    for (const Shot& shot : shots) {
        render::TraceOptions trace = how;
        trace.tracer = render::Tracer::Scalar;
        trace.precision = render::Precision::Float;
        trace.shading = render::Shading::Lambert;
        trace.samples_per_pixel = 1;
        trace.stats = nullptr;
        trace.start = shot.cell;
        trace.cut_z = shot.view.cut_z;
        trace.look.sky_zenith = trace.look.sky_horizon = trace.look.paper = trace.look.cut = {0, 0, 0};
        trace.lamps = lamps(1);
        small.push_back(render::trace(scene, small_camera(shot.view.camera, metered_side), trace));
    }
    ev_ = metered_ev(small, usual_ev);
}

render::LampOptions LitPictures::lamps(double exposure) const {
    render::LampOptions options{.search = *choice_.search, .exposure = static_cast<float>(exposure)};
    if (options.search != render::LampSearch::Naive) options.trees = lists();
    return options;
}

double LitPictures::ambient_lux() const {
    return choice_.ambient_lux.value_or(ambient_share * std::numbers::pi * white_luminance(ev_));
}

void LitPictures::light(render::TraceOptions& trace) const {
    if (!are_lit()) return;
    const double white = white_luminance(ev_);
    trace.lamps = lamps(is_linear_ ? 1 : 1 / white);
    render::Look& look = trace.look;
    const double scale = is_linear_ ? white : 1;
    look.sky_zenith = scaled(scale, {0.010f, 0.016f, 0.034f});
    look.sky_horizon = scaled(scale, {0.034f, 0.044f, 0.072f});
    look.paper = scaled(scale, {0.080f, 0.086f, 0.100f});
    if (is_linear_) look.shoulder = 1;
    if (trace.shading != render::Shading::Look) return;
    const double ambient = ambient_lux() / (std::numbers::pi * white) * scale;
    look.sun = {0, 0, 0};
    look.sun_direction = {0, 0, -1};
    look.headlight = 0;
    look.ambient = scaled(ambient, {0.96f, 0.99f, 1.05f});
}

std::string LitPictures::text() const {
    return counted(lamp_count_, "lamp") + ", exposure " + plans::rounded_text(ev_, 1) + " EV";
}

std::string LitPictures::report() const {
    if (!are_lit()) return {};
    std::string text = "lamps: " + grouped(lamp_count_);
    if (walled_ != 0) text += ", of which " + grouped(walled_) + " in walls light nothing";
    if (*choice_.search != render::LampSearch::Naive) {
        const accel::LightTreesView view = trees_.view();
        text += "; " + plans::rounded_text(double(view.cell_lights.size()) / double(cell_count_), 2) +
                " entries in a cell's list";
        if (*choice_.search == render::LampSearch::Tree)
            text += ", " + counted(view.beams.size(), "beam") + ", " + counted(view.planes.size(), "plane");
        text += ", " + byte_text(double(trees_.bytes())) + ", made in " + time_text(seconds_);
        if (*choice_.search == render::LampSearch::Tree && trees_.lamps_without_tree() != 0)
            text += "; " + counted(trees_.lamps_without_tree(), "lamp") + " of too many ways without a tree";
        if (clusters_) text += cluster_report();
    }
    return text + '\n';
}

std::string LitPictures::cluster_report() const {
    return "\nclusters: " + grouped(clusters_->listed_count()) + "; " +
           plans::rounded_text(double(lists().cell_lights.size()) / double(cell_count_), 2) +
           " entries in a cell's list with them, " + byte_text(double(clusters_->bytes())) + ", made in " +
           time_text(cluster_seconds_);
}

nlohmann::ordered_json LitPictures::json() const {
    if (!are_lit()) return nullptr;
    nlohmann::ordered_json json = {{"search", choice_.name()}, {"lamps", lamp_count_}, {"lamps_in_walls", walled_}};
    json["exposure_ev"] = ev_;
    json["is_exposure_chosen"] = choice_.exposure_ev.has_value();
    json["ambient_lux"] = ambient_lux();
    json["unit"] = is_linear_ ? "candela/m2" : "white";
    json["trees"] = nullptr;
    json["clusters"] = nullptr;
    if (*choice_.search == render::LampSearch::Naive) return json;
    const accel::LightTreesView view = trees_.view();
    json["trees"] = {{"cells", cell_count_},
                     {"cell_lights", view.cell_lights.size()},
                     {"beams", *choice_.search == render::LampSearch::Tree ? view.beams.size() : 0},
                     {"planes", view.planes.size()},
                     {"bytes", trees_.bytes()},
                     {"lamps_without_tree", trees_.lamps_without_tree()},
                     {"seconds", seconds_}};
    if (clusters_)
        json["clusters"] = {{"error", *choice_.cluster_error},
                            {"clusters", clusters_->listed_count()},
                            {"cell_lights", lists().cell_lights.size()},
                            {"bytes", clusters_->bytes()},
                            {"seconds", cluster_seconds_}};
    return json;
}

}  // namespace enfilade::tools
