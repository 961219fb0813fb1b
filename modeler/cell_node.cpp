#include "modeler/cell_node.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

std::array<double, 2> centroid(std::span<const GridPoint> ring) {
    const GridPoint origin = ring.front();
    double area = 0, x = 0, y = 0;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
        const GridPoint p = ring[k], q = ring[k + 1];
        const double part = double(orientation(origin, p, q));
        area += part;
        x += part * ((double(p.x) - origin.x) + (double(q.x) - origin.x)) / 3;
        y += part * ((double(p.y) - origin.y) + (double(q.y) - origin.y)) / 3;
    }
    if (area == 0) return {double(origin.x), double(origin.y)};
    return {origin.x + x / area, origin.y + y / area};
}

/// The side on which the ring runs round the point, and how far its border is: negative outside.
double depth(std::span<const GridPoint> ring, std::array<double, 2> point) {
    double nearest = HUGE_VAL;
    bool inside = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const GridPoint a = ring[k], b = ring[k + 1 < ring.size() ? k + 1 : 0];
        const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
        const double px = point[0] - a.x, py = point[1] - a.y;
        const double square = dx * dx + dy * dy;
        const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
        nearest = std::min(nearest, std::hypot(px - t * dx, py - t * dy));
        if ((a.y > point[1]) != (b.y > point[1]) && px < dx * py / dy) inside = !inside;
    }
    return inside ? nearest : -nearest;
}

/// Half of the radius of the circle with the same share of area and perimeter. (In a convex ring the centroid is deeper
/// than half of this.)
double mean_depth(std::span<const GridPoint> ring) {
    double area = 0, perimeter = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const GridPoint a = ring[k], b = ring[k + 1 < ring.size() ? k + 1 : 0];
        area += double(orientation(ring[0], a, b)) / 2;
        perimeter += std::hypot(double(b.x) - a.x, double(b.y) - a.y);
    }
    return perimeter > 0 ? std::abs(area) / perimeter : 0;
}

struct Chord {
    double x = 0, y = 0;
    double room = 0;  ///< the lesser of its length and of the height in which it is clear of corners
};

/// The longest stretch of the horizontal line at y inside the ring; no corner lies on that line.
Chord longest_chord(std::span<const GridPoint> ring, double y, std::vector<double>& crossings) {
    crossings.clear();
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const GridPoint a = ring[k], b = ring[k + 1 < ring.size() ? k + 1 : 0];
        if ((a.y > y) == (b.y > y)) continue;
        crossings.push_back(a.x + (double(b.x) - a.x) * (y - a.y) / (double(b.y) - a.y));
    }
    std::sort(crossings.begin(), crossings.end());
    Chord best;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        if (crossings[k + 1] - crossings[k] > best.room)
            best = {(crossings[k] + crossings[k + 1]) / 2, y, crossings[k + 1] - crossings[k]};
    return best;
}

constexpr std::size_t most_chords = 16;

}  // namespace

std::array<double, 2> inner_point(std::span<const GridPoint> ring) {
    const std::array<double, 2> centre = centroid(ring);
    if (depth(ring, centre) >= std::max(0.25, mean_depth(ring) / 2)) return centre;
    std::vector<std::int32_t> levels;
    for (const GridPoint p : ring) levels.push_back(p.y);
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    std::vector<std::pair<std::int32_t, std::int32_t>> gaps;  // height, from
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) gaps.emplace_back(levels[k] - levels[k + 1], levels[k]);
    std::sort(gaps.begin(), gaps.end());
    gaps.resize(std::min(gaps.size(), most_chords));
    Chord best;
    std::vector<double> crossings;
    for (const auto& [negative_height, from] : gaps) {
        const double height = -double(negative_height);
        Chord chord = longest_chord(ring, from + height / 2, crossings);
        chord.room = std::min(chord.room, height);
        if (chord.room > best.room) best = chord;
    }
    if (best.room > 0) return {best.x, best.y};
    return centre;
}

std::array<double, 3> cell_node(const Building& building, std::uint32_t volume) {
    const plans::GridFrame& frame = building.frame;
    const Volume& row = building.volumes[volume];
    if (row.piece >= building.pieces.size()) {
        const double x = (double(building.site_min[0]) + building.site_max[0]) / 2;
        const double y = (double(building.site_min[1]) + building.site_max[1]) / 2;
        return {frame.origin_x + frame.unit * x, frame.origin_y + frame.unit * y,
                frame.origin_z + frame.unit * building.site_max[2] + 1};
    }
    const Piece& piece = building.pieces[row.piece];
    std::vector<GridPoint> ring(piece.corner_count);
    for (std::uint32_t k = 0; k < piece.corner_count; ++k)
        ring[k] = building.points[building.corners[piece.first_corner + k].vertex];
    const std::array<double, 2> point = inner_point(ring);
    return {frame.origin_x + frame.unit * point[0], frame.origin_y + frame.unit * point[1],
            frame.origin_z + frame.unit * (double(row.z_low) + row.z_high) / 2};
}

}  // namespace enfilade::modeler
