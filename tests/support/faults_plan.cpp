// S2 ... S5: what the model lacks of its plan.

#include <algorithm>
#include <cmath>

#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/cutting/polygon.h"
#include "plans/read.h"
#include "plans/vector2.h"
#include "tests/support/fault_place.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::testing {

using modeler::Building;
using modeler::Direction;
using modeler::Face;
using modeler::Label;
using modeler::Volume;

namespace {

ElementRef element(const Building& building, std::uint32_t volume) {
    return {"", building.spaces[building.volumes[volume].space].id, ""};
}

void relabel(Building& building, std::uint32_t volume, std::uint32_t space) {
    const std::uint32_t parent = building.volumes[volume].parent;
    for (Volume& piece : building.volumes)
        if (piece.parent == parent) piece.space = space, piece.label = building.spaces[space].label;
}

/// The volumes beside each volume, across side faces.
std::vector<std::vector<std::uint32_t>> neighbours(const Building& building) {
    std::vector<std::vector<std::uint32_t>> beside(building.volumes.size());
    for (const Face& face : building.faces) {
        if (face.direction != Direction::Side) continue;
        beside[face.front].push_back(face.back);
        beside[face.back].push_back(face.front);
    }
    return beside;
}

bool is_convex(const Building& building, std::uint32_t piece) {
    const modeler::Piece& row = building.pieces[piece];
    std::vector<modeler::RingCorner> ring;
    for (std::uint32_t k = 0; k < row.corner_count; ++k) {
        const modeler::Corner& corner = building.corners[row.first_corner + k];
        ring.push_back({building.points[corner.vertex], corner.line});
    }
    return !modeler::reflex_corner(ring);
}

/// The plan says that the opening is in another wall, elsewhere.
std::optional<InjectedFault> opening_in_another_wall(Building& building, plans::Random& random) {
    plans::Plan plan = plans::read_json(building.plan_json, "");
    std::vector<plans::Opening*> openings;
    std::vector<const plans::Storey*> storeys;
    for (plans::Storey& storey : plan.storeys)
        for (plans::Opening& opening : storey.openings)
            if (opening.kind != plans::OpeningKind::Opening) openings.push_back(&opening), storeys.push_back(&storey);
    if (openings.empty()) return std::nullopt;
    const std::uint32_t o = random.below(std::uint32_t(openings.size()));
    plans::Opening& opening = *openings[o];
    std::vector<const plans::Wall*> others;
    for (const plans::Wall& wall : storeys[o]->walls)
        if (wall.id != opening.wall && wall.arc_extent == 0 &&
            plans::distance(wall.start, wall.end) > opening.offset + opening.width)
            others.push_back(&wall);
    if (others.empty()) return std::nullopt;
    const plans::Wall& wall = *others[random.below(std::uint32_t(others.size()))];
    opening.wall = wall.id;
    const plans::Point at =
        wall.start + (wall.end - wall.start) * (opening.offset / plans::distance(wall.start, wall.end));
    InjectedFault fault{.code = "S2", .elements = {{"", opening.id, ""}}, .reach = 0.01};
    fault.point = {at.x, at.y, storeys[o]->elevation + (opening.sill + opening.head) / 2};
    building.plan_json = plans::write_json(plan);
    return fault;
}

/// The plan has the opening further along its wall.
std::optional<InjectedFault> opening_elsewhere(Building& building, plans::Random& random) {
    plans::Plan plan = plans::read_json(building.plan_json, "");
    std::vector<std::pair<plans::Storey*, plans::Opening*>> openings;
    for (plans::Storey& storey : plan.storeys)
        for (plans::Opening& opening : storey.openings) openings.emplace_back(&storey, &opening);
    if (openings.empty()) return std::nullopt;
    auto& [storey, opening] = openings[random.below(std::uint32_t(openings.size()))];
    const auto v = pick(building, random, [&, id = opening->id](std::uint32_t u) {
        return building.spaces[building.volumes[u].space].id == id;
    });
    if (!v) return std::nullopt;
    InjectedFault fault = fault_at(building, "S2", *v);
    fault.elements = {{"", opening->id, ""}};
    const double by = random.uniform(0.05, 0.3) * (random.chance(0.5) ? 1 : -1);
    opening->offset += by;
    fault.reach += std::abs(by);
    building.plan_json = plans::write_json(plan);
    return fault;
}

}  // namespace

