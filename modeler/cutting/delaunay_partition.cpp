#include "modeler/cutting/delaunay_partition.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/disjoint_sets.h"
#include "modeler/cutting/triangulation.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

/// The pieces while diagonals are taken out: rings of half-edges, three to a triangle at first.
class Rings {
public:
    Rings(std::span<const GridPoint> points, std::span<const PolygonSide> sides)
        : points_(points), sides_(sides), triangles_(triangulate(points, sides)) {
        next_.resize(from_.size());
        prev_.resize(from_.size());
        for (std::uint32_t h = 0; h < from_.size(); ++h) {
            next_[h] = next_in_triangle(h);
            prev_[h] = previous_in_triangle(h);
        }
    }

    void merge(PartitionGoal goal) {
        std::vector<std::uint32_t> diagonals;
        for (std::uint32_t h = 0; h < twin_.size(); ++h)
            if (twin_[h] != no_index && h < twin_[h]) diagonals.push_back(h);
        std::sort(diagonals.begin(), diagonals.end(), [&](std::uint32_t g, std::uint32_t h) {
            const auto key = [&](std::uint32_t e) {  // fragile cuts go first, then long ones
                return std::tuple(!is_fragile(e), -length2(e), std::min(from_[e], to(e)), std::max(from_[e], to(e)));
            };
            return key(g) < key(h);
        });
        pieces_.reset(from_.size() / 3);
        if (goal == PartitionGoal::Disc) {
            corners_.resize(pieces_.size());
            for (std::uint32_t h = 0; h < from_.size(); ++h) corners_[h / 3].insert(from_[h]);
        }
        for (const std::uint32_t h : diagonals) {
            const std::uint32_t p = pieces_.find(h / 3), q = pieces_.find(twin_[h] / 3);
            if (p == q) continue;
            if (goal == PartitionGoal::Disc ? !stays_disc(p, q) : !stays_convex(h)) continue;
            remove(h, p, q, goal);
        }
    }

    [[nodiscard]] Partition collect() const {
        Partition result;
        std::vector<bool> seen(from_.size(), false);
        for (std::uint32_t start = 0; start < from_.size(); ++start) {
            if (seen[start] || next_[start] == no_index) continue;
            for (std::uint32_t h = start; !seen[h]; h = next_[h]) {
                seen[h] = true;
                PolygonSide side = {from_[h], to(h), line(h), cut_tag};
                if (side_[h] != no_index) side = sides_[side_[h]];
                result.sides.push_back(side);
            }
            result.first_side.push_back(std::uint32_t(result.sides.size()));
        }
        return result;
    }

private:
    [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return from_[next_[h]]; }
    [[nodiscard]] std::int64_t length2(std::uint32_t h) const {
        const GridPoint a = points_[from_[h]], b = points_[to(h)];
        const std::int64_t x = std::int64_t(b.x) - a.x, y = std::int64_t(b.y) - a.y;
        return x * x + y * y;
    }
    /// Whether a corner of the triangles beside a diagonal is so near it that rounding may lay them onto each other.
    [[nodiscard]] bool is_fragile(std::uint32_t h) const {
        const double length = std::sqrt(double(length2(h)));
        const auto height = [&](std::uint32_t side) {
            return double(orientation(points_[from_[side]], points_[to(side)], points_[from_[prev_[side]]])) / length;
        };
        return std::min(height(h), height(twin_[h])) < least_gap;
    }
    [[nodiscard]] std::uint32_t line(std::uint32_t h) const {
        return side_[h] == no_index ? first_cut_line + std::min(h, twin_[h]) : sides_[side_[h]].line;
    }

