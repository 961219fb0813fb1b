#pragma once
// What stands in the rooms of a scene: the furniture of its plan.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "modeler/building.h"
#include "plans/plan.h"

namespace enfilade::modeler {

/// A piece of furniture of the plan: the box that holds it, in the frame of the scene (metres, z up).
struct PlacedFurniture {
    std::string id;
    std::string name;
    std::string model;                ///< pieces of one model and colour look alike
    std::uint32_t storey = 0;         ///< into Building::storeys
    std::array<double, 3> foot = {};  ///< middle of the underside
    double angle = 0;                 ///< radians about z, counter-clockwise
    std::array<double, 3> size = {};  ///< width, depth, height before turning: positive
    bool mirrored = false;
    std::optional<plans::Colour> colour;
};

struct Fittings {
    std::vector<PlacedFurniture> furniture;  ///< by storey, then as in the plan; pieces without extent are left out
    std::vector<StoreyInfo> storeys;         ///< Building::storeys
};

/// Those of the building's storeys, from the plan that the building carries (`plan_json`). None where it carries none;
/// throws InputError where that plan cannot be read.
[[nodiscard]] Fittings fittings(const Building& building);

}  // namespace enfilade::modeler
