#include "modeler/extrude.h"

#include <algorithm>

#include "modeler/overlay.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t no_index = UINT32_MAX;

/// A side of an edge between two volumes, from z_low to z_high.
struct SideInterval {
    std::int32_t z_low, z_high;
    std::uint32_t left, right;  ///< volumes
};

class Extruder {
public:
    Extruder(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph)
        : stack_(stack), pieces_(pieces), graph_(graph) {}

    Extrusion run() {
        number_volumes();
        raise_sides();
        number_vertices();
        emit_sides();
        emit_levels_inside_bands();
        emit_bottom_and_top();
        for (std::uint32_t b = 0; b + 1 < stack_.bands.size(); ++b) emit_interface(b);
        result_.tuples.vertex_count = std::uint32_t(result_.vertices.size());
        result_.tuples.volume_count = std::uint32_t(result_.volumes.size());
        return std::move(result_);
    }

private:
    [[nodiscard]] const Region& region_of(std::uint32_t piece) const {
        return stack_.regions[pieces_.region[graph_.source[piece]]];
    }
    [[nodiscard]] const Column& column_of(std::uint32_t piece, std::uint32_t band) const {
        const Region& region = region_of(piece);
        return stack_.columns[stack_.region_columns[region.first_column + band - region.first_band]];
    }
    /// Volume of slice s of the piece's column in a band.
    [[nodiscard]] std::uint32_t volume(std::uint32_t piece, std::uint32_t band, std::uint32_t slice) const {
        const Region& region = region_of(piece);
        std::uint32_t at = first_slice_volume_[piece] + slice;
        for (std::uint32_t b = region.first_band; b < band; ++b) at += column_of(piece, b).slice_count;
        return slice_volume_[at];
    }
    [[nodiscard]] std::uint32_t bottom_volume(std::uint32_t piece, std::uint32_t band) const {
        return volume(piece, band, 0);
    }
    [[nodiscard]] std::uint32_t top_volume(std::uint32_t piece, std::uint32_t band) const {
        return volume(piece, band, column_of(piece, band).slice_count - 1);
    }

    /// Calls visit(band, slice, z_low, continues): `continues` where the slice goes on from the one below it.
    template <class Visit>
    void for_each_slice(const Region& region, Visit visit) const {
        const Slice* below = nullptr;
        for (std::uint32_t b = region.first_band; b <= region.last_band; ++b) {
            const Column& column = stack_.columns[stack_.region_columns[region.first_column + b - region.first_band]];
            std::int32_t z = stack_.bands[b].z_low;
            for (std::uint32_t s = 0; s < column.slice_count; ++s) {
                const Slice& slice = stack_.slices[column.first_slice + s];
                const bool continues = below && s == 0 && below->space == slice.space &&
                                       (slice.label == Label::Exterior || slice.label == Label::Object);
                visit(slice, z, continues);
                z = slice.z_high;
                below = &slice;
            }
        }
    }

    void number_volumes() {
        std::vector<std::uint32_t> first_parent;
        std::uint32_t parents = 0;
        for (const std::uint32_t r : pieces_.disc_region) {
            first_parent.push_back(parents);
            for_each_slice(stack_.regions[r],
                           [&](const Slice&, std::int32_t, bool continues) { parents += continues ? 0 : 1; });
        }
        for (std::uint32_t p = 0; p < graph_.piece_count(); ++p) {
            first_slice_volume_.push_back(std::uint32_t(slice_volume_.size()));
            std::uint32_t parent = first_parent[pieces_.disc[graph_.source[p]]];
            for_each_slice(region_of(p), [&](const Slice& slice, std::int32_t z, bool continues) {
                if (continues) result_.volumes.back().z_high = slice.z_high;
                else result_.volumes.push_back({slice.label, slice.space, p, parent++, z, slice.z_high});
                slice_volume_.push_back(std::uint32_t(result_.volumes.size() - 1));
            });
        }
        outside_ = std::uint32_t(result_.volumes.size());
        result_.volumes.push_back(
            {Label::Outside, outside_space, no_index, parents, stack_.bands.front().z_low, stack_.bands.back().z_high});
    }

