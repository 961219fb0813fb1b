#pragma once
// Lamps in the model group of a scene file (docs/scene-format.md, m.lamps).

#include <string>
#include <vector>

#include "modeler/lighting/lamp.h"

namespace enfilade::modeler {

/// The lamps as JSON.
[[nodiscard]] std::string lamps_text(const std::vector<Lamp>& lamps);

/// What was written. storey_count: of the building. \throws InputError (F20) for any other text
[[nodiscard]] std::vector<Lamp> read_lamps(const std::string& text, std::size_t storey_count);

}  // namespace enfilade::modeler
