#include "modeler/cutting/diagonal_partition.h"

#include <algorithm>
#include <cmath>

#include "modeler/cutting/delaunay_partition.h"
#include "modeler/cutting/merge_diagonals.h"
#include "modeler/cutting/notch_grid.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

/// The corners first .. last of the rest, along its boundary: a piece but for the diagonal from last to first.
struct Chain {
    std::uint32_t first = 0, last = 0;
    std::uint32_t count = 0;
};

/// Rings that take more than this times the square of their corners are cut otherwise. (Spirals take 1.)
constexpr std::uint64_t work_per_square = 8;

enum class Growth : std::uint8_t { Forwards, Backwards };

/// The rest of the polygon, from which pieces are cut. Corners are positions in the ring at the start; corner k stands
/// at the start of side k.
class Rest {
public:
    Rest(std::span<const GridPoint> points, std::span<const PolygonSide> sides, std::span<const std::uint32_t> ring)
        : count_(std::uint32_t(ring.size())) {
        for (const std::uint32_t k : ring) {
            out_.push_back(sides[k]);
            at_.push_back(points[sides[k].from]);
        }
        next_.resize(count_), prev_.resize(count_);
        for (std::uint32_t k = 0; k < count_; ++k) link(k, (k + 1) % count_);
        is_notch_.resize(count_);
        in_chain_.resize(count_, false);
        std::vector<std::uint32_t> notches;
        for (std::uint32_t k = 0; k < count_; ++k)
            if ((is_notch_[k] = turn(k) < 0)) notches.push_back(k);
        grid_ = NotchGrid(at_, notches);
        work_left_ = work_per_square * count_ * count_ + 65536;
    }

    /// Cuts pieces off until the rest is convex, or there is none to cut off; returns whether it is convex.
    bool cut_pieces(Partition& pieces) {
        while (const std::optional<std::uint32_t> notch = next_reflex(start_)) {
            const std::optional<Chain> chain = next_piece(*notch);
            if (!chain) return false;
            cut_off(*chain, pieces);
        }
        return true;
    }

