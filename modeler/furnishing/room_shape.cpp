#include "modeler/furnishing/room_shape.h"

#include <algorithm>
#include <cmath>

#include "modeler/outline.h"

namespace enfilade::modeler {

using plans::GridPoint;
using plans::Point;

namespace {

constexpr double step_over = 0.3;       ///< metres: people step over sills up to this height
constexpr double least_passage = 1.5;   ///< metres of height that people pass through
constexpr double low_furniture = 0.45;  ///< metres: what is lower stands before windows down to the floor, too

Point place(GridPoint p) { return {double(p.x), double(p.y)}; }

}  // namespace

RoomShapes::RoomShapes(const Building& building) : building_(building), parts_(space_parts(building)) {
    part_of_space_.assign(building.spaces.size(), UINT32_MAX);
    for (std::uint32_t k = 0; k < parts_.size(); ++k) {
        std::uint32_t& best = part_of_space_[parts_[k].space];
        if (best == UINT32_MAX || area_m2(building, parts_[k]) > area_m2(building, parts_[best])) best = k;
    }
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s) {
        const Space& space = building.spaces[s];
        const bool named = space.label == Label::Exterior && s != exterior_space && !space.kind.empty();
        if (part_of_space_[s] != UINT32_MAX && (space.label == Label::Room || named)) spaces_.push_back(s);
    }
    first_face_.assign(building.edges.size() + 1, 0);
    for (const Face& face : building.faces)
        if (face.direction == Direction::Side) ++first_face_[face.edge + 1];
    for (std::size_t e = 0; e < building.edges.size(); ++e) first_face_[e + 1] += first_face_[e];
    faces_of_edge_.resize(first_face_.back());
    std::vector<std::uint32_t> slot(first_face_.begin(), first_face_.end() - 1);
    for (std::uint32_t f = 0; f < building.faces.size(); ++f)
        if (building.faces[f].direction == Direction::Side) faces_of_edge_[slot[building.faces[f].edge]++] = f;
}

RoomSide RoomShapes::side_of(std::uint32_t half_edge, const SpacePart& part) const {
    RoomSide side;
    side.a = building_.points[start_of(building_, half_edge)];
    side.b = building_.points[start_of(building_, half_edge ^ 1)];
    const double unit = building_.frame.unit;
    const std::uint32_t edge = half_edge / 2;
    side.wall_top = part.z_high;
    for (std::uint32_t k = first_face_[edge]; k < first_face_[edge + 1]; ++k) {
        const Face& face = building_.faces[faces_of_edge_[k]];
        const bool front = building_.volumes[face.front].space == part.space;
        const bool back = building_.volumes[face.back].space == part.space;
        if (front == back) continue;
        const Volume& other = building_.volumes[front ? face.back : face.front];
        if (face.z_low >= part.z_high || face.z_high <= part.z_low) continue;
        const bool solid = other.label == Label::Wall || other.label == Label::Slab || other.label == Label::Ground ||
                           other.label == Label::Outside || other.label == Label::Object;
        if (solid) continue;
        side.wall_top = std::min(side.wall_top, std::max(face.z_low, part.z_low));
        const bool walkable = (face.z_low - part.z_low) * unit <= step_over &&
                              (face.z_high - std::max(face.z_low, part.z_low)) * unit >= least_passage;
        Beyond beyond = Beyond::Edge;
        if (other.label == Label::Window) beyond = Beyond::Window;
        else if (other.label == Label::Door && walkable) beyond = Beyond::Door;
        else if (other.label == Label::Opening && walkable) beyond = Beyond::Opening;
        else if (other.label == Label::Stair && walkable) beyond = Beyond::Opening;
        else if (other.label == Label::Room && walkable) beyond = Beyond::Border;
        else if (!walkable) beyond = Beyond::Window;  // a gap over a low wall: nothing high stands before it
        // Where several lie above each other, people's way counts most.
        if (side.beyond != Beyond::Wall && !is_passage(beyond)) continue;
        side.beyond = beyond;
        side.space = other.space;
        side.z_low = face.z_low;
        side.z_high = face.z_high;
    }
    return side;
}

std::optional<RoomShape> RoomShapes::shape(std::uint32_t space) const {
    if (space >= part_of_space_.size() || part_of_space_[space] == UINT32_MAX) return std::nullopt;
    const SpacePart& part = parts_[part_of_space_[space]];
    const Space& from = building_.spaces[space];
    RoomShape room;
    room.space = space;
    room.id = from.id;
    room.name = from.name;
    room.kind = from.kind;
    room.frame = building_.frame;
    room.z_floor = part.z_low;
    room.z_ceiling = part.z_high;
    room.open_to_sky = from.label == Label::Exterior;
    const auto add = [&](const HalfEdgeRing& ring) {
        room.rings.emplace_back();
        for (const std::uint32_t h : ring) room.rings.back().push_back(side_of(h, part));
    };
    add(part.outer);
    for (const HalfEdgeRing& hole : part.holes) add(hole);
    const std::array<double, 2> middle = label_point(building_, part);
    room.middle = {(middle[0] - room.frame.origin_x) / room.frame.unit,
                   (middle[1] - room.frame.origin_y) / room.frame.unit};
    room.area_m2 = area_m2(building_, part);
    complete(room);
    add_sweeps_next_door(room);
    return room;
}

