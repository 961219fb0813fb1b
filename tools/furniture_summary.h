#pragma once
// What stands in a scene, for `info`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "accel/scene.h"
#include "accel/stats.h"

namespace enfilade::tools {

/// Rooms with the number of objects of each model, most first, then meshes, triangles and bytes; empty without objects.
[[nodiscard]] std::string furniture_text(const accel::SceneView& scene, const accel::SceneStats& stats);
/// The object `furniture` of docs/info.schema.json; null without objects.
[[nodiscard]] nlohmann::ordered_json furniture_json(const accel::SceneView& scene, const accel::SceneStats& stats);

}  // namespace enfilade::tools
