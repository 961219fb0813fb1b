// G6: faults that a plan can have, so the building is built again.

#include <algorithm>
#include <cmath>

#include "modeler/build.h"
#include "modeler/convexify.h"
#include "plans/read.h"
#include "tests/support/face_oracle.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::testing {

void shift_levels(modeler::Building& building, std::int32_t from, std::int32_t by) {
    const auto shift = [&](std::int32_t& z) { z += z >= from ? by : 0; };
    for (auto& p : building.vertices) shift(p[2]);
    for (modeler::Volume& volume : building.volumes) shift(volume.z_low), shift(volume.z_high);
    for (modeler::Face& face : building.faces) shift(face.z_low), shift(face.z_high);
    shift(building.site_min[2]), shift(building.site_max[2]);
    plans::Plan plan = plans::read_json(building.plan_json, "");
    for (modeler::StoreyInfo& storey : building.storeys) {
        for (plans::Storey& of_plan : plan.storeys)
            if (of_plan.id == storey.id && storey.z_floor >= from) of_plan.elevation += by * building.frame.unit;
        shift(storey.z_floor), shift(storey.z_ceiling);
    }
    building.plan_json = plans::write_json(plan);
    for (modeler::Band& band : building.stack.bands) shift(band.z_low), shift(band.z_high);
    for (modeler::Slice& slice : building.stack.slices) shift(slice.z_high);
}

namespace {

/// The slab that is alone between its levels becomes thin: all above it comes down.
std::optional<InjectedFault> thin_slab(modeler::Building& building, plans::Random& random) {
    std::vector<std::uint32_t> alone;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        const modeler::Volume& volume = building.volumes[v];
        if (volume.label == modeler::Label::Slab &&
            std::none_of(building.volumes.begin(), building.volumes.end(), [&](const modeler::Volume& other) {
                return other.label == modeler::Label::Slab && other.space != volume.space &&
                       other.z_high > volume.z_low && other.z_low < volume.z_high;
            }))
            alone.push_back(v);
    }
    if (alone.empty()) return std::nullopt;
    const modeler::Volume slab = building.volumes[alone[random.below(std::uint32_t(alone.size()))]];
    InjectedFault fault{.code = "G6"};
    fault.elements = {{"slab", building.spaces[slab.space].id, ""}};
    for (std::size_t i = 0; i < 3; ++i)
        fault.reach += building.frame.unit * (double(building.site_max[i]) - building.site_min[i]);
    shift_levels(building, slab.z_high, slab.z_low + 10 + std::int32_t(random.below(60)) - slab.z_high);
    return fault;
}

}  // namespace

std::optional<InjectedFault> inject_g6(modeler::Building& building, plans::Random& random) {
    if (random.chance(0.3)) return thin_slab(building, random);
    plans::Plan plan = plans::read_json(building.plan_json, "");
    plans::Storey& storey = plan.storeys[random.below(std::uint32_t(plan.storeys.size()))];
    InjectedFault fault{.code = "G6"};
    // A wall that no door or window needs: these would be thin, too.
    std::vector<plans::Wall*> walls;
    for (plans::Wall& wall : storey.walls)
        if (wall.thickness > 0.02 && std::none_of(storey.openings.begin(), storey.openings.end(),
                                                  [&](const plans::Opening& o) { return o.wall == wall.id; }))
            walls.push_back(&wall);
    if (walls.empty()) return std::nullopt;
    plans::Wall& wall = *walls[random.below(std::uint32_t(walls.size()))];
    wall.thickness = random.uniform(0.002, 0.009);
    fault.elements = {{"wall", wall.id, wall.name}};
    fault.point = {(wall.start.x + wall.end.x) / 2, (wall.start.y + wall.end.y) / 2,
                   storey.elevation + wall.height_at_start / 2};
    const double sweep = std::abs(wall.arc_extent) / 4;
    const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
    fault.reach = length / 2 * (1 + std::tan(std::min(sweep, 1.5))) + wall.height_at_start;
    const bool convex = building.convex;
    building = modeler::build(plan);
    if (convex) building = modeler::convexify(building);
    return fault;
}

}  // namespace enfilade::testing
