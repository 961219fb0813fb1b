#pragma once
// The edges of a story on which spaces border, as a graph: cut wherever another edge ends on them or crosses them, each
// piece once, however often the file draws it.

#include <cstdint>
#include <vector>

#include "plans/floorspace/floor_file.h"

namespace enfilade::plans {

/// A straight piece between two nodes, a < b.
struct FloorPiece {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t edge = 0;  ///< the first edge of the file that runs over it
};

/// A piece as a part of an edge, in the direction of that edge.
struct FloorPieceUse {
    std::uint32_t piece = 0;
    bool forward = true;  ///< the edge runs from the piece's a to its b
    double from = 0;      ///< metres along the edge from its first vertex
    double to = 0;
};

struct FloorGraph {
    std::vector<Point> nodes;
    std::vector<std::uint32_t> node_of_vertex;        ///< [FloorStory::vertices]
    std::vector<FloorPiece> pieces;                   ///< in the order of the file
    std::vector<std::vector<FloorPieceUse>> of_edge;  ///< [FloorStory::edges] in order; none for edges without length
    std::vector<std::vector<std::uint32_t>> at_node;  ///< [nodes] pieces that end there
    std::size_t short_edges = 0;                      ///< without length
    std::size_t doubled_edges = 0;                    ///< that run wholly over others
    std::size_t touched_edges = 0;                    ///< on which another one ends
    std::size_t crossed_edges = 0;                    ///< pairs that cross
    Point crossing;                                   ///< where the first pair does

    [[nodiscard]] double length(std::uint32_t piece) const;
};

/// How near two places must be to be one, in metres.
inline constexpr double floor_tolerance = 5e-4;

/// `used`: [FloorStory::edges] whether an edge takes part. Vertices within the tolerance of each other become one node.
/// Cost: n log n where a bounded number of edges passes any place.
[[nodiscard]] FloorGraph make_floor_graph(const FloorStory& story, const std::vector<bool>& used);

}  // namespace enfilade::plans
