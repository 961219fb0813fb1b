#include "plans/arrange_rooms.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace enfilade::plans {
namespace {

constexpr double kSmallest = 0.05;  ///< m2: no room is smaller, unless named or with a stair or shaft
constexpr double kThinnest = 0.03;  ///< m, 2 area / perimeter: no room is thinner
constexpr double kSplinter = 1e-4;  ///< m2: what rounding and almost equal walls leave, counted only

std::string text(const char* format, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

bool is_open(const std::string& kind) { return kind == "courtyard" || kind == "terrace"; }

const std::string& id_of(const Owner& owner, const Storey& storey) {
    switch (owner.kind) {
        case OwnerKind::Wall: return storey.walls[owner.element].id;
        case OwnerKind::Opening: return storey.openings[owner.element].id;
        case OwnerKind::Column: return storey.columns[owner.element].id;
        case OwnerKind::Exterior:
        case OwnerKind::Room:
        case OwnerKind::Stair:
        case OwnerKind::Shaft: break;
    }
    return storey.id;
}

/// The solid with the longest edge on each place: walls before columns before openings, then the lower id.
std::vector<Owner> longest_neighbours(const Overlay& overlay, const Places& places, const std::vector<Owner>& owner,
                                      const std::vector<bool>& wanted, const Storey& storey) {
    struct Contact {
        Owner solid;
        double length;
    };
    std::vector<std::vector<Contact>> contacts(places.places.size());
    const NodedGraph& graph = overlay.graph;
    for (std::uint32_t h = 0; h < 2 * graph.edges.size(); ++h) {
        const std::uint32_t place = places.of_face[overlay.map.face(h)];
        const Owner& solid = owner[overlay.map.face(h ^ 1u)];
        if (place == kNone || !wanted[place] || !is_solid(solid.kind)) continue;
        const GridPoint a = graph.vertices[graph.edges[h / 2].a];
        const GridPoint b = graph.vertices[graph.edges[h / 2].b];
        const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        const auto known = std::find_if(contacts[place].begin(), contacts[place].end(),
                                        [&](const Contact& contact) { return contact.solid == solid; });
        if (known == contacts[place].end()) contacts[place].push_back({solid, length});
        else known->length += length;
    }
    const auto strength = [](OwnerKind kind) {
        return kind == OwnerKind::Wall ? 2 : kind == OwnerKind::Column ? 1 : 0;
    };
    std::vector<Owner> best(places.places.size(), {OwnerKind::Exterior, 0});
    for (std::size_t p = 0; p < best.size(); ++p) {
        if (contacts[p].empty()) continue;
        best[p] =
            std::min_element(contacts[p].begin(), contacts[p].end(), [&](const Contact& l, const Contact& r) {
                if (strength(l.solid.kind) != strength(r.solid.kind))
                    return strength(l.solid.kind) > strength(r.solid.kind);
                return l.length != r.length ? l.length > r.length : id_of(l.solid, storey) < id_of(r.solid, storey);
            })->solid;
    }
    return best;
}

std::array<double, 3> point_in(const Overlay& overlay, const Places::Place& place, const StoreyRooms& from) {
    for (std::uint32_t h = 0; h < 2 * overlay.graph.edges.size(); ++h)
        if (overlay.map.face(h) == place.first_face) {
            const GridPoint p = overlay.graph.vertices[origin(overlay.graph, h)];
            return {from.frame->world_x(p.x), from.frame->world_y(p.y), from.storey->elevation};
        }
    return {0, 0, 0};
}

Finding small_place(const Overlay& overlay, const Places::Place& place, double area, double width,
                    const StoreyRooms& from) {
    Finding finding;
    finding.code = "P320";
    finding.severity = area < 0.005 ? Severity::Note : Severity::Warning;
    finding.point = point_in(overlay, place, from);
    finding.sentence = "A gap of " + text("%.4f", area) + " m2, " + text("%.1f", width * 1000) +
                       " mm wide, between walls of storey \"" + from.storey->name + "\" at (" +
                       text("%.3f", (*finding.point)[0]) + ", " + text("%.3f", (*finding.point)[1]) +
                       ") was filled: it is too small for a room.";
    finding.hint = "Draw the walls so that they touch, or name the gap by a room polygon if it is meant.";
    finding.storey = from.storey->id;
    return finding;
}

}  // namespace

RoomRings room_rings(const Storey& storey, const GridFrame& frame, std::vector<Finding>& findings) {
    RoomRings result;
    constexpr double limit = 1 << 24;
    const auto on_grid = [&](Point p) {
        const auto round = [&](double d) {
            return std::int32_t(std::floor(std::clamp(d / frame.unit, -limit, limit) + 0.5));
        };
        return GridPoint{round(p.x - frame.origin_x), round(p.y - frame.origin_y)};
    };
    for (const std::uint32_t r : by_id(storey.rooms)) {
        const Room& room = storey.rooms[r];
        std::vector<GridPoint> ring;
        for (const Point p : room.polygon)
            if (const GridPoint at = on_grid(p); ring.empty() || !(ring.back() == at)) ring.push_back(at);
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        std::int64_t area2 = 0;
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) area2 += orientation(ring[0], ring[i], ring[i + 1]);
        if (ring.size() < 3 || area2 == 0) {
            Finding finding;
            finding.code = "P303";
            finding.sentence = "The polygon of room \"" + (room.name.empty() ? room.id : room.name) +
                               "\" on storey \"" + storey.name + "\" encloses nothing and was left out.";
            finding.hint = "Give it at least three corners that are not in one line.";
            finding.storey = storey.id;
            finding.elements.push_back({"room", room.id, room.name});
            findings.push_back(std::move(finding));
            continue;
        }
        if (area2 < 0) std::reverse(ring.begin(), ring.end());
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
        result.room.push_back(r);
        result.rings.push_back(std::move(ring));
    }
    return result;
}

