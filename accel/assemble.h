#pragma once
// From the modeler's plain description to the flat scene.

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "accel/scene_input.h"

namespace enfilade::accel {

/// Lays out `input` as a scene file image, builds its point locator, hashes its arrays and validates the whole.
/// The same input gives the same bytes. Cost: n log n in the cells, for the locator.
/// \throws InputError (codes F10-F13) if `input` cannot be a scene: an index out of range, a coordinate beyond 2^24
///         units, a unit that is no power of two, a stack that does not end at the ceiling, a portal not seen from both
///         sides.
[[nodiscard]] Scene assemble(const SceneInput& input, const Executor* executor = nullptr);

}  // namespace enfilade::accel
