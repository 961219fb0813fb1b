#include "tools/light_flags.h"

#include <charconv>
#include <cmath>

#include "base/error.h"
#include "tools/exposure.h"
#include "tools/mesh_scene.h"

namespace enfilade::tools {

namespace {

constexpr double most_ambient = 1e6;  ///< lux; ten suns

[[noreturn]] void refuse(const std::string& sentence) { throw InputError("F160", "", sentence); }

/// The number that is all of `text`.
std::optional<double> number(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<double> parse_exposure(const std::string& text) {
    if (text.empty() || text == "auto") return std::nullopt;
    const std::optional<double> ev = number(text);
    if (!ev || *ev < darkest_ev || *ev > brightest_ev)
        refuse("--exposure \"" + text +
               "\" is none: give auto, or an exposure value from -20 to 30: 5 to 7 suit rooms lit by lamps.");
    return ev;
}

void check_lit(const RenderOptions& options) {
    if (options.tracer == "oracle") refuse("The oracle knows no lamp but the one at the eye: leave out --lights.");
    if (!options.show.empty())
        refuse("--show " + options.show + " shows what rays cost in place of light: leave out --lights.");
    if (is_mesh_file(options.scene)) refuse("A mesh by itself has no lamps: leave out --lights.");
}

void check_clusters(const LightChoice& choice) {
    if (!choice.cluster_error) return;
    if (*choice.search == render::LampSearch::Naive)
        refuse("--lights naive asks each lamp by itself: give --lights tree or pvs, or leave out --light-clusters.");
    if (!(*choice.cluster_error >= 0 && *choice.cluster_error < 1))
        refuse("--light-clusters is how large clusters may be for their distance, from 0 to under 1: 0.1 is fine.");
}

}  // namespace

const char* LightChoice::name() const {
    if (!search) return "none";
    if (*search == render::LampSearch::Naive) return "naive";
    return *search == render::LampSearch::Pvs ? "pvs" : "tree";
}

LightChoice light_choice(const RenderOptions& options) {
    const LightFlags& flags = options.lights;
    LightChoice choice;
    if (flags.search.empty() || flags.search == "none") {
        if (flags.ambient_lux) refuse("--ambient is for pictures lit by lamps: give --lights tree, too.");
        if (flags.clusters)
            refuse("--light-clusters is for pictures lit by lamps: give --lights tree or --lights pvs, too.");
        if (!flags.exposure.empty() && options.path.integrator != "path")
            refuse(
                "--exposure is for pictures lit by lamps or by paths: give --lights tree or --integrator path, too.");
        choice.exposure_ev = parse_exposure(flags.exposure);
        return choice;
    }
    check_lit(options);
    choice.search = flags.search == "naive" ? render::LampSearch::Naive
                    : flags.search == "pvs" ? render::LampSearch::Pvs
                                            : render::LampSearch::Tree;
    choice.exposure_ev = parse_exposure(flags.exposure);
    choice.are_balls = options.path.integrator == "path";
    choice.ambient_lux = flags.ambient_lux;
    if (choice.ambient_lux && !(*choice.ambient_lux >= 0 && *choice.ambient_lux <= most_ambient))
        refuse("--ambient is lux, from 0 to 1000000: 10 suit a room whose lamps give 100.");
    if (choice.ambient_lux && options.shading == "lambert")
        refuse("With --shading lambert lamps shine alone: leave out --ambient.");
    choice.cluster_error = flags.clusters;
    check_clusters(choice);
    return choice;
}

}  // namespace enfilade::tools
