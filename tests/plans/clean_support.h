#pragma once
// What the tests of cleaning ask of its findings.

#include <algorithm>
#include <string>
#include <vector>

#include "plans/read.h"
#include "tests/support/small_plans.h"

namespace enfilade::testing {

inline std::vector<Finding> findings_of(const plans::Plan& plan, const std::string& code) {
    std::vector<Finding> found;
    std::copy_if(plan.findings.begin(), plan.findings.end(), std::back_inserter(found),
                 [&](const Finding& finding) { return finding.code == code; });
    return found;
}

/// All codes of the plan's findings, sorted: "P215 P215 P221".
inline std::string codes_of(const plans::Plan& plan) {
    std::vector<std::string> codes;
    for (const Finding& finding : plan.findings) codes.push_back(finding.code);
    std::sort(codes.begin(), codes.end());
    std::string text;
    for (const std::string& code : codes) text += (text.empty() ? "" : " ") + code;
    return text;
}

inline const plans::Wall* wall_of(const plans::Plan& plan, const std::string& id) {
    for (const plans::Storey& storey : plan.storeys)
        for (const plans::Wall& wall : storey.walls)
            if (wall.id == id) return &wall;
    return nullptr;
}

inline const plans::Opening* opening_of(const plans::Plan& plan, const std::string& id) {
    for (const plans::Storey& storey : plan.storeys)
        for (const plans::Opening& opening : storey.openings)
            if (opening.id == id) return &opening;
    return nullptr;
}

/// One storey with these walls.
inline plans::Plan plan_of(std::vector<plans::Wall> walls) {
    plans::Plan plan;
    plan.name = "walls";
    plan.storeys.push_back(storey("ground"));
    plan.storeys[0].walls = std::move(walls);
    return plan;
}

}  // namespace enfilade::testing
