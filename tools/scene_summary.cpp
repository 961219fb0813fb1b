#include "tools/scene_summary.h"

#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "tools/console.h"

namespace enfilade::tools {

SceneCounts scene_counts(const accel::Scene& scene) {
    const accel::SceneView& view = scene.view();
    SceneCounts counts;
    std::set<std::uint32_t> storeys;
    const std::vector<std::size_t> cells = cells_per_space(view);
    for (std::size_t s = 0; s < cells.size(); ++s) {
        if (cells[s] == 0 || view.spaces[s].label != accel::Label::Room) continue;
        ++counts.rooms;
        storeys.insert(view.spaces[s].storey_index);
    }
    counts.storeys = storeys.size();
    counts.cells = view.cells.size();
    counts.sections = view.section_count();
    counts.side_faces = view.side_faces.size();
    counts.portals = view.portals.size();
    counts.source_faces = view.source_face_count();
    counts.file_bytes = scene.bytes().size();
    for (const accel::SceneArray& array : scene.arrays()) {
        if (array.group == accel::Group::Trace) counts.trace_bytes += array.bytes.size();
        if (array.group == accel::Group::Model) counts.model_bytes += array.bytes.size();
    }
    return counts;
}

std::string scene_counts_text(const SceneCounts& counts) {
    return counted(counts.rooms, "room") + " on " + counted(counts.storeys, "storey") + ", " +
           counted(counts.cells, "cell") + ", " + byte_text(double(counts.file_bytes));
}

nlohmann::ordered_json scene_counts_json(const SceneCounts& counts) {
    return {{"rooms", counts.rooms},
            {"storeys", counts.storeys},
            {"cells", counts.cells},
            {"sections", counts.sections},
            {"side_faces", counts.side_faces},
            {"portals", counts.portals},
            {"source_faces", counts.source_faces},
            {"file_bytes", counts.file_bytes},
            {"trace_bytes", counts.trace_bytes},
            {"model_bytes", counts.model_bytes}};
}

std::vector<std::size_t> cells_per_space(const accel::SceneView& scene) {
    std::vector<std::size_t> counts(scene.spaces.size());
    for (const accel::Cell& cell : scene.cells) ++counts[index(cell.space)];
    return counts;
}

std::size_t component_count(const accel::SceneView& scene) {
    std::vector<std::uint32_t> parent(scene.cells.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&parent](std::uint32_t cell) {
        while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
        return cell;
    };
    std::size_t components = parent.size();
    for (const accel::Portal& portal : scene.portals) {
        const std::uint32_t a = root(std::uint32_t(index(portal.front)));
        const std::uint32_t b = root(std::uint32_t(index(portal.back)));
        if (a == b) continue;
        parent[a] = b;
        --components;
    }
    return components;
}

}  // namespace enfilade::tools
