#pragma once
// What `check` made of an injected fault: found with its code, at its place, and nothing else.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "modeler/check.h"
#include "tests/support/injected_fault.h"

namespace enfilade::testing {

struct FaultVerdict {
    std::size_t found = 0;               ///< findings with the fault's code
    std::vector<std::string> other;      ///< "S3: sentence" of errors and warnings with another code
    std::vector<std::string> sentences;  ///< of what was found
    std::size_t out_of_place = 0;        ///< found, but too far away or without a point
    std::size_t unnamed = 0;             ///< found, but naming none of the fault's elements

    [[nodiscard]] bool exact() const { return found >= 1 && other.empty() && out_of_place == 0 && unnamed == 0; }
    [[nodiscard]] std::string text() const {
        std::string text = "found " + std::to_string(found) + ", out of place " + std::to_string(out_of_place) +
                           ", unnamed " + std::to_string(unnamed);
        for (const std::string& sentence : sentences) text += "\n  " + sentence;
        for (const std::string& sentence : other) text += "\n  and " + sentence;
        return text;
    }
};

/// Errors and warnings that are in `after` and not in `before`.
inline std::vector<Finding> fresh_findings(const modeler::CheckReport& before, const modeler::CheckReport& after) {
    std::vector<bool> used(before.findings.size(), false);
    std::vector<Finding> fresh;
    for (const Finding& finding : after.findings) {
        if (finding.severity == Severity::Note) continue;
        bool known = false;
        for (std::size_t k = 0; k < used.size() && !known; ++k) {
            const Finding& old = before.findings[k];
            known = !used[k] && old.code == finding.code && old.sentence == finding.sentence;
            if (known) used[k] = true;
        }
        if (!known) fresh.push_back(finding);
    }
    return fresh;
}

inline FaultVerdict judge(const modeler::CheckReport& before, const modeler::CheckReport& after,
                          const InjectedFault& fault) {
    FaultVerdict verdict;
    for (const Finding& finding : fresh_findings(before, after)) {
        // Lamps stay where they hang: what has moved or gone around them is told of them, too.
        if (finding.code == "S7" && fault.code != "S7") continue;
        if (finding.code != fault.code) {
            verdict.other.push_back(finding.code + ": " + finding.sentence);
            continue;
        }
        ++verdict.found;
        verdict.sentences.push_back(finding.code + ": " + finding.sentence);
        const auto distance = [&](const std::array<double, 3>& p) {
            return std::hypot(p[0] - fault.point[0], p[1] - fault.point[1], p[2] - fault.point[2]);
        };
        if (!finding.point || !(distance(*finding.point) <= fault.reach)) ++verdict.out_of_place;
        const auto is_named = [&](const ElementRef& wanted) {
            return std::any_of(finding.elements.begin(), finding.elements.end(), [&](const ElementRef& element) {
                return element.id == wanted.id && (wanted.kind.empty() || element.kind == wanted.kind);
            });
        };
        if (!fault.elements.empty() && std::none_of(fault.elements.begin(), fault.elements.end(), is_named))
            ++verdict.unnamed;
    }
    return verdict;
}

}  // namespace enfilade::testing
