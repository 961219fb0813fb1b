#pragma once
// New segments laid over a planar graph that stays as it is but for the points that they bring.

#include <span>
#include <vector>

#include "plans/noding.h"

namespace enfilade::modeler {

struct RoutedGraph {
    plans::NodedGraph graph;                         ///< segments: the fixed ones, then the added ones
    std::vector<std::vector<std::uint32_t>> chains;  ///< [fixed segment] its half-edges in its direction
};

/// Snap rounding of `added` against `fixed` and each other: as `plans::node`, but fixed segments get points only from
/// ends and crossings of added ones, never from each other, so that what is far from the added ones does not change.
/// \pre fixed segments meet in common ends only; |coordinates| <= 2^25. Cost: fixed x added.
[[nodiscard]] RoutedGraph route(std::span<const plans::Segment> fixed, std::span<const plans::Segment> added);

}  // namespace enfilade::modeler
