#pragma once
// The upright sides of a part of a space as a person sees them: one straight side after another, and what is behind.

#include <cstdint>
#include <vector>

#include "modeler/space_parts.h"

namespace enfilade::modeler {

/// What a side has behind it between two levels.
struct SideInterval {
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    std::uint32_t behind = 0;  ///< volume
};

/// A half-edge of the part's outline with what stands over it, from the part's floor to its ceiling without gaps.
struct SideStrip {
    std::uint32_t half_edge = 0;
    std::vector<SideInterval> intervals;  ///< ascending, one for each face of the building
};

/// Strips that go straight on along one line.
struct StraightSide {
    std::vector<SideStrip> strips;
};

/// The sides along one ring of a part, the part on their left; one follows the other, and the last one the first.
struct RingSides {
    std::vector<StraightSide> sides;
};

/// Looks up the faces of a building by edge.
class PartSides {
public:
    explicit PartSides(const Building& building);
    /// First the outer ring, then the holes. A ring that goes straight on at every corner (a circle of chords of one
    /// line) begins at its first half-edge.
    [[nodiscard]] std::vector<RingSides> of(const SpacePart& part) const;

private:
    [[nodiscard]] SideStrip strip(const SpacePart& part, std::uint32_t half_edge) const;

    const Building& building_;
    std::vector<std::uint32_t> first_face_;  ///< [edge + 1] into side_faces_
    std::vector<std::uint32_t> side_faces_;  ///< by edge, then upward
};

}  // namespace enfilade::modeler
