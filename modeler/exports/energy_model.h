#pragma once
// A building as energy models see it: rooms as closed solids of flat faces, each with what is on its other side.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "modeler/building.h"
#include "modeler/exports/wall_views.h"

namespace enfilade::modeler {

enum class EnergyFaceKind : std::uint8_t { Wall, Floor, Ceiling };

/// A rectangle in a face: a door or window.
struct EnergyOpening {
    std::uint32_t space = 0;  ///< of the door or window, into Building::spaces
    std::array<std::array<double, 3>, 4> corners = {};
};

struct EnergyFace {
    static constexpr std::uint32_t none = UINT32_MAX;

    EnergyFaceKind kind = EnergyFaceKind::Wall;
    Across across = Across::Nothing;  ///< Across::Part: of `other_room`
    bool is_air = false;              ///< nothing solid between the two rooms
    std::uint32_t other_room = none;  ///< the face of the other room that is paired with this one
    std::uint32_t other_face = none;
    std::vector<std::array<double, 3>> outer;  ///< world metres, counter-clockwise seen from outside the room
    std::vector<std::vector<std::array<double, 3>>> holes;
    std::vector<EnergyOpening> openings;  ///< in the same order in both faces of a pair
};

struct EnergyRoom {
    std::uint32_t space = 0;  ///< into Building::spaces
    bool has_floor = true;    ///< not the hole of a stair through a slab
    std::vector<EnergyFace> faces;
};

struct EnergyModel {
    std::vector<EnergyRoom> rooms;
};

/// Rooms, stairs and shafts with their faces as they are inside (internal dimensions, ISO 13789): walls keep their real
/// thickness as a gap between rooms. The two faces of a pair look at each other through wall or slab, have the same
/// area, and know each other. What looks at the end of a wall, at a column or at a wall below has nothing across.
/// The faces of a room tile its shell, to within a millimetre and a square centimetre.
[[nodiscard]] EnergyModel energy_model(const Building& building);

}  // namespace enfilade::modeler
