#pragma once
// A building's lamps in its scene.

#include "accel/scene_input.h"
#include "modeler/building.h"

namespace enfilade::modeler {

/// Adds `building.lamps` to its scene: by ascending id, in the scene's frame, each with the object that carries it.
/// Those in solids or off the site are among them: `assemble` finds no cell for them, they light nothing (`check`: S9).
/// \pre input: of this building, with its objects. Cost: n log m of n lamps and m objects
void add_lights(const Building& building, accel::SceneInput& input);

}  // namespace enfilade::modeler
