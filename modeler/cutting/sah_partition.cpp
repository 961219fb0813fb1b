#include "modeler/cutting/sah_partition.h"

#include <algorithm>
#include <cmath>

#include "modeler/cutting/cut_chooser.h"
#include "modeler/cutting/disc_merge.h"
#include "modeler/cutting/section_split.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

/// Lengths of portal that cost a ray as much as the sections that a cut adds: two, one of them a cell's whole
/// surface away; and one more where it ends in the middle of a side.
CutPrice price_of(std::span<const GridPoint> points, std::span<const PolygonSide> sides, const SahOptions& options) {
    double perimeter = 0;
    for (const PolygonSide& side : sides)
        perimeter += std::hypot(double(points[side.to].x) - points[side.from].x,
                                double(points[side.to].y) - points[side.from].y);
    const CutCost& cost = options.cost;
    const double visit = cost.visit + 5 * cost.section + 8 * cost.face;
    const double cell = std::min(perimeter, 16 / options.unit);
    const double section = cell * (cost.section + cost.face) / (2 * visit);
    return {section, section / 2};
}

/// Takes out the cuts that later ones made needless, the longest first.
void remove_needless(Subdivision& subdivision) {
    std::vector<std::uint32_t> cuts;
    for (std::uint32_t t = subdivision.first_cut(); t < subdivision.track_count(); ++t) cuts.push_back(t);
    const auto length = [&](std::uint32_t t) {
        const GridPoint a = subdivision.point(subdivision.track(t).nodes.front()),
                        b = subdivision.point(subdivision.track(t).nodes.back());
        return std::hypot(double(b.x) - a.x, double(b.y) - a.y);
    };
    std::stable_sort(cuts.begin(), cuts.end(), [&](std::uint32_t s, std::uint32_t t) { return length(s) > length(t); });
    for (bool changed = true; changed;) {
        changed = false;
        for (const std::uint32_t t : cuts) {
            const Track& track = subdivision.track(t);
            if (track.removed || track.nodes.size() != 2 || !subdivision.is_removable(t)) continue;
            subdivision.remove(t);
            changed = true;
        }
    }
}

bool is_convex_ring(std::span<const GridPoint> points, std::span<const PolygonSide> ring) {
    std::vector<RingCorner> corners;
    for (const PolygonSide& side : ring) corners.push_back({points[side.from], side.line});
    return !reflex_corner(corners);
}

std::vector<GridPoint> all_points(std::span<const GridPoint> points, const Partition& partition) {
    std::vector<GridPoint> all(points.begin(), points.end());
    all.insert(all.end(), partition.new_points.begin(), partition.new_points.end());
    return all;
}

/// Pieces that are not convex after all (rounding, or no cut was found) are cut along diagonals, and pieces with many
/// sections further.
Partition finish(std::span<const GridPoint> points, Partition rough, const SahOptions& options) {
    const std::vector<GridPoint> all = all_points(points, rough);
    Partition result;
    result.new_points = std::move(rough.new_points);
    result.moved = rough.moved;
    result.fallen_back = rough.fallen_back;
    std::uint32_t next_line = first_cut_line;
    for (const PolygonSide& side : rough.sides)
        if (side.line >= first_cut_line) next_line = std::max(next_line, side.line + 1);
    for (std::uint32_t k = 0; k < rough.piece_count(); ++k) {
        const auto ring = rough.piece(k);
        if (is_convex_ring(all, ring)) {
            split_sections(all, ring, options, next_line, result);
            continue;
        }
        ++result.fallen_back;
        Partition parts = delaunay_partition(all, ring, PartitionGoal::Convex);
        std::uint32_t last_line = next_line;
        for (PolygonSide& side : parts.sides) {
            const bool is_own = std::none_of(ring.begin(), ring.end(),
                                             [&](const PolygonSide& given) { return given.line == side.line; });
            if (side.tag == cut_tag && is_own) {
                side.line = side.line - first_cut_line + next_line;
                last_line = std::max(last_line, side.line + 1);
            }
        }
        next_line = last_line;
        for (std::uint32_t p = 0; p < parts.piece_count(); ++p)
            split_sections(all, parts.piece(p), options, next_line, result);
    }
    return result;
}

bool is_sound(std::span<const GridPoint> points, const Partition& partition) {
    const std::vector<GridPoint> all = all_points(points, partition);
    for (std::uint32_t k = 0; k < partition.piece_count(); ++k)
        if (area2(all, partition.piece(k)) <= 0) return false;
    return true;
}

}  // namespace

Partition sah_partition(std::span<const GridPoint> points, std::span<const PolygonSide> sides, PartitionGoal goal,
                        const SahOptions& options) {
    const std::vector<std::uint32_t> ring = simple_ring(sides);
    if (!ring.empty() && (goal == PartitionGoal::Disc || is_convex(points, sides, ring))) {
        Partition whole;
        for (const std::uint32_t k : ring) whole.sides.push_back(sides[k]);
        whole.first_side.push_back(std::uint32_t(ring.size()));
        return goal == PartitionGoal::Disc ? whole : finish(points, std::move(whole), options);
    }
    CutChooser chooser(points, sides, price_of(points, sides, options));
    chooser.run();
    Subdivision& subdivision = chooser.subdivision();
    remove_needless(subdivision);
    Partition rough = subdivision.collect(sides);
    rough.moved = chooser.moved();
    if (!is_sound(points, rough)) {
        Partition safe = delaunay_partition(points, sides, goal);
        if (goal == PartitionGoal::Convex) safe = finish(points, std::move(safe), options);
        ++safe.fallen_back;
        return safe;
    }
    return goal == PartitionGoal::Disc ? merge_to_discs(points, std::move(rough)) : finish(points, std::move(rough), options);
}

}  // namespace enfilade::modeler