    [[nodiscard]] std::vector<PolygonSide> sides() const {
        std::vector<PolygonSide> ring;
        std::uint32_t k = start_;
        do ring.push_back(out_[k]);
        while ((k = next_[k]) != start_);
        return ring;
    }

private:
    void link(std::uint32_t a, std::uint32_t b) { next_[a] = b, prev_[b] = a; }
    [[nodiscard]] std::int64_t turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation(at_[a], at_[b], at_[c]);
    }
    [[nodiscard]] std::int64_t turn(std::uint32_t k) const { return turn(prev_[k], k, next_[k]); }
    [[nodiscard]] bool is_straight(std::uint32_t k) const {
        return goes_straight(at_[prev_[k]], at_[k], at_[next_[k]], out_[prev_[k]].line, out_[k].line);
    }
    /// The ends of the straight runs into and out of a corner, no farther than `stop`.
    [[nodiscard]] std::uint32_t run_end(std::uint32_t k, std::uint32_t stop) const {
        do k = next_[k];
        while (k != stop && is_straight(k));
        return k;
    }
    [[nodiscard]] std::uint32_t run_start(std::uint32_t k, std::uint32_t stop) const {
        do k = prev_[k];
        while (k != stop && is_straight(k));
        return k;
    }
    /// Whether a corner turns right between the chords of its straight runs, no farther than `stop`. What turns by
    /// chords later roundings hardly turn back: `reflex_corner` finds none where there is none here.
    [[nodiscard]] bool is_reflex(std::uint32_t k, std::uint32_t stop) const {
        const std::uint32_t before = prev_[k], after = next_[k];
        const bool runs_before = out_[prev_[before]].line == out_[before].line;
        const bool runs_after = out_[after].line == out_[k].line;
        if (!runs_before && !runs_after) return is_notch_[k] && !is_straight(k);
        return !is_straight(k) && turn(run_start(k, stop), k, run_end(k, stop)) < 0;
    }
    [[nodiscard]] bool is_reflex(std::uint32_t k) const { return is_reflex(k, k); }
    [[nodiscard]] std::optional<std::uint32_t> next_reflex(std::uint32_t from) const {
        std::uint32_t k = from;
        do
            if (is_reflex(k)) return k;
        while ((k = next_[k]) != from);
        return std::nullopt;
    }

    /// The paper's order: from each notch forwards, then from each backwards; only if that fails from all corners, and
    /// without a distance between diagonals and corners.
    std::optional<Chain> next_piece(std::uint32_t start) {
        for (const bool keep_gap : {true, false})
            for (const bool from_all : {false, true})
                for (const Growth growth : {Growth::Forwards, Growth::Backwards}) {
                    std::uint32_t k = start;
                    do {
                        if (work_left_ == 0) return std::nullopt;
                        if (!from_all && !is_reflex(k)) continue;
                        if (const Chain chain = piece_from(k, growth, keep_gap); chain.count >= 3) return chain;
                    } while ((k = next_[k]) != start);
                }
        return std::nullopt;
    }

    Chain piece_from(std::uint32_t start, Growth growth, bool keep_gap) {
        Chain chain = growth == Growth::Forwards ? grown_forwards(start) : grown_backwards(start);
        for (std::uint32_t k = chain.first;; k = next_[k]) {
            in_chain_[k] = true;
            if (k == chain.last) break;
        }
        while (chain.count >= 3) {
            if (const std::optional<std::uint32_t> notch = blocking(chain, keep_gap))
                shrink(chain, growth, at_[*notch]);
            else if (!closes_well(chain, keep_gap)) drop_end(chain, growth);
            else break;
        }
        for (std::uint32_t k = chain.first;; k = next_[k]) {
            in_chain_[k] = false;
            if (k == chain.last) break;
        }
        return chain;
    }

    /// Corners are added while the turns at the last corner, at the new one and at the first stay convex. As long as
    /// all is one line, the last two say nothing.
    [[nodiscard]] Chain grown_forwards(std::uint32_t start) {
        Chain chain{start, next_[start], 2};
        const std::uint32_t second = chain.last;
        for (bool one_line = true; next_[next_[chain.last]] != start; ++chain.count) {
            const std::uint32_t last = chain.last, added = next_[last];
            one_line = one_line && is_straight(last);
            if (is_reflex(last, start)) break;
            if (!one_line && (turn(last, added, start) < 0 || turn(added, start, second) < 0)) break;
            chain.last = added;
        }
        pay(chain.count);
        return chain;
    }
    [[nodiscard]] Chain grown_backwards(std::uint32_t start) {
        Chain chain{prev_[start], start, 2};
        const std::uint32_t second = chain.first;
        for (bool one_line = true; prev_[prev_[chain.first]] != start; ++chain.count) {
            const std::uint32_t first = chain.first, added = prev_[first];
            one_line = one_line && is_straight(first);
            if (is_reflex(first, start)) break;
            if (!one_line && (turn(start, added, first) < 0 || turn(second, start, added) < 0)) break;
            chain.first = added;
        }
        pay(chain.count);
        return chain;
    }

    /// A notch of the rest in the piece or on its border, or too near its diagonal.
    std::optional<std::uint32_t> blocking(const Chain& chain, bool keep_gap) {
        GridBox box;
        for (std::uint32_t k = chain.first;; k = next_[k]) {
            box.add(at_[k]);
            if (k == chain.last) break;
        }
        pay(chain.count);
        const auto gap = std::int32_t(std::ceil(least_gap));
        if (keep_gap) box = {{box.min.x - gap, box.min.y - gap}, {box.max.x + gap, box.max.y + gap}};
        std::optional<std::uint32_t> found;
        const auto blocks = [&](std::uint32_t k) {
            pay(1);
            if (in_chain_[k] || !is_notch_[k]) return false;
            if ((keep_gap && is_near(chain, k)) || holds(chain, at_[k])) found = k;
            return found.has_value();
        };
        grid_.find(
            box, [&](std::uint32_t k) { return !is_notch_[k]; }, blocks);
        return found;
    }

    /// Whether a point lies in the piece or on its diagonal. (It lies on no side of the polygon.)
    [[nodiscard]] bool holds(const Chain& chain, GridPoint p) {
        const GridPoint a = at_[chain.last], b = at_[chain.first];
        const std::int64_t beside = orientation(a, b, p);
        if (beside < 0) return false;
        if (beside == 0) {
            GridBox box;
            box.add(a), box.add(b);
            if (box.holds(p)) return true;
        }
        pay(chain.count);
        bool inside = false;
        for (std::uint32_t k = chain.first;; k = next_[k]) {
            const GridPoint from = at_[k], to = k == chain.last ? b : at_[next_[k]];
            if ((from.y > p.y) != (to.y > p.y) && (orientation(from, to, p) > 0) == (to.y > from.y)) inside = !inside;
            if (k == chain.last) break;
        }
        return inside;
    }

    /// Whether a corner lies closer than `least_gap` to the diagonal.
    [[nodiscard]] bool is_near(const Chain& chain, std::uint32_t corner) const {
        const GridPoint a = at_[chain.last], b = at_[chain.first], p = at_[corner];
        const double x = double(b.x) - a.x, y = double(b.y) - a.y, px = double(p.x) - a.x, py = double(p.y) - a.y;
        const double length2 = x * x + y * y, along = std::clamp((px * x + py * y) / length2, 0.0, 1.0);
        return std::hypot(px - along * x, py - along * y) < least_gap;
    }

    /// The paper's rule: corners that `notch` hides from the far end of the diagonal go, and at least one.
    void shrink(Chain& chain, Growth growth, GridPoint notch) {
        drop_end(chain, growth);
        const GridPoint pivot = at_[growth == Growth::Forwards ? chain.first : chain.last];
        while (chain.count >= 3) {
            const std::int64_t beside =
                orientation(pivot, notch, at_[growth == Growth::Forwards ? chain.last : chain.first]);
            if (growth == Growth::Forwards ? beside < 0 : beside > 0) break;
            drop_end(chain, growth);
        }
    }
    void drop_end(Chain& chain, Growth growth) {
        std::uint32_t& end = growth == Growth::Forwards ? chain.last : chain.first;
        in_chain_[end] = false;
        end = growth == Growth::Forwards ? prev_[end] : next_[end];
        --chain.count;
    }

    /// Whether the piece is one: convex at both ends of the diagonal and of the runs that it cuts, and all of it on the
    /// diagonal's left.
    [[nodiscard]] bool closes_well(const Chain& chain, bool keep_gap) {
        const std::uint32_t first = chain.first, last = chain.last;
        const std::uint32_t head = run_end(first, last), tail = run_start(last, first);
        if (head == last || turn(last, first, head) < 0 || turn(tail, last, first) < 0) return false;
        if (turn(first, head, run_end(head, last)) < 0 || turn(run_start(tail, first), tail, last) < 0) return false;
        pay(chain.count);
        for (std::uint32_t k = next_[first]; k != last; k = next_[k])
            if (turn(last, first, k) <= 0 || (keep_gap && is_near(chain, k))) return false;
        return !keep_gap || !(is_near(chain, prev_[first]) || is_near(chain, next_[last]));
    }

    void cut_off(const Chain& chain, Partition& pieces) {
        const std::uint32_t line = first_cut_line + cut_count_++;
        for (std::uint32_t k = chain.first; k != chain.last; k = next_[k]) {
            pieces.sides.push_back(out_[k]);
            if (k != chain.first) is_notch_[k] = false;
        }
        const std::uint32_t a = out_[chain.first].from, b = out_[chain.last].from;
        pieces.sides.push_back({b, a, line, cut_tag});
        pieces.first_side.push_back(std::uint32_t(pieces.sides.size()));
        out_[chain.first] = {a, b, line, cut_tag};
        link(chain.first, chain.last);
        for (const std::uint32_t k : {chain.first, chain.last}) is_notch_[k] = is_notch_[k] && turn(k) < 0;
        start_ = chain.last;
    }

    void pay(std::uint64_t work) { work_left_ -= std::min(work, work_left_); }

    std::uint32_t count_;
    std::vector<PolygonSide> out_;            ///< [corner] the side that leaves it
    std::vector<GridPoint> at_;               ///< [corner]
    std::vector<std::uint32_t> next_, prev_;  ///< [corner]
    std::vector<bool> is_notch_;              ///< [corner] of the rest, turning right; none becomes one later
    std::vector<bool> in_chain_;              ///< [corner]
    NotchGrid grid_{{}, {}};
    std::uint32_t start_ = 0;
    std::uint32_t cut_count_ = 0;
    std::uint64_t work_left_ = 0;
};

