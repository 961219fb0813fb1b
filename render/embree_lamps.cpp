#include "render/embree_lamps.h"

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

std::string text(const EmbreeLitWay& way) {
    return text(way.primary) + "; shadow rays" + (way.coherent_shadows ? " coherent," : "") + " from " +
           (way.from_lamps ? "lamps" : "places");
}

std::vector<EmbreeLitWay> embree_lit_ways() {
    std::vector<EmbreeLitWay> ways;
    for (const EmbreeWay primary : embree_ways) {
        if (!primary.coherent) continue;
        for (const bool coherent : {false, true})
            for (const bool from_lamps : {false, true}) ways.push_back({primary, coherent, from_lamps});
    }
    return ways;
}

}  // namespace enfilade::render
