#include "modeler/editing/region_split.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/disjoint_sets.h"
#include "modeler/editing/route.h"
#include "plans/planar_map.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr std::uint32_t no_index = UINT32_MAX;

/// Area over half the perimeter, from twice the area: of long strips their width.
double thickness(double doubled_area, double perimeter) { return perimeter > 0 ? doubled_area / perimeter : 0; }

class RegionSplitter {
public:
    RegionSplitter(const Stack& stack, std::uint32_t region, std::span<const PlacedBox> boxes)
        : stack_(stack), region_(stack.regions[region]), boxes_(boxes) {}

    RegionSplit run() {
        lay_out();
        wind();
        settle_overlaps();
        for (std::uint32_t k = 0; k < boxes_.size(); ++k) drop_thin_parts(k);
        give_splinters_away();
        number_parts();
        if (result_.parts.size() > 1 || (result_.parts.size() == 1 && !result_.parts[0].boxes.empty())) emit();
        return std::move(result_);
    }

private:
    [[nodiscard]] std::uint32_t half_edge(std::uint32_t k) const {
        return stack_.boundary[region_.first_half_edge + k];
    }

    void lay_out() {
        std::vector<plans::Segment> fixed, added;
        for (std::uint32_t k = 0; k < region_.half_edge_count; ++k) {
            const StackEdge& edge = stack_.edges[half_edge(k) / 2];
            const GridPoint a = stack_.points[edge.a], b = stack_.points[edge.b];
            if (half_edge(k) % 2 == 0) fixed.push_back({a, b});
            else fixed.push_back({b, a});
        }
        for (std::uint32_t k = 0; k < boxes_.size(); ++k)
            for (std::uint32_t i = 0; i < boxes_[k].footprint.size(); ++i) {
                added.push_back({boxes_[k].footprint[i], boxes_[k].footprint[(i + 1) % boxes_[k].footprint.size()]});
                side_of_.push_back({k, i});
            }
        routed_ = route(fixed, added);
        map_ = plans::planar_map(routed_.graph);
        fixed_count_ = region_.half_edge_count;
        area2_.assign(map_.face_count, 0);
        for (std::size_t loop = 0; loop < map_.loop_area2.size(); ++loop)
            area2_[map_.face_of_loop[loop]] += double(map_.loop_area2[loop]);
        for (const plans::NodedEdge& edge : routed_.graph.edges) {
            const GridPoint a = routed_.graph.vertices[edge.a], b = routed_.graph.vertices[edge.b];
            length_.push_back(std::hypot(double(b.x) - a.x, double(b.y) - a.y));
        }
    }

    [[nodiscard]] std::uint32_t left(std::uint32_t e) const { return map_.face(2 * e); }
    [[nodiscard]] std::uint32_t right(std::uint32_t e) const { return map_.face(2 * e + 1); }
    [[nodiscard]] std::uint32_t edge_count() const { return std::uint32_t(routed_.graph.edges.size()); }
    /// Whether a side of the region runs along the edge.
    [[nodiscard]] bool is_fixed(std::uint32_t e) const {
        return routed_.graph.uses[routed_.graph.edges[e].first_use].segment < fixed_count_;
    }

