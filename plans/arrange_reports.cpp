// Why a named room was not found: the sentences that let a user repair the plan.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "plans/arrange_rooms.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

/// Where walls leave a room open.
struct Gap {
    Point from;  ///< relative to the frame's origin
    Point to;
    bool at_free_end = false;
};

constexpr double kReach = 1.0;  ///< m: free ends farther from a polygon's outline have nothing to do with it

std::string metres(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3f", value);
    return buffer;
}

std::string place_text(Point local, const GridFrame& frame) {
    return "(" + metres(local.x + frame.origin_x) + ", " + metres(local.y + frame.origin_y) + ")";
}

std::vector<Point> local_ring(const std::vector<GridPoint>& ring, const GridFrame& frame) {
    std::vector<Point> points;
    for (const GridPoint p : ring) points.push_back({p.x * frame.unit, p.y * frame.unit});
    return points;
}

double distance_to_ring(Point p, const std::vector<Point>& ring) {
    double best = HUGE_VAL;
    for (std::size_t i = 0; i < ring.size(); ++i)
        best = std::min(best, distance(p, ring[i], ring[(i + 1) % ring.size()]));
    return best;
}

Point nearest_on(Point p, Point a, Point b) {
    const Point d = b - a;
    const double square = dot(d, d);
    return square == 0 ? a : a + d * std::clamp(dot(p - a, d) / square, 0.0, 1.0);
}

/// From a free end near the polygon to the closest other wall: the narrowest of those, since rooms leak where a
/// wall was meant to meet another.
std::optional<Gap> narrowest_gap(const std::vector<Point>& ring, const StoreyOutlines& outlines) {
    std::optional<Gap> best;
    for (const FreeEnd& end : outlines.free_ends) {
        if (distance_to_ring(end.at, ring) > kReach) continue;
        for (std::uint32_t w = 0; w < outlines.walls.size(); ++w) {
            const WallOutline& wall = outlines.walls[w];
            if (w == end.wall || wall.ring.empty()) continue;
            for (std::size_t i = 0; i < wall.ring.size(); ++i) {
                const Point near = nearest_on(end.at, wall.ring[i].at, wall.ring[(i + 1) % wall.ring.size()].at);
                if (!best || distance(end.at, near) < distance(best->from, best->to)) best = Gap{end.at, near, true};
            }
        }
    }
    return best;
}

/// The longest stretch of the polygon's outline without a wall along it.
std::optional<Gap> longest_open_side(const std::vector<Point>& ring, const StoreyOutlines& outlines) {
    std::optional<Gap> best;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i];
        const Point b = ring[(i + 1) % ring.size()];
        constexpr int kSteps = 32;
        int first = 0;
        for (int k = 0; k <= kSteps; ++k) {
            const Point p = a + (b - a) * ((k + 0.5) / kSteps);
            const bool open =
                k < kSteps && std::none_of(outlines.walls.begin(), outlines.walls.end(), [&](const WallOutline& wall) {
                    return !wall.ring.empty() && distance(p, wall.axis.at(wall.axis.nearest(p))) < wall.half + 0.2;
                });
            if (open) continue;
            const Gap stretch{a + (b - a) * (double(first) / kSteps), a + (b - a) * (double(k) / kSteps), false};
            if (k > first && (!best || distance(stretch.from, stretch.to) > distance(best->from, best->to)))
                best = stretch;
            first = k + 1;
        }
    }
    return best;
}

Finding about(const StoreyRooms& from, const Room& room, const char* code, Severity severity) {
    Finding finding;
    finding.code = code;
    finding.severity = severity;
    finding.storey = from.storey->id;
    finding.elements.push_back({"room", room.id, room.name});
    return finding;
}

std::string named(const Room& room, const StoreyRooms& from) {
    return "Room \"" + (room.name.empty() ? room.id : room.name) + "\" on storey \"" + from.storey->name + "\"";
}

