#pragma once
// The graph of a scene, for programs that walk or draw graphs.

#include <string>

#include "accel/scene.h"

namespace enfilade::modeler {

/// GraphML with two graphs: first "spaces" (rooms, doors, windows, ...: an edge where one sees from one into the
/// other), then "cells" (the convex pieces: an edge for each portal). Nodes carry label, name, storey, area, volume and
/// centre (metres, in the frame of the scene); edges the kind and the area of their opening.
[[nodiscard]] std::string to_graphml(const accel::SceneView& scene);

}  // namespace enfilade::modeler