    /// How often the region and each box run around each face: from the outer face inwards, edge by edge.
    void wind() {
        const std::size_t items = boxes_.size() + 1;
        std::vector<std::int16_t> winding(items * map_.face_count, 0);
        std::vector<std::vector<std::uint32_t>> around(map_.face_count);
        for (std::uint32_t e = 0; e < edge_count(); ++e) {
            around[left(e)].push_back(2 * e);
            around[right(e)].push_back(2 * e + 1);
        }
        std::vector<bool> known(map_.face_count, false);
        std::vector<std::uint32_t> queue = {0};
        known[0] = true;
        for (std::size_t at = 0; at < queue.size(); ++at)
            for (const std::uint32_t h : around[queue[at]]) {
                const std::uint32_t other = map_.face(h ^ 1);
                if (known[other]) continue;
                known[other] = true;
                queue.push_back(other);
                for (std::size_t i = 0; i < items; ++i) winding[other * items + i] = winding[queue[at] * items + i];
                const plans::NodedEdge& edge = routed_.graph.edges[h / 2];
                for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
                    const plans::EdgeUse use = routed_.graph.uses[u];
                    const std::size_t item =
                        use.segment < fixed_count_ ? 0 : 1 + side_of_[use.segment - fixed_count_][0];
                    // Left of a directed side is inside; `other` lies on the right of h.
                    const bool along = use.reversed == (h % 2 == 1);
                    winding[other * items + item] = std::int16_t(winding[other * items + item] + (along ? -1 : 1));
                }
            }
        inside_.resize(map_.face_count);
        over_.resize(map_.face_count);
        for (std::uint32_t f = 0; f < map_.face_count; ++f) {
            inside_[f] = winding[f * items] > 0;
            if (!inside_[f]) continue;
            for (std::uint32_t k = 0; k < boxes_.size(); ++k)
                if (winding[f * items + 1 + k] > 0) over_[f].push_back(k);
        }
    }

    [[nodiscard]] bool share_height(std::uint32_t j, std::uint32_t k) const {
        return std::max(boxes_[j].z_low, boxes_[k].z_low) < std::min(boxes_[j].z_high, boxes_[k].z_high);
    }
    [[nodiscard]] bool is_over(std::uint32_t f, std::uint32_t k) const {
        return std::binary_search(over_[f].begin(), over_[f].end(), k);
    }

    void settle_overlaps() {
        std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> shared;  // pair -> faces
        for (std::uint32_t f = 0; f < map_.face_count; ++f)
            for (std::size_t i = 0; i < over_[f].size(); ++i)
                for (std::size_t j = i + 1; j < over_[f].size(); ++j)
                    if (share_height(over_[f][i], over_[f][j])) shared[{over_[f][i], over_[f][j]}].push_back(f);
        std::vector<bool> in(map_.face_count, false);
        for (const auto& [pair, faces] : shared) {
            double doubled_area = 0, perimeter = 0;
            for (const std::uint32_t f : faces) in[f] = true, doubled_area += area2_[f];
            for (std::uint32_t e = 0; e < edge_count(); ++e)
                if (in[left(e)] != in[right(e)]) perimeter += length_[e];
            for (const std::uint32_t f : faces) in[f] = false;
            if (thickness(doubled_area, perimeter) >= least_thickness)
                result_.overlaps.push_back({boxes_[pair[0]].box, boxes_[pair[1]].box});
        }
        for (std::vector<std::uint32_t>& over : over_) {
            std::vector<std::uint32_t> kept;
            for (const std::uint32_t k : over)
                if (std::none_of(kept.begin(), kept.end(), [&](std::uint32_t j) { return share_height(j, k); }))
                    kept.push_back(k);
            over = std::move(kept);
        }
    }

    /// Sets of faces of the region that hang together across edges which `same` accepts, each with its thickness.
    template <class Same>
    [[nodiscard]] std::vector<double> connect(DisjointSets& sets, Same same) const {
        sets.reset(map_.face_count);
        for (std::uint32_t e = 0; e < edge_count(); ++e)
            if (inside_[left(e)] && inside_[right(e)] && !is_fixed(e) && same(left(e), right(e)))
                sets.join(left(e), right(e));
        std::vector<double> doubled_area(map_.face_count, 0), perimeter(map_.face_count, 0);
        for (std::uint32_t f = 0; f < map_.face_count; ++f) doubled_area[sets.find(f)] += area2_[f];
        for (std::uint32_t e = 0; e < edge_count(); ++e) {
            const std::uint32_t l = sets.find(left(e)), r = sets.find(right(e));
            if (l == r) continue;
            perimeter[l] += length_[e];
            perimeter[r] += length_[e];
        }
        for (std::uint32_t f = 0; f < map_.face_count; ++f) doubled_area[f] = thickness(doubled_area[f], perimeter[f]);
        return doubled_area;
    }

    void drop_thin_parts(std::uint32_t k) {
        DisjointSets sets;
        const std::vector<double> thick =
            connect(sets, [&](std::uint32_t f, std::uint32_t g) { return is_over(f, k) && is_over(g, k); });
        for (std::uint32_t f = 0; f < map_.face_count; ++f)
            if (is_over(f, k) && thick[sets.find(f)] < least_thickness) std::erase(over_[f], k);
    }

    /// Floor too thin to be any goes to the box with which it shares most of its sides.
    void give_splinters_away() {
        DisjointSets sets;
        const std::vector<double> thick =
            connect(sets, [&](std::uint32_t f, std::uint32_t g) { return over_[f] == over_[g]; });
        const auto is_splinter = [&](std::uint32_t f) {
            return inside_[f] && over_[f].empty() && thick[sets.find(f)] < least_thickness;
        };
        std::map<std::uint32_t, std::map<std::vector<std::uint32_t>, double>> shared;  // splinter -> boxes -> length
        for (std::uint32_t e = 0; e < edge_count(); ++e)
            for (const auto& [f, g] : {std::pair(left(e), right(e)), std::pair(right(e), left(e))})
                if (is_splinter(f) && inside_[g] && !over_[g].empty() && !is_fixed(e))
                    shared[sets.find(f)][over_[g]] += length_[e];
        for (std::uint32_t f = 0; f < map_.face_count; ++f) {
            if (!is_splinter(f)) continue;
            const auto at = shared.find(sets.find(f));
            if (at == shared.end()) continue;
            over_[f] = std::max_element(at->second.begin(), at->second.end(), [](const auto& p, const auto& q) {
                           return p.second < q.second;
                       })->first;
        }
    }

    void number_parts() {
        DisjointSets sets;
        (void)connect(sets, [&](std::uint32_t f, std::uint32_t g) { return over_[f] == over_[g]; });
        part_.assign(map_.face_count, no_index);
        for (const bool boxed : {false, true})
            for (std::uint32_t f = 0; f < map_.face_count; ++f) {
                if (!inside_[f] || over_[f].empty() == boxed) continue;
                const std::uint32_t root = sets.find(f);
                if (part_[root] == no_index) {
                    part_[root] = std::uint32_t(result_.parts.size());
                    result_.parts.emplace_back();
                    for (const std::uint32_t k : over_[f]) result_.parts.back().boxes.push_back(boxes_[k].box);
                }
                part_[f] = part_[root];
            }
    }

    void emit() {
        std::vector<bool> is_corner(routed_.graph.vertices.size(), false);
        for (std::uint32_t e = 0; e < edge_count(); ++e) {
            if (is_fixed(e) || part_[left(e)] == part_[right(e)]) continue;
            for (const std::uint32_t v : {routed_.graph.edges[e].a, routed_.graph.edges[e].b}) is_corner[v] = true;
            emit_new(e);
        }
        for (std::uint32_t s = 0; s < fixed_count_; ++s) emit_fixed(s, is_corner);
    }

    void emit_new(std::uint32_t e) {
        const plans::NodedEdge& edge = routed_.graph.edges[e];
        const GridPoint a = routed_.graph.vertices[edge.a], b = routed_.graph.vertices[edge.b];
        const auto [k, side] = side_of_[routed_.graph.uses[edge.first_use].segment - fixed_count_];
        const std::uint32_t number = std::uint32_t(result_.new_edges.size());
        result_.new_edges.push_back({a, b, boxes_[k].box, side});
        if (const std::uint32_t p = part_[left(e)]; p != no_index)
            result_.parts[p].sides.push_back({number, true, false, a, b});
        if (const std::uint32_t p = part_[right(e)]; p != no_index)
            result_.parts[p].sides.push_back({number, true, true, b, a});
    }

    /// The pieces of a side of the region, joined again where nothing ends between them.
    void emit_fixed(std::uint32_t s, const std::vector<bool>& is_corner) {
        std::uint32_t before = no_index;
        for (const std::uint32_t h : routed_.chains[s]) {
            const plans::NodedEdge& edge = routed_.graph.edges[h / 2];
            const std::uint32_t p = part_[map_.face(h)];
            // Sides that rounding lays onto each other: the first one counts, and what is between them is gone.
            if (p == no_index || p == part_[map_.face(h ^ 1)] || routed_.graph.uses[edge.first_use].segment != s) {
                before = no_index;
                continue;
            }
            const std::uint32_t v = plans::origin(routed_.graph, h);
            const GridPoint from = routed_.graph.vertices[v];
            const GridPoint to = routed_.graph.vertices[plans::origin(routed_.graph, h ^ 1)];
            std::vector<SplitSide>& sides = result_.parts[p].sides;
            if (before == p && !is_corner[v]) sides.back().to = to;
            else sides.push_back({half_edge(s) / 2, false, half_edge(s) % 2 == 1, from, to});
            before = p;
        }
    }

    const Stack& stack_;
    const Region& region_;
    std::span<const PlacedBox> boxes_;
    std::vector<std::array<std::uint32_t, 2>> side_of_;  ///< [added segment] box, side
    std::uint32_t fixed_count_ = 0;
    RoutedGraph routed_;
    plans::PlanarMap map_;
    std::vector<double> area2_;                     ///< [face]
    std::vector<double> length_;                    ///< [edge]
    std::vector<bool> inside_;                      ///< [face]
    std::vector<std::vector<std::uint32_t>> over_;  ///< [face] boxes, ascending
    std::vector<std::uint32_t> part_;               ///< [face]
    RegionSplit result_;
};

}  // namespace

RegionSplit split_region(const Stack& stack, std::uint32_t region, std::span<const PlacedBox> boxes) {
    return RegionSplitter(stack, region, boxes).run();
}

}  // namespace enfilade::modeler
