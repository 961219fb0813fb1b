#pragma once
// Snap rounding: segments with integer ends -> an integer planar graph without crossings.

#include <cstdint>
#include <span>
#include <vector>

#include "plans/grid.h"

namespace enfilade::plans {

/// An input segment; its index in the input is its identity.
struct Segment {
    GridPoint a;
    GridPoint b;
};

/// One use of an edge of the graph by an input segment.
struct EdgeUse {
    std::uint32_t segment = 0;
    bool reversed = false;  ///< the segment runs from the edge's `b` to its `a` here
};

struct NodedEdge {
    std::uint32_t a = 0;  ///< vertex index, a < b in the order of `vertices`
    std::uint32_t b = 0;
    std::uint32_t first_use = 0;
    std::uint32_t use_count = 0;
};

/// A straight-line planar graph: two edges meet only in common vertices.
struct NodedGraph {
    std::vector<GridPoint> vertices;  ///< sorted by (x, y), distinct, each an end of some edge
    std::vector<NodedEdge> edges;     ///< distinct vertex pairs, sorted by (a, b)
    std::vector<EdgeUse> uses;        ///< [sum of use_count], by ascending segment within an edge
    double max_deviation = 0;         ///< largest distance, in grid units, of a vertex from a segment routed through it
};

/// Rounds all crossings to the grid and routes every segment through each hot pixel that it meets (Hobby 1999,
/// Guibas and Marimont 1998). Crossings are decided exactly in 128-bit integers. Every segment becomes a
/// chain of edges that stays within one half unit of it (per axis); chains never cross, they may share edges.
/// One pass: noding the result again stays free of crossings, but may route edges through vertices that they pass by
/// less than half a unit.
/// Segments that round to nothing leave no edge. Deterministic; independent of the order of the segments but for
/// `EdgeUse::segment`. \pre |coordinates| <= 2^25 Cost: about n log n for segments as plans have them (segment_tree.h
/// finds the pairs).
[[nodiscard]] NodedGraph node(std::span<const Segment> segments);

}  // namespace enfilade::plans
