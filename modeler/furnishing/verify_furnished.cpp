#include "modeler/furnishing/verify_furnished.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/disjoint_sets.h"
#include "modeler/editing/footprint.h"
#include "modeler/furnishing/verify_ways.h"

namespace enfilade::modeler {

using plans::Point;

std::string_view name_of(FurnishingFault fault) {
    switch (fault) {
        case FurnishingFault::Overlap: return "overlap";
        case FurnishingFault::Outside: return "outside its room";
        case FurnishingFault::DoorBlocked: return "before a door";
        case FurnishingFault::WindowBlocked: return "before a window";
        case FurnishingFault::Unreachable: return "way closed";
    }
    return "overlap";
}

namespace {

using Polygon = std::vector<Point>;

constexpr double leaf_rest = 0.03;     // metres under a leaf, and over it, that carpets and lamps may have
constexpr double window_floor = 0.49;  // metres before windows
constexpr double least_area = 0.5;     // square grid units: less is no place

Polygon polygon_of(const Ring& ring, plans::GridPoint origin) {
    Polygon polygon;
    for (const plans::GridPoint p : ring) polygon.push_back({double(p.x) - origin.x, double(p.y) - origin.y});
    return polygon;
}

/// The part of the polygon on the left of the line through p (Sutherland, Hodgman 1974).
Polygon left_of(const Polygon& polygon, Point p, Point way) {
    Polygon result;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        const double sa = plans::cross(way, a - p), sb = plans::cross(way, b - p);
        if (sa >= 0) result.push_back(a);
        if ((sa > 0 && sb < 0) || (sa < 0 && sb > 0)) result.push_back(a + (b - a) * (sa / (sa - sb)));
    }
    return result;
}

double area_of(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) sum += plans::cross(polygon[k], polygon[(k + 1) % polygon.size()]);
    return sum / 2;
}

Polygon common(Polygon polygon, const Polygon& convex) {
    for (std::size_t k = 0; k < convex.size() && !polygon.empty(); ++k)
        polygon = left_of(polygon, convex[k], convex[(k + 1) % convex.size()] - convex[k]);
    return polygon;
}

/// Distance of the origin from a polygon that does not hold it, or 0.
double distance_from(Point p, const Polygon& polygon) {
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        least = std::min(least, plans::distance(p, polygon[k], polygon[(k + 1) % polygon.size()]));
    return least;
}

class RoomVerifier {
public:
    RoomVerifier(const RoomShape& room, const std::vector<CheckedPiece>& pieces) : room_(room), pieces_(pieces) {}

    std::vector<FurnishingViolation> run() {
        for (std::size_t a = 0; a < pieces_.size(); ++a) {
            for (std::size_t b = a + 1; b < pieces_.size(); ++b) check_pair(pieces_[a], pieces_[b]);
            if (!pieces_[a].by_rule) continue;
            check_inside(pieces_[a]);
            for (const RoomOpening& gate : room_.gates)
                if (gate.beyond == Beyond::Door) check_door(pieces_[a], gate);
            for (const RoomOpening& window : room_.windows) check_window(pieces_[a], window);
        }
        for (const std::string& way : closed_ways(room_, pieces_)) add(FurnishingFault::Unreachable, "", way);
        return std::move(found_);
    }

private:
    void add(FurnishingFault fault, const std::string& object, const std::string& other) {
        found_.push_back({fault, room_.space, object, other});
    }

    void check_pair(const CheckedPiece& a, const CheckedPiece& b) {
        if (!a.by_rule && !b.by_rule) return;
        if (a.stands_on == b.id || b.stands_on == a.id) return;
        if (a.z_high <= b.z_low || b.z_high <= a.z_low) return;
        const plans::GridPoint origin = a.footprint.front();
        if (area_of(common(polygon_of(a.footprint, origin), polygon_of(b.footprint, origin))) > least_area)
            add(FurnishingFault::Overlap, a.id, b.id);
    }

    void check_inside(const CheckedPiece& piece) {
        const plans::GridPoint origin = piece.footprint.front();
        const Polygon own = polygon_of(piece.footprint, origin);
        double inside = 0;
        for (const std::vector<RoomSide>& ring : room_.rings) {
            Polygon outline;
            for (const RoomSide& side : ring)
                outline.push_back({double(side.a.x) - origin.x, double(side.a.y) - origin.y});
            inside += area_of(common(std::move(outline), own));
        }
        if (area_of(own) - inside > least_area || piece.z_low < room_.z_floor || piece.z_high > room_.z_ceiling)
            add(FurnishingFault::Outside, piece.id, room_.id);
    }

