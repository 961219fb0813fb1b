#pragma once
// Spaces as people know them, put together from the volumes that they are cut into: what plans are drawn from and what
// semantic formats hold. A room has one part, a prism over a polygon with holes; a wall may have several.

#include <cstdint>
#include <vector>

#include "modeler/building.h"

namespace enfilade::modeler {

/// A ring of half-edges of the building: edge `h / 2` from its a to its b, or back where `h` is odd. The part lies on
/// its left, so outer rings run counter-clockwise and holes clockwise.
using HalfEdgeRing = std::vector<std::uint32_t>;

/// The union of volumes of one space that have the same floor and ceiling and hang together.
struct SpacePart {
    std::uint32_t space = 0;  ///< into Building::spaces
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    HalfEdgeRing outer;
    std::vector<HalfEdgeRing> holes;
    std::vector<std::uint32_t> volumes;  ///< ascending
};

/// All parts but those of `Outside`, by space, then z_low, then lowest volume. Rings visit a vertex once: where an
/// outline touches itself it is split into more rings. Works before and after convexification, with the same result
/// but for the edges' subdivision. Cost: linear, times the log of the rings of one part.
[[nodiscard]] std::vector<SpacePart> space_parts(const Building& building);

/// The points of a ring, as indices into Building::points, without those on which it goes on along one line (within
/// the grid's rounding: sides of one line count as straight): what a person would draw.
[[nodiscard]] std::vector<std::uint32_t> drawn_corners(const Building& building, const HalfEdgeRing& ring);

/// Square metres, exact but for the last rounding.
[[nodiscard]] double area_m2(const Building& building, const SpacePart& part);

/// A side of an outline, in grid units or millimetres.
struct OutlineSide {
    double ax, ay, bx, by;
};
/// The point furthest from the sides of a polygon with holes, near its middle, where a person would write its name.
/// \pre sides form closed loops
[[nodiscard]] std::array<double, 2> label_point(std::vector<OutlineSide> sides);

/// A point inside the part, away from its border, for a label: world metres (x, y).
[[nodiscard]] std::array<double, 2> label_point(const Building& building, const SpacePart& part);

}  // namespace enfilade::modeler
