#include "modeler/region.h"

#include <unordered_map>

#include "base/disjoint_sets.h"

namespace enfilade::modeler {
namespace {

using plans::Layout;

constexpr std::uint32_t no_index = UINT32_MAX;

/// Numbers for sequences of columns: a sequence is known by the number of its beginning and its last column.
class SequenceIds {
public:
    std::uint32_t extend(std::uint32_t beginning, std::uint32_t column) {
        const std::uint64_t key = std::uint64_t(beginning) << 32 | column;
        return ids_.try_emplace(key, std::uint32_t(ids_.size())).first->second;
    }

private:
    std::unordered_map<std::uint64_t, std::uint32_t> ids_;
};

class RegionFinder {
public:
    RegionFinder(const Layout& layout, const std::vector<std::vector<std::uint32_t>>& columns, Stack& stack)
        : layout_(layout), columns_(columns), stack_(stack), face_count_(layout.map.face_count) {}

    void run() {
        find_runs();
        region_.assign(stack_.bands.size(), {});
        for (std::uint32_t band = 0; band < stack_.bands.size(); ++band) number_regions(band);
        dissolve_and_chain();
        collect_boundaries();
    }

private:
    [[nodiscard]] const Slice& top(std::uint32_t column) const {
        const Column& c = stack_.columns[column];
        return stack_.slices[c.first_slice + c.slice_count - 1];
    }
    [[nodiscard]] const Slice& bottom(std::uint32_t column) const {
        return stack_.slices[stack_.columns[column].first_slice];
    }

    /// Bands are joined over a face where light passes from the top slice of one to the bottom slice of the next.
    void find_runs() {
        const std::size_t bands = stack_.bands.size();
        key_.assign(bands, std::vector<std::uint32_t>(face_count_, no_index));
        starts_.assign(bands, std::vector<bool>(face_count_, false));
        last_.assign(bands, std::vector<std::uint32_t>(face_count_, 0));
        SequenceIds sequences;
        for (std::uint32_t face = 1; face < face_count_; ++face)
            for (std::uint32_t b = 0; b < bands;) {
                std::uint32_t end = b;
                std::uint32_t id = sequences.extend(no_index, columns_[b][face]);
                while (end + 1 < bands && carries_light(top(columns_[end][face]).label) &&
                       carries_light(bottom(columns_[end + 1][face]).label)) {
                    ++end;
                    id = sequences.extend(id, columns_[end][face]);
                }
                starts_[b][face] = true;
                for (std::uint32_t k = b; k <= end; ++k) key_[k][face] = id, last_[k][face] = end;
                b = end + 1;
            }
    }

    void number_regions(std::uint32_t band) {
        region_[band].assign(face_count_, no_index);
        DisjointSets faces(face_count_);
        for (std::uint32_t e = 0; e < layout_.graph.edges.size(); ++e) {
            const std::uint32_t f = layout_.map.face(2 * e), g = layout_.map.face(2 * e + 1);
            if (f == 0 || g == 0 || !starts_[band][f] || !starts_[band][g] || key_[band][f] != key_[band][g]) continue;
            faces.join(f, g);
        }
        for (std::uint32_t face = 1; face < face_count_; ++face) {
            if (!starts_[band][face]) {
                region_[band][face] = region_[band - 1][face];
                continue;
            }
            const std::uint32_t root = faces.find(face);
            if (region_[band][root] == no_index) region_[band][root] = add_region(band, root);
            region_[band][face] = region_[band][root];
        }
    }

    std::uint32_t add_region(std::uint32_t band, std::uint32_t face) {
        Region region;
        region.first_band = band;
        region.last_band = last_[band][face];
        region.first_column = std::uint32_t(stack_.region_columns.size());
        for (std::uint32_t b = band; b <= region.last_band; ++b) {
            stack_.region_columns.push_back(columns_[b][face]);
            const Column& column = stack_.columns[columns_[b][face]];
            for (std::uint32_t s = 0; s < column.slice_count; ++s)
                region.carries_light |= carries_light(stack_.slices[column.first_slice + s].label);
        }
        stack_.regions.push_back(region);
        return std::uint32_t(stack_.regions.size() - 1);
    }

