#pragma once
// Which space of a building holds a place.

#include <cstdint>

#include "modeler/building.h"
#include "modeler/objects/object_box.h"
#include "modeler/volume_finder.h"

namespace enfilade::modeler {

/// Finds spaces that carry light: rooms, the exterior, doorways, stairs. Of an object's volume: the room around it.
class SpaceFinder {
public:
    /// `building` must outlive it. Cost: linear
    explicit SpaceFinder(const Building& building) : building_(building), volumes_(building) {}

    /// The space that holds a point (metres of the plan, z as storeys' elevations); none<> in solids and off the site.
    [[nodiscard]] std::uint32_t at(double x, double y, double z) const;

    /// The space that an object stands in: of the rooms that hold part of its box the one that holds most, else the
    /// exterior, else a doorway or stair; none<> wholly inside solids. Sampled at 75 places.
    [[nodiscard]] std::uint32_t of(const ObjectBox& box) const;

private:
    const Building& building_;
    VolumeFinder volumes_;
};

}  // namespace enfilade::modeler
