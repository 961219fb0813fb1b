#pragma once
// What --lights, --exposure, --ambient and --light-clusters ask for.

#include <optional>
#include <string>

#include "render/lamps.h"
#include "tools/commands.h"

namespace enfilade::tools {

/// How the scene's lamps light a picture.
struct LightChoice {
    std::optional<render::LampSearch> search;  ///< nothing: they do not
    std::optional<double> exposure_ev;         ///< nothing: by the picture
    std::optional<double> ambient_lux;         ///< nothing: by the exposure
    std::optional<double> cluster_error;       ///< LightClusterOptions::error; nothing: no clusters
    bool are_balls = false;                    ///< lamps shine with all of their ball, as paths follow them
    /// As --lights takes it.
    [[nodiscard]] const char* name() const;
};

/// Reads and checks the flags, before any work. Throws InputError (F160) with one sentence for what is wrong, means
/// nothing without lamps, or has none: a mesh, the oracle, --show.
[[nodiscard]] LightChoice light_choice(const RenderOptions& options);

}  // namespace enfilade::tools
