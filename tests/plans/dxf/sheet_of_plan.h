#pragma once
// A storey as an architect's program would write it to DXF: outlines of walls, swings of doors, panes of windows.

#include <cmath>
#include <string>

#include "plans/layout.h"
#include "plans/read.h"
#include "plans/vector2.h"
#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans::dxf_text {

struct SheetNames {
    const char* wall = "A-WALL";
    const char* door = "A-DOOR";
    const char* window = "A-GLAZ";
    const char* text = nullptr;  ///< where names of rooms stand; null: none are written
    double scale = 1000;         ///< units of the drawing in a metre
    int insunits = 4;
};

/// A point along a straight wall, `left` metres beside its axis.
inline Point beside(const Wall& wall, double along, double left) {
    const Point d = (wall.end - wall.start) * (1 / distance(wall.start, wall.end));
    return wall.start + d * along + turned_left(d) * left;
}

/// The outline of what is solid in the storey's layout: every edge between a wall and what is none.
inline std::string wall_outlines(const Layout& layout, const SheetNames& names) {
    const StoreyLayout& here = layout.storeys[0];
    const auto solid = [&](std::uint32_t half_edge) {
        const OwnerKind kind = here.owner[layout.map.face(half_edge)].kind;
        return kind == OwnerKind::Wall || kind == OwnerKind::Column;
    };
    const auto world = [&](std::uint32_t vertex) {
        const GridPoint p = layout.graph.vertices[vertex];
        return Point{layout.frame.world_x(p.x), layout.frame.world_y(p.y)} * names.scale;
    };
    std::string text;
    for (std::uint32_t e = 0; e < layout.graph.edges.size(); ++e) {
        if (solid(2 * e) == solid(2 * e + 1)) continue;
        const Point a = world(layout.graph.edges[e].a), b = world(layout.graph.edges[e].b);
        text += line(a.x, a.y, b.x, b.y, names.wall);
    }
    return text;
}

inline std::string symbol(const Opening& opening, const Wall& wall, const SheetNames& names) {
    const double half = opening.width / 2, t = wall.thickness / 2;
    const auto at = [&](double along, double left) { return beside(wall, along, left) * names.scale; };
    if (opening.kind == OpeningKind::Window) {
        std::string text;
        for (const double left : {-t / 3, t / 3}) {
            const Point a = at(opening.offset - half, left), b = at(opening.offset + half, left);
            text += line(a.x, a.y, b.x, b.y, names.window);
        }
        return text;
    }
    if (opening.kind == OpeningKind::Opening) return "";
    // Leaves are drawn open to the left: one with its hinge at the start, of wide doors two.
    const auto leaf = [&](double hinge_at, double shut_at) {
        const double width = std::abs(shut_at - hinge_at);
        const Point hinge = at(hinge_at, t), shut = at(shut_at, t), open = at(hinge_at, t + width);
        const Point first = shut_at > hinge_at ? shut : open;
        const double from = std::atan2(first.y - hinge.y, first.x - hinge.x) * 180 / 3.14159265358979323846;
        return line(hinge.x, hinge.y, open.x, open.y, names.door) + entity("ARC", {{8, names.door},
                                                                                   {10, hinge.x},
                                                                                   {20, hinge.y},
                                                                                   {40, width * names.scale},
                                                                                   {50, from},
                                                                                   {51, from + 90}});
    };
    const double low = opening.offset - half, high = opening.offset + half;
    return opening.width <= 1.3 ? leaf(low, high) : leaf(low, opening.offset) + leaf(high, opening.offset);
}

/// The name of each room in the middle of its polygon.
inline std::string room_texts(const Storey& storey, const SheetNames& names) {
    std::string text;
    for (const Room& room : storey.rooms) {
        Point middle{0, 0};
        for (const Point p : room.polygon) middle = middle + p * (names.scale / double(room.polygon.size()));
        text += entity("TEXT", {{8, names.text}, {10, middle.x}, {20, middle.y}, {40, 100}, {1, room.name}});
    }
    return text;
}

/// The first storey of a plan of straight walls.
inline std::string sheet_of(const Plan& plan, const SheetNames& names = {}) {
    const Plan cleaned = clean(plan);
    const Layout layout = arrange(cleaned, {.storeys = {0}});
    std::string text = wall_outlines(layout, names);
    for (const Opening& opening : cleaned.storeys[0].openings)
        for (const Wall& wall : cleaned.storeys[0].walls)
            if (wall.id == opening.wall) text += symbol(opening, wall, names);
    if (names.text != nullptr) text += room_texts(cleaned.storeys[0], names);
    return File{text, {}, pairs({{9, "$INSUNITS"}, {70, names.insunits}})}.text();
}

/// Rooms, doors, windows and plain openings of a plan's first storey, as the exact stage finds them.
struct Contents {
    std::size_t rooms = 0;
    std::size_t doors = 0;
    std::size_t windows = 0;
    std::size_t openings = 0;
    double room_area = 0;
    friend bool operator==(const Contents& l, const Contents& r) {
        return l.rooms == r.rooms && l.doors == r.doors && l.windows == r.windows && l.openings == r.openings;
    }
    friend std::ostream& operator<<(std::ostream& out, const Contents& c) {
        return out << c.rooms << " rooms, " << c.doors << " doors, " << c.windows << " windows, " << c.openings
                   << " openings, " << c.room_area << " m2";
    }
};

inline Contents contents_of(const Plan& plan) {
    const Plan cleaned = clean(plan);
    const Layout layout = arrange(cleaned, {.storeys = {0}});
    Contents contents;
    contents.rooms = layout.storeys[0].rooms.size();
    for (const FoundRoom& room : layout.storeys[0].rooms) contents.room_area += room.area_m2;
    for (const Opening& opening : cleaned.storeys[0].openings)
        (opening.kind == OpeningKind::Door     ? contents.doors
         : opening.kind == OpeningKind::Window ? contents.windows
                                               : contents.openings)++;
    return contents;
}

}  // namespace enfilade::plans::dxf_text