namespace {

/// Grows [from, to] of the chord by `beside` to both sides, and reaches from the wall into the room.
Ring before(const RoomOpening& opening, double from, double to, double depth) {
    const Point along = {opening.inward.y, -opening.inward.x};  // from a to b
    const auto corner = [&](double u, double v) {
        const Point p = opening.a + along * u + opening.inward * v;
        return GridPoint{std::int32_t(std::lround(p.x)), std::int32_t(std::lround(p.y))};
    };
    const double behind = -depth / 8;  // curved walls recede between the ends of the chord
    return {corner(from, behind), corner(to, behind), corner(to, depth), corner(from, depth)};
}

/// The floor that stays free before a gate or window: see docs/furnishing.md, "Guarantees".
void set_keep_free(RoomOpening& opening, double unit) {
    const double metre = 1 / unit, w = opening.width;
    const double beside = std::max(0.05 * metre, 0.4 * metre - w / 2);
    if (opening.beyond == Beyond::Window) {
        opening.keep_free = before(opening, 0, w, 0.5 * metre);
    } else if (opening.beyond == Beyond::Door) {
        // One leaf turns with the radius of the doorway, two with half of it, wider doors slide.
        const double leaf = w < 1.3 * metre ? w : w < 2.6 * metre ? w / 2 : 0;
        opening.keep_free = before(opening, -beside, w + beside, std::max(leaf + 0.02 * metre, 0.8 * metre));
    } else {
        const double half = std::clamp(w / 2 + beside, 0.4 * metre, 0.6 * metre);
        opening.keep_free = before(opening, w / 2 - half, w / 2 + half, 0.8 * metre);
    }
}

/// Sides that hang together, lead to the same space and hardly turn are one gate or window.
void add_openings(const RoomShape& room, const std::vector<RoomSide>& ring, std::vector<RoomOpening>& gates,
                  std::vector<RoomOpening>& windows) {
    const std::size_t n = ring.size();
    const auto continues = [&](const RoomSide& first, const RoomSide& a, const RoomSide& b) {
        if (a.beyond != b.beyond || a.space != b.space || a.b != b.a) return false;
        const Point da = place(first.b) - place(first.a), db = place(b.b) - place(b.a);
        return plans::dot(da, db) > 0.5 * plans::norm(da) * plans::norm(db);
    };
    std::size_t start = 0;
    while (start < n && n > 1 && continues(ring[start], ring[(start + n - 1) % n], ring[start])) ++start;
    if (start == n) start = 0;
    for (std::size_t k = 0; k < n;) {
        const RoomSide& first = ring[(start + k) % n];
        std::size_t last = k;
        while (last + 1 < n && continues(first, ring[(start + last) % n], ring[(start + last + 1) % n])) ++last;
        RoomOpening opening{
            first.beyond, first.space, place(first.a), place(ring[(start + last) % n].b), {}, 0, 0, 0, {}};
        opening.z_low = first.z_low;
        opening.z_high = first.z_high;
        const Point along = opening.b - opening.a;
        opening.width = plans::norm(along);
        k = last + 1;
        if (!(opening.width > 0)) continue;
        opening.inward = plans::turned_left(along) * (1 / opening.width);
        if (!is_passage(first.beyond) && first.beyond != Beyond::Window) continue;
        if (first.beyond == Beyond::Window) {
            const auto low = std::int32_t(low_furniture / room.frame.unit);
            opening.z_low = std::max(opening.z_low, room.z_floor + low);
        }
        set_keep_free(opening, room.frame.unit);
        (first.beyond == Beyond::Window ? windows : gates).push_back(std::move(opening));
    }
}

}  // namespace

void complete(RoomShape& room) {
    std::vector<FloorSide> sides;
    room.gates.clear();
    room.windows.clear();
    for (const std::vector<RoomSide>& ring : room.rings) {
        for (const RoomSide& side : ring) sides.push_back({side.a, side.b});
        add_openings(room, ring, room.gates, room.windows);
    }
    room.floor = Floor(std::move(sides));
}

/// Leaves of doors of the next room reach over an open border into this one.
void RoomShapes::add_sweeps_next_door(RoomShape& room) const {
    std::vector<std::uint32_t> neighbours;
    for (const RoomOpening& gate : room.gates)
        if (gate.beyond == Beyond::Border && part_of_space_[gate.space] != UINT32_MAX) neighbours.push_back(gate.space);
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (const std::uint32_t space : neighbours) {
        const SpacePart& part = parts_[part_of_space_[space]];
        RoomShape other;
        other.frame = room.frame;
        other.z_floor = part.z_low;
        other.rings.emplace_back();
        for (const std::uint32_t h : part.outer) other.rings.back().push_back(side_of(h, part));
        std::vector<RoomOpening> gates, windows;
        add_openings(other, other.rings.back(), gates, windows);
        for (RoomOpening& gate : gates)
            if (gate.beyond == Beyond::Door && box_around(gate.keep_free).meets(room.floor.box())) {
                gate.beyond = Beyond::Edge;  // no way of this room, but a place to keep free
                room.gates.push_back(std::move(gate));
            }
    }
}

}  // namespace enfilade::modeler
