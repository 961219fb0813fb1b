#include "modeler/exports/fittings.h"

#include <algorithm>

#include "plans/read.h"

namespace enfilade::modeler {

Fittings fittings(const Building& building) {
    Fittings result;
    result.storeys = building.storeys;
    if (building.plan_json.empty()) return result;
    const plans::Plan plan = plans::read_json(building.plan_json, building.name);
    const plans::GridFrame& frame = building.frame;
    for (std::uint32_t k = 0; k < building.storeys.size(); ++k) {
        const auto storey = std::find_if(plan.storeys.begin(), plan.storeys.end(),
                                         [&](const plans::Storey& s) { return s.id == building.storeys[k].id; });
        if (storey == plan.storeys.end()) continue;
        const auto place = [&](plans::Point p, double elevation) {
            return std::array{p.x - frame.origin_x, p.y - frame.origin_y,
                              storey->elevation + elevation - frame.origin_z};
        };
        for (const plans::Furniture& piece : storey->furniture) {
            if (!(piece.width > 0 && piece.depth > 0 && piece.height > 0)) continue;
            result.furniture.push_back({piece.id,
                                        piece.name,
                                        piece.model,
                                        k,
                                        place(piece.position, piece.elevation),
                                        piece.angle,
                                        {piece.width, piece.depth, piece.height},
                                        piece.mirrored,
                                        piece.colour});
        }
    }
    return result;
}

}  // namespace enfilade::modeler
