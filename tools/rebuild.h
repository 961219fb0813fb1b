#pragma once
// A building read back from a scene, made again from its plan so that it can be cut anew.

#include <string>

#include "modeler/building.h"

namespace enfilade::tools {

/// The convex building of `read.plan_json`, without furniture, as the options of its certificate say (tools/model.h).
/// \throws InputError (F123) where that does not give the rooms that the scene has: it was made in another way
[[nodiscard]] modeler::Building rebuilt(const modeler::Building& read, const std::string& options_json);

}  // namespace enfilade::tools
