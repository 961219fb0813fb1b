#pragma once
// How high the stories of a FloorspaceJS file stand, and what is left of them between the slabs.

#include <vector>

#include "plans/floorspace/floor_file.h"
#include "plans/plan.h"
#include "plans/read.h"

namespace enfilade::plans {

struct FloorLevel {
    double wall_height = 0;  ///< metres from floor to ceiling as the file has it
    double floor = 0;        ///< elevation
    double height = 0;       ///< of the rooms, up to the slab above
    double slab = 0;         ///< thickness of the slab under the floor
    double plenum = 0;       ///< between this ceiling and the next floor
    bool height_given = true;
};

/// A story's base lies on top of the one below it, its floor above the plenum under it. Floors stay where the file has
/// them. Where a plenum of 5 cm or more lies between a ceiling and the next floor, the ceiling stays too; else the slab
/// (20 cm, a tenth of low stories) is taken from the room under it. Throws InputError P105 where a story stands too
/// high.
[[nodiscard]] std::vector<FloorLevel> find_floor_levels(const FloorFile& file, const std::string& file_name,
                                                        double usual_height);

}  // namespace enfilade::plans
