#include "tests/support/shrink_room.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/support/crossings.h"

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

/// Largest distance of a point from the chord of a run of sides of one line. Points where loops meet end runs.
double stray_of_sides(const Room& room) {
    constexpr std::uint32_t none = UINT32_MAX, several = UINT32_MAX - 1;
    std::vector<std::uint32_t> leaving(room.points.size(), none);
    for (std::uint32_t k = 0; k < room.sides.size(); ++k) {
        std::uint32_t& at = leaving[room.sides[k].from];
        at = at == none ? k : several;
    }
    const auto next = [&](std::uint32_t k) {
        const std::uint32_t n = leaving[room.sides[k].to];
        if (n >= several) return none;
        const PolygonSide &in = room.sides[k], &out = room.sides[n];
        const bool straight =
            modeler::goes_straight(room.points[in.from], room.points[in.to], room.points[out.to], in.line, out.line);
        return straight ? n : none;
    };
    std::vector<bool> goes_on(room.sides.size(), false);
    for (std::uint32_t k = 0; k < room.sides.size(); ++k)
        if (next(k) != none) goes_on[next(k)] = true;
    double worst = 0;
    for (std::uint32_t start = 0; start < room.sides.size(); ++start) {
        if (goes_on[start]) continue;
        std::uint32_t last = start;
        for (std::uint32_t k = next(start); k != none; k = next(k)) last = k;
        const GridPoint a = room.points[room.sides[start].from], b = room.points[room.sides[last].to];
        const double length = std::max(1.0, std::hypot(double(b.x) - a.x, double(b.y) - a.y));
        for (std::uint32_t k = next(start); k != none; k = next(k))
            worst = std::max(worst, std::abs(double(orientation(a, b, room.points[room.sides[k].from]))) / length);
    }
    return worst;
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
           area2(room.points, room.sides) > 0 && !first_crossing(segments) &&
           stray_of_sides(room) < std::sqrt(2.0) + 1e-9;
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