    /// What stands on both sides of each edge, over all bands in which it is a boundary.
    void raise_sides() {
        const std::size_t bands = stack_.bands.size();
        band_edges_.resize(bands);
        std::vector<std::uint32_t> left(bands), right(bands);
        first_interval_.push_back(0);
        for (std::uint32_t e = 0; e < graph_.graph.edges.size(); ++e) {
            std::fill(left.begin(), left.end(), no_index);
            std::fill(right.begin(), right.end(), no_index);
            for (std::uint32_t k = graph_.first_edge_side[e]; k < graph_.first_edge_side[e + 1]; ++k) {
                const EdgeSide side = graph_.edge_sides[k];
                const Region& region = region_of(side.piece);
                for (std::uint32_t b = region.first_band; b <= region.last_band; ++b)
                    (side.right ? right : left)[b] = side.piece;
            }
            for (std::uint32_t b = 0; b < bands; ++b) {
                if (left[b] == no_index && right[b] == no_index) continue;
                band_edges_[b].push_back({e, left[b], right[b]});
                raise_band(b, left[b], right[b]);
            }
            first_interval_.push_back(std::uint32_t(intervals_.size()));
        }
    }

    void raise_band(std::uint32_t b, std::uint32_t left, std::uint32_t right) {
        std::int32_t z = stack_.bands[b].z_low;
        std::uint32_t l = 0, r = 0;
        while (z < stack_.bands[b].z_high) {
            const std::int32_t left_top = slice_top(left, b, l), right_top = slice_top(right, b, r);
            const std::int32_t top = std::min(left_top, right_top);
            const std::uint32_t left_volume = left == no_index ? outside_ : volume(left, b, l);
            const std::uint32_t right_volume = right == no_index ? outside_ : volume(right, b, r);
            SideInterval* below = intervals_.size() > first_interval_.back() ? &intervals_.back() : nullptr;
            if (below && below->z_high == z && below->left == left_volume && below->right == right_volume)
                below->z_high = top;
            else intervals_.push_back({z, top, left_volume, right_volume});
            z = top;
            if (left_top == top) ++l;
            if (right_top == top) ++r;
        }
    }
    [[nodiscard]] std::int32_t slice_top(std::uint32_t piece, std::uint32_t band, std::uint32_t slice) const {
        if (piece == no_index) return stack_.bands[band].z_high;
        return stack_.slices[column_of(piece, band).first_slice + slice].z_high;
    }

    /// A vertex at every level of a side face over the point.
    void number_vertices() {
        const auto& edges = graph_.graph.edges;
        std::vector<std::uint32_t> count(graph_.graph.vertices.size() + 1, 0);
        for (std::uint32_t e = 0; e < edges.size(); ++e)
            for (const std::uint32_t v : {edges[e].a, edges[e].b})
                count[v + 1] += 2 * (first_interval_[e + 1] - first_interval_[e]);
        for (std::size_t v = 1; v < count.size(); ++v) count[v] += count[v - 1];
        std::vector<std::int32_t> all(count.back());
        std::vector<std::uint32_t> fill(count.begin(), count.end() - 1);
        for (std::uint32_t e = 0; e < edges.size(); ++e)
            for (std::uint32_t k = first_interval_[e]; k < first_interval_[e + 1]; ++k)
                for (const std::uint32_t v : {edges[e].a, edges[e].b}) {
                    all[fill[v]++] = intervals_[k].z_low;
                    all[fill[v]++] = intervals_[k].z_high;
                }
        first_level_.push_back(0);
        for (std::uint32_t v = 0; v + 1 < count.size(); ++v) {
            const auto begin = all.begin() + count[v], end = all.begin() + count[v + 1];
            std::sort(begin, end);
            levels_.insert(levels_.end(), begin, std::unique(begin, end));
            first_level_.push_back(std::uint32_t(levels_.size()));
            for (std::uint32_t k = first_level_[v]; k < first_level_[v + 1]; ++k)
                result_.vertices.push_back({graph_.graph.vertices[v].x, graph_.graph.vertices[v].y, levels_[k]});
        }
    }
    /// The map vertex over point v at level z.
    [[nodiscard]] std::uint32_t vertex(std::uint32_t v, std::int32_t z) const {
        const auto begin = levels_.begin() + first_level_[v], end = levels_.begin() + first_level_[v + 1];
        return std::uint32_t(std::lower_bound(begin, end, z) - levels_.begin());
    }

