#pragma once
// The upright boxes of objects and of their meshes.

#include <array>

#include "modeler/objects/furnishing.h"
#include "plans/plan.h"

namespace enfilade::modeler {

/// An object's box where it stands: metres of the plan's frame, z as storeys' elevations.
struct ObjectBox {
    std::array<plans::Point, 4> footprint;  ///< counter-clockwise, from the left of its front
    double z_low = 0;
    double z_high = 0;
};
[[nodiscard]] ObjectBox box_of(const FurnishedObject& object);

/// The box of a mesh after it was turned, along the axes; a point for a mesh without vertices.
struct TurnedBox {
    std::array<double, 3> low = {0, 0, 0};
    std::array<double, 3> high = {0, 0, 0};
};
/// Cost: linear in the vertices, used by triangles or not.
[[nodiscard]] TurnedBox turned_box(const std::array<double, 9>& turned, const ObjectMesh& mesh);

/// As in furnishing.h, for many objects of one mesh. \pre box: `turned_box(object.turned, mesh)`
[[nodiscard]] std::array<double, 12> plan_from_mesh(const FurnishedObject& object, const TurnedBox& box);

}  // namespace enfilade::modeler
