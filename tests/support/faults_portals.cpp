// D2: portals of the tables against the map.

#include "tests/support/fault_place.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::testing {

using modeler::Building;
using modeler::Face;
using modeler::Label;

std::optional<InjectedFault> inject_d2(Building& building, plans::Random& random) {
    std::vector<std::uint32_t> portals;
    for (std::uint32_t f = 0; f < building.faces.size(); ++f)
        if (carries_light(building.volumes[building.faces[f].front].label) &&
            carries_light(building.volumes[building.faces[f].back].label))
            portals.push_back(f);
    if (portals.empty()) return std::nullopt;
    Face& face = building.faces[portals[random.below(std::uint32_t(portals.size()))]];
    const bool in_front = random.chance(0.5);
    InjectedFault fault = fault_at(building, "D2", in_front ? face.back : face.front);
    const auto other = pick(building, random, [&](std::uint32_t u) {
        return u + 1 < building.volumes.size() && u != face.front && u != face.back &&
               building.volumes[u].label != Label::Outside;
    });
    (in_front ? face.front : face.back) = *other;
    return fault;
}

}  // namespace enfilade::testing
