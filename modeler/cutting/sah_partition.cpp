#include "modeler/cutting/sah_partition.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "modeler/cutting/cut_chooser.h"
#include "modeler/cutting/disc_merge.h"
#include "modeler/cutting/plane_check.h"
#include "modeler/cutting/section_split.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

/// Lengths of portal that cost a ray as much as the sections that a cut adds to the cells beside it (taken as 16 m
/// around, with five sections and eight faces), and as the one more where it ends in the middle of a side.
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
    return is_convex(corners);
}

std::vector<GridPoint> all_points(std::span<const GridPoint> points, const Partition& partition) {
    std::vector<GridPoint> all(points.begin(), points.end());
    all.insert(all.end(), partition.new_points.begin(), partition.new_points.end());
    return all;
}

constexpr std::uint32_t cut_lines_aside = first_cut_line / 4;

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
        // Lines of cuts made so far stand aside from those of the diagonals.
        std::vector<PolygonSide> aside(ring.begin(), ring.end());
        for (PolygonSide& side : aside)
            if (side.line >= first_cut_line) side.line -= cut_lines_aside;
        Partition parts = delaunay_partition(all, aside, PartitionGoal::Convex);
        std::uint32_t last_line = next_line;
        for (PolygonSide& side : parts.sides) {
            if (side.line >= first_cut_line) {
                side.line = side.line - first_cut_line + next_line;
                last_line = std::max(last_line, side.line + 1);
            } else if (side.line >= first_cut_line - cut_lines_aside) {
                side.line += cut_lines_aside;
            }
        }
        next_line = last_line;
        for (std::uint32_t p = 0; p < parts.piece_count(); ++p)
            split_sections(all, parts.piece(p), options, next_line, result);
    }
    return result;
}

/// Cuts at all reflex corners, or nothing where rounding them to the grid made some of them meet.
std::optional<Partition> cut_corners(std::span<const GridPoint> points, std::span<const PolygonSide> sides,
                                     const SahOptions& options, bool exact) {
    CutChooser chooser(points, sides, price_of(points, sides, options), exact);
    chooser.run();
    remove_needless(chooser.subdivision());
    Partition rough = chooser.subdivision().collect(sides);
    rough.moved = chooser.moved();
    rough.fallen_back = exact ? 1 : 0;
    if (!is_plane(all_points(points, rough), std::uint32_t(points.size()), rough)) return std::nullopt;
    return rough;
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
    std::optional<Partition> rough = cut_corners(points, sides, options, false);
    if (!rough) rough = cut_corners(points, sides, options, true);
    // Where walls are needles, two short diagonals at a corner beat one cut that makes it convex.
    Partition diagonals = delaunay_partition(points, sides, PartitionGoal::Convex);
    diagonals.fallen_back = rough ? 0 : 1;
    const auto cost = [&](const Partition& partition) {
        return sah_sum(points, partition, options.unit, options.height, options.cost);
    };
    Partition& better = rough && cost(*rough) <= cost(diagonals) ? *rough : diagonals;
    return goal == PartitionGoal::Disc ? merge_to_discs(points, std::move(better))
                                       : finish(points, std::move(better), options);
}

}  // namespace enfilade::modeler
