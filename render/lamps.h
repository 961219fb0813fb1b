#pragma once
// The lamps of a picture: plain data, on host and device.

#include <cstdint>

#include "accel/lights/light_trees.h"
#include "render/vec.h"

namespace enfilade::render {

/// How it is found out which lamps a place sees. All give the same light.
enum class LampSearch : std::uint32_t {
    Naive,  ///< a walk to each lamp of the scene: the truth
    Pvs,    ///< a walk to each lamp that the place's cell may see
    Tree    ///< the planes of the beams that come into the cell; no walk
};

/// The lamps are the scene's (SceneView::lights).
struct Lamps {
    accel::LightTreesView trees;  ///< of Pvs and Tree
    LampSearch search = LampSearch::Tree;
    float exposure = 1;  ///< what a white surface in a light of pi lux becomes in the picture
};

}  // namespace enfilade::render
