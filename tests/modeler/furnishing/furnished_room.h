#pragma once
// Rooms to furnish without a building around them, and what came of it.

#include <cmath>
#include <deque>
#include <string>
#include <vector>

#include "modeler/catalogue/own_pieces.h"
#include "modeler/furnishing/furnish_room.h"
#include "modeler/furnishing/verify_furnished.h"

namespace enfilade::testing {

/// Our own pieces, as a list that outlives the tests.
inline const std::vector<modeler::CatalogueEntry>& own_entries() {
    static const std::vector<modeler::CatalogueEntry> entries = [] {
        std::vector<modeler::CatalogueEntry> list;
        for (const modeler::OwnPiece& piece : modeler::own_pieces()) list.push_back(piece.entry);
        return list;
    }();
    return entries;
}

inline modeler::CatalogueEntry entry(const std::string& kind, double width, double depth, double height) {
    modeler::CatalogueEntry result;
    result.id = "test/" + kind;
    result.name = result.kind = kind;
    result.width = width;
    result.depth = depth;
    result.height = height;
    result.top = height;
    return result;
}

/// A hole in the walls of a room: the side between these shares of side `side` leads there.
struct Hole {
    std::size_t side = 0;
    double from = 0.4;  ///< shares of the side
    double to = 0.6;
    modeler::Beyond beyond = modeler::Beyond::Door;
    double sill = 0;
    double head = 2.1;
};

/// A room over a polygon of metres, counter-clockwise, 2.5 m high.
inline modeler::RoomShape room_of(const std::vector<plans::Point>& corners, const std::vector<Hole>& holes = {},
                                  double height = 2.5) {
    modeler::RoomShape room;
    room.id = "room";
    room.space = 7;
    const double unit = room.frame.unit;
    room.z_ceiling = std::int32_t(std::lround(height / unit));
    room.rings.emplace_back();
    double area = 0;
    plans::Point middle;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const plans::Point a = corners[k], b = corners[(k + 1) % corners.size()];
        area += plans::cross(a, b) / 2;
        middle = middle + a * (1.0 / double(corners.size()));
        const auto at = [&](double share) {
            const plans::Point p = a + (b - a) * share;
            return plans::GridPoint{std::int32_t(std::lround(p.x / unit)), std::int32_t(std::lround(p.y / unit))};
        };
        double done = 0;
        const auto add = [&](double to, modeler::Beyond beyond, double sill, double head) {
            if (to <= done) return;
            modeler::RoomSide side;
            side.a = at(done);
            side.b = at(to);
            side.beyond = beyond;
            side.space = beyond == modeler::Beyond::Wall ? UINT32_MAX : std::uint32_t(100 + k);
            side.z_low = std::int32_t(std::lround(sill / unit));
            side.z_high = std::int32_t(std::lround(head / unit));
            side.wall_top = beyond == modeler::Beyond::Wall ? room.z_ceiling : side.z_low;
            room.rings.back().push_back(side);
            done = to;
        };
        for (const Hole& hole : holes) {
            if (hole.side != k) continue;
            add(hole.from, modeler::Beyond::Wall, 0, 0);
            add(hole.to, hole.beyond, hole.sill, hole.head);
        }
        add(1, modeler::Beyond::Wall, 0, 0);
    }
    room.area_m2 = area;
    room.middle = middle * (1 / unit);
    modeler::complete(room);
    return room;
}

inline std::vector<plans::Point> rectangle(double width, double depth) {
    return {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
}

/// The pieces as the verifier takes them: "kind-number".
inline std::vector<modeler::CheckedPiece> checked(const modeler::RoomShape& room, const modeler::RoomLayout& layout) {
    std::vector<modeler::CheckedPiece> pieces;
    const auto id = [&](std::size_t k) { return layout.pieces[k].entry->kind + "-" + std::to_string(k); };
    const modeler::Occupancy occupancy(room);
    for (std::size_t k = 0; k < layout.pieces.size(); ++k) {
        const modeler::RoomPiece& piece = layout.pieces[k];
        const modeler::Body body =
            occupancy.body(*piece.entry, piece.pose, piece.z_low - room.z_floor, piece.size[0], piece.size[1]);
        pieces.push_back({id(k), body.ring, piece.z_low, body.z_high, true, ""});
        if (piece.carrier != UINT32_MAX) pieces.back().stands_on = id(piece.carrier);
    }
    return pieces;
}

/// What the verifier finds, in words.
inline std::string faults(const modeler::RoomShape& room, const std::vector<modeler::CheckedPiece>& pieces) {
    std::string text;
    for (const modeler::FurnishingViolation& violation : modeler::verify_room(room, pieces))
        text += std::string(name_of(violation.fault)) + ": " + violation.object + " " + violation.other + "\n";
    return text;
}

inline modeler::RoomLayout furnished(const modeler::RoomShape& room, const std::string& rules,
                                     const std::vector<modeler::CatalogueEntry>& entries, std::uint64_t seed = 1) {
    // The layout points to its entries: they live as long as the program.
    static std::deque<std::vector<modeler::CatalogueEntry>> kept;
    kept.push_back(entries);
    const modeler::Rules read = modeler::read_rules_text(rules, "rules");
    return modeler::furnish_room(room, read.rooms.at(0), read.temperature, modeler::EntryLists(kept.back()), {}, seed);
}

inline const modeler::RoomPiece* find(const modeler::RoomLayout& layout, const std::string& kind) {
    for (const modeler::RoomPiece& piece : layout.pieces)
        if (piece.entry->kind == kind) return &piece;
    return nullptr;
}

}  // namespace enfilade::testing
