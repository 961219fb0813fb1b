#pragma once
// How much a plan holds.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "plans/plan.h"

namespace enfilade::tools {

/// "2 storeys, 44 walls, 21 openings, 15 rooms"
[[nodiscard]] std::string plan_counts_text(const plans::Plan& plan);
[[nodiscard]] nlohmann::ordered_json plan_counts_json(const plans::Plan& plan);

}  // namespace enfilade::tools