std::optional<InjectedFault> inject_s2(Building& building, plans::Random& random) {
    return random.chance(0.5) ? opening_in_another_wall(building, random) : opening_elsewhere(building, random);
}

/// A wall between a room and something else becomes air, ground, or part of the room.
std::optional<InjectedFault> inject_s3(Building& building, plans::Random& random) {
    const auto beside = neighbours(building);
    const auto beside_of = [&](std::uint32_t v, Label label) {
        return std::find_if(beside[v].begin(), beside[v].end(),
                            [&](std::uint32_t u) { return building.volumes[u].label == label; });
    };
    // Walls without openings: an opening in it would lose its wall, which is S2.
    const auto wall = pick(building, random, [&](std::uint32_t v) {
        if (building.volumes[v].label != Label::Wall || beside_of(v, Label::Room) == beside[v].end()) return false;
        const modeler::StoreyInfo& storey = building.storeys[building.spaces[building.volumes[v].space].storey];
        // Splinters where walls meet are nobody's wall.
        const auto [low, high] = box_of(building, building.volumes[v].piece);
        if (building.frame.unit * std::max(high.x - low.x, high.y - low.y) < 0.8) return false;
        if (building.convex && !is_convex(building, building.volumes[v].piece)) return false;
        if (building.volumes[v].z_low != storey.z_floor || building.volumes[v].z_high != storey.z_ceiling) return false;
        return beside_of(v, Label::Door) == beside[v].end() && beside_of(v, Label::Window) == beside[v].end() &&
               beside_of(v, Label::Opening) == beside[v].end();
    });
    if (!wall) return std::nullopt;
    const std::uint32_t room = *beside_of(*wall, Label::Room);
    InjectedFault fault = fault_at(building, "S3", *wall);
    const bool parts_rooms = std::any_of(beside[*wall].begin(), beside[*wall].end(), [&](std::uint32_t u) {
        return building.volumes[u].label == Label::Room && building.volumes[u].space != building.volumes[room].space;
    });
    // One room on one side of it, and nothing but walls and that room around it: one fault is one pair of spaces.
    std::vector<std::uint32_t> rooms;
    for (const std::uint32_t u : beside[*wall])
        if (carries_light(building.volumes[u].label)) rooms.push_back(building.volumes[u].space);
    std::sort(rooms.begin(), rooms.end());
    rooms.erase(std::unique(rooms.begin(), rooms.end()), rooms.end());
    if (parts_rooms && rooms.size() == 2 && rooms.front() > 2) {
        relabel(building, *wall, building.volumes[room].space);
        fault.elements = {{"", building.spaces[rooms[0]].id, ""}, {"", building.spaces[rooms[1]].id, ""}};
        return fault;
    }
    rooms.erase(std::remove(rooms.begin(), rooms.end(), modeler::exterior_space), rooms.end());
    if (rooms.size() != 1) return std::nullopt;
    fault.elements = {element(building, room)};
    relabel(building, *wall, random.chance(0.5) ? modeler::ground_space : modeler::exterior_space);
    return fault;
}

namespace {

std::uint32_t built_storey(const Building& building, const std::string& id) {
    for (std::uint32_t k = 0; k < building.storeys.size(); ++k)
        if (building.storeys[k].id == id) return k;
    return UINT32_MAX;
}

}  // namespace

/// The slab closes over a stair, or the stair's flight is filled, or the plan has one more stair than the model.
std::optional<InjectedFault> inject_s4(Building& building, plans::Random& random) {
    if (random.chance(0.3) && building.storeys.size() > 1) {
        plans::Plan plan = plans::read_json(building.plan_json, "");
        const std::uint32_t at = random.below(std::uint32_t(plan.storeys.size() - 1));
        plans::Storey& storey = plan.storeys[at];
        const std::uint32_t k = built_storey(building, storey.id);
        if (k + 1 >= building.storeys.size() || building.storeys[k + 1].id != plan.storeys[at + 1].id)
            return std::nullopt;
        const double x = random.uniform(0, 10), y = random.uniform(0, 10);
        storey.stairs.push_back({"extra stair", "", {{x, y}, {x + 1, y}, {x + 1, y + 2}, {x, y + 2}}});
        building.plan_json = plans::write_json(plan);
        return InjectedFault{.code = "S4",
                             .point = {x + 0.5, y + 1, building.frame.world_z(building.storeys[k].z_ceiling)},
                             .elements = {{"stair", "extra stair", ""}},
                             .reach = 0.01};
    }
    const auto well = pick(building, random, [&](std::uint32_t v) {
        const modeler::Space& space = building.spaces[building.volumes[v].space];
        return space.label == Label::Stair && space.id.ends_with("/slab");
    });
    if (!well) return std::nullopt;
    const std::string& id = building.spaces[building.volumes[*well].space].id;
    InjectedFault fault = fault_at(building, "S4", *well);
    fault.reach += 0.5;
    fault.elements = {{"stair", id.substr(0, id.size() - 5), ""}};
    const auto slab = pick(building, random, [&](std::uint32_t v) {
        return building.volumes[v].label == Label::Slab && building.volumes[v].z_low == building.volumes[*well].z_low;
    });
    if (!slab) return std::nullopt;
    const std::uint32_t space = building.volumes[*well].space;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].space == space) relabel(building, v, building.volumes[*slab].space);
    return fault;
}

