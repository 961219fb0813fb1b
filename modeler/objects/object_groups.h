#pragma once
// Objects that share a volume.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "modeler/editing/box.h"
#include "modeler/objects/furnishing.h"
#include "plans/grid.h"

namespace enfilade::modeler {

/// A box for some objects of one room.
struct ObjectGroup {
    Box box;
    std::vector<std::uint32_t> objects;  ///< ascending; the box has the first one's id
};

/// One group for each of `objects` (into `all`), then of any two groups of one room whose boxes share a place thicker
/// than a touch one, over the hull of both footprints and from the lower bottom to the higher top: until none do.
/// By ascending id. Cost: the objects of each room, squared
[[nodiscard]] std::vector<ObjectGroup> group_objects(std::span<const FurnishedObject> all,
                                                     std::span<const std::uint32_t> objects,
                                                     const plans::GridFrame& frame);

}  // namespace enfilade::modeler
