#pragma once
// The spaces of a story: which faces bound them, where they lie, whether they overlap.

#include <optional>
#include <vector>

#include "plans/box_index.h"
#include "plans/floorspace/edge_graph.h"

namespace enfilade::plans {

/// The ring of a face over the vertices of its story, or why it has none.
struct FloorRing {
    std::vector<std::uint32_t> vertices;  ///< into FloorStory::vertices, as the face goes around
    bool broken = false;                  ///< its edges do not form one loop
};
[[nodiscard]] FloorRing ring_of(const FloorStory& story, const FloorFace& face);

/// A space with an outline.
struct FloorOutline {
    std::uint32_t space = 0;     ///< into FloorStory::spaces
    std::vector<Point> corners;  ///< counter-clockwise, none twice in a row
    PlanBox box;                 ///< around them
    double area = 0;
    double perimeter = 0;
};

/// Does the point lie in the outline (even-odd)?
[[nodiscard]] bool within(Point p, const FloorOutline& outline);

struct FloorSpaces {
    std::vector<FloorOutline> outlines;
    std::vector<std::uint32_t> without_outline;  ///< spaces
    std::vector<std::uint32_t> doubled;          ///< spaces whose face an earlier one has
    std::vector<std::uint32_t> broken;           ///< spaces whose edges form no loop
    std::vector<bool> edge_used;                 ///< [FloorStory::edges] some space borders on it
    std::size_t inner_edges = 0;                 ///< that one space alone has on both sides: a slit, no wall
    std::size_t idle_faces = 0;                  ///< of no space and no shading
    std::size_t idle_edges = 0;                  ///< of no face
};
[[nodiscard]] FloorSpaces find_spaces(const FloorStory& story);

/// For each outline that shares some area with others one such pair (by index, the smaller first), each pair once.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping(const FloorStory& story,
                                                                               const FloorSpaces& spaces,
                                                                               const FloorGraph& graph);

}  // namespace enfilade::plans