    [[nodiscard]] bool is_boundary(std::uint32_t edge) const {
        const std::uint32_t f = layout_.map.face(2 * edge), g = layout_.map.face(2 * edge + 1);
        if (f == g) return false;
        for (const auto& region : region_)
            if (region[f] != region[g]) return true;
        return false;
    }

    void dissolve_and_chain() {
        const plans::NodedGraph& graph = layout_.graph;
        const std::uint32_t vertex_count = std::uint32_t(graph.vertices.size());
        std::vector<bool> kept(graph.edges.size());
        std::vector<std::uint32_t> degree(vertex_count, 0);
        std::vector<std::array<std::uint32_t, 2>> at(vertex_count, {no_index, no_index});
        for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
            kept[e] = is_boundary(e);
            if (!kept[e]) continue;
            for (const std::uint32_t v : {graph.edges[e].a, graph.edges[e].b}) {
                if (degree[v] < 2) at[v][degree[v]] = e;
                ++degree[v];
            }
        }
        const auto other_end = [&](std::uint32_t e, std::uint32_t v) {
            return graph.edges[e].a == v ? graph.edges[e].b : graph.edges[e].a;
        };
        const auto dissolves = [&](std::uint32_t v) {
            if (degree[v] != 2) return false;
            const auto [e, f] = at[v];
            return layout_.edge_line[e] == layout_.edge_line[f] &&
                   orientation(graph.vertices[other_end(e, v)], graph.vertices[v], graph.vertices[other_end(f, v)]) ==
                       0;
        };
        std::vector<std::uint32_t> point(vertex_count, no_index);
        const auto point_of = [&](std::uint32_t v) {
            if (point[v] == no_index) {
                point[v] = std::uint32_t(stack_.points.size());
                stack_.points.push_back(graph.vertices[v]);
            }
            return point[v];
        };
        std::vector<bool> done(graph.edges.size(), false);
        for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
            if (!kept[e] || done[e] || dissolves(graph.edges[e].a)) continue;
            std::uint32_t v = graph.edges[e].a;
            // Edges point from the lesser to the greater vertex, and a chain is straight: its first edge starts it.
            std::uint32_t edge = e;
            done[edge] = true;
            std::uint32_t w = other_end(edge, v);
            while (dissolves(w)) {
                edge = at[w][0] == edge ? at[w][1] : at[w][0];
                done[edge] = true;
                w = other_end(edge, w);
            }
            stack_.edges.push_back({point_of(v), point_of(w), std::uint32_t(layout_.edge_line[e])});
            fine_.push_back(2 * e);
        }
    }

    void collect_boundaries() {
        std::vector<std::vector<std::uint32_t>> sides(stack_.regions.size());
        for (std::uint32_t k = 0; k < stack_.edges.size(); ++k) {
            const std::uint32_t left = layout_.map.face(fine_[k]), right = layout_.map.face(fine_[k] ^ 1);
            for (std::uint32_t b = 0; b < stack_.bands.size(); ++b) {
                const std::uint32_t l = region_[b][left], r = region_[b][right];
                if (l == r) continue;
                if (l != no_index && stack_.regions[l].first_band == b) sides[l].push_back(2 * k);
                if (r != no_index && stack_.regions[r].first_band == b) sides[r].push_back(2 * k + 1);
            }
        }
        for (std::uint32_t r = 0; r < sides.size(); ++r) {
            stack_.regions[r].first_half_edge = std::uint32_t(stack_.boundary.size());
            stack_.regions[r].half_edge_count = std::uint32_t(sides[r].size());
            stack_.boundary.insert(stack_.boundary.end(), sides[r].begin(), sides[r].end());
        }
    }

    const Layout& layout_;
    const std::vector<std::vector<std::uint32_t>>& columns_;
    Stack& stack_;
    std::uint32_t face_count_;
    std::vector<std::vector<std::uint32_t>> key_, last_, region_;  ///< [band][face]
    std::vector<std::vector<bool>> starts_;                        ///< [band][face] a run starts here
    std::vector<std::uint32_t> fine_;                              ///< [stack edge] its first half-edge in the layout
};

}  // namespace

void find_regions(const Layout& layout, const std::vector<std::vector<std::uint32_t>>& band_columns, Stack& stack) {
    RegionFinder(layout, band_columns, stack).run();
}

}  // namespace enfilade::modeler
