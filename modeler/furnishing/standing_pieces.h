#pragma once
// What a building holds already, found by its place.

#include <map>
#include <utility>
#include <vector>

#include "modeler/building.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/furnishing/furnish_room.h"

namespace enfilade::modeler {

class StandingPieces {
public:
    StandingPieces(const Building& building, const Catalogue& catalogue);
    /// Those that share a place with the box of the room, in the order of the building's objects.
    [[nodiscard]] std::vector<StandingPiece> in(const RoomShape& room) const;

private:
    std::vector<StandingPiece> pieces_;
    std::vector<GridBox> boxes_;
    std::int32_t cell_ = 1;
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::uint32_t>> cells_;
};

}  // namespace enfilade::modeler
