#include "render/lamp_lists.h"

namespace enfilade::render {

LampLists lamp_lists(const accel::LightTreesView& trees) {
    LampLists lists;
    lists.offsets.push_back(0);
    for (std::size_t c = 0; c + 1 < trees.cell_offsets.size(); ++c) {
        for (std::uint32_t k = trees.cell_offsets[c]; k < trees.cell_offsets[c + 1]; ++k) {
            const accel::LightId light = trees.cell_lights[k].light;
            if (k > trees.cell_offsets[c] && trees.cell_lights[k - 1].light == light) continue;
            lists.lamps.push_back(static_cast<std::uint32_t>(light));
        }
        lists.offsets.push_back(static_cast<std::uint32_t>(lists.lamps.size()));
    }
    return lists;
}

LampLists all_lamps(const accel::SceneView& scene) {
    LampLists lists;
    lists.offsets.push_back(0);
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
        for (std::uint32_t l = 0; l < scene.lights.size(); ++l)
            if (scene.lights[l].cell != none<accel::CellId>) lists.lamps.push_back(l);
        lists.offsets.push_back(static_cast<std::uint32_t>(lists.lamps.size()));
    }
    return lists;
}

}  // namespace enfilade::render
