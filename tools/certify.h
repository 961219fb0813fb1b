#pragma once
// Whether a scene file still is what was checked when it was written (docs/scene-format.md).

#include <optional>
#include <string>

#include "accel/scene.h"
#include "modeler/check.h"

namespace enfilade::tools {

struct Certification {
    /// "certified", "differs at ARRAY[INDEX]", or "uncertified: no model group".
    std::string verdict;
    /// Of the map in the file, validated anew; nothing for a stripped scene.
    std::optional<modeler::CheckReport> report;
};

/// Rebuilds the building from the scene's model group, checks it again, exports it again, and compares the trace group
/// index by index.
[[nodiscard]] Certification certify(const accel::Scene& scene);

/// Where the trace groups of two scenes differ first: "cells[12]", "section_x: 40 elements instead of 48"; nothing
/// where they are the same.
[[nodiscard]] std::optional<std::string> first_difference(const accel::Scene& scene, const accel::Scene& again);

}  // namespace enfilade::tools
