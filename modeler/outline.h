#pragma once
// The volumes of a convex building put together again: outlines of what they were before the cuts.

#include <cstdint>
#include <vector>

#include "modeler/building.h"

namespace enfilade::modeler {

/// Half-edges around the union of the pieces of some volumes, which is a disc: counter-clockwise.
/// `scratch`: [2 * edge count], all UINT32_MAX before and after.
[[nodiscard]] std::vector<std::uint32_t> outline(const Building& building, const std::vector<std::uint32_t>& volumes,
                                                 std::vector<std::uint32_t>& scratch);

/// The points of a ring without those on which it goes exactly straight on.
[[nodiscard]] std::vector<std::uint32_t> corners_of(const Building& building, const std::vector<std::uint32_t>& ring);

/// The point at which a half-edge starts.
[[nodiscard]] inline std::uint32_t start_of(const Building& building, std::uint32_t half_edge) {
    const PlanEdge& edge = building.edges[half_edge / 2];
    return half_edge % 2 == 0 ? edge.a : edge.b;
}

}  // namespace enfilade::modeler
