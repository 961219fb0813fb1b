#include "modeler/cutting/merge_diagonals.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;
constexpr std::uint32_t gone = UINT32_MAX;

/// Pieces as linked rings of sides, so that taking out a diagonal costs four links.
class LinkedPieces {
public:
    LinkedPieces(std::span<const GridPoint> points, const Partition& pieces) : points_(points), sides_(pieces.sides) {
        next_.resize(sides_.size());
        prev_.resize(sides_.size());
        for (std::uint32_t p = 0; p < pieces.piece_count(); ++p)
            for (std::uint32_t h = pieces.first_side[p]; h < pieces.first_side[p + 1]; ++h)
                link(h, h + 1 == pieces.first_side[p + 1] ? pieces.first_side[p] : h + 1);
        for (std::uint32_t h = 0; h < sides_.size(); ++h)
            if (sides_[h].tag == cut_tag) cuts_.push_back(h);
        std::sort(cuts_.begin(), cuts_.end(), [&](std::uint32_t g, std::uint32_t h) {
            return std::pair(sides_[g].line, g) < std::pair(sides_[h].line, h);
        });
        ENFILADE_CHECK(cuts_.size() % 2 == 0);
    }

    void merge() {
        std::vector<std::uint32_t> order;
        for (std::uint32_t k = 0; k < cuts_.size(); k += 2) order.push_back(k);
        std::stable_partition(order.begin(), order.end(), [&](std::uint32_t k) { return is_fragile(k); });
        for (const std::uint32_t k : order) {
            const std::uint32_t h = cuts_[k], t = cuts_[k + 1];
            if (!corner_is_fine(prev_[h], next_[t]) || !corner_is_fine(prev_[t], next_[h])) continue;
            const std::uint32_t before_h = prev_[h], before_t = prev_[t];
            link(before_h, next_[t]);
            link(before_t, next_[h]);
            next_[h] = next_[t] = gone;
        }
    }

    [[nodiscard]] Partition collect() const {
        std::vector<std::uint32_t> line(sides_.size());
        std::uint32_t lines = first_cut_line;
        for (std::size_t k = 0; k < cuts_.size(); k += 2)
            if (next_[cuts_[k]] != gone) line[cuts_[k]] = line[cuts_[k + 1]] = lines++;
        Partition result;
        std::vector<bool> seen(sides_.size(), false);
        for (std::uint32_t start = 0; start < sides_.size(); ++start) {
            if (seen[start] || next_[start] == gone) continue;
            for (std::uint32_t h = start; !seen[h]; h = next_[h]) {
                seen[h] = true;
                result.sides.push_back(sides_[h]);
                if (sides_[h].tag == cut_tag) result.sides.back().line = line[h];
            }
            result.first_side.push_back(std::uint32_t(result.sides.size()));
        }
        return result;
    }

private:
    void link(std::uint32_t in, std::uint32_t out) { next_[in] = out, prev_[out] = in; }
    [[nodiscard]] GridPoint from(std::uint32_t h) const { return points_[sides_[h].from]; }
    [[nodiscard]] GridPoint to(std::uint32_t h) const { return points_[sides_[h].to]; }

    /// Whether the corners before or after a diagonal are so near its line that rounding may lay them onto it.
    [[nodiscard]] bool is_fragile(std::uint32_t k) const {
        const GridPoint a = from(cuts_[k]), b = to(cuts_[k]);
        const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        const auto near = [&](GridPoint p) { return std::abs(double(orientation(a, b, p))) < least_gap * length; };
        return near(from(prev_[cuts_[k]])) || near(to(next_[cuts_[k]])) || near(from(prev_[cuts_[k + 1]])) ||
               near(to(next_[cuts_[k + 1]]));
    }

    [[nodiscard]] bool one_line(std::uint32_t in, std::uint32_t out) const {
        return goes_straight(from(in), from(out), to(out), sides_[in].line, sides_[out].line);
    }
    /// The first and the last side of the straight run that a side is part of; `stop` ends the walk around a piece.
    [[nodiscard]] std::uint32_t run_first(std::uint32_t h) const {
        for (const std::uint32_t stop = next_[h]; prev_[h] != stop && one_line(prev_[h], h);) h = prev_[h];
        return h;
    }
    [[nodiscard]] std::uint32_t run_last(std::uint32_t h) const {
        for (const std::uint32_t stop = prev_[h]; next_[h] != stop && one_line(h, next_[h]);) h = next_[h];
        return h;
    }

    /// Whether `in` may be followed by `out`: as in `reflex_corner`, by the chords of the straight runs. Where the two
    /// become one run, that run's ends change their chords.
    [[nodiscard]] bool corner_is_fine(std::uint32_t in, std::uint32_t out) const {
        const std::uint32_t first = run_first(in), last = run_last(out);
        if (!one_line(in, out)) return orientation(from(first), from(out), to(last)) >= 0;
        return orientation(from(run_first(prev_[first])), from(first), to(last)) >= 0 &&
               orientation(from(first), to(last), to(run_last(next_[last]))) >= 0;
    }

    std::span<const GridPoint> points_;
    const std::vector<PolygonSide>& sides_;
    std::vector<std::uint32_t> next_, prev_;  ///< [side]
    std::vector<std::uint32_t> cuts_;         ///< the two sides of one diagonal, the two of the next, ...
};

bool all_convex(std::span<const GridPoint> points, const Partition& pieces) {
    std::vector<RingCorner> corners;
    for (std::uint32_t p = 0; p < pieces.piece_count(); ++p) {
        corners.clear();
        for (const PolygonSide& side : pieces.piece(p)) corners.push_back({points[side.from], side.line});
        if (reflex_corner(corners)) return false;
    }
    return true;
}

}  // namespace

Partition merge_diagonals(std::span<const GridPoint> points, Partition pieces) {
    LinkedPieces linked(points, pieces);
    linked.merge();
    Partition result = linked.collect();
    if (!all_convex(points, result)) return pieces;  // a bent run on around both ends of a diagonal
    result.new_points = std::move(pieces.new_points);
    result.moved = pieces.moved;
    result.fallen_back = pieces.fallen_back;
    return result;
}

}  // namespace enfilade::modeler
