#include "tests/support/partition_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <unordered_map>

#include "tests/support/crossings.h"
#include "tests/support/piece_shape.h"

namespace enfilade::testing {
namespace {

using modeler::cut_tag;
using modeler::Partition;
using modeler::PartitionGoal;
using modeler::PolygonSide;
using plans::GridPoint;

std::string place(GridPoint p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

/// The pixel of `p` touches the segment from a to b.
bool lies_on(GridPoint p, GridPoint a, GridPoint b) {
    const std::int64_t dx = std::int64_t(b.x) - a.x, dy = std::int64_t(b.y) - a.y;
    return 2 * std::abs(orientation(a, b, p)) <= std::abs(dx) + std::abs(dy) && std::min(a.x, b.x) <= p.x &&
           p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

class Judge {
public:
    Judge(std::span<const GridPoint> points, std::span<const PolygonSide> sides, const Partition& partition,
          const PartitionWish& wish)
        : points_(points.begin(), points.end()), sides_(sides), partition_(partition), wish_(wish) {
        given_ = points_.size();
        points_.insert(points_.end(), partition.new_points.begin(), partition.new_points.end());
    }

    PartitionVerdict run() {
        if (!has_sound_indices()) return std::move(verdict_);
        if (!wish_.new_points && !partition_.new_points.empty()) fault("there are new points, and none were asked for");
        check_rings();
        check_given_sides();
        check_cuts();
        check_plane();
        check_area();
        if (wish_.goal == PartitionGoal::Convex && verdict_.faults.empty()) check_shapes();
        return std::move(verdict_);
    }

private:
    void fault(std::string sentence) { verdict_.faults.push_back(std::move(sentence)); }
    [[nodiscard]] std::string name(const PolygonSide& side) const {
        return place(points_[side.from]) + " to " + place(points_[side.to]);
    }

    bool has_sound_indices() {
        const auto& first = partition_.first_side;
        if (first.empty() || first.front() != 0 || first.back() != partition_.sides.size() ||
            !std::is_sorted(first.begin(), first.end())) {
            fault("the pieces do not share out the sides");
            return false;
        }
        for (const PolygonSide& side : partition_.sides)
            if (side.from >= points_.size() || side.to >= points_.size()) {
                fault("a side leads to a point that does not exist");
                return false;
            }
        return true;
    }

    void check_rings() {
        for (std::uint32_t k = 0; k < partition_.piece_count(); ++k) {
            const auto ring = partition_.piece(k);
            const std::string piece = "piece " + std::to_string(k);
            if (ring.size() < 3) {
                fault(piece + " has " + std::to_string(ring.size()) + " sides");
                continue;
            }
            std::set<GridPoint> seen;
            for (std::size_t s = 0; s < ring.size(); ++s) {
                if (ring[s].to != ring[(s + 1) % ring.size()].from) fault(piece + " is open after " + name(ring[s]));
                if (points_[ring[s].from] == points_[ring[s].to]) fault(piece + " has a side without length");
                if (!seen.insert(points_[ring[s].from]).second)
                    fault(piece + " visits " + place(points_[ring[s].from]) + " twice");
            }
            if (area2(points_, ring) <= 0) fault(piece + " has no area, at " + place(points_[ring[0].from]));
        }
    }

    /// The parts of each side of the polygon, from its start to its end.
    void check_given_sides() {
        std::unordered_map<std::uint32_t, std::vector<const PolygonSide*>> parts;
        for (const PolygonSide& side : partition_.sides)
            if (side.tag != cut_tag) parts[side.tag].push_back(&side);
        for (const PolygonSide& side : sides_) {
            const auto found = parts.find(side.tag);
            if (found == parts.end()) {
                fault("no piece has the side " + name(side));
                continue;
            }
            check_chain(side, found->second);
            parts.erase(found);
        }
        for (const auto& [tag, strangers] : parts)
            fault("tag " + std::to_string(tag) + " is not of the polygon: " + name(*strangers[0]));
    }

    void check_chain(const PolygonSide& side, const std::vector<const PolygonSide*>& parts) {
        std::uint32_t at = side.from;
        for (std::size_t taken = 0; taken < parts.size(); ++taken) {
            const auto next =
                std::find_if(parts.begin(), parts.end(), [&](const PolygonSide* part) { return part->from == at; });
            if (next == parts.end() || (taken > 0 && at == side.to)) {
                fault("the parts of " + name(side) + " are no chain at " + place(points_[at]));
                return;
            }
            const PolygonSide& part = **next;
            if (part.line != side.line || part.look != side.look || part.faces != side.faces)
                fault("a part of " + name(side) + " has changed its line, look or faces");
            if (part.to != side.to && !lies_on(points_[part.to], points_[side.from], points_[side.to]))
                fault("the side " + name(side) + " is led through " + place(points_[part.to]) + ", which is not on it");
            at = part.to;
        }
        if (at != side.to) fault("the parts of " + name(side) + " end at " + place(points_[at]));
    }

    void check_cuts() {
        std::map<std::array<std::uint32_t, 2>, std::vector<const PolygonSide*>> cuts;
        std::set<std::uint32_t> lines;
        for (const PolygonSide& side : sides_) lines.insert(side.line);
        for (const PolygonSide& side : partition_.sides)
            if (side.tag == cut_tag) cuts[{side.from, side.to}].push_back(&side);
        for (const auto& [ends, uses] : cuts) {
            const auto back = cuts.find({ends[1], ends[0]});
            if (uses.size() != 1 || back == cuts.end() || back->second.size() != 1) {
                fault("the cut " + name(*uses[0]) + " is not run once in each direction");
                continue;
            }
            const std::uint32_t line = uses[0]->line;
            if (line != back->second[0]->line) fault("the cut " + name(*uses[0]) + " has two lines");
            if (line < modeler::first_cut_line && !lines.contains(line))
                fault("the cut " + name(*uses[0]) + " is on a line that the polygon does not have");
        }
    }

    void check_plane() {
        std::vector<plans::Segment> segments;
        for (const PolygonSide& side : partition_.sides)
            if (side.tag != cut_tag || side.from < side.to) segments.push_back({points_[side.from], points_[side.to]});
        if (const auto pair = first_crossing(segments)) {
            const auto& [s, t] = *pair;
            fault("two sides meet: " + place(segments[s].a) + " to " + place(segments[s].b) + " and " +
                  place(segments[t].a) + " to " + place(segments[t].b));
        }
        std::map<GridPoint, std::uint32_t> at;
        for (const PolygonSide& side : partition_.sides) {
            const auto [found, is_new] = at.try_emplace(points_[side.from], side.from);
            if (!is_new && found->second != side.from) fault("two points lie at " + place(points_[side.from]));
        }
        for (std::size_t p = given_; p < points_.size(); ++p) verdict_.unused += !at.contains(points_[p]);
    }

    void check_area() {
        std::int64_t pieces = 0;
        for (std::uint32_t k = 0; k < partition_.piece_count(); ++k) pieces += area2(points_, partition_.piece(k));
        std::int64_t chains = 0;
        const GridPoint origin = points_.empty() ? GridPoint{} : points_[0];
        for (const PolygonSide& side : partition_.sides)
            if (side.tag != cut_tag) chains += orientation(origin, points_[side.from], points_[side.to]);
        if (pieces != chains) fault("the pieces do not sum to the polygon between the chains of its sides");
        verdict_.area2_change = pieces - area2(points_, sides_);
        const bool bent = std::any_of(partition_.sides.begin(), partition_.sides.end(), [&](const PolygonSide& side) {
            return side.tag != cut_tag && (side.from >= given_ || side.to >= given_);
        });
        if (!bent && verdict_.area2_change != 0) fault("the pieces do not sum to the polygon");
    }

    void check_shapes() {
        for (std::uint32_t k = 0; k < partition_.piece_count(); ++k) {
            const auto ring = partition_.piece(k);
            std::vector<modeler::RingCorner> corners;
            for (const PolygonSide& side : ring) corners.push_back({points_[side.from], side.line});
            const std::string piece = "piece " + std::to_string(k) + " at " + place(corners[0].point);
            if (const auto reflex = reflex_corner(corners))
                fault(piece + " is reflex at " + place(corners[*reflex].point));
            const double off = stray(corners);
            verdict_.stray = std::max(verdict_.stray, off);
            if (off > most_stray + 1e-9) fault(piece + " leaves one of its lines by " + std::to_string(off) + " units");
            const PieceShape shape = piece_shape(points_, ring);
            verdict_.dent = std::max(verdict_.dent, shape.dent);
            if (shape.dent > most_dent)
                fault(piece + " is dented by " + std::to_string(shape.dent) +
                      " units, though no corner counts as reflex");
            if (shape.width >= modeler::least_gap) continue;
            if (shape.between_walls) ++verdict_.thin_walls;
            else if (std::any_of(ring.begin(), ring.end(), [&](const PolygonSide& s) { return s.from >= given_; }))
                ++verdict_.thin_cuts;
            else ++verdict_.thin_corners;
        }
    }

    std::vector<GridPoint> points_;
    std::size_t given_ = 0;
    std::span<const PolygonSide> sides_;
    const Partition& partition_;
    PartitionWish wish_;
    PartitionVerdict verdict_;
};

}  // namespace

std::string PartitionVerdict::text() const {
    std::ostringstream text;
    for (const std::string& sentence : faults) text << sentence << '\n';
    return text.str();
}

PartitionVerdict judge_partition(std::span<const GridPoint> points, std::span<const PolygonSide> sides,
                                 const Partition& partition, const PartitionWish& wish) {
    return Judge(points, sides, partition, wish).run();
}

}  // namespace enfilade::testing
