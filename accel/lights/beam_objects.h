#pragma once
// Inside of accel: which objects can stand between a lamp and the places that one of its beams holds.

#include <vector>

#include "accel/lights/light_trees.h"

namespace enfilade::accel::detail {

/// The objects of each beam of `trees`: what stands in the cells on its way. lists: [beam_count]
void list_objects(const SceneView& view, const LightTreesView& trees, const Executor& executor,
                  std::vector<BeamObjects>& lists, std::vector<ObjectId>& objects);

}  // namespace enfilade::accel::detail
