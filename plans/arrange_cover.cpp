// Winding numbers across edges instead of point location: a closed chain adds one on its left.

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "plans/arrange_parts.h"

namespace enfilade::plans {
namespace {

using Entries = std::vector<Cover::Entry>;

/// What one gains by crossing the edge from its right to its left, by ascending region, without zeros.
void edge_delta(const NodedGraph& graph, const NodedEdge& edge, const std::vector<SegmentTag>& tags, Entries& delta) {
    delta.clear();
    for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
        const std::uint32_t region = tags[graph.uses[u].segment].region;
        if (region != kNone) delta.push_back({region, graph.uses[u].reversed ? -1 : 1});
    }
    if (delta.size() < 2) return;
    std::sort(delta.begin(), delta.end(), [](const auto& l, const auto& r) { return l.region < r.region; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < delta.size();) {
        Cover::Entry sum = delta[i];
        for (++i; i < delta.size() && delta[i].region == sum.region; ++i) sum.winding += delta[i].winding;
        if (sum.winding != 0) delta[kept++] = sum;
    }
    delta.resize(kept);
}

bool is_border(const NodedGraph& graph, const NodedEdge& edge, const std::vector<SegmentTag>& tags) {
    for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u)
        if (tags[graph.uses[u].segment].border_storey != kNone) return true;
    return false;
}

/// Appends entries[first .. last) +- delta.
void append_crossed(std::uint32_t first, std::uint32_t last, const Entries& delta, int sign, Entries& entries) {
    std::size_t d = 0;
    for (std::uint32_t i = first; i < last || d < delta.size();) {
        if (i < last && (d == delta.size() || entries[i].region < delta[d].region)) {
            entries.push_back(Cover::Entry(entries[i++]));
        } else if (i == last || delta[d].region < entries[i].region) {
            entries.push_back({delta[d].region, sign * delta[d].winding});
            ++d;
        } else {
            const Cover::Entry sum{entries[i].region, entries[i].winding + sign * delta[d].winding};
            if (sum.winding != 0) entries.push_back(sum);
            ++i;
            ++d;
        }
    }
}

/// The half-edges of each face, in one array.
struct FaceEdges {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> half_edges;
};

FaceEdges face_edges(const PlanarMap& map) {
    FaceEdges faces;
    faces.first.assign(map.face_count + 1, 0);
    const auto count = std::uint32_t(map.next.size());
    for (std::uint32_t h = 0; h < count; ++h) ++faces.first[map.face(h) + 1];
    for (std::size_t f = 1; f < faces.first.size(); ++f) faces.first[f] += faces.first[f - 1];
    faces.half_edges.resize(count);
    std::vector<std::uint32_t> slot(faces.first.begin(), faces.first.end() - 1);
    for (std::uint32_t h = 0; h < count; ++h) faces.half_edges[slot[map.face(h)]++] = h;
    return faces;
}

Cover propagate(const NodedGraph& graph, const PlanarMap& map, const std::vector<SegmentTag>& tags) {
    const FaceEdges faces = face_edges(map);
    std::vector<std::uint32_t> begin(map.face_count, kNone);
    std::vector<std::uint32_t> end(map.face_count, 0);
    std::vector<std::uint32_t> open{0};
    Entries entries;
    Entries delta;
    begin[0] = 0;
    while (!open.empty()) {
        const std::uint32_t from = open.back();
        open.pop_back();
        for (std::uint32_t i = faces.first[from]; i < faces.first[from + 1]; ++i) {
            const std::uint32_t h = faces.half_edges[i];
            const std::uint32_t to = map.face(h ^ 1u);
            if (begin[to] != kNone) continue;
            edge_delta(graph, graph.edges[h / 2], tags, delta);
            begin[to] = std::uint32_t(entries.size());
            // We stand left of h: h = 2e is left of the edge, so that crossing it loses what the edge gives.
            append_crossed(begin[from], end[from], delta, h % 2 == 0 ? -1 : 1, entries);
            end[to] = std::uint32_t(entries.size());
            open.push_back(to);
        }
    }
    Cover cover;
    cover.first.reserve(map.face_count + 1);
    cover.entries.reserve(entries.size());
    for (std::uint32_t f = 0; f < map.face_count; ++f) {
        ENFILADE_CHECK(begin[f] != kNone);
        cover.first.push_back(std::uint32_t(cover.entries.size()));
        cover.entries.insert(cover.entries.end(), entries.begin() + begin[f], entries.begin() + end[f]);
    }
    cover.first.push_back(std::uint32_t(cover.entries.size()));
    return cover;
}

}  // namespace

NodedGraph filtered(const NodedGraph& graph, const std::vector<bool>& keep) {
    NodedGraph result;
    result.max_deviation = graph.max_deviation;
    std::vector<std::uint32_t> renumbered(graph.vertices.size(), kNone);
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
        if (keep[e]) renumbered[graph.edges[e].a] = renumbered[graph.edges[e].b] = 0;
    for (std::size_t v = 0; v < renumbered.size(); ++v)
        if (renumbered[v] == 0) {
            renumbered[v] = std::uint32_t(result.vertices.size());
            result.vertices.push_back(graph.vertices[v]);
        }
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        if (!keep[e]) continue;
        NodedEdge edge = graph.edges[e];
        const auto uses = graph.uses.begin() + edge.first_use;
        edge = {renumbered[edge.a], renumbered[edge.b], std::uint32_t(result.uses.size()), edge.use_count};
        result.uses.insert(result.uses.end(), uses, uses + edge.use_count);
        result.edges.push_back(edge);
    }
    return result;
}

std::vector<std::int64_t> face_areas2(const PlanarMap& map) {
    std::vector<std::int64_t> areas(map.face_count, 0);
    for (std::size_t l = 0; l < map.loop_first.size(); ++l) areas[map.face_of_loop[l]] += map.loop_area2[l];
    areas[0] = 0;
    return areas;
}

Overlay overlay_of(NodedGraph graph, const std::vector<SegmentTag>& tags) {
    Overlay result;
    result.graph = std::move(graph);
    // Strips that the grid closes leave edges that lie between a region and itself: those are no boundary.
    std::vector<bool> keep(result.graph.edges.size());
    Entries delta;
    for (std::size_t e = 0; e < keep.size(); ++e) {
        edge_delta(result.graph, result.graph.edges[e], tags, delta);
        keep[e] = !delta.empty() || is_border(result.graph, result.graph.edges[e], tags);
    }
    if (std::find(keep.begin(), keep.end(), false) != keep.end()) result.graph = filtered(result.graph, keep);
    result.map = planar_map(result.graph);
    result.cover = propagate(result.graph, result.map, tags);
    return result;
}

Overlay overlay(const std::vector<Segment>& segments, const std::vector<SegmentTag>& tags) {
    return overlay_of(node(segments), tags);
}

}  // namespace enfilade::plans
