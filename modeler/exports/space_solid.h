#pragma once
// The parts of a building's spaces as solids: closed shells of flat faces with shared vertices, as semantic formats
// hold them.

#include <array>
#include <cstdint>
#include <vector>

#include "modeler/space_parts.h"

namespace enfilade::modeler {

enum class SolidFaceKind : std::uint8_t { Floor, Ceiling, Side };

struct SolidFace {
    static constexpr std::uint32_t solid = UINT32_MAX;
    static constexpr std::uint32_t no_part = UINT32_MAX;

    SolidFaceKind kind = SolidFaceKind::Side;
    std::uint32_t behind = solid;  ///< the space with light, or the ground, behind it; `solid` for walls and slabs
    /// Its part: into SpaceSolids::parts; `no_part` for walls, slabs, the exterior, the ground.
    std::uint32_t behind_part = no_part;
    std::uint32_t material = 0;        ///< one space behind it, whatever its label: of several the first
    std::vector<std::uint32_t> outer;  ///< into SpaceSolids::vertices, counter-clockwise seen from outside the solid
    std::vector<std::vector<std::uint32_t>> holes;  ///< clockwise
};

/// The shell of one part: each edge belongs to two faces, in opposite directions (to four where the outline of the
/// part touches itself in a point).
struct SpaceSolid {
    std::uint32_t part = 0;  ///< into SpaceSolids::parts
    std::vector<SolidFace> faces;
};

struct SpaceSolids {
    std::vector<std::array<std::int32_t, 3>> vertices;  ///< grid units, each once, in the order of their first use
    std::vector<SpacePart> parts;                       ///< space_parts(building)
    std::vector<SpaceSolid> solids;                     ///< those asked for, by part
};

/// Floors and ceilings are one face (one for each part with light behind it, for the exterior and for the ground),
/// sides one face for each straight stretch of solid, with windows as holes and doors as notches, and one for each
/// opening. Points on which all edges of a solid go exactly straight on are left out: geometry is exactly that of the
/// volumes. Sides are flat to within the rounding of the grid. `labels`: the spaces that are wanted. Throws InputError
/// (F22) where a border does not close. Cost: linear, times the log of the border of one part.
[[nodiscard]] SpaceSolids space_solids(const Building& building, const std::vector<Label>& labels);

}  // namespace enfilade::modeler