namespace {

/// What surrounds one room.
struct Ways {
    std::vector<std::uint32_t> doors;  ///< spaces
    bool others = false;               ///< openings, stairs, other rooms
    bool windows = false;
    bool outside = false;  ///< one of the doors leads to the exterior
};

Ways ways_of(const Building& building, std::uint32_t space, const std::vector<std::vector<std::uint32_t>>& beside) {
    Ways ways;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        if (building.volumes[v].space != space) continue;
        for (const std::uint32_t w : beside[v]) {
            const Volume& other = building.volumes[w];
            if (other.space == space) continue;
            ways.windows = ways.windows || other.label == Label::Window;
            ways.others = ways.others ||
                          (carries_light(other.label) && other.label != Label::Window && other.label != Label::Door);
            if (other.label != Label::Door) continue;
            if (std::find(ways.doors.begin(), ways.doors.end(), other.space) == ways.doors.end())
                ways.doors.push_back(other.space);
            for (const std::uint32_t u : beside[w])
                ways.outside = ways.outside || building.volumes[u].label == Label::Exterior;
        }
    }
    return ways;
}

/// The box around all volumes of a space.
InjectedFault fault_at_space(const Building& building, std::string code, std::uint32_t space) {
    std::vector<InjectedFault> parts;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].space == space) parts.push_back(fault_at(building, code, v));
    InjectedFault fault = parts.front();
    for (const InjectedFault& part : parts)
        fault.reach = std::max(fault.reach,
                               part.reach + std::hypot(part.point[0] - fault.point[0], part.point[1] - fault.point[1],
                                                       part.point[2] - fault.point[2]));
    return fault;
}

}  // namespace

std::optional<InjectedFault> inject_s5(Building& building, plans::Random& random) {
    const auto beside = neighbours(building);
    const bool second_exterior = random.chance(0.5);
    std::vector<bool> over_stair(building.spaces.size(), false);
    for (const Face& face : building.faces)
        if (building.volumes[face.back].label == Label::Stair) over_stair[building.volumes[face.front].space] = true;
    const auto room = pick(building, random, [&](std::uint32_t v) {
        if (building.volumes[v].label != Label::Room || over_stair[building.volumes[v].space]) return false;
        const Ways ways = ways_of(building, building.volumes[v].space, beside);
        if (ways.others || ways.outside) return false;
        return second_exterior ? !ways.windows && !ways.doors.empty() : ways.doors.size() == 1;
    });
    if (!room) return std::nullopt;
    const std::uint32_t space = building.volumes[*room].space;
    InjectedFault fault = fault_at_space(building, "S5", space);
    if (second_exterior) {
        for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
            if (building.volumes[v].space == space)
                building.volumes[v].label = Label::Exterior, building.volumes[v].space = modeler::exterior_space;
        return fault;
    }
    fault.elements = {{"room", building.spaces[space].id, ""}};
    const std::string door = building.spaces[ways_of(building, space, beside).doors.front()].id;
    plans::Plan plan = plans::read_json(building.plan_json, "");
    for (plans::Storey& storey : plan.storeys)
        for (plans::Opening& opening : storey.openings)
            if (opening.id == door) opening.kind = plans::OpeningKind::Window;
    const bool is_convex = building.convex;
    building = modeler::build(plan);
    if (is_convex) building = modeler::convexify(building);
    return fault;
}

}  // namespace enfilade::testing
