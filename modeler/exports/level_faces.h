#pragma once
// The horizontal faces of a building by the volumes that they bound, with their rings on the points of the plan.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modeler/building.h"
#include "modeler/exports/ring_trace.h"

namespace enfilade::modeler {

/// A horizontal face as one of its volumes sees it.
struct LevelFace {
    std::uint32_t volume = 0;
    std::uint32_t face = 0;    ///< into Building::faces
    std::uint32_t behind = 0;  ///< volume
};

class LevelFaces {
public:
    explicit LevelFaces(const Building& building);

    /// The faces under a volume, or over it.
    [[nodiscard]] std::span<const LevelFace> floors(std::uint32_t volume) const { return of(floors_, volume); }
    [[nodiscard]] std::span<const LevelFace> ceilings(std::uint32_t volume) const { return of(ceilings_, volume); }
    /// The outlines of some faces at one level, one for each set that hangs together over edges, by lowest face. Nodes
    /// are into Building::points.
    [[nodiscard]] std::vector<RegionRings> outlines(std::span<const std::uint32_t> faces) const;

private:
    static std::span<const LevelFace> of(const std::vector<LevelFace>& faces, std::uint32_t volume);

    std::vector<LevelFace> floors_;    ///< by volume, then face
    std::vector<LevelFace> ceilings_;  ///< likewise
    std::vector<std::array<std::int64_t, 2>> points_;
    std::vector<std::uint32_t> first_ring_;  ///< [face + 1] into ring_
    std::vector<std::uint32_t> ring_;        ///< points, counter-clockwise seen from above; none of side faces
};

}  // namespace enfilade::modeler