/// Lines of cuts made before, while a rest is cut once more: out of the way of those that are made there.
constexpr std::uint32_t earlier_cut_line = first_cut_line + (1u << 30);

/// What has no piece that can be cut off.
void cut_by_triangles(std::span<const GridPoint> points, std::vector<PolygonSide> rest, Partition& pieces) {
    std::uint32_t lines = first_cut_line + pieces.piece_count();  // so far a cut to each piece
    for (PolygonSide& side : rest)
        if (side.line >= first_cut_line) side.line += earlier_cut_line - first_cut_line;
    const Partition more = delaunay_partition(points, rest, PartitionGoal::Convex);
    std::vector<std::uint32_t> made;
    for (const PolygonSide& side : more.sides)
        if (side.line >= first_cut_line && side.line < earlier_cut_line) made.push_back(side.line);
    std::sort(made.begin(), made.end());
    made.erase(std::unique(made.begin(), made.end()), made.end());
    const std::uint32_t base = std::uint32_t(pieces.sides.size());
    for (PolygonSide side : more.sides) {
        if (side.line >= earlier_cut_line) side.line -= earlier_cut_line - first_cut_line;
        else if (side.line >= first_cut_line)
            side.line = lines + std::uint32_t(std::lower_bound(made.begin(), made.end(), side.line) - made.begin());
        pieces.sides.push_back(side);
    }
    for (std::uint32_t k = 1; k < more.first_side.size(); ++k) pieces.first_side.push_back(base + more.first_side[k]);
    ++pieces.fallen_back;
}

}  // namespace

Partition diagonal_partition(std::span<const GridPoint> points, std::span<const PolygonSide> sides) {
    const std::vector<std::uint32_t> ring = simple_ring(sides);
    Partition pieces;
    Rest rest(points, sides, ring);
    if (is_convex(points, sides, ring) || rest.cut_pieces(pieces)) {
        const std::vector<PolygonSide> last = rest.sides();
        pieces.sides.insert(pieces.sides.end(), last.begin(), last.end());
        pieces.first_side.push_back(std::uint32_t(pieces.sides.size()));
    } else {
        cut_by_triangles(points, rest.sides(), pieces);
    }
    return merge_diagonals(points, std::move(pieces));
}

}  // namespace enfilade::modeler