    void begin_face(Face face) {
        result_.faces.push_back(face);
        result_.tuples.face_volumes.push_back({face.front, face.back});
        if (result_.tuples.ring_first.empty()) result_.tuples.ring_first.push_back(0);
    }
    void end_face() { result_.tuples.ring_first.push_back(std::uint32_t(result_.tuples.ring.size())); }

    void emit_sides() {
        for (std::uint32_t e = 0; e < graph_.graph.edges.size(); ++e)
            for (std::uint32_t k = first_interval_[e]; k < first_interval_[e + 1]; ++k) {
                const SideInterval& side = intervals_[k];
                const plans::NodedEdge& edge = graph_.graph.edges[e];
                begin_face({Direction::Side, side.left, side.right, e, side.z_low, side.z_high});
                std::vector<std::uint32_t>& ring = result_.tuples.ring;
                ring.push_back(vertex(edge.a, side.z_low));
                for (std::uint32_t v = vertex(edge.b, side.z_low), top = vertex(edge.b, side.z_high); v <= top; ++v)
                    ring.push_back(v);
                for (std::uint32_t v = vertex(edge.a, side.z_high), bottom = vertex(edge.a, side.z_low); v > bottom;
                     --v)
                    ring.push_back(v);
                end_face();
            }
    }

    /// A horizontal face, counter-clockwise seen from above, `front` above it.
    void emit_level(std::span<const std::uint32_t> half_edges, std::int32_t z, std::uint32_t above,
                    std::uint32_t below) {
        begin_face({Direction::Up, above, below, 0, z, z});
        for (const std::uint32_t h : half_edges)
            result_.tuples.ring.push_back(vertex(plans::origin(graph_.graph, h), z));
        end_face();
    }

    void emit_levels_inside_bands() {
        for (std::uint32_t p = 0; p < graph_.piece_count(); ++p) {
            const Region& region = region_of(p);
            for (std::uint32_t b = region.first_band; b <= region.last_band; ++b)
                for (std::uint32_t s = 0; s + 1 < column_of(p, b).slice_count; ++s)
                    emit_level(graph_.piece(p), slice_top(p, b, s), volume(p, b, s + 1), volume(p, b, s));
        }
    }

    void emit_bottom_and_top() {
        const std::uint32_t last = std::uint32_t(stack_.bands.size() - 1);
        for (std::uint32_t p = 0; p < graph_.piece_count(); ++p) {
            const Region& region = region_of(p);
            if (region.first_band == 0)
                emit_level(graph_.piece(p), stack_.bands[0].z_low, bottom_volume(p, 0), outside_);
            if (region.last_band == last)
                emit_level(graph_.piece(p), stack_.bands[last].z_high, outside_, top_volume(p, last));
        }
    }

    void emit_interface(std::uint32_t b) {
        const std::int32_t z = stack_.bands[b].z_high;
        overlay(graph_, band_edges_[b], band_edges_[b + 1],
                [&](std::span<const std::uint32_t> ring, std::uint32_t below, std::uint32_t above) {
                    const std::uint32_t below_volume = top_volume(below, b), above_volume = bottom_volume(above, b + 1);
                    if (below_volume != above_volume) emit_level(ring, z, above_volume, below_volume);
                });
    }

    const Stack& stack_;
    const CutPieces& pieces_;
    const PlanGraph& graph_;
    Extrusion result_;
    std::uint32_t outside_ = 0;
    std::vector<std::uint32_t> first_slice_volume_;  ///< [piece] into slice_volume_
    std::vector<std::uint32_t> slice_volume_;        ///< by piece, band, slice
    std::vector<std::vector<BandEdge>> band_edges_;  ///< [band]
    std::vector<SideInterval> intervals_;
    std::vector<std::uint32_t> first_interval_;  ///< [edge + 1]
    std::vector<std::int32_t> levels_;           ///< by point, ascending
    std::vector<std::uint32_t> first_level_;     ///< [point + 1]
};

}  // namespace

Extrusion extrude(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph) {
    return Extruder(stack, pieces, graph).run();
}

}  // namespace enfilade::modeler
