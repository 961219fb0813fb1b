// The cuts of single regions on common segments.

#include <algorithm>
#include <map>

#include "base/check.h"
#include "modeler/cutting/cut.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

/// Edges on which cuts end, each as the chain of its parts. Points are rounded, so a chain may leave the straight line
/// by half a unit; both sides of the edge follow it.
class SplitEdges {
public:
    /// \pre point lies within half a unit per axis of the segment, or is one of its ends
    void add(std::uint32_t segment, GridPoint point) { points_.push_back({segment, point}); }

    /// Orders the points; `segments` are split in place: the first part takes the segment's own place.
    void split(CutPieces& pieces) {
        std::sort(points_.begin(), points_.end());
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        for (std::size_t begin = 0, end; begin < points_.size(); begin = end) {
            end = begin;
            while (end < points_.size() && points_[end].segment == points_[begin].segment) ++end;
            split_one(points_[begin].segment, std::span(points_).subspan(begin, end - begin), pieces);
        }
    }

    /// Appends the half-edges from one point of a segment to another, in that direction.
    void append(std::uint32_t segment, GridPoint from, GridPoint to, bool reversed, const CutPieces& pieces,
                std::vector<std::uint32_t>& half_edges) const {
        const auto at = std::lower_bound(chains_.begin(), chains_.end(), segment,
                                         [](const Chain& chain, std::uint32_t s) { return chain.segment < s; });
        if (at == chains_.end() || at->segment != segment) {
            half_edges.push_back(2 * segment + (reversed ? 1 : 0));
            return;
        }
        const std::size_t first = half_edges.size();
        const GridPoint start = reversed ? to : from, stop = reversed ? from : to;
        bool inside = false;
        for (std::uint32_t k = 0; k < at->part_count; ++k) {
            const std::uint32_t part = k == 0 ? segment : at->first_part + k - 1;
            if (pieces.points[pieces.segments[part][0]] == start) inside = true;
            if (inside) half_edges.push_back(2 * part + (reversed ? 1 : 0));
            if (pieces.points[pieces.segments[part][1]] == stop) break;
        }
        if (reversed) std::reverse(half_edges.begin() + std::ptrdiff_t(first), half_edges.end());
        ENFILADE_CHECK(half_edges.size() > first);
    }

private:
    struct SplitPoint {
        std::uint32_t segment;
        GridPoint point;
        friend auto operator<=>(const SplitPoint&, const SplitPoint&) = default;
    };
    struct Chain {
        std::uint32_t segment, first_part, part_count;
    };

    void split_one(std::uint32_t segment, std::span<const SplitPoint> points, CutPieces& pieces) {
        const auto [a, b] = pieces.segments[segment];
        const GridPoint p = pieces.points[a], q = pieces.points[b];
        std::vector<GridPoint> inner;
        for (const SplitPoint& at : points)
            if (at.point != p && at.point != q) inner.push_back(at.point);
        if (inner.empty()) return;
        // Rounding keeps the order of points along a line, in each coordinate.
        const bool x_falls = q.x < p.x, y_falls = q.y < p.y;
        std::sort(inner.begin(), inner.end(), [&](GridPoint s, GridPoint t) {
            if (s.x != t.x) return (s.x < t.x) != x_falls;
            return (s.y < t.y) != y_falls;
        });
        chains_.push_back({segment, std::uint32_t(pieces.segments.size()), std::uint32_t(inner.size()) + 1});
        std::uint32_t before = a;
        for (std::size_t k = 0; k <= inner.size(); ++k) {
            std::uint32_t end = b;
            if (k < inner.size()) {
                end = std::uint32_t(pieces.points.size());
                pieces.points.push_back(inner[k]);
            }
            if (k == 0) pieces.segments[segment] = {before, end};
            else pieces.segments.push_back({before, end});
            before = end;
        }
    }

    std::vector<SplitPoint> points_;
    std::vector<Chain> chains_;  ///< by ascending segment
};

class Joiner {
public:
    Joiner(const Stack& stack, std::span<const RegionCut> cuts) : stack_(stack), cuts_(cuts) {}

