#pragma once
// A building with findings of every kind, as a check would report them: the page does not ask who found them.

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "tests/support/small_plans.h"

namespace enfilade::testing {

inline modeler::Building cells_of(const plans::Plan& plan) { return modeler::convexify(modeler::build(plan)); }

inline Finding finding(std::string code, Severity severity, std::string sentence) {
    Finding result;
    result.code = std::move(code);
    result.severity = severity;
    result.sentence = std::move(sentence);
    return result;
}

/// Of `two_storeys`: a note without a place, a warning on the upper storey found by its height, an error on the ground
/// floor that names a wall, and a repair.
inline modeler::CheckReport mixed_report() {
    modeler::CheckReport report;
    report.codes_checked = {"T1", "T7", "G5"};
    report.findings.push_back(finding("P203", Severity::Note, "A note without a place."));
    Finding warning = finding("G5", Severity::Warning, "Something overlaps upstairs.");
    warning.point = {1, 5, 3.5};
    report.findings.push_back(warning);
    Finding error = finding("T7", Severity::Error, "The east wall is broken.");
    error.hint = "Draw it again.";
    error.point = {8, 3, 1};
    error.storey = "ground";
    error.elements.push_back({"wall", "ge", "East wall"});
    report.findings.push_back(error);
    Finding repair = finding("P215", Severity::Warning, "Two wall ends were joined.");
    repair.point = {5, 6, 2.75};
    repair.storey = "upper";
    repair.moved_mm = 12.5;
    report.findings.push_back(repair);
    return report;
}

}  // namespace enfilade::testing
