#pragma once
// How much a scene holds, and how its cells are joined.

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "accel/scene.h"

namespace enfilade::tools {

struct SceneCounts {
    std::size_t rooms = 0;    ///< spaces labelled Room that have cells
    std::size_t storeys = 0;  ///< that hold rooms
    std::size_t cells = 0;
    std::size_t sections = 0;
    std::size_t side_faces = 0;
    std::size_t portals = 0;
    std::size_t source_faces = 0;
    std::size_t file_bytes = 0;
    std::size_t trace_bytes = 0;
    std::size_t model_bytes = 0;
};

[[nodiscard]] SceneCounts scene_counts(const accel::Scene& scene);
/// "15 rooms on 2 storeys, 812 cells, 1.2 MB"
[[nodiscard]] std::string scene_counts_text(const SceneCounts& counts);
[[nodiscard]] nlohmann::ordered_json scene_counts_json(const SceneCounts& counts);

/// Number of cells of each space. [space_count]
[[nodiscard]] std::vector<std::size_t> cells_per_space(const accel::SceneView& scene);

/// Connected parts of the graph whose nodes are the cells and whose edges are the portals.
[[nodiscard]] std::size_t component_count(const accel::SceneView& scene);

}  // namespace enfilade::tools
