#pragma once
// What the reader has to say about a storey, and the ids of its elements.

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "plans/clean_report.h"
#include "plans/plan.h"

namespace enfilade::plans {

/// Ids that are unique in the plan: the file's, with "-2", "-3", ... behind it where it is taken.
class FloorElementIds {
public:
    [[nodiscard]] std::string take(const std::string& id);

private:
    std::unordered_set<std::string> taken_;
    std::unordered_map<std::string, std::size_t> last_;
};

struct FloorReport {
    std::vector<Finding>& findings;
    FloorElementIds& ids;

    Finding& add(const char* code, Severity severity, const Storey& storey, std::string sentence, std::string hint) {
        findings.push_back({code, severity, std::move(sentence), std::move(hint), {}, storey.id, {}, 0});
        return findings.back();
    }
};

/// "1 window", "3 windows".
[[nodiscard]] std::string floor_count(std::size_t count, const char* one, const char* more);
/// "\"A\"", "\"A\" and \"B\"", "\"A\", \"B\" and 3 others".
[[nodiscard]] std::string floor_names(const std::vector<ElementRef>& elements);

}  // namespace enfilade::plans
