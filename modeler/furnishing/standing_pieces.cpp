#include "modeler/furnishing/standing_pieces.h"

#include <algorithm>
#include <cmath>

#include "modeler/editing/footprint.h"

namespace enfilade::modeler {

StandingPieces::StandingPieces(const Building& building, const Catalogue& catalogue) {
    const plans::GridFrame& frame = building.frame;
    cell_ = std::max(1, std::int32_t(4 / frame.unit));
    for (const FurnishedObject& object : building.furnishing.objects) {
        StandingPiece piece;
        piece.footprint = rectangle_footprint(frame, object.position[0], object.position[1], object.size[0],
                                              object.size[1], object.angle);
        const double low = (object.position[2] - frame.origin_z) / frame.unit;
        piece.z_low = std::int32_t(std::floor(low + 1e-6));
        piece.z_high = std::int32_t(std::ceil(low + object.size[2] / frame.unit - 1e-6));
        if (const CatalogueEntry* entry = catalogue.find(object.model)) piece.kind = entry->kind;
        const GridBox box = box_around(piece.footprint);
        for (std::int32_t y = box.y_low / cell_ - 1; y <= box.y_high / cell_ + 1; ++y)
            for (std::int32_t x = box.x_low / cell_ - 1; x <= box.x_high / cell_ + 1; ++x)
                cells_[{x, y}].push_back(std::uint32_t(pieces_.size()));
        boxes_.push_back(box);
        pieces_.push_back(std::move(piece));
    }
}

std::vector<StandingPiece> StandingPieces::in(const RoomShape& room) const {
    std::vector<std::uint32_t> found;
    if (pieces_.empty()) return {};
    const GridBox& box = room.floor.box();
    for (std::int32_t y = box.y_low / cell_; y <= box.y_high / cell_; ++y)
        for (std::int32_t x = box.x_low / cell_; x <= box.x_high / cell_; ++x)
            if (const auto cell = cells_.find({x, y}); cell != cells_.end())
                for (const std::uint32_t k : cell->second)
                    if (boxes_[k].meets(box) && pieces_[k].z_low < room.z_ceiling && pieces_[k].z_high > room.z_floor)
                        found.push_back(k);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<StandingPiece> result;
    for (const std::uint32_t k : found) result.push_back(pieces_[k]);
    return result;
}

}  // namespace enfilade::modeler
