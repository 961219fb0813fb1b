#pragma once
// How much a scene holds, in a line or as JSON.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "accel/scene.h"

namespace enfilade::tools {

/// "15 rooms on 2 storeys, 812 cells, 1.2 MB"
[[nodiscard]] std::string scene_counts_text(const accel::Scene& scene);
/// The object `counts` of docs/info.schema.json.
[[nodiscard]] nlohmann::ordered_json scene_counts_json(const accel::Scene& scene);

}  // namespace enfilade::tools
