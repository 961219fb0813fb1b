#pragma once
// D3: whether a scene file still is what was checked when it was written (docs/scene-format.md).

#include <optional>
#include <string>

#include "accel/scene.h"
#include "modeler/building.h"
#include "modeler/check.h"

namespace enfilade::modeler {

struct Certification {
    /// "certified", "differs at ARRAY[INDEX]" (or "at model", "at certificate"), or "uncertified: no model group".
    std::string verdict;
    /// Of the map in the file, validated anew, with an Error D3 for each way in which the file differs from it; nothing
    /// for a stripped scene.
    std::optional<CheckReport> report;
    /// What was read from the file, to draw it; nothing for a stripped scene.
    std::optional<Building> building;
};

/// Rebuilds the building from the scene's model group, checks it again, exports it again, and compares the trace group
/// index by index; the certificate has to state the hash of this model group and what this check counts. Throws
/// InputError where the model group is damaged, or cannot become a scene.
[[nodiscard]] Certification certify(const accel::Scene& scene);

/// Where two scenes differ.
struct SceneDifference {
    std::string text;  ///< "cells[12]", "section_x: 40 elements instead of 48", "tints" (missing in one of them)
    std::uint32_t array_id = 0;        ///< accel::SectionKind
    std::optional<std::size_t> index;  ///< the first element that differs; nothing where the array is missing
};

/// The first difference of the trace groups, in file order; nothing where they are the same.
[[nodiscard]] std::optional<SceneDifference> first_difference(const accel::Scene& scene, const accel::Scene& again);

}  // namespace enfilade::modeler
