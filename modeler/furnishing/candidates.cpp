#include "modeler/furnishing/candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enfilade::modeler {

using plans::Point;

namespace {

constexpr double half_turn = std::numbers::pi;

/// The extent of the floor along a way and across it.
struct Extent {
    double u_low = HUGE_VAL, u_high = -HUGE_VAL, v_low = HUGE_VAL, v_high = -HUGE_VAL;
};

Extent extent_of(const RoomShape& room, Point along) {
    Extent extent;
    const Point across = plans::turned_left(along);
    for (const FloorSide& side : room.floor.sides()) {
        const Point p{double(side.a.x), double(side.a.y)};
        extent.u_low = std::min(extent.u_low, plans::dot(p, along));
        extent.u_high = std::max(extent.u_high, plans::dot(p, along));
        extent.v_low = std::min(extent.v_low, plans::dot(p, across));
        extent.v_high = std::max(extent.v_high, plans::dot(p, across));
    }
    return extent;
}

bool holds(const RoomShape& room, Point p) {
    return room.floor.holds(plans::GridPoint{std::int32_t(std::floor(p.x)), std::int32_t(std::floor(p.y))});
}

}  // namespace

Point main_way(const std::vector<WallRing>& rings) {
    Point way{1, 0};
    double longest = 0;
    for (const WallRing& ring : rings)
        for (const WallRun& run : ring.runs)
            // A little more is not longer: walls that face each other give one way.
            if (run.length > 1.001 * longest) {
                longest = run.length;
                way = run.along;
            }
    return way;
}

std::vector<Candidate> middle_candidates(const Occupancy& occupancy, const std::vector<WallRing>& rings,
                                         PieceSize size) {
    const RoomShape& room = occupancy.room();
    const Point along = main_way(rings), across = plans::turned_left(along);
    const Extent extent = extent_of(room, along);
    std::vector<Point> places = {room.middle};
    const Point box_middle =
        along * ((extent.u_low + extent.u_high) / 2) + across * ((extent.v_low + extent.v_high) / 2);
    if (holds(room, box_middle)) places.push_back(box_middle);
    constexpr int steps = 9;
    for (int i = 1; i < steps; ++i)
        for (int j = 1; j < steps; ++j) {
            const Point p = along * (extent.u_low + (extent.u_high - extent.u_low) * i / steps) +
                            across * (extent.v_low + (extent.v_high - extent.v_low) * j / steps);
            if (holds(room, p)) places.push_back(p);
        }
    const double angle = std::atan2(along.y, along.x);
    const int turns = std::abs(size.width - size.depth) < 1 ? 2 : 4;
    std::vector<Candidate> candidates;
    for (const Point& p : places)
        for (int k = 0; k < turns; ++k) candidates.push_back({{p, angle + k * half_turn / 2}, -1});
    return candidates;
}

std::vector<Candidate> row_candidates(const Occupancy& occupancy, const std::vector<WallRing>& rings, PieceSize size,
                                      double way) {
    const RoomShape& room = occupancy.room();
    const double metre = 1 / room.frame.unit;
    const Point along = main_way(rings), across = plans::turned_left(along);
    const Extent extent = extent_of(room, along);
    const double border = 0.9 * metre, aisle = 0.9 * metre;
    const double row = size.depth + std::max(way, 0.9 * metre);
    const double breadth = extent.u_high - extent.u_low - 2 * border;
    // Blocks of three at most, an aisle between them.
    std::vector<double> us;
    double u = extent.u_low + border + size.width / 2;
    for (int in_block = 0; u + size.width / 2 <= extent.u_low + border + breadth && us.size() < 64; ++in_block) {
        us.push_back(u);
        u += size.width + (in_block % 3 == 2 ? aisle : 0.02 * metre);
    }
    const double left_over = us.empty() ? 0 : extent.u_high - border - (us.back() + size.width / 2);
    std::vector<Candidate> candidates;
    const double angle = std::atan2(along.y, along.x);
    int rows = 0;
    for (double v = extent.v_low + border + way; v + size.depth / 2 <= extent.v_high - border / 2 && rows < 64;
         v += row, ++rows)
        for (const double at : us) {
            const Point p = along * (at + left_over / 2) + across * v;
            if (holds(room, p)) candidates.push_back({{p, angle}, -1});
        }
    return candidates;
}

std::vector<Point> spread_over(const RoomShape& room, const std::vector<WallRing>& rings, std::uint32_t count) {
    if (count == 0) return {};
    if (count == 1 && holds(room, room.middle)) return {room.middle};
    const Point along = main_way(rings), across = plans::turned_left(along);
    const Extent extent = extent_of(room, along);
    const double width = extent.u_high - extent.u_low, depth = extent.v_high - extent.v_low;
    const double cell = std::sqrt(width * depth / std::clamp(64.0 * count, 400.0, 4000.0));
    std::vector<Point> samples;
    for (double v = extent.v_low + cell / 2; v < extent.v_high; v += cell)
        for (double u = extent.u_low + cell / 2; u < extent.u_high; u += cell) {
            const Point p = along * u + across * v;
            if (holds(room, p)) samples.push_back(p);
        }
    if (samples.empty()) return {room.middle};
    count = std::min(count, std::uint32_t(samples.size()));
    // Begun along the room's way, evenly: rows of lamps stay rows.
    std::sort(samples.begin(), samples.end(), [&](Point a, Point b) {
        const double ua = plans::dot(a, along), ub = plans::dot(b, along);
        return ua != ub ? ua < ub : plans::dot(a, across) < plans::dot(b, across);
    });
    std::vector<Point> centres;
    for (std::uint32_t k = 0; k < count; ++k) centres.push_back(samples[(2 * k + 1) * samples.size() / (2 * count)]);
    std::vector<Point> sums;
    std::vector<double> counts;
    for (int round = 0; round < 12; ++round) {
        sums.assign(centres.size(), {0, 0});
        counts.assign(centres.size(), 0);
        for (const Point& p : samples) {
            std::size_t best = 0;
            for (std::size_t c = 1; c < centres.size(); ++c)
                if (plans::distance(p, centres[c]) < plans::distance(p, centres[best])) best = c;
            sums[best] = sums[best] + p;
            counts[best] += 1;
        }
        for (std::size_t c = 0; c < centres.size(); ++c)
            if (counts[c] > 0) centres[c] = sums[c] * (1 / counts[c]);
    }
    return centres;
}

}  // namespace enfilade::modeler
