#pragma once
// Octrees as devices like them.

#include "accel/octree/octree.h"

namespace enfilade::render::cuda {

/// What devices walk best, by count (README.md): triangles are tested one by one there, so leaves are smaller.
[[nodiscard]] inline accel::OctreeOptions device_octree_options() {
    accel::OctreeOptions options;
    options.cost.at_once = 1;
    return options;
}

}  // namespace enfilade::render::cuda
