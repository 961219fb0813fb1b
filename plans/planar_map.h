#pragma once
// The faces of a noded graph: half-edges sorted around vertices by exact orientation.

#include <cstdint>
#include <vector>

#include "plans/noding.h"

namespace enfilade::plans {

/// Half-edge 2e runs along edge e from a to b, 2e + 1 back; the face of a half-edge lies on its left.
struct PlanarMap {
    std::vector<std::uint32_t> next;          ///< [2 * edge_count] the next half-edge along the same face's boundary
    std::vector<std::uint32_t> loop;          ///< [2 * edge_count] the boundary loop of a half-edge
    std::vector<std::uint32_t> loop_first;    ///< [loop_count] one half-edge of each loop
    std::vector<std::int64_t> loop_area2;     ///< [loop_count] twice the signed area; > 0: outer boundary of a face
    std::vector<std::uint32_t> face_of_loop;  ///< [loop_count] holes and the loops of other components included
    std::uint32_t face_count = 0;             ///< face 0 is the unbounded one

    [[nodiscard]] std::uint32_t face(std::uint32_t half_edge) const { return face_of_loop[loop[half_edge]]; }
};

[[nodiscard]] inline std::uint32_t origin(const NodedGraph& graph, std::uint32_t half_edge) {
    const NodedEdge& edge = graph.edges[half_edge / 2];
    return half_edge % 2 == 0 ? edge.a : edge.b;
}

/// Finds the faces. A loop that is a hole (or a lone component) gets the face in which it lies, found by a sweep
/// over x. Cost: n log n.
[[nodiscard]] PlanarMap planar_map(const NodedGraph& graph);

}  // namespace enfilade::plans
