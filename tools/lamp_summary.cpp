#include "tools/lamp_summary.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "modeler/lighting/lamp.h"
#include "tools/console.h"

namespace enfilade::tools {

LampSummary lamp_summary(const accel::SceneView& scene) {
    LampSummary sum;
    std::vector<char> is_lit(scene.spaces.size(), 0);
    for (const accel::Light& light : scene.lights) {
        ++sum.lamps;
        sum.carried += light.carrier != none<accel::ObjectId>;
        const double lumen = 4 * std::numbers::pi * modeler::luminance(light.intensity);
        if (light.cell == none<accel::CellId>) {
            ++sum.in_solids;
            continue;
        }
        const accel::Cell& cell = scene.cells[index(light.cell)];
        ++(cell.label == accel::Label::Exterior ? sum.outdoors : sum.indoors);
        if (!(lumen > 0)) {
            ++sum.without_power;
            continue;
        }
        sum.lumen += lumen;
        is_lit[index(cell.space)] = 1;
    }
    for (std::size_t s = 0; s < is_lit.size(); ++s)
        sum.dark_rooms += scene.spaces[s].label == accel::Label::Room && is_lit[s] == 0;
    return sum;
}

std::string lamps_text(const LampSummary& lamps) {
    if (lamps.lamps == 0) return {};
    std::string text =
        counted(lamps.lamps, "lamp") + " of " + grouped((unsigned long long)(std::llround(lamps.lumen))) +
        " lumen in all: " + grouped(lamps.indoors) + " in rooms, " + grouped(lamps.outdoors) + " outside";
    if (lamps.in_solids > 0) text += ", " + grouped(lamps.in_solids) + " in solids or off the site, lighting nothing";
    if (lamps.without_power > 0) text += "; " + grouped(lamps.without_power) + " without power";
    if (lamps.carried > 0) text += "; " + grouped(lamps.carried) + " in furniture";
    if (lamps.dark_rooms > 0)
        text += "; " + counted(lamps.dark_rooms, "room") + (lamps.dark_rooms == 1 ? " has" : " have") + " none";
    return text + '.';
}

nlohmann::ordered_json lamps_json(const LampSummary& lamps) {
    if (lamps.lamps == 0) return nullptr;
    return {{"lamps", lamps.lamps},
            {"indoors", lamps.indoors},
            {"outdoors", lamps.outdoors},
            {"in_solids", lamps.in_solids},
            {"without_power", lamps.without_power},
            {"carried", lamps.carried},
            {"dark_rooms", lamps.dark_rooms},
            {"lumen", lamps.lumen}};
}

}  // namespace enfilade::tools
