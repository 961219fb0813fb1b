// The panels of a scene's own storeys, with what their cuts come to.

#include <algorithm>

#include "tools/console.h"
#include "tools/cut_summary.h"
#include "tools/report/cut_sheet.h"
#include "tools/report/html_text.h"

namespace enfilade::tools {

std::vector<CutPanel> storey_panels(const accel::SceneView& scene, std::span<const SceneStorey> storeys) {
    const std::vector<SpaceCuts> cuts = cuts_per_space(scene);
    std::vector<CutPanel> panels;
    for (const SceneStorey& storey : storeys) {
        std::size_t rooms = 0, cells = 0, least = SIZE_MAX, most = 0;
        double area = 0;
        for (std::size_t s = 0; s < cuts.size(); ++s) {
            if (scene.spaces[s].label != accel::Label::Room || scene.spaces[s].storey_index != storey.index) continue;
            ++rooms, cells += cuts[s].cells, area += cuts[s].cut_area_m2;
            least = std::min(least, cuts[s].cells), most = std::max(most, cuts[s].cells);
        }
        CutPanel panel{&scene, storey, "Storey " + storey.name, {}};
        panel.lines.push_back(counted(rooms, "room") + " of " + counted(cells, "cell") + ": " +
                              decimal(double(cells) / double(std::max<std::size_t>(rooms, 1)), 1) + " a room, " +
                              std::to_string(least) + " to " + std::to_string(most));
        panel.lines.push_back(area_text(area) + " of cuts in rooms");
        panels.push_back(std::move(panel));
    }
    return panels;
}

}  // namespace enfilade::tools
