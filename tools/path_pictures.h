#pragma once
// Pictures whose light goes from surface to surface: --integrator path and its flags.

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/path_trace.h"
#include "tools/exposure.h"
#include "tools/lit_pictures.h"

namespace enfilade::tools {

/// What the flags ask for.
struct PathChoice {
    bool is_on = false;
    int samples = 64;  ///< a pixel, at most
    double noise = 0;  ///< at which a part of the picture is good enough; 0: never
    int bounces = 32;
    std::uint64_t seed = 0;
    float clamp = 0;  ///< light that comes by a bounce counts for no more, in parts of white; 0: for all that it is
};

/// Reads and checks the flags, before any work. Throws InputError (F161) with one sentence for what is wrong, or means
/// nothing to paths or without them.
[[nodiscard]] PathChoice path_choice(const RenderOptions& options);

/// Rays a pixel of pictures without paths: --spp, rounded up to a square number.
[[nodiscard]] int direct_samples(const RenderOptions& options);

class PathPictures {
public:
    /// how: sizes, objects, executor, look of the pictures. lit: exposed here, by what small pictures of the shots show
    /// where no exposure is chosen; without lamps sun and sky shine.
    PathPictures(const accel::SceneView& scene, const PathChoice& choice, const LightChoice& lights,
                 std::span<const Shot> shots, const render::TraceOptions& how, LitPictures& lit);

    /// \param told how much of the picture is done (0 to 1) and its noise, from time to time
    [[nodiscard]] render::Image picture(const Shot& shot, const render::TraceOptions& how, const LitPictures& lit,
                                        const std::function<void(double, double)>& told);

    /// "64 samples a pixel, noise 3.1 %"
    [[nodiscard]] std::string text() const;
    [[nodiscard]] nlohmann::ordered_json json() const;

private:
    /// What became of one picture.
    struct Made {
        double samples = 0;  ///< a pixel, on average
        render::PathNoise noise;
    };
    [[nodiscard]] render::PathOptions options(const Shot& shot, const render::TraceOptions& how,
                                              const LitPictures& lit) const;

    const accel::SceneView& scene_;
    PathChoice choice_;
    double daylight_ = 1;  ///< what sun and sky are multiplied by
    double ev_ = daylight_ev;
    bool is_exposure_chosen_ = false;
    std::vector<Made> made_;
};

}  // namespace enfilade::tools
