#pragma once
// How cleaning says what it did: one finding per repair, none twice.

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "plans/number_text.h"
#include "plans/plan.h"

namespace enfilade::plans {

/// Adds findings to a plan. What the plan says already (it was cleaned before, or comes from `import`) is not said
/// again: cleaning twice changes nothing.
class CleanReport {
public:
    explicit CleanReport(std::vector<Finding>& findings) : findings_(findings) {
        for (const Finding& finding : findings) known_.insert(key(finding));
    }

    void add(Finding finding) {
        if (known_.insert(key(finding)).second) fresh_.push_back(std::move(finding));
    }

    /// Puts the new findings behind the old ones, in an order that does not depend on that of the file.
    void finish() {
        std::sort(fresh_.begin(), fresh_.end(), [](const Finding& l, const Finding& r) {
            return std::tie(l.code, l.storey, l.sentence) < std::tie(r.code, r.storey, r.sentence);
        });
        findings_.insert(findings_.end(), std::make_move_iterator(fresh_.begin()),
                         std::make_move_iterator(fresh_.end()));
        fresh_.clear();
    }

private:
    static std::string key(const Finding& finding) {
        return finding.code + '\n' + finding.storey + '\n' + finding.sentence;
    }

    std::vector<Finding>& findings_;
    std::vector<Finding> fresh_;
    std::unordered_set<std::string> known_;
};

template <class Element>
[[nodiscard]] std::string called(const Element& element) {
    return "\"" + (element.name.empty() ? element.id : element.name) + "\"";
}

/// "Wall "w1" on storey "Ground"": how every sentence about an element begins.
template <class Element>
[[nodiscard]] std::string named(const char* kind, const Element& element, const Storey& storey) {
    return std::string(kind) + " " + called(element) + " on storey " + called(storey);
}

[[nodiscard]] inline std::string metres_text(double value) { return rounded_text(value, 3) + " m"; }
[[nodiscard]] inline std::string millimetres_text(double metres) { return rounded_text(metres * 1000, 1) + " mm"; }

/// A finding about one element of a storey, its sentence and hint still to be said.
template <class Element>
[[nodiscard]] Finding about(const char* code, Severity severity, const char* kind, const Element& element,
                            const Storey& storey, Point at) {
    Finding finding;
    finding.code = code;
    finding.severity = severity;
    finding.storey = storey.id;
    finding.elements.push_back({kind, element.id, element.name});
    finding.point = {at.x, at.y, storey.elevation};
    return finding;
}

}  // namespace enfilade::plans
