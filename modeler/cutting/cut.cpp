#include "modeler/cutting/cut.h"

#include <algorithm>

#include "modeler/cutting/delaunay_partition.h"
#include "modeler/cutting/diagonal_partition.h"
#include "modeler/cutting/sah_partition.h"

namespace enfilade::modeler {
namespace {

/// For each boundary half-edge, what stands on the other side of its edge.
class Neighbours {
public:
    explicit Neighbours(const Stack& stack) : stack_(stack) {
        first_.assign(2 * stack.edges.size() + 1, 0);
        for (const std::uint32_t h : stack.boundary) ++first_[h + 1];
        for (std::size_t h = 1; h < first_.size(); ++h) first_[h] += first_[h - 1];
        regions_.resize(stack.boundary.size());
        std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
        for (std::uint32_t r = 0; r < stack.regions.size(); ++r)
            for (std::uint32_t k = 0; k < stack.regions[r].half_edge_count; ++k)
                regions_[fill[stack.boundary[stack.regions[r].first_half_edge + k]]++] = r;
    }

    /// Of the regions behind a half-edge of `region`: which let light through, and how many slices they have.
    [[nodiscard]] std::array<std::uint32_t, 2> behind(const Region& region, std::uint32_t half_edge) const {
        std::uint64_t look = 1;
        std::uint32_t faces = 0;
        for (std::uint32_t k = first_[half_edge ^ 1]; k < first_[(half_edge ^ 1) + 1]; ++k) {
            const Region& other = stack_.regions[regions_[k]];
            if (other.last_band < region.first_band || other.first_band > region.last_band) continue;
            if (other.carries_light) look = (look ^ (regions_[k] + 2)) * 0x9e3779b97f4a7c15u;
            faces += slice_count(other);
        }
        return {std::uint32_t(look >> 32 ^ look), std::max(faces, 1u)};
    }

private:
    [[nodiscard]] std::uint32_t slice_count(const Region& region) const {
        std::uint32_t count = 0;
        for (std::uint32_t band = region.first_band; band <= region.last_band; ++band)
            count += stack_.columns[stack_.region_columns[region.first_column + band - region.first_band]].slice_count;
        return region.carries_light ? count : 1;
    }

    const Stack& stack_;
    std::vector<std::uint32_t> first_;    ///< [half-edge + 1]
    std::vector<std::uint32_t> regions_;  ///< with this half-edge on their boundary
};

Partition convex_partition(std::span<const plans::GridPoint> points, std::span<const PolygonSide> ring,
                           const CutOptions& options, const SahOptions& sah) {
    switch (options.convexifier) {
        case Convexifier::Sah: return sah_partition(points, ring, PartitionGoal::Convex, sah);
        case Convexifier::Diagonals: return diagonal_partition(points, ring);
        case Convexifier::HertelMehlhorn: break;
    }
    return delaunay_partition(points, ring, PartitionGoal::Convex);
}

/// Gathers the pieces of one region.
class RegionCutBuilder {
public:
    RegionCutBuilder(const Stack& stack, RegionCut& cut) : cut_(cut) {
        for (const std::uint32_t p : cut.points) points_.push_back(stack.points[p]);
    }
    [[nodiscard]] const std::vector<plans::GridPoint>& points() const { return points_; }

    /// The rings of the discs; the cuts between them become edges like those of the plan.
    [[nodiscard]] std::vector<std::vector<PolygonSide>> add_discs(Partition discs) {
        take_points(discs);
        for (PolygonSide& side : discs.sides) {
            if (side.tag != cut_tag) continue;
            const std::array<std::uint32_t, 2> ends = {std::min(side.from, side.to), std::max(side.from, side.to)};
            const auto at = std::find(cut_.disc_cuts.begin(), cut_.disc_cuts.end(), ends);
            const std::uint32_t k = std::uint32_t(at - cut_.disc_cuts.begin());
            if (at == cut_.disc_cuts.end()) cut_.disc_cuts.push_back(ends);
            side.tag = first_disc_cut + 2 * k + (side.from == ends[0] ? 0 : 1);
            side.look = first_disc_cut + k;
            if (side.line >= first_cut_line) side.line = disc_line(side.line);
        }
        std::vector<std::vector<PolygonSide>> rings;
        for (std::uint32_t d = 0; d < discs.piece_count(); ++d)
            rings.emplace_back(discs.piece(d).begin(), discs.piece(d).end());
        cut_.disc_count = discs.piece_count();
        return rings;
    }

    void add_pieces(std::uint32_t disc, Partition pieces) {
        take_points(pieces);
        std::uint32_t next_line = cut_line_end_;
        for (PolygonSide side : pieces.sides) {
            if (side.line >= first_cut_line) {
                side.line = side.line - first_cut_line + cut_line_end_;
                next_line = std::max(next_line, side.line + 1);
            }
            cut_.sides.push_back(side);
        }
        cut_line_end_ = next_line;
        const std::uint32_t base = cut_.first_side.back();
        for (std::uint32_t k = 0; k < pieces.piece_count(); ++k) {
            cut_.first_side.push_back(base + pieces.first_side[k + 1]);
            cut_.disc.push_back(disc);
        }
    }

private:
    void take_points(Partition& from) {
        points_.insert(points_.end(), from.new_points.begin(), from.new_points.end());
        cut_.new_points.insert(cut_.new_points.end(), from.new_points.begin(), from.new_points.end());
        cut_.moved += from.moved;
        cut_.fallen_back += from.fallen_back;
    }
    std::uint32_t disc_line(std::uint32_t line) {
        auto at = std::find(disc_lines_.begin(), disc_lines_.end(), line);
        if (at == disc_lines_.end()) at = disc_lines_.insert(at, line);
        return first_disc_line + std::uint32_t(at - disc_lines_.begin());
    }

