#include "modeler/cutting/disc_merge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

#include "base/check.h"
#include "base/disjoint_sets.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr std::uint32_t no_side = UINT32_MAX;

class DiscMerger {
public:
    DiscMerger(std::span<const GridPoint> points, Partition pieces) : pieces_(std::move(pieces)) {
        points_.assign(points.begin(), points.end());
        points_.insert(points_.end(), pieces_.new_points.begin(), pieces_.new_points.end());
        given_point_count_ = std::uint32_t(points.size());
    }

    Partition run() {
        find_twins();
        merge();
        return collect();
    }

private:
    void find_twins() {
        const std::size_t count = pieces_.sides.size();
        next_.resize(count), twin_.assign(count, no_side), piece_.resize(count);
        removed_.assign(count, false);
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts;
        corners_.resize(pieces_.piece_count());
        for (std::uint32_t k = 0; k < pieces_.piece_count(); ++k) {
            const std::uint32_t begin = pieces_.first_side[k], end = pieces_.first_side[k + 1];
            for (std::uint32_t s = begin; s < end; ++s) {
                next_[s] = s + 1 == end ? begin : s + 1;
                piece_[s] = k;
                corners_[k].insert(pieces_.sides[s].from);
                if (pieces_.sides[s].tag == cut_tag) cuts[{pieces_.sides[s].from, pieces_.sides[s].to}] = s;
            }
        }
        for (const auto& [ends, s] : cuts) {
            const auto back = cuts.find({ends.second, ends.first});
            ENFILADE_CHECK(back != cuts.end());
            twin_[s] = back->second;
        }
    }

    void merge() {
        std::vector<std::uint32_t> cuts;
        for (std::uint32_t s = 0; s < twin_.size(); ++s)
            if (twin_[s] != no_side && s < twin_[s]) cuts.push_back(s);
        const auto length = [&](std::uint32_t s) {
            const GridPoint a = points_[pieces_.sides[s].from], b = points_[pieces_.sides[s].to];
            return std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        };
        std::stable_sort(cuts.begin(), cuts.end(),
                         [&](std::uint32_t s, std::uint32_t t) { return length(s) > length(t); });
        // The edges of a piece that are cuts, to count those that two pieces share.
        std::vector<std::vector<std::uint32_t>> own(pieces_.piece_count());
        for (std::uint32_t s = 0; s < twin_.size(); ++s)
            if (twin_[s] != no_side) own[piece_[s]].push_back(s);
        sets_.reset(pieces_.piece_count());
        for (const std::uint32_t s : cuts) {
            if (removed_[s]) continue;
            std::uint32_t p = sets_.find(piece_[s]), q = sets_.find(piece_[twin_[s]]);
            if (p == q) continue;
            if (own[p].size() > own[q].size()) std::swap(p, q);
            std::vector<std::uint32_t> shared;
            for (const std::uint32_t e : own[p])
                if (!removed_[e] && sets_.find(piece_[twin_[e]]) == q) shared.push_back(e);
            // Two discs joined along one chain of edges are a disc iff they share no point but the chain's.
            if (shared_corners(p, q) != shared.size() + 1) continue;
            for (const std::uint32_t e : shared) removed_[e] = removed_[twin_[e]] = true;
            sets_.join(p, q);
            const std::uint32_t root = sets_.find(p), other = root == p ? q : p;
            own[root].insert(own[root].end(), own[other].begin(), own[other].end());
            corners_[root].insert(corners_[other].begin(), corners_[other].end());
            own[other].clear();
            corners_[other].clear();
        }
    }

    [[nodiscard]] std::size_t shared_corners(std::uint32_t p, std::uint32_t q) const {
        const auto& small = corners_[p].size() < corners_[q].size() ? corners_[p] : corners_[q];
        const auto& large = corners_[p].size() < corners_[q].size() ? corners_[q] : corners_[p];
        std::size_t shared = 0;
        for (const std::uint32_t corner : small) shared += large.count(corner);
        return shared;
    }

    /// The side that follows where `s` ends, over the cuts that are gone.
    [[nodiscard]] std::uint32_t follow(std::uint32_t s) const {
        std::uint32_t n = next_[s];
        while (removed_[n]) n = next_[twin_[n]];
        return n;
    }

    Partition collect() {
        // A new point is needed where a cut that is left ends on a side or on another cut.
        std::vector<bool> is_needed(points_.size(), false);
        std::fill(is_needed.begin(), is_needed.begin() + given_point_count_, true);
        for (std::uint32_t s = 0; s < next_.size(); ++s) {
            if (removed_[s]) continue;
            const PolygonSide& side = pieces_.sides[s];
            const PolygonSide& after = pieces_.sides[follow(s)];
            if (!is_one(side, after)) is_needed[side.to] = true;
        }
        Partition result;
        result.moved = pieces_.moved;
        result.fallen_back = pieces_.fallen_back;
        std::vector<bool> seen(next_.size(), false);
        for (std::uint32_t start = 0; start < next_.size(); ++start) {
            if (removed_[start] || seen[start] || !is_needed[pieces_.sides[start].from]) continue;
            for (std::uint32_t s = start; !seen[s]; s = follow(s)) {
                PolygonSide side = pieces_.sides[s];
                seen[s] = true;
                while (!is_needed[side.to]) {
                    s = follow(s);
                    seen[s] = true;
                    side.to = pieces_.sides[s].to;
                }
                result.sides.push_back(side);
            }
            result.first_side.push_back(std::uint32_t(result.sides.size()));
        }
        result.new_points = std::move(pieces_.new_points);
        drop_unused_points(given_point_count_, result);
        return result;
    }

    [[nodiscard]] static bool is_one(const PolygonSide& a, const PolygonSide& b) {
        return a.tag == b.tag && a.line == b.line && (a.tag != cut_tag || a.line >= first_cut_line);
    }

    Partition pieces_;
    std::vector<GridPoint> points_;
    std::uint32_t given_point_count_ = 0;
    std::vector<std::uint32_t> next_, twin_, piece_;  ///< [side]
    std::vector<bool> removed_;                       ///< [side]
    std::vector<std::unordered_set<std::uint32_t>> corners_;
    DisjointSets sets_;
};

}  // namespace

Partition merge_to_discs(std::span<const GridPoint> points, Partition pieces) {
    return DiscMerger(points, std::move(pieces)).run();
}

}  // namespace enfilade::modeler
