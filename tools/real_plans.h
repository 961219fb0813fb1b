#pragma once
// The plans of other people that the developers have at hand: read by path, never part of this repository.

#include <filesystem>
#include <string>
#include <vector>

#include "plans/read.h"

namespace enfilade::tools {

struct RealPlan {
    std::string name;  ///< of the file
    std::filesystem::path file;
    plans::ReadOptions options;  ///< what a drawing does not say of itself (inputs_counted.json)
};

/// The homes, drawings and floor plans under `folder` (sh3d/*.sh3d, dxf/*.dxf, other/floorspace_*.json), by name within
/// each kind. Empty where there are none.
[[nodiscard]] std::vector<RealPlan> real_plans(const std::filesystem::path& folder);

}  // namespace enfilade::tools
