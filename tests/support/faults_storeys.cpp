// T8.

#include "plans/read.h"
#include "tests/support/fault_place.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::testing {

using modeler::Building;
using modeler::Label;

std::optional<InjectedFault> inject_t8(Building& building, plans::Random& random) {
    if (random.chance(0.2)) {
        plans::Plan plan = plans::read_json(building.plan_json, "");
        const std::uint32_t k = random.below(std::uint32_t(building.storeys.size()));
        for (plans::Storey& storey : plan.storeys)
            if (storey.id == building.storeys[k].id) storey.elevation += random.uniform(0.01, 0.5);
        const auto room = pick(building, random, [&](std::uint32_t v) {
            return building.volumes[v].label == Label::Room && building.spaces[building.volumes[v].space].storey == k;
        });
        if (!room) return std::nullopt;
        building.plan_json = plans::write_json(plan);
        InjectedFault fault = fault_at(building, "T8", *room);
        fault.elements = {{"storey", building.storeys[k].id, ""}};
        fault.reach = site_diagonal(building);  // the whole storey is the place
        return fault;
    }
    // A slab on or under which something of a storey lies.
    const auto slab = pick(building, random, [&](std::uint32_t v) { return building.volumes[v].label == Label::Slab; });
    if (!slab) return std::nullopt;
    InjectedFault fault = fault_at(building, "T8", *slab);
    const Label label = std::array{Label::Wall, Label::Ground, Label::Exterior}[random.below(3)];
    const auto as = pick(building, random, [&](std::uint32_t v) { return building.volumes[v].label == label; });
    if (!as) return std::nullopt;
    const std::uint32_t parent = building.volumes[*slab].parent, space = building.volumes[*as].space;
    for (modeler::Volume& piece : building.volumes)
        if (piece.parent == parent) piece.label = label, piece.space = space;
    return fault;
}

}  // namespace enfilade::testing
