#include "plans/sweet_home/gaps.h"

#include <algorithm>
#include <cmath>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double widest_gap = 1.2;       // m, unless the door is wider
constexpr double beyond_door = 0.35;     // m, how far beside the door its walls may begin
constexpr double narrowest_gap = 0.2;    // m
constexpr double jamb = 0.02;            // m, of wall left beside a door that fills its gap
constexpr double cos_in_line = 0.93969;  // 20 degrees

/// Where a gap ends on one side.
struct Stop {
    std::size_t wall = 0;
    double at = 0;         ///< along the door, from its middle
    bool in_line = false;  ///< a wall end, else the face of a wall across
    Point joint;           ///< where the new wall meets its axis
};

/// The nearer end of a wall that looks the door's way.
Point near_end(const WallBody& body, Point from) {
    const Point start = body.axis.at(0);
    const Point end = body.axis.at(1);
    return distance(from, start) <= distance(from, end) ? start : end;
}

/// Where the line through `from` meets the axis of a wall across, within the wall.
Point crossing(const WallBody& body, Point from, Point along) {
    const double foot = body.axis.nearest(from);
    if (!body.axis.straight()) return body.axis.at(foot);
    const Point direction = body.along(0);
    const double turn = cross(direction, along);
    if (std::abs(turn) < 0.5) return body.axis.at(foot);
    const double offset = cross(from - body.axis.at(0), along) / turn;
    return body.axis.at(std::clamp(offset / body.axis.length(), 0.0, 1.0));
}

/// Of two stops on one side the nearer; where they are alike, the wall in line.
bool nearer(const Stop& a, const Stop& b, const StoreyBodies& bodies) {
    const double tolerance = std::max(bodies[a.wall].half, bodies[b.wall].half) + 0.01;
    if (a.in_line != b.in_line && std::abs(a.at - b.at) <= tolerance) return a.in_line;
    return std::abs(a.at) < std::abs(b.at);
}

struct Stops {
    std::optional<Stop> left;
    std::optional<Stop> right;
};

std::optional<Stops> find_stops(const PlacedOpening& door, const PlanRectangle& strip, const StoreyBodies& bodies) {
    Stops stops;
    for (const std::size_t wall : bodies.near(door.middle)) {
        const WallBody& body = bodies[wall];
        if (body.height <= door.opening.sill) continue;
        const LocalBox extent = body.extent_in(strip);
        if (extent.empty()) continue;
        const bool left = extent.max.x < 0;
        if (!left && extent.min.x <= 0) return {};  // a wall stands across the middle
        Stop stop{wall, left ? extent.max.x : extent.min.x, false, {}};
        const Point end = near_end(body, door.wall_middle);
        const double t = body.axis.nearest(end);
        stop.in_line =
            std::abs(dot(body.along(t), strip.along)) >= cos_in_line && std::abs(strip.local(end).y) <= strip.depth / 2;
        stop.joint = end;
        std::optional<Stop>& best = left ? stops.left : stops.right;
        if (!best || nearer(stop, *best, bodies)) best = stop;
    }
    if (!stops.left || !stops.right) return {};
    return stops;
}

/// The ends of walls in line are taken as they are; the line of the gap goes on to the axis of a wall across.
void join(Stops& stops, const PlanRectangle& strip, const StoreyBodies& bodies) {
    const Point through = stops.left->in_line    ? stops.left->joint
                          : stops.right->in_line ? stops.right->joint
                                                 : strip.middle;
    for (Stop* stop : {&*stops.left, &*stops.right})
        if (!stop->in_line) stop->joint = crossing(bodies[stop->wall], through, strip.along);
}

Wall wall_between(const Stops& stops, const Storey& storey) {
    const Wall& left = storey.walls[stops.left->wall];
    const Wall& right = storey.walls[stops.right->wall];
    Wall wall;
    wall.start = stops.left->joint;
    wall.end = stops.right->joint;
    const auto height = [](const Wall& neighbour) {
        return std::min(neighbour.height_at_start, neighbour.height_at_end) > 0
                   ? std::min(neighbour.height_at_start, neighbour.height_at_end)
                   : std::max(neighbour.height_at_start, neighbour.height_at_end);
    };
    if (stops.left->in_line == stops.right->in_line) wall.thickness = std::min(left.thickness, right.thickness);
    else wall.thickness = stops.left->in_line ? left.thickness : right.thickness;
    wall.height_at_start = wall.height_at_end = std::max(height(left), height(right));
    return wall;
}

}  // namespace

double reach_of(const PlacedOpening& door) {
    return std::hypot(door.width, door.depth) + 2 * beyond_door + widest_gap / 2;
}

std::optional<ClosedGap> close_gap(const PlacedOpening& door, const Storey& storey, const StoreyBodies& bodies) {
    const Point along{std::cos(door.angle), std::sin(door.angle)};
    const PlanRectangle strip{door.wall_middle, along, door.wall_width + 2 * beyond_door,
                              std::max(door.wall_depth, 0.1) + 0.1};
    std::optional<Stops> stops = find_stops(door, strip, bodies);
    if (!stops) return {};
    ClosedGap gap;
    gap.clear = stops->right->at - stops->left->at;
    if (gap.clear < narrowest_gap || gap.clear > std::max(widest_gap, door.wall_width + beyond_door)) return {};
    join(*stops, strip, bodies);
    gap.wall = wall_between(*stops, storey);
    const double length = distance(gap.wall.start, gap.wall.end);
    if (!(length >= gap.clear - 0.01)) return {};
    const Point direction = (gap.wall.end - gap.wall.start) * (1 / length);
    if (dot(direction, along) < cos_in_line) return {};
    const auto offset = [&](double at) { return dot(door.wall_middle + along * at - gap.wall.start, direction); };
    const double from = std::max(0.0, offset(stops->left->at)) + jamb;
    const double to = std::min(length, offset(stops->right->at)) - jamb;
    gap.width = std::min(door.opening.width, to - from);
    if (!(gap.width > jamb)) return {};
    gap.offset = std::clamp(offset(0), from + gap.width / 2, to - gap.width / 2);
    const double moved = distance(gap.wall.start + direction * gap.offset, door.wall_middle);
    gap.moved = std::max(moved, door.opening.width - gap.width);
    return gap;
}

}  // namespace enfilade::plans