    /// Whether side `out` goes straight on where side `in` ends.
    [[nodiscard]] bool one_line(std::uint32_t in, std::uint32_t out) const {
        return goes_straight(points_[from_[in]], points_[from_[out]], points_[to(out)], line(in), line(out));
    }
    /// The first and the last side of the straight run that a side is part of.
    [[nodiscard]] std::uint32_t run_first(std::uint32_t h) const {
        for (const std::uint32_t start = h; one_line(prev_[h], h) && prev_[h] != start;) h = prev_[h];
        return h;
    }
    [[nodiscard]] std::uint32_t run_last(std::uint32_t h) const {
        for (const std::uint32_t start = h; one_line(h, next_[h]) && next_[h] != start;) h = next_[h];
        return h;
    }
    [[nodiscard]] bool turns_left(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation(points_[a], points_[b], points_[c]) >= 0;
    }

    /// Whether `in` may be followed by `out`: between the chords of straight runs, which later roundings hardly turn.
    [[nodiscard]] bool corner_is_fine(std::uint32_t in, std::uint32_t out) const {
        const std::uint32_t first = run_first(in), last = run_last(out);
        if (!one_line(in, out)) return turns_left(from_[first], from_[out], to(last));
        return turns_left(from_[run_first(prev_[first])], from_[first], to(last)) &&
               turns_left(from_[first], to(last), to(run_last(next_[last])));
    }
    [[nodiscard]] bool stays_convex(std::uint32_t h) const {
        const std::uint32_t t = twin_[h];
        return corner_is_fine(prev_[h], next_[t]) && corner_is_fine(prev_[t], next_[h]);
    }
    /// Two discs joined along one diagonal are a disc iff they share no point but its ends.
    [[nodiscard]] bool stays_disc(std::uint32_t p, std::uint32_t q) const {
        const auto& small = corners_[p].size() < corners_[q].size() ? corners_[p] : corners_[q];
        const auto& large = corners_[p].size() < corners_[q].size() ? corners_[q] : corners_[p];
        std::size_t shared = 0;
        for (const std::uint32_t corner : small) shared += large.count(corner);
        return shared == 2;
    }

    void remove(std::uint32_t h, std::uint32_t p, std::uint32_t q, PartitionGoal goal) {
        const std::uint32_t t = twin_[h];
        const auto join = [&](std::uint32_t in, std::uint32_t out) { next_[in] = out, prev_[out] = in; };
        const std::uint32_t before_h = prev_[h], after_h = next_[h], before_t = prev_[t], after_t = next_[t];
        join(before_h, after_t);
        join(before_t, after_h);
        next_[h] = next_[t] = no_index;
        pieces_.join(p, q);
        if (goal != PartitionGoal::Disc) return;
        const std::uint32_t root = pieces_.find(p), other = root == p ? q : p;
        if (corners_[root].size() < corners_[other].size()) corners_[root].swap(corners_[other]);
        corners_[root].insert(corners_[other].begin(), corners_[other].end());
        corners_[other].clear();
    }

    std::span<const GridPoint> points_;
    std::span<const PolygonSide> sides_;
    Triangulation triangles_;
    const std::vector<std::uint32_t>&from_ = triangles_.from, &twin_ = triangles_.twin, &side_ = triangles_.side;
    std::vector<std::uint32_t> next_, prev_;                  ///< [3 * triangles]
    DisjointSets pieces_;                                     ///< of triangles
    std::vector<std::unordered_set<std::uint32_t>> corners_;  ///< [triangles] points of a piece, for the disc goal
};

}  // namespace

Partition delaunay_partition(std::span<const GridPoint> points, std::span<const PolygonSide> sides,
                             PartitionGoal goal) {
    const std::vector<std::uint32_t> ring = simple_ring(sides);
    if (!ring.empty() && (goal == PartitionGoal::Disc || is_convex(points, sides, ring))) {
        Partition result;
        for (const std::uint32_t k : ring) result.sides.push_back(sides[k]);
        result.first_side = {0, std::uint32_t(ring.size())};
        return result;
    }
    Rings rings(points, sides);
    rings.merge(goal);
    return rings.collect();
}

}  // namespace enfilade::modeler