    CutPieces run() {
        pieces_.points = stack_.points;
        for (const StackEdge& edge : stack_.edges) pieces_.segments.push_back({edge.a, edge.b});
        pieces_.line_count = stack_.line_count;
        for (std::uint32_t r = 0; r < cuts_.size(); ++r) add_points(r);
        split_.split(pieces_);
        for (std::uint32_t r = 0; r < cuts_.size(); ++r) add_pieces(r);
        return std::move(pieces_);
    }

private:
    [[nodiscard]] std::uint32_t point(std::uint32_t r, std::uint32_t local) const {
        const RegionCut& cut = cuts_[r];
        const std::uint32_t own = std::uint32_t(cut.points.size());
        return local < own ? cut.points[local] : first_new_point_[r] + local - own;
    }

    /// The segment under a side that is no cut between convex pieces, and whether the side runs back on it.
    [[nodiscard]] std::array<std::uint32_t, 2> segment_of(std::uint32_t r, std::uint32_t tag) const {
        if (tag < first_disc_cut) return {tag / 2, tag % 2};
        return {first_disc_segment_[r] + (tag - first_disc_cut) / 2, tag % 2};
    }

    void add_points(std::uint32_t r) {
        const RegionCut& cut = cuts_[r];
        first_new_point_.push_back(std::uint32_t(pieces_.points.size()));
        pieces_.points.insert(pieces_.points.end(), cut.new_points.begin(), cut.new_points.end());
        first_disc_segment_.push_back(std::uint32_t(pieces_.segments.size()));
        for (const auto& [a, b] : cut.disc_cuts) pieces_.segments.push_back({point(r, a), point(r, b)});
        for (const PolygonSide& side : cut.sides) {
            if (side.tag == cut_tag) continue;
            const auto [segment, reversed] = segment_of(r, side.tag);
            const auto [a, b] = pieces_.segments[segment];
            const std::uint32_t from = point(r, side.from), to = point(r, side.to);
            if (from != (reversed ? b : a)) split_.add(segment, pieces_.points[from]);
            if (to != (reversed ? a : b)) split_.add(segment, pieces_.points[to]);
        }
    }

    void add_pieces(std::uint32_t r) {
        const RegionCut& cut = cuts_[r];
        std::map<std::array<std::uint32_t, 2>, std::uint32_t> cut_segments;
        std::map<std::uint32_t, std::uint32_t> lines;
        const std::uint32_t first_disc = std::uint32_t(pieces_.disc_region.size());
        pieces_.disc_region.insert(pieces_.disc_region.end(), cut.disc_count, r);
        for (std::uint32_t k = 0; k + 1 < cut.first_side.size(); ++k) {
            for (std::uint32_t s = cut.first_side[k]; s < cut.first_side[k + 1]; ++s) {
                const PolygonSide& side = cut.sides[s];
                const std::uint32_t from = point(r, side.from), to = point(r, side.to);
                if (side.tag == cut_tag) {
                    const std::array<std::uint32_t, 2> ends = {std::min(from, to), std::max(from, to)};
                    const auto [at, is_new] = cut_segments.try_emplace(ends, std::uint32_t(pieces_.segments.size()));
                    if (is_new) pieces_.segments.push_back(ends);
                    pieces_.sides.push_back(2 * at->second + (from == ends[0] ? 0 : 1));
                } else {
                    const auto [segment, reversed] = segment_of(r, side.tag);
                    split_.append(segment, pieces_.points[from], pieces_.points[to], reversed == 1, pieces_,
                                  pieces_.sides);
                }
                std::uint32_t line = side.line;
                if (line >= first_disc_line) {
                    const auto [at, is_new] = lines.try_emplace(line, pieces_.line_count);
                    if (is_new) ++pieces_.line_count;
                    line = at->second;
                }
                pieces_.side_line.resize(pieces_.sides.size(), line);
            }
            pieces_.region.push_back(r);
            pieces_.disc.push_back(first_disc + cut.disc[k]);
            pieces_.first_side.push_back(std::uint32_t(pieces_.sides.size()));
        }
    }

    const Stack& stack_;
    std::span<const RegionCut> cuts_;
    CutPieces pieces_;
    SplitEdges split_;
    std::vector<std::uint32_t> first_new_point_;     ///< [region]
    std::vector<std::uint32_t> first_disc_segment_;  ///< [region]
};

}  // namespace

CutPieces join_cuts(const Stack& stack, std::span<const RegionCut> cuts) { return Joiner(stack, cuts).run(); }

}  // namespace enfilade::modeler
