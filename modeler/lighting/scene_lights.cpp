#include "modeler/lighting/scene_lights.h"

#include <algorithm>

namespace enfilade::modeler {

void add_lights(const Building& building, accel::SceneInput& input) {
    input.lights.reserve(building.lamps.size());
    for (const Lamp& lamp : building.lamps) {
        accel::InputLight light{.id = lamp.id, .name = lamp.name, .position = lamp.position, .radius = lamp.radius};
        for (std::size_t k = 0; k < 3; ++k) light.position[k] -= input.origin[k];
        light.intensity = candela(lamp);
        if (!lamp.carrier.empty()) {
            const auto carrier = std::ranges::lower_bound(input.objects, lamp.carrier, {}, &accel::InputObject::id);
            if (carrier != input.objects.end() && carrier->id == lamp.carrier)
                light.carrier = std::uint32_t(carrier - input.objects.begin());
        }
        input.lights.push_back(std::move(light));
    }
}

}  // namespace enfilade::modeler
