#include "tools/path_pictures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "plans/number_text.h"
#include "tools/console.h"

namespace enfilade::tools {

namespace {

constexpr int metered_side = 64, metered_samples = 16;
constexpr std::uint32_t usual_direct = 4;
constexpr float usual_clamp = 2;  ///< of pictures for the eye: no dots that are brighter by a single path

[[noreturn]] void refuse(const std::string& sentence) { throw InputError("F161", "", sentence); }

void check_direct(const PathFlags& flags) {
    for (const auto& [is_given, flag] :
         {std::pair(flags.noise.has_value(), "--noise"), std::pair(flags.bounces.has_value(), "--bounces"),
          std::pair(flags.seed.has_value(), "--seed")})
        if (is_given) refuse(std::string(flag) + " is for paths: give --integrator path, too.");
}

void check_path(const RenderOptions& options) {
    if (!options.show.empty())
        refuse("--show " + options.show + " shows what rays cost in place of light: leave out --integrator path.");
    if (!options.tracer.empty() && options.tracer != "scalar")
        refuse("Paths go ray by ray: leave out --tracer " + options.tracer + '.');
    if (options.real == "double") refuse("Paths go in single precision: leave out --real double.");
    if (!options.packets.empty()) refuse("Paths go ray by ray: leave out --packets.");
    const bool has_lamps = !options.lights.search.empty() && options.lights.search != "none";
    if (options.lights.ambient_lux) refuse("Paths bring the light that goes from wall to wall: leave out --ambient.");
    if (!has_lamps && options.shading == "lambert")
        refuse("With --shading lambert lamps shine alone: give --lights tree, or leave out --shading.");
}

}  // namespace

PathChoice path_choice(const RenderOptions& options) {
    const PathFlags& flags = options.path;
    PathChoice choice;
    choice.is_on = flags.integrator == "path";
    if (!choice.is_on) {
        check_direct(flags);
        return choice;
    }
    check_path(options);
    choice.samples = int(options.spp.value_or(std::uint32_t(choice.samples)));
    choice.noise = flags.noise.value_or(0);
    if (!(choice.noise >= 0 && choice.noise <= 1))
        refuse("--noise is a share, from 0 (all samples are taken) to 1: 0.03 shows little of it.");
    choice.bounces = int(flags.bounces.value_or(std::uint32_t(choice.bounces)));
    choice.seed = flags.seed.value_or(0);
    choice.clamp = options.output.extension() == ".exr" ? 0 : usual_clamp;
    return choice;
}

int direct_samples(const RenderOptions& options) {
    const int side = int(std::ceil(std::sqrt(double(options.spp.value_or(usual_direct)))));
    return side * side;
}

PathPictures::PathPictures(const accel::SceneView& scene, const PathChoice& choice, const LightChoice& lights,
                           std::span<const Shot> shots, const render::TraceOptions& how, LitPictures& lit)
    : scene_(scene), choice_(choice), is_exposure_chosen_(lights.exposure_ev.has_value()) {
    const bool are_lit = lit.are_lit();
    const auto expose = [&](double ev) {
        ev_ = ev;
        if (are_lit) lit.expose(ev);
        else daylight_ = std::exp2(daylight_ev - ev);
    };
    // A first exposure, whose white is known.
    expose(lights.exposure_ev.value_or(are_lit ? lit.ev() : daylight_ev));
    if (lights.exposure_ev) return;
    std::vector<render::Image> small;
    for (Shot shot : shots) {
        shot.view.camera = small_camera(shot.view.camera, metered_side);
        render::PathOptions path = options(shot, how, lit);
        path.samples_per_pixel = metered_samples;
        path.noise = 0;
        path.stats = nullptr;
        small.push_back(render::trace_paths(scene, shot.view.camera, path).image);
        if (!lit.is_linear())
            for (float& v : small.back().rgb) v *= static_cast<float>(white_luminance(ev_));
    }
    expose(metered_ev(small, ev_));
}

render::PathOptions PathPictures::options(const Shot& shot, const render::TraceOptions& how,
                                          const LitPictures& lit) const {
    render::TraceOptions trace = how;
    lit.light(trace);
    if (shot.view.cut_z) trace.look.sky_zenith = trace.look.sky_horizon = trace.look.paper;
    render::PathOptions path;
    path.samples_per_pixel = choice_.samples;
    path.most_bounces = choice_.bounces;
    path.noise = choice_.noise;
    path.seed = choice_.seed;
    path.clamp = choice_.clamp;
    path.lamps = trace.lamps.has_value();
    if (trace.lamps) {
        path.search = trace.lamps->search;
        path.exposure = trace.lamps->exposure;
        path.trees = trace.lamps->trees;
    }
    path.look = trace.look;
    path.sky = path.lamps ? (trace.shading == render::Shading::Look ? 1.0f : 0.0f) : static_cast<float>(daylight_);
    path.sun = path.lamps ? 0 : static_cast<float>(daylight_);
    path.mirror_floor = trace.mirror_floor;
    path.start = shot.cell;
    path.cut_z = shot.view.cut_z;
    path.executor = trace.executor;
    path.objects = trace.objects;
    path.stats = trace.stats;
    return path;
}

render::Image PathPictures::picture(const Shot& shot, const render::TraceOptions& how, const LitPictures& lit,
                                    const std::function<void(double, double)>& told) {
    render::PathOptions path = options(shot, how, lit);
    path.progress = [&](const render::PathProgress& at) {
        told(std::max(double(at.samples_done) / double(at.samples_wanted), at.share_finished), at.noise);
        return true;
    };
    render::PathResult result = render::trace_paths(scene_, shot.view.camera, path);
    double samples = 0;
    for (const int count : result.samples) samples += count;
    made_.push_back({samples / double(result.samples.size()), result.noise});
    return lit.is_linear() ? std::move(result.image)
                           : render::under_shoulder(std::move(result.image), path.look.shoulder);
}

std::string PathPictures::text() const {
    double samples = 0, noise = 0;
    for (const Made& made : made_) {
        samples += made.samples / double(made_.size());
        noise = std::max(noise, made.noise.typical);
    }
    return plans::rounded_text(samples, 0) + " samples a pixel, noise " + plans::rounded_text(100 * noise, 1) + " %";
}

nlohmann::ordered_json PathPictures::json() const {
    nlohmann::ordered_json json = {{"most_samples", choice_.samples},
                                   {"wanted_noise", choice_.noise},
                                   {"bounces", choice_.bounces},
                                   {"seed", choice_.seed},
                                   {"clamp", choice_.clamp},
                                   {"exposure_ev", ev_},
                                   {"is_exposure_chosen", is_exposure_chosen_}};
    json["pictures"] = nlohmann::ordered_json::array();
    for (const Made& made : made_)
        json["pictures"].push_back({{"samples", made.samples},
                                    {"noise", made.noise.typical},
                                    {"share_above_5_percent", made.noise.share_above_5},
                                    {"mean_luminance", made.noise.mean_luminance},
                                    {"error_of_the_mean", made.noise.error_of_the_mean}});
    return json;
}

}  // namespace enfilade::tools
