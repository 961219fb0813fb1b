// S6.

#include <cmath>

#include "modeler/constraints/wall_bodies.h"
#include "plans/read.h"
#include "plans/vector2.h"
#include "tests/support/fault_place.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::testing {

using modeler::Building;
using plans::Point;

namespace {

/// A tall box that nothing but `why` touches.
plans::Furniture box(Point at, double angle, double width, double depth) {
    plans::Furniture piece;
    piece.id = "misplaced";
    piece.position = at;
    piece.angle = angle;
    piece.width = width;
    piece.depth = depth;
    piece.height = 1.5;
    return piece;
}

/// Straight walls of a storey, long enough, with their share at which no opening is near.
struct Spot {
    plans::Storey* storey;
    const plans::Wall* wall;
    Point at;      ///< on the axis
    Point normal;  ///< unit, to the left
    double angle;  ///< of the wall
};

std::vector<Spot> spots(plans::Plan& plan) {
    std::vector<Spot> found;
    for (plans::Storey& storey : plan.storeys)
        for (const plans::Wall& wall : storey.walls) {
            const double length = plans::distance(wall.start, wall.end);
            if (wall.arc_extent != 0 || length < 2) continue;
            for (double along = 0.8; along < length - 0.8; along += 0.4) {
                bool is_free = true;
                for (const plans::Opening& opening : storey.openings)
                    is_free = is_free &&
                              (opening.wall != wall.id || std::abs(opening.offset - along) > 1.5 * opening.width + 0.5);
                if (!is_free) continue;
                const Point direction = (wall.end - wall.start) * (1 / length);
                found.push_back({&storey, &wall, wall.start + direction * along, plans::turned_left(direction),
                                 std::atan2(direction.y, direction.x)});
            }
        }
    return found;
}

InjectedFault fault_of(const plans::Storey& storey, const plans::Furniture& piece) {
    InjectedFault fault{.code = "S6", .elements = {{"furniture", piece.id, ""}}};
    fault.point = {piece.position.x, piece.position.y, storey.elevation + piece.height / 2};
    fault.reach = std::hypot(piece.width, piece.depth, piece.height) / 2;
    return fault;
}

/// No other wall and no door within 1.2 m of a place.
bool is_clear(const plans::Storey& storey, const plans::Wall* wall, Point at) {
    for (const plans::Wall& other : storey.walls) {
        const plans::WallAxis axis = modeler::axis_of(other);
        if (&other != wall && plans::distance(at, axis.at(axis.nearest(at))) < other.thickness / 2 + 0.7) return false;
        for (const plans::Opening& opening : storey.openings)
            if (opening.wall == other.id &&
                plans::distance(at, axis.at(opening.offset / axis.length())) < 1.2 * opening.width + 0.8)
                return false;
    }
    return true;
}

}  // namespace

std::optional<InjectedFault> inject_s6(Building& building, plans::Random& random) {
    plans::Plan plan = plans::read_json(building.plan_json, "");
    const auto all = spots(plan);
    const std::uint32_t reason = random.below(3);
    std::vector<Spot> usable;
    for (const Spot& spot : all) {
        const double out = spot.wall->thickness / 2 + (reason == 0 ? 0.1 : 0.4);
        if (is_clear(*spot.storey, spot.wall, spot.at + spot.normal * out)) usable.push_back(spot);
    }
    if (usable.empty()) return std::nullopt;
    const Spot spot = usable[random.below(std::uint32_t(usable.size()))];
    plans::Furniture piece;
    if (reason == 2) {  // in the way of a door: right in front of it
        std::vector<const plans::Opening*> doors;
        for (const plans::Opening& opening : spot.storey->openings)
            if (opening.kind == plans::OpeningKind::Door && opening.width < 1.3 && opening.width > 0.6)
                doors.push_back(&opening);
        if (doors.empty()) return std::nullopt;
        const plans::Opening& door = *doors[random.below(std::uint32_t(doors.size()))];
        for (const plans::Wall& wall : spot.storey->walls) {
            if (wall.id != door.wall) continue;
            const plans::WallAxis axis = modeler::axis_of(wall);
            const double t = door.offset / axis.length();
            const Point normal = axis.normal(t);
            const double side = random.chance(0.5) ? 1 : -1;
            const Point at = axis.offset(t, side * (wall.thickness / 2 + 0.45));
            piece = box(at, std::atan2(normal.y, normal.x), 0.4, 0.4);
        }
    } else {
        const double depth = 0.5, in_wall = reason == 0 ? random.uniform(0.09, 0.13) : -0.05;
        const Point at = spot.at + spot.normal * (spot.wall->thickness / 2 + depth / 2 - in_wall);
        piece = box(at, spot.angle, 0.6, depth);
        if (reason == 0 && spot.wall->thickness < in_wall) return std::nullopt;
        if (reason == 1) {
            plans::Furniture twin = piece;
            twin.id = "twin";
            twin.position = twin.position + Point{0.02, 0.01};
            spot.storey->furniture.push_back(twin);
        }
    }
    spot.storey->furniture.push_back(piece);
    building.plan_json = plans::write_json(plan);
    return fault_of(*spot.storey, piece);
}

}  // namespace enfilade::testing