Finding open_room(const StoreyRooms& from, const Room& room, const std::vector<Point>& ring) {
    const GridFrame& frame = *from.frame;
    Finding finding = about(from, room, "P311", Severity::Warning);
    finding.sentence = named(room, from) + " is open to the exterior";
    std::optional<Gap> gap = narrowest_gap(ring, *from.outlines);
    if (!gap || distance(gap->from, gap->to) > 2) {
        if (const auto side = longest_open_side(ring, *from.outlines)) gap = side;
    }
    if (gap && gap->at_free_end) {
        finding.sentence += ": a wall ends at " + place_text(gap->from, frame) + ", " +
                            metres(distance(gap->from, gap->to)) + " m short of the next one at " +
                            place_text(gap->to, frame) + ".";
        finding.hint = "Extend that wall, or name the place \"terrace\" or \"courtyard\" if it is meant to be open.";
    } else if (gap) {
        finding.sentence += ": there is no wall along it from " + place_text(gap->from, frame) + " to " +
                            place_text(gap->to, frame) + ".";
        finding.hint =
            "Draw a wall there, or give the room the kind \"terrace\" or \"courtyard\" if it is meant to be open.";
    } else {
        finding.sentence += ": the walls around it do not close.";
        finding.hint = "Look for walls around it that end without meeting another.";
    }
    Point at = ring.front();
    if (gap) at = (gap->from + gap->to) * 0.5;
    finding.point = {at.x + frame.origin_x, at.y + frame.origin_y, from.storey->elevation};
    return finding;
}

}  // namespace

void report_rooms(const StoreyRooms& from, std::vector<Finding>& findings) {
    if (from.match == nullptr) return;
    const RoomMatch& match = *from.match;
    for (std::uint32_t k = 0; k < from.rings->rings.size(); ++k) {
        const Room& room = from.storey->rooms[from.rings->room[k]];
        const bool open = room.kind == "terrace" || room.kind == "courtyard";
        const std::vector<Point> ring = local_ring(from.rings->rings[k], *from.frame);
        const std::array<double, 3> at{ring[0].x + from.frame->origin_x, ring[0].y + from.frame->origin_y,
                                       from.storey->elevation};
        const std::uint32_t place = match.place_of_polygon[k];
        if (place == kNone) {
            if (open) continue;
            if (2 * match.exterior_area2[k] >= match.polygon_area2[k]) {
                findings.push_back(open_room(from, room, ring));
                continue;
            }
            Finding finding = about(from, room, "P310", Severity::Warning);
            finding.sentence = named(room, from) +
                               " names no place between walls: its polygon lies in walls or across several places.";
            finding.hint = "Draw the polygon over the one place that it names.";
            finding.point = at;
            findings.push_back(std::move(finding));
            continue;
        }
        const std::uint32_t first = match.polygons_of_place[place].front();
        if (first != k) {
            Finding finding = about(from, room, "P312", Severity::Note);
            const Room& other = from.storey->rooms[from.rings->room[first]];
            finding.elements.push_back({"room", other.id, other.name});
            finding.sentence = named(room, from) + " lies over the same place as \"" +
                               (other.name.empty() ? other.id : other.name) + "\", which names it.";
            finding.hint = "Remove one of the two polygons.";
            finding.point = at;
            findings.push_back(std::move(finding));
        }
        std::size_t others = 0;
        for (const std::uint32_t other : match.also_covered[k]) others += match.polygons_of_place[other].empty();
        if (others > 0) {
            Finding finding = about(from, room, "P313", Severity::Note);
            finding.sentence = named(room, from) + " also covers " + std::to_string(others) + " other closed place" +
                               (others > 1 ? "s" : "") + ": it names the largest, the others stay unnamed.";
            finding.hint = "Draw one polygon for each room.";
            finding.point = at;
            findings.push_back(std::move(finding));
        }
    }
}

}  // namespace enfilade::plans
