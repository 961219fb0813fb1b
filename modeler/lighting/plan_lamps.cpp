#include "modeler/lighting/plan_lamps.h"

#include <algorithm>

namespace enfilade::modeler {

std::vector<Lamp> plan_lamps(const plans::Plan& plan, std::span<const StoreyInfo> storeys) {
    std::vector<Lamp> lamps;
    for (std::uint32_t k = 0; k < storeys.size(); ++k) {
        const auto storey = std::ranges::find(plan.storeys, storeys[k].id, &plans::Storey::id);
        if (storey == plan.storeys.end()) continue;
        for (const plans::Light& light : storey->lights)
            lamps.push_back({.id = light.id,
                             .name = light.name,
                             .storey = k,
                             .position = {light.position.x, light.position.y, storey->elevation + light.elevation},
                             .radius = light.radius,
                             .colour = light.colour,
                             .lumen = light.power_lumen,
                             .carrier = light.furniture});
    }
    std::ranges::stable_sort(lamps, {}, &Lamp::id);
    const auto repeated = std::ranges::unique(lamps, {}, &Lamp::id);
    lamps.erase(repeated.begin(), repeated.end());
    return lamps;
}

}  // namespace enfilade::modeler
