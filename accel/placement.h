#pragma once
// Where objects stand: affine maps between an object's space and the scene's.

#include <array>
#include <optional>

#include "accel/scene.h"

namespace enfilade::accel {

/// The inverse of an affine map (rows of 3 x 4 numbers), or nothing where it is singular or not finite.
[[nodiscard]] std::optional<std::array<double, 12>> inverse_of(const std::array<double, 12>& rows);

/// Sets the object's box from its placement and the corners of its mesh's box, rounded outward by more than a tracer's
/// roundings. An empty mesh has the box of its origin.
void bound(const ObjectMesh& mesh, PlacedObject& object);

}  // namespace enfilade::accel
