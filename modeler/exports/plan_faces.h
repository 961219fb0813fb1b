#pragma once
// The smallest faces of the plan, which no edge of any band crosses, and what is stacked over each of them.

#include <cstdint>
#include <span>
#include <vector>

#include "modeler/building.h"
#include "modeler/exports/ring_trace.h"

namespace enfilade::modeler {

class PlanFaces {
public:
    explicit PlanFaces(const Building& building);

    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// The volumes over a face, bottom to top.
    [[nodiscard]] std::span<const std::uint32_t> stack(std::uint32_t face) const {
        return std::span(volumes_).subspan(first_[face], first_[face + 1] - first_[face]);
    }
    /// The outlines of a set of faces, one for each that hangs together over edges, by lowest face; nodes are into
    /// Building::points.
    [[nodiscard]] std::vector<RegionRings> outlines(std::span<const std::uint32_t> faces) const;

private:
    void trace(const std::vector<PlanEdge>& edges);
    void stack_volumes(const Building& building);

    std::uint32_t count_ = 0;
    std::vector<std::array<std::int64_t, 2>> points_;
    std::vector<BorderSegment> segments_;    ///< [half-edge]
    std::vector<std::uint32_t> face_of_;     ///< [half-edge] the face on its left
    std::vector<std::uint32_t> first_half_;  ///< [face + 1] into half_edges_
    std::vector<std::uint32_t> half_edges_;  ///< by face
    std::vector<std::uint32_t> first_;       ///< [face + 1] into volumes_
    std::vector<std::uint32_t> volumes_;
};

}  // namespace enfilade::modeler