void settle_rooms(const Overlay& overlay, const StoreyRooms& from, StoreyLayout& layout,
                  std::vector<Finding>& findings) {
    const std::vector<Places::Place>& places = from.places->places;
    const double unit = from.frame->unit;
    std::vector<Owner> settled(places.size(), {OwnerKind::Exterior, 0});
    std::vector<bool> too_small(places.size(), false);
    std::uint32_t splinters = 0;
    double splinter_area = 0;
    std::uint32_t unnamed = 0;
    for (std::size_t p = 0; p < places.size(); ++p) {
        const Places::Place& place = places[p];
        if (place.exterior) continue;
        const double area = double(place.area2) / 2 * unit * unit;
        const double width = place.perimeter > 0 ? double(place.area2) / place.perimeter * unit : 0;
        const bool named = from.match != nullptr && !from.match->polygons_of_place[p].empty();
        if (!named && !place.pierced && (area < kSmallest || width < kThinnest)) {
            too_small[p] = true;
            if (area < kSplinter) {
                ++splinters;
                splinter_area += area;
            } else {
                findings.push_back(small_place(overlay, place, area, width, from));
            }
            continue;
        }
        FoundRoom room;
        room.area_m2 = area;
        if (named) {
            room.polygon = from.rings->room[from.match->polygons_of_place[p].front()];
            const Room& polygon = from.storey->rooms[*room.polygon];
            if (is_open(polygon.kind)) continue;
            room.id = polygon.id;
            room.name = polygon.name;
            room.kind = polygon.kind;
        } else {
            room.id = "room@" + from.storey->id + "/" + std::to_string(unnamed++);
        }
        settled[p] = {OwnerKind::Room, std::uint32_t(layout.rooms.size())};
        layout.rooms.push_back(std::move(room));
    }
    if (splinters > 0) {
        Finding finding;
        finding.code = "P321";
        finding.severity = Severity::Note;
        finding.sentence = std::to_string(splinters) + " splinters between walls of storey \"" + from.storey->name +
                           "\" were filled, " + text("%.2f", splinter_area * 1e6) + " mm2 together.";
        finding.storey = from.storey->id;
        findings.push_back(std::move(finding));
    }
    const std::vector<Owner> neighbours =
        longest_neighbours(overlay, *from.places, layout.owner, too_small, *from.storey);
    for (std::uint32_t f = 0; f < layout.owner.size(); ++f) {
        const std::uint32_t p = from.places->of_face[f];
        if (p == kNone) continue;
        if (too_small[p]) layout.owner[f] = neighbours[p];
        else if (layout.owner[f].kind == OwnerKind::Room) layout.owner[f] = settled[p];
    }
}

}  // namespace enfilade::plans
