#pragma once
// The cells that a lamp's light crosses on its way to others.

#include <cstdint>
#include <vector>

#include "accel/beam.h"

namespace enfilade::modeler {

/// Sets `is_crossed` for every cell on a beam's way from the lamp to a cell that `is_wanted`, both ends included.
/// [cell] each. margin: grid units. Where beams are too many to be followed one by one, all ways that could lead there
/// count.
void mark_lamp_paths(const accel::SceneView& scene, const accel::BeamSource& lamp, std::int64_t margin,
                     const std::vector<char>& is_wanted, std::vector<char>& is_crossed);

}  // namespace enfilade::modeler
