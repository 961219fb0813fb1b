#pragma once
// The convex building as the flat scene that the tracer walks.

#include <string>

#include "accel/scene.h"
#include "accel/scene_input.h"
#include "modeler/building.h"
#include "modeler/check.h"

namespace enfilade::modeler {

/// Cells (cell i is the i-th volume that carries light, in ascending volume id), portals, and the solid faces as they
/// were before convexification. Sides of a cell that go straight on along one line with the same faces are one section.
/// \pre building.convex
[[nodiscard]] accel::SceneInput scene_input(const Building& building);

/// The scene with its model group and certificate (1-architecture, decision 7). `options_json` goes into the
/// certificate.
[[nodiscard]] accel::Scene export_scene(const Building& building, const CheckReport& report,
                                        const std::string& options_json);

}  // namespace enfilade::modeler
