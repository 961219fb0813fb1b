#pragma once
// Plans for the tests of the arrangement, and what every layout must satisfy.

#include <cstdint>
#include <string>
#include <vector>

#include "base/id.h"
#include "plans/layout.h"
#include "plans/plan.h"
#include "plans/read.h"

namespace enfilade::plans::testing {

inline Wall wall(std::string id, Point a, Point b, double thickness = 0.25, double arc = 0) {
    Wall result;
    result.id = std::move(id);
    result.start = a;
    result.end = b;
    result.thickness = thickness;
    result.arc_extent = arc;
    return result;
}

inline Room room(std::string id, std::vector<Point> polygon, std::string kind = "room") {
    Room result;
    result.id = id;
    result.name = std::move(id);
    result.kind = std::move(kind);
    result.polygon = std::move(polygon);
    return result;
}

inline std::vector<Point> box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline void add_box(Storey& storey, const std::string& prefix, double x0, double y0, double x1, double y1,
                    double thickness = 0.25) {
    const std::vector<Point> p = box(x0, y0, x1, y1);
    for (std::size_t i = 0; i < 4; ++i)
        storey.walls.push_back(wall(prefix + std::to_string(i), p[i], p[(i + 1) % 4], thickness));
}

inline Opening opening(std::string id, std::string host, double offset, double width) {
    Opening result;
    result.id = std::move(id);
    result.wall = std::move(host);
    result.offset = offset;
    result.width = width;
    return result;
}

inline Plan plan_of(std::vector<Storey> storeys) {
    Plan plan;
    plan.name = "test";
    for (std::size_t s = 0; s < storeys.size(); ++s) {
        storeys[s].id = storeys[s].name = "s" + std::to_string(s);
        storeys[s].elevation = 3.0 * double(s);
        plan.storeys.push_back(std::move(storeys[s]));
    }
    return plan;
}

inline std::vector<std::int64_t> areas2(const Layout& layout) {
    std::vector<std::int64_t> areas(layout.map.face_count, 0);
    for (std::size_t l = 0; l < layout.map.loop_first.size(); ++l)
        areas[layout.map.face_of_loop[l]] += layout.map.loop_area2[l];
    return areas;
}

/// Square metres that one kind of owner holds in a storey; face 0 left out.
inline double area_of(const Layout& layout, std::size_t storey, OwnerKind kind) {
    const std::vector<std::int64_t> areas = areas2(layout);
    std::int64_t sum = 0;
    for (std::size_t f = 1; f < areas.size(); ++f)
        if (layout.storeys[storey].owner[f].kind == kind) sum += areas[f];
    return double(sum) / 2 * layout.frame.unit * layout.frame.unit;
}

inline const FoundRoom* find_room(const StoreyLayout& storey, const std::string& id) {
    for (const FoundRoom& found : storey.rooms)
        if (found.id == id) return &found;
    return nullptr;
}

inline std::size_t count_findings(const Layout& layout, const std::string& code) {
    return std::count_if(layout.findings.begin(), layout.findings.end(),
                         [&](const Finding& f) { return f.code == code; });
}

/// What holds for every layout: faces fill the site box, each has an owner that exists, and where no polygons
/// share a place, rooms touch solids alone. Returns what is wrong.
inline std::string defect(const Layout& layout, const Plan& plan, bool borders_allowed = false) {
    const std::vector<std::int64_t> areas = areas2(layout);
    std::int64_t sum = 0;
    for (std::size_t f = 1; f < areas.size(); ++f) {
        if (areas[f] <= 0) return "a face without area";
        sum += areas[f];
    }
    const std::int64_t width = std::int64_t(layout.site_max.x) - layout.site_min.x;
    const std::int64_t height = std::int64_t(layout.site_max.y) - layout.site_min.y;
    if (sum != 2 * width * height) return "faces do not fill the site box";
    if (layout.edge_line.size() != layout.graph.edges.size()) return "edges without a line";
    if (layout.use_line.size() != layout.graph.uses.size()) return "uses without a line";
    for (const LineId line : layout.edge_line)
        if (index(line) >= layout.lines.size()) return "a line that does not exist";
    for (const StoreyLayout& storey : layout.storeys) {
        const Storey& from = plan.storeys[storey.plan_storey];
        if (storey.owner.size() != layout.map.face_count) return "faces without owner";
        const std::map<OwnerKind, std::size_t> counts{{OwnerKind::Exterior, 1},
                                                      {OwnerKind::Room, storey.rooms.size()},
                                                      {OwnerKind::Wall, from.walls.size()},
                                                      {OwnerKind::Opening, from.openings.size()},
                                                      {OwnerKind::Column, from.columns.size()},
                                                      {OwnerKind::Stair, from.stairs.size()},
                                                      {OwnerKind::Shaft, from.shafts.size()}};
        for (const Owner& owner : storey.owner)
            if (owner.element >= counts.at(owner.kind)) return "an owner that does not exist";
        if (storey.owner[0].kind != OwnerKind::Exterior) return "beyond the site is not exterior";
        for (std::uint32_t e = 0; e < layout.graph.edges.size(); ++e) {
            const Owner l = storey.owner[layout.map.face(2 * e)];
            const Owner r = storey.owner[layout.map.face(2 * e + 1)];
            const bool open = (l.kind == OwnerKind::Room || l.kind == OwnerKind::Exterior) &&
                              (r.kind == OwnerKind::Room || r.kind == OwnerKind::Exterior);
            if (open && l != r && !borders_allowed) return "a room that no wall closes";
        }
    }
    return "";
}

/// The layout without the numbers of file order: vertices, edges, lines, and owners by id.
inline std::vector<std::string> in_words(const Layout& layout, const Plan& plan) {
    std::vector<std::string> words;
    for (const GridPoint p : layout.graph.vertices) words.push_back(std::to_string(p.x) + " " + std::to_string(p.y));
    for (std::size_t e = 0; e < layout.graph.edges.size(); ++e)
        words.push_back(std::to_string(layout.graph.edges[e].a) + "-" + std::to_string(layout.graph.edges[e].b) + " " +
                        std::to_string(index(layout.edge_line[e])));
    for (const StoreyLayout& storey : layout.storeys) {
        const Storey& from = plan.storeys[storey.plan_storey];
        for (const Owner& owner : storey.owner) {
            std::string word = std::to_string(int(owner.kind)) + " ";
            if (owner.kind == OwnerKind::Wall) word += from.walls[owner.element].id;
            if (owner.kind == OwnerKind::Opening) word += from.openings[owner.element].id;
            if (owner.kind == OwnerKind::Room) word += storey.rooms[owner.element].id;
            words.push_back(std::move(word));
        }
    }
    return words;
}

inline Storey two_rooms() {
    Storey storey;
    add_box(storey, "outer", 0, 0, 8, 4);
    storey.walls.push_back(wall("inner", {5, 0}, {5, 4}, 0.125));
    return storey;
}

}  // namespace enfilade::plans::testing
