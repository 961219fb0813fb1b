#include "tests/support/shrink_room.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/support/crossings.h"
#include "tests/support/partition_checks.h"

namespace enfilade::testing {
namespace {

using modeler::PolygonSide;
using plans::GridPoint;

/// Without points that no side uses.
Room tidied(const Room& room) {
    Room result;
    std::map<std::uint32_t, std::uint32_t> renamed;
    for (PolygonSide side : room.sides) {
        for (std::uint32_t* end : {&side.from, &side.to}) {
            const auto [at, is_new] = renamed.try_emplace(*end, std::uint32_t(result.points.size()));
            if (is_new) result.points.push_back(room.points[*end]);
            *end = at->second;
        }
        result.sides.push_back(side);
    }
    return result;
}

/// The side that leaves where side k ends; the sides' number where there are several.
std::size_t follower(const Room& room, std::size_t k) {
    std::size_t found = room.sides.size();
    for (std::size_t s = 0; s < room.sides.size(); ++s) {
        if (room.sides[s].from != room.sides[k].to) continue;
        if (found != room.sides.size()) return room.sides.size();
        found = s;
    }
    return found;
}

/// Without the corner at the end of side k; empty where several loops meet there.
Room without_corner(const Room& room, std::size_t k) {
    const std::size_t next = follower(room, k);
    if (next == room.sides.size() || next == k) return {};
    Room result = room;
    result.sides[k].to = room.sides[next].to;
    result.sides.erase(result.sides.begin() + std::ptrdiff_t(next));
    return tidied(result);
}

/// Without the loop that side k is on; empty where loops meet.
Room without_loop(const Room& room, std::size_t k) {
    std::vector<bool> gone(room.sides.size(), false);
    for (std::size_t s = k; !gone[s];) {
        gone[s] = true;
        s = follower(room, s);
        if (s == room.sides.size()) return {};
    }
    Room result;
    result.points = room.points;
    for (std::size_t s = 0; s < room.sides.size(); ++s)
        if (!gone[s]) result.sides.push_back(room.sides[s]);
    return tidied(result);
}

/// Largest distance of a point from the chord through all points of its line.
double stray_of_lines(const Room& room) {
    std::map<std::uint32_t, std::vector<GridPoint>> lines;
    for (const PolygonSide& side : room.sides)
        for (const std::uint32_t end : {side.from, side.to}) lines[side.line].push_back(room.points[end]);
    double worst = 0;
    for (const auto& [line, points] : lines) {
        const auto farthest = [&points = points](GridPoint from) {
            const auto length = [from](GridPoint p) { return std::hypot(double(p.x) - from.x, double(p.y) - from.y); };
            return *std::max_element(points.begin(), points.end(),
                                     [&](GridPoint p, GridPoint q) { return length(p) < length(q); });
        };
        const GridPoint a = farthest(points[0]), b = farthest(a);
        const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        for (const GridPoint p : points) worst = std::max(worst, std::abs(double(orientation(a, b, p))) / length);
    }
    return worst;
}

/// How often all sides wind around the place just left of the middle of side k.
std::int32_t winding_left_of(const Room& room, std::size_t k) {
    const PolygonSide& own = room.sides[k];
    const auto doubled = [&](std::uint32_t p) { return GridPoint{2 * room.points[p].x, 2 * room.points[p].y}; };
    const GridPoint from = room.points[own.from], to = room.points[own.to];
    const GridPoint middle = {from.x + to.x, from.y + to.y};
    const bool above = from.y < to.y || (from.y == to.y && from.x < to.x);  // where a horizontal side's left lies
    std::int32_t winding = from.y < to.y ? 1 : 0;
    for (std::size_t s = 0; s < room.sides.size(); ++s) {
        if (s == k) continue;
        const GridPoint a = doubled(room.sides[s].from), b = doubled(room.sides[s].to);
        const auto is_below = [&](GridPoint p) { return above ? p.y <= middle.y : p.y < middle.y; };
        if (is_below(a) == is_below(b)) continue;
        const bool rises = is_below(a);
        if ((orientation(a, b, middle) > 0) == rises) winding += rises ? 1 : -1;
    }
    return winding;
}

Room halved(const Room& room) {
    Room result = room;
    GridPoint low = room.points[0];
    for (const GridPoint p : room.points) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    for (GridPoint& p : result.points) p = {(p.x - low.x) / 2, (p.y - low.y) / 2};
    return result;
}

Room at_origin(const Room& room) {
    Room result = room;
    GridPoint low = room.points[0];
    for (const GridPoint p : room.points) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    for (GridPoint& p : result.points) p = {p.x - low.x, p.y - low.y};
    return result;
}

bool winds_once(const Room& room) {
    for (std::size_t k = 0; k < room.sides.size(); ++k)
        if (winding_left_of(room, k) != 1) return false;
    return true;
}

}  // namespace

bool is_sound(const Room& room) {
    if (room.sides.size() < 3) return false;
    std::vector<std::int32_t> balance(room.points.size(), 0);
    std::vector<plans::Segment> segments;
    for (const PolygonSide& side : room.sides) {
        ++balance[side.from], --balance[side.to];
        if (room.points[side.from] == room.points[side.to]) return false;
        segments.push_back({room.points[side.from], room.points[side.to]});
    }
    std::vector<GridPoint> places = room.points;
    std::sort(places.begin(), places.end());
    if (std::adjacent_find(places.begin(), places.end()) != places.end()) return false;
    return std::all_of(balance.begin(), balance.end(), [](std::int32_t b) { return b == 0; }) &&
           !first_crossing(segments) && winds_once(room) && stray_of_lines(room) <= most_stray;
}

Room shrink_room(Room room, const std::function<bool(const Room&)>& fails, std::uint32_t budget) {
    const auto take = [&](const Room& smaller) {
        if (budget == 0 || smaller.sides.empty() || !is_sound(smaller)) return false;
        --budget;
        if (!fails(smaller)) return false;
        room = smaller;
        return true;
    };
    (void)take(at_origin(room));
    for (bool smaller = true; smaller && budget > 0;) {
        smaller = false;
        for (std::size_t k = 0; k < room.sides.size(); ++k) smaller |= take(without_loop(room, k));
        for (std::size_t k = 0; k < room.sides.size();) {
            if (take(without_corner(room, k))) smaller = true;
            else ++k;
        }
        smaller |= take(halved(room));
    }
    return room;
}

}  // namespace enfilade::testing
