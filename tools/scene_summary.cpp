#include "tools/scene_summary.h"

#include <nlohmann/json.hpp>
#include <set>

#include "accel/stats.h"
#include "tools/console.h"

namespace enfilade::tools {

namespace {
/// How many storeys hold rooms.
std::size_t storey_count(const accel::SceneView& scene) {
    std::set<std::uint32_t> storeys;
    for (const accel::Space& space : scene.spaces)
        if (space.label == accel::Label::Room) storeys.insert(space.storey_index);
    return storeys.size();
}
}  // namespace

std::string scene_counts_text(const accel::Scene& scene) {
    const accel::SceneStats stats = accel::stats(scene);
    return counted(stats.rooms, "room") + " on " + counted(storey_count(scene.view()), "storey") + ", " +
           counted(stats.cells, "cell") + ", " + byte_text(double(scene.bytes().size()));
}

nlohmann::ordered_json scene_counts_json(const accel::Scene& scene) {
    const accel::SceneStats stats = accel::stats(scene);
    return {{"rooms", stats.rooms},
            {"storeys", storey_count(scene.view())},
            {"cells", stats.cells},
            {"sections", stats.sections},
            {"side_faces", stats.side_faces},
            {"portals", stats.portals},
            {"source_faces", stats.source_faces},
            {"file_bytes", scene.bytes().size()},
            {"trace_bytes", stats.trace_bytes},
            {"model_bytes", stats.model_bytes}};
}

}  // namespace enfilade::tools
