// G9: a corner of a curved wall is moved off its circle, in the map and in the tables alike.

#include <algorithm>
#include <cmath>
#include <set>

#include "modeler/cutting/polygon.h"
#include "plans/outline.h"
#include "plans/read.h"
#include "plans/vector2.h"
#include "tests/support/face_oracle.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::testing {
namespace {

using modeler::Building;
using modeler::Label;

/// The walls, by space, among what stands at a point of the plan.
std::set<std::uint32_t> walls_at(const Building& building, const FaceOracle& oracle,
                                 const std::vector<std::uint32_t>& vertices) {
    std::set<std::uint32_t> spaces;
    for (const std::uint32_t v : vertices)
        for (const std::uint32_t f : oracle.faces_at(v))
            for (const std::uint32_t volume : oracle.faces()[f].volumes)
                if (building.volumes[volume].label == Label::Wall) spaces.insert(building.volumes[volume].space);
    return spaces;
}

/// Whether a piece with this point is convex, and has no line that passes straight through the point.
bool pieces_allow(const Building& building, std::uint32_t point) {
    for (const modeler::Piece& piece : building.pieces) {
        std::vector<modeler::RingCorner> ring;
        bool has_point = false;
        for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
            const modeler::Corner& corner = building.corners[piece.first_corner + k];
            const modeler::Corner& before =
                building.corners[piece.first_corner + (k + piece.corner_count - 1) % piece.corner_count];
            ring.push_back({building.points[corner.vertex], corner.line});
            if (corner.vertex != point) continue;
            has_point = true;
            if (corner.line == before.line) return false;
        }
        if (has_point && building.convex && modeler::reflex_corner(ring)) return false;
    }
    return true;
}

}  // namespace

std::optional<InjectedFault> inject_g9(Building& building, plans::Random& random) {
    const FaceOracle oracle(building);
    const plans::Plan plan = plans::read_json(building.plan_json, "");
    std::vector<const plans::Wall*> curved;
    for (const plans::Storey& storey : plan.storeys)
        for (const plans::Wall& wall : storey.walls)
            if (wall.arc_extent != 0) curved.push_back(&wall);
    for (int k = 0; k < 100 && !curved.empty(); ++k) {
        const plans::Wall& wall = *curved[random.below(std::uint32_t(curved.size()))];
        const plans::WallAxis axis(wall.start, wall.end, wall.arc_extent, building.frame.unit / 4);
        const std::uint32_t p = random.below(std::uint32_t(building.points.size()));
        const plans::GridPoint before = building.points[p];
        const plans::Point at{building.frame.world_x(before.x), building.frame.world_y(before.y)};
        const double share = axis.nearest(at);
        if (axis.straight() || share < 0.15 || share > 0.85 ||
            std::abs(plans::distance(at, axis.at(share)) - wall.thickness / 2) > 0.001) {
            if (random.chance(0.99)) --k;  // most points are no corners of this wall
            continue;
        }
        std::vector<std::uint32_t> over;
        for (std::uint32_t v = 0; v < building.vertices.size(); ++v)
            if (building.vertices[v][0] == before.x && building.vertices[v][1] == before.y) over.push_back(v);
        const std::set<std::uint32_t> walls = walls_at(building, oracle, over);
        if (walls.size() != 1 || building.spaces[*walls.begin()].id != wall.id) continue;
        const double by = random.uniform(0.0028, 0.008) * (random.chance(0.5) ? 1 : -1);
        const plans::Point to = at + axis.normal(share) * by;
        const plans::GridPoint moved = building.frame.grid(to.x, to.y);
        const auto put = [&](plans::GridPoint place) {
            building.points[p] = place;
            for (const std::uint32_t v : over) building.vertices[v] = {place.x, place.y, building.vertices[v][2]};
        };
        put(moved);
        bool is_simple = true;
        double z_low = HUGE_VAL, z_high = -HUGE_VAL;
        for (const std::uint32_t v : over) {
            is_simple = is_simple && oracle.is_alone(v);
            z_low = std::min(z_low, oracle.world(v)[2]), z_high = std::max(z_high, oracle.world(v)[2]);
            for (const std::uint32_t f : oracle.faces_at(v)) is_simple = is_simple && oracle.is_simple(f);
        }
        if (is_simple && pieces_allow(building, p)) {
            InjectedFault fault{.code = "G9", .point = {to.x, to.y, (z_low + z_high) / 2}};
            fault.elements = {{"wall", wall.id, wall.name}};
            fault.reach = (z_high - z_low) / 2 + 0.01;
            return fault;
        }
        put(before);
    }
    return std::nullopt;
}

}  // namespace enfilade::testing
