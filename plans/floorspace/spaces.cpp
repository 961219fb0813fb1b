#include "plans/floorspace/spaces.h"

#include <algorithm>
#include <cmath>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

/// The vertex at which a side of a face begins, and that at which it ends.
std::pair<std::uint32_t, std::uint32_t> ends_of(const FloorStory& story, FloorSide side) {
    const auto& ends = story.edges[side.edge].ends;
    return side.forward ? std::pair(ends[0], ends[1]) : std::pair(ends[1], ends[0]);
}

bool follows(const FloorStory& story, const std::vector<FloorSide>& sides) {
    for (std::size_t k = 0; k < sides.size(); ++k)
        if (ends_of(story, sides[k]).second != ends_of(story, sides[(k + 1) % sides.size()]).first) return false;
    return true;
}

double signed_area(const std::vector<Point>& ring) {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) twice += cross(ring[k] - ring[0], ring[k + 1] - ring[0]);
    return twice / 2;
}

std::optional<FloorOutline> outline_of(const FloorStory& story, const FloorRing& ring, std::uint32_t space) {
    FloorOutline outline;
    outline.space = space;
    for (const std::uint32_t v : ring.vertices) {
        const Point p = story.vertices[v].at;
        if (outline.corners.empty() || distance(outline.corners.back(), p) > floor_tolerance)
            outline.corners.push_back(p);
    }
    while (outline.corners.size() > 1 && distance(outline.corners.front(), outline.corners.back()) <= floor_tolerance)
        outline.corners.pop_back();
    if (outline.corners.size() < 3) return {};
    for (const Point p : outline.corners) outline.box.add(p);
    outline.area = signed_area(outline.corners);
    if (outline.area < 0) std::reverse(outline.corners.begin(), outline.corners.end());
    outline.area = std::abs(outline.area);
    for (std::size_t k = 0; k < outline.corners.size(); ++k)
        outline.perimeter += distance(outline.corners[k], outline.corners[(k + 1) % outline.corners.size()]);
    if (outline.area <= floor_tolerance * outline.perimeter) return {};
    return outline;
}

/// Another outline over the place just inside of an outline's piece; none: no_floor_item.
std::uint32_t other_beside(const FloorGraph& graph, const FloorPiece& piece, std::uint32_t outline,
                           const FloorSpaces& spaces, const BoxIndex& index) {
    const Point a = graph.nodes[piece.a];
    const Point b = graph.nodes[piece.b];
    const Point aside = turned_left(b - a) * (2 * floor_tolerance / distance(a, b));
    Point beside = (a + b) * 0.5 + aside;
    if (!within(beside, spaces.outlines[outline])) beside = beside - aside * 2;
    std::uint32_t found = no_floor_item;
    index.near(beside, [&](std::uint32_t other) {
        if (found == no_floor_item && other != outline && within(beside, spaces.outlines[other])) found = other;
    });
    return found;
}

}  // namespace

bool within(Point p, const FloorOutline& outline) {
    const PlanBox& box = outline.box;
    if (p.x < box.min.x || p.x > box.max.x || p.y < box.min.y || p.y > box.max.y) return false;
    const std::vector<Point>& ring = outline.corners;
    bool in = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point a = ring[k];
        const Point b = ring[(k + 1) % ring.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
    }
    return in;
}

FloorRing ring_of(const FloorStory& story, const FloorFace& face) {
    FloorRing ring;
    std::vector<FloorSide> sides = face.sides;
    std::erase_if(sides, [&](FloorSide side) {
        const auto [a, b] = ends_of(story, side);
        return a == b;
    });
    if (sides.empty()) return ring;
    // Where the directions do not fit, the edges may still go around one after the other.
    for (const bool first : {sides[0].forward, !sides[0].forward}) {
        if (follows(story, sides)) break;
        sides[0].forward = first;
        for (std::size_t k = 1; k < sides.size(); ++k)
            sides[k].forward = story.edges[sides[k].edge].ends[0] == ends_of(story, sides[k - 1]).second;
    }
    ring.broken = !follows(story, sides);
    if (ring.broken) return ring;
    for (const FloorSide side : sides) ring.vertices.push_back(ends_of(story, side).first);
    return ring;
}

FloorSpaces find_spaces(const FloorStory& story) {
    FloorSpaces spaces;
    spaces.edge_used.assign(story.edges.size(), false);
    std::vector<bool> edge_of_face(story.edges.size(), false);
    std::vector<std::uint32_t> uses(story.edges.size(), 0);
    std::vector<bool> face_used(story.faces.size(), false);
    for (std::uint32_t s = 0; s < story.spaces.size(); ++s) {
        const std::uint32_t f = story.spaces[s].face;
        if (f == no_floor_item) {
            spaces.without_outline.push_back(s);
            continue;
        }
        const FloorFace& face = story.faces[f];
        if (face_used[f]) {
            spaces.doubled.push_back(s);
            continue;
        }
        face_used[f] = true;
        for (const FloorSide side : face.sides) ++uses[side.edge];
        const FloorRing ring = ring_of(story, face);
        if (ring.broken) spaces.broken.push_back(s);
        else if (auto outline = outline_of(story, ring, s)) spaces.outlines.push_back(std::move(*outline));
        else spaces.without_outline.push_back(s);
    }
    // A face that goes along an edge twice lies on both sides of it: that is how it goes around an island.
    std::vector<std::uint32_t> own(story.edges.size(), 0);
    for (std::size_t f = 0; f < story.faces.size(); ++f) {
        if (!face_used[f]) continue;
        for (const FloorSide side : story.faces[f].sides) ++own[side.edge];
        for (const FloorSide side : story.faces[f].sides) {
            const bool slit = own[side.edge] == 2 && uses[side.edge] == 2;
            spaces.edge_used[side.edge] = !slit;
        }
        for (const FloorSide side : story.faces[f].sides) own[side.edge] = 0;
    }
    for (std::size_t e = 0; e < uses.size(); ++e)
        if (uses[e] > 0 && !spaces.edge_used[e]) ++spaces.inner_edges;
    for (const std::uint32_t f : story.shading_faces) face_used[f] = true;
    for (std::size_t f = 0; f < story.faces.size(); ++f) {
        if (!face_used[f] && !story.faces[f].sides.empty()) ++spaces.idle_faces;
        for (const FloorSide side : story.faces[f].sides) edge_of_face[side.edge] = true;
    }
    spaces.idle_edges = std::size_t(std::count(edge_of_face.begin(), edge_of_face.end(), false));
    return spaces;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping(const FloorStory& story, const FloorSpaces& spaces,
                                                                 const FloorGraph& graph) {
    std::vector<PlanBox> boxes;
    for (const FloorOutline& outline : spaces.outlines) boxes.push_back(outline.box);
    const BoxIndex index(boxes);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    // No piece crosses a side of an outline: a point just inside one of its sides tells for the whole piece.
    for (std::uint32_t o = 0; o < spaces.outlines.size(); ++o) {
        std::uint32_t found = no_floor_item;
        for (const FloorSide side : story.faces[story.spaces[spaces.outlines[o].space].face].sides)
            for (const FloorPieceUse use : graph.of_edge[side.edge])
                if (found == no_floor_item) found = other_beside(graph, graph.pieces[use.piece], o, spaces, index);
        if (found != no_floor_item) pairs.emplace_back(std::min(o, found), std::max(o, found));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace enfilade::plans