    /// The part of a footprint before an opening, in its frame: u from jamb to jamb, v into the room. Grid units.
    static Polygon before(const CheckedPiece& piece, const RoomOpening& opening) {
        const Point along = (opening.b - opening.a) * (1 / opening.width);
        Polygon result;
        for (const plans::GridPoint p : piece.footprint) {
            const Point d = Point{double(p.x), double(p.y)} - opening.a;
            result.push_back({plans::dot(d, along), plans::dot(d, opening.inward)});
        }
        result = left_of(result, {0, 0}, {1, 0});
        result = left_of(result, {0, 0}, {0, -1});
        return left_of(result, {opening.width, 0}, {0, 1});
    }

    /// Leaves on either jamb: one of the doorway's width, from 1.3 m on two of half of it, from 2.6 m on none.
    void check_door(const CheckedPiece& piece, const RoomOpening& door) {
        const double metre = 1 / room_.frame.unit;
        if ((piece.z_high - room_.z_floor) <= leaf_rest * metre || piece.z_low >= door.z_high - leaf_rest * metre)
            return;
        const double leaf = door.width < 1.3 * metre ? door.width : door.width < 2.6 * metre ? door.width / 2 : 0;
        const Polygon part = before(piece, door);
        if (part.size() < 3 || area_of(part) <= least_area) return;
        const double nearest = std::min(distance_from({0, 0}, part), distance_from({door.width, 0}, part));
        if (nearest < leaf - 1) add(FurnishingFault::DoorBlocked, piece.id, std::to_string(door.space));
    }

    void check_window(const CheckedPiece& piece, const RoomOpening& window) {
        if (!piece.stands_on.empty() || piece.z_high <= window.z_low || piece.z_low >= window.z_high) return;
        const double depth = window_floor / room_.frame.unit;
        const Polygon part = left_of(before(piece, window), {0, depth}, {-1, 0});
        if (part.size() >= 3 && area_of(part) > least_area)
            add(FurnishingFault::WindowBlocked, piece.id, std::to_string(window.space));
    }

    const RoomShape& room_;
    const std::vector<CheckedPiece>& pieces_;
    std::vector<FurnishingViolation> found_;
};

}  // namespace

std::vector<FurnishingViolation> verify_room(const RoomShape& room, const std::vector<CheckedPiece>& pieces) {
    return RoomVerifier(room, pieces).run();
}

std::vector<FurnishingViolation> verify_furnished(const Building& building, const Furnishing& furnishing) {
    const plans::GridFrame& frame = building.frame;
    std::map<std::uint32_t, std::vector<CheckedPiece>> by_space;
    std::vector<std::pair<std::uint32_t, CheckedPiece>> standing;
    for (const FurnishedObject& object : furnishing.objects) {
        CheckedPiece piece;
        piece.id = object.id;
        piece.footprint = rectangle_footprint(frame, object.position[0], object.position[1], object.size[0],
                                              object.size[1], object.angle);
        const double low = (object.position[2] - frame.origin_z) / frame.unit;
        piece.z_low = std::int32_t(std::floor(low + 1e-6));
        piece.z_high = std::int32_t(std::ceil(low + object.size[2] / frame.unit - 1e-6));
        piece.by_rule = object.by_rule;
        piece.stands_on = object.stands_on;
        if (object.by_rule) by_space[object.space].push_back(std::move(piece));
        else standing.emplace_back(object.space, std::move(piece));
    }
    std::vector<FurnishingViolation> found;
    const RoomShapes shapes(building);
    for (auto& [space, pieces] : by_space) {
        const std::optional<RoomShape> room = shapes.shape(space);
        if (!room) {
            for (const CheckedPiece& piece : pieces) found.push_back({FurnishingFault::Outside, space, piece.id, ""});
            continue;
        }
        // What the plan placed may reach over from the next room.
        for (const auto& [of, piece] : standing)
            if (box_around(piece.footprint).meets(room->floor.box()) && piece.z_low < room->z_ceiling &&
                piece.z_high > room->z_floor)
                pieces.push_back(piece);
        for (FurnishingViolation& violation : verify_room(*room, pieces)) found.push_back(std::move(violation));
    }
    return found;
}

}  // namespace enfilade::modeler
