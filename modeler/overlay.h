#pragma once
// The plane between two bands: every face lies in one piece of the band below and one of the band above.

#include <cstdint>
#include <functional>
#include <span>

#include "modeler/plan_graph.h"

namespace enfilade::modeler {

/// An edge that is a boundary in a band, with the pieces beside it; UINT32_MAX beyond the site box.
struct BandEdge {
    std::uint32_t edge = 0;
    std::uint32_t left = 0;
    std::uint32_t right = 0;
};

using OverlayFace =
    std::function<void(std::span<const std::uint32_t> half_edges, std::uint32_t below, std::uint32_t above)>;

/// Visits the faces of the overlay of two bands, with their boundary counter-clockwise. Both bands tile the site with
/// discs, so their overlay is connected and its faces are discs as well. Cost: linear in the edges of both bands,
/// and of the graph around their points.
void overlay(const PlanGraph& graph, std::span<const BandEdge> below, std::span<const BandEdge> above,
             const OverlayFace& visit);

}  // namespace enfilade::modeler