    RegionCut& cut_;
    std::vector<plans::GridPoint> points_;
    std::vector<std::uint32_t> disc_lines_;
    std::uint32_t cut_line_end_ = first_cut_line;
};

}  // namespace

RegionCutter::RegionCutter(const Stack& stack, const CutOptions& options) : stack_(stack), options_(options) {
    const Neighbours neighbours(stack);
    look_.resize(stack.boundary.size());
    faces_.resize(stack.boundary.size());
    for (const Region& region : stack.regions) {
        if (!region.carries_light) continue;
        for (std::uint32_t k = region.first_half_edge; k < region.first_half_edge + region.half_edge_count; ++k) {
            const auto [look, faces] = neighbours.behind(region, stack.boundary[k]);
            look_[k] = look;
            faces_[k] = faces;
        }
    }
}

RegionPolygon RegionCutter::polygon(std::uint32_t r) const {
    const Region& region = stack_.regions[r];
    RegionPolygon result;
    result.carries_light = region.carries_light;
    result.height = stack_.bands[region.last_band].z_high - stack_.bands[region.first_band].z_low;
    result.sides.reserve(region.half_edge_count);
    for (std::uint32_t k = region.first_half_edge; k < region.first_half_edge + region.half_edge_count; ++k) {
        const std::uint32_t h = stack_.boundary[k];
        const StackEdge& edge = stack_.edges[h / 2];
        PolygonSide side{edge.a, edge.b, edge.line, h, look_[k], faces_[k]};
        if (h % 2 == 1) std::swap(side.from, side.to);
        result.sides.push_back(side);
        result.points.push_back(side.from);
    }
    std::sort(result.points.begin(), result.points.end());
    result.points.erase(std::unique(result.points.begin(), result.points.end()), result.points.end());
    const auto local = [&](std::uint32_t point) {
        return std::uint32_t(std::lower_bound(result.points.begin(), result.points.end(), point) -
                             result.points.begin());
    };
    for (PolygonSide& side : result.sides) side.from = local(side.from), side.to = local(side.to);
    return result;
}

bool RegionCutter::same_in(const RegionCutter& other, std::uint32_t r) const {
    const Stack &s = stack_, &t = other.stack_;
    if (r >= t.regions.size()) return false;
    const Region &a = s.regions[r], &b = t.regions[r];
    if (a.half_edge_count != b.half_edge_count || a.carries_light != b.carries_light ||
        s.bands[a.last_band].z_high - s.bands[a.first_band].z_low !=
            t.bands[b.last_band].z_high - t.bands[b.first_band].z_low)
        return false;
    for (std::uint32_t k = 0; k < a.half_edge_count; ++k) {
        const std::uint32_t i = a.first_half_edge + k, j = b.first_half_edge + k, h = s.boundary[i];
        if (h != t.boundary[j] || look_[i] != other.look_[j] || faces_[i] != other.faces_[j]) return false;
        const StackEdge &e = s.edges[h / 2], &f = t.edges[h / 2];
        if (e.a != f.a || e.b != f.b || e.line != f.line || s.points[e.a] != t.points[f.a] ||
            s.points[e.b] != t.points[f.b])
            return false;
    }
    return true;
}

RegionCut RegionCutter::cut(RegionPolygon polygon) const {
    RegionCut result;
    if (polygon.sides.empty()) return result;
    result.points = std::move(polygon.points);
    SahOptions sah{options_.cost, stack_.frame.unit, polygon.height * stack_.frame.unit};
    RegionCutBuilder builder(stack_, result);
    const std::vector<std::vector<PolygonSide>> discs = builder.add_discs(
        polygon.carries_light ? sah_partition(builder.points(), polygon.sides, PartitionGoal::Disc, sah)
                              : delaunay_partition(builder.points(), polygon.sides, PartitionGoal::Disc));
    for (std::uint32_t d = 0; d < discs.size(); ++d) {
        if (options_.convex && polygon.carries_light) {
            builder.add_pieces(d, convex_partition(builder.points(), discs[d], options_, sah));
        } else {
            Partition whole;
            whole.sides = discs[d];
            whole.first_side.push_back(std::uint32_t(discs[d].size()));
            builder.add_pieces(d, std::move(whole));
        }
    }
    return result;
}

std::vector<RegionCut> cut_regions(const Stack& stack, const CutOptions& options, const accel::Executor& executor) {
    const RegionCutter cutter(stack, options);
    std::vector<RegionCut> cuts(stack.regions.size());
    accel::parallel_for(executor, cuts.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) cuts[r] = cutter.cut(std::uint32_t(r));
    });
    return cuts;
}

}  // namespace enfilade::modeler
