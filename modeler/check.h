#pragma once
// Is the building sound? The written list of constraints, applied (2-model, "Constraints"; docs/checks.md).

#include <cstdint>
#include <string>
#include <vector>

#include "base/finding.h"
#include "modeler/building.h"

namespace enfilade::modeler {

struct CheckReport {
    std::vector<Finding> findings;           ///< by level T, G, S, D, then of the plan's stages
    std::uint64_t suppressed = 0;            ///< findings left out because what they blame is blamed already
    std::vector<std::string> codes_checked;  ///< constraints that were applied, in order

    /// No finding of severity Error.
    [[nodiscard]] bool sound() const { return !has_errors(findings); }
    [[nodiscard]] std::size_t count(const std::string& code) const;
};

struct CheckOptions {
    double least_thickness = 0.01;  ///< metres: walls and slabs thinner than this are doubtful (G6)
};

/// Applies the constraints to the map, and adds what the plan's stages had to say. The geometry is computed anew from
/// the map and its points; what the plan says is read anew from the building's `plan_json`.
[[nodiscard]] CheckReport check(const Building& building, const CheckOptions& options = {});

}  // namespace enfilade::modeler
