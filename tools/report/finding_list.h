#pragma once
// Findings as entries of a list and as pins on storeys.

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "modeler/check.h"
#include "tools/report/plan_view.h"

namespace enfilade::tools {

struct PlacedFinding {
    const Finding* finding = nullptr;
    std::size_t number = 0;             ///< from 1 on: errors, then warnings, then notes, each as reported
    std::uint32_t storey = UINT32_MAX;  ///< of the building; none where the finding has no place there
    bool has_pin = false;
    double x = 0, y = 0;  ///< of the pin: metres from the drawings' origin, y down
};

/// `view`: null where nothing is drawn.
[[nodiscard]] std::vector<PlacedFinding> place_findings(const modeler::CheckReport& report, const PlanView* view);

/// Ids of all elements that findings name.
[[nodiscard]] std::set<std::string> blamed_elements(const modeler::CheckReport& report);

/// `<li>` for each finding.
[[nodiscard]] std::string finding_list(const std::vector<PlacedFinding>& findings, const PlanView* view);

/// `<g class="pin">` for each finding on one storey.
[[nodiscard]] std::string pins(const std::vector<PlacedFinding>& findings, std::uint32_t storey);

/// What the page's script works with: storeys, and for each finding its number, code, severity, storey, place and ids.
[[nodiscard]] nlohmann::ordered_json page_data(const std::vector<PlacedFinding>& findings, const PlanView* view);

}  // namespace enfilade::tools
