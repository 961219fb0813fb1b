#pragma once
// What a scene must satisfy so that every walk stays inside its arrays and ends.

#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"

namespace enfilade::accel {

struct Defect {
    std::string code;      ///< F3: an array, F4: an index, F5: a number, F6: the portal graph
    std::string sentence;  ///< which array and index, and what is wrong
};

/// Checks every index range, number, portal, mesh, placement and list of the view; stops at 32 defects. Empty for a
/// sound scene. Cost: one pass over the trace group, more than 1 GB/s a core.
[[nodiscard]] std::vector<Defect> validate(const SceneView& view, const Executor& executor);
[[nodiscard]] std::vector<Defect> validate(const SceneView& view);

}  // namespace enfilade::accel
