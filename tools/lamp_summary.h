#pragma once
// The lamps of a scene, for `build` and `info`.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "accel/scene.h"

namespace enfilade::tools {

struct LampSummary {
    std::size_t lamps = 0;
    std::size_t indoors = 0;
    std::size_t outdoors = 0;
    std::size_t in_solids = 0;      ///< they light nothing
    std::size_t without_power = 0;  ///< nor do these
    std::size_t carried = 0;        ///< by an object that throws no shadow of them
    std::size_t dark_rooms = 0;     ///< rooms without a lamp that shines
    double lumen = 0;               ///< of all that shine
};
[[nodiscard]] LampSummary lamp_summary(const accel::SceneView& scene);

/// One sentence; empty without lamps.
[[nodiscard]] std::string lamps_text(const LampSummary& lamps);
/// The object `lamps` of docs/info.schema.json; null without lamps.
[[nodiscard]] nlohmann::ordered_json lamps_json(const LampSummary& lamps);

}  // namespace enfilade::tools
