#include "plans/arrange_owners.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"

namespace enfilade::plans {
namespace {

bool borders_rooms(const NodedGraph& graph, const NodedEdge& edge, const std::vector<SegmentTag>& tags,
                   std::uint32_t storey) {
    for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u)
        if (tags[graph.uses[u].segment].border_storey == storey) return true;
    return false;
}

double length(const NodedGraph& graph, const NodedEdge& edge) {
    const GridPoint a = graph.vertices[edge.a];
    const GridPoint b = graph.vertices[edge.b];
    return std::hypot(double(b.x) - a.x, double(b.y) - a.y);
}

}  // namespace

std::vector<std::vector<Owner>> strongest_owners(const Overlay& overlay, const std::vector<Region>& regions,
                                                 std::size_t storey_count) {
    const std::uint32_t face_count = overlay.map.face_count;
    std::vector<std::vector<Owner>> owner(storey_count, std::vector<Owner>(face_count, {OwnerKind::Room, kNone}));
    std::vector<std::uint32_t> rank(storey_count);
    for (std::uint32_t f = 0; f < face_count; ++f) {
        std::fill(rank.begin(), rank.end(), kNone);
        for (std::uint32_t i = overlay.cover.first[f]; i < overlay.cover.first[f + 1]; ++i) {
            const Region& region = regions[overlay.cover.entries[i].region];
            if (region.storey == kNone || region.rank >= rank[region.storey]) continue;
            rank[region.storey] = region.rank;
            owner[region.storey][f] = region.owner;
        }
    }
    return owner;
}

Places find_places(const Overlay& overlay, const std::vector<SegmentTag>& tags, const std::vector<Owner>& owner,
                   std::uint32_t storey) {
    const NodedGraph& graph = overlay.graph;
    const PlanarMap& map = overlay.map;
    DisjointSets faces(map.face_count);
    // The exterior reaches beyond the site box, whose edges are no walls: face 0 is part of it.
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
        const std::uint32_t left = map.face(2 * e);
        const std::uint32_t right = map.face(2 * e + 1);
        if (left == right || is_solid(owner[left].kind) || is_solid(owner[right].kind)) continue;
        if (borders_rooms(graph, graph.edges[e], tags, storey)) continue;
        faces.join(left, right);
    }
    Places result;
    result.of_face.assign(map.face_count, kNone);
    const std::vector<std::int64_t> areas2 = face_areas2(map);
    for (std::uint32_t f = 0; f < map.face_count; ++f) {
        if (is_solid(owner[f].kind)) continue;
        const std::uint32_t least = faces.find(f);
        if (least == f) {
            result.of_face[f] = std::uint32_t(result.places.size());
            result.places.push_back({0, 0, f, f == 0, false});
        }
        result.of_face[f] = result.of_face[least];
        Places::Place& place = result.places[result.of_face[f]];
        place.area2 += areas2[f];
        place.pierced = place.pierced || owner[f].kind == OwnerKind::Stair || owner[f].kind == OwnerKind::Shaft;
    }
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
        const std::uint32_t left = result.of_face[map.face(2 * e)];
        const std::uint32_t right = result.of_face[map.face(2 * e + 1)];
        if (left == right) continue;
        for (const std::uint32_t place : {left, right})
            if (place != kNone) result.places[place].perimeter += length(graph, graph.edges[e]);
    }
    return result;
}

}  // namespace enfilade::plans
