#include "modeler/build.h"

#include <algorithm>

#include "base/error.h"
#include "modeler/levels.h"
#include "modeler/lighting/plan_lamps.h"
#include "modeler/realise.h"

namespace enfilade::modeler {
namespace {

/// The plan without the storeys that cannot be stacked, and `chosen` renumbered to match.
plans::Plan without_unstackable(plans::Plan plan, std::vector<std::uint32_t>& chosen) {
    for (const std::uint32_t k : chosen)
        if (k >= plan.storeys.size())
            throw InputError("P404", plan.name,
                             "The plan has " + std::to_string(plan.storeys.size()) +
                                 " storeys, numbered from 0: there is no storey " + std::to_string(k) + ".");
    std::vector<std::uint32_t> kept = stackable(plan, chosen, plan.findings);
    std::vector<std::uint32_t> considered = chosen;
    if (considered.empty())
        for (std::uint32_t k = 0; k < plan.storeys.size(); ++k) considered.push_back(k);
    std::vector<std::uint32_t> new_index(plan.storeys.size(), UINT32_MAX);
    std::vector<plans::Storey> storeys;
    for (std::uint32_t k = 0; k < plan.storeys.size(); ++k) {
        const bool refused = std::find(considered.begin(), considered.end(), k) != considered.end() &&
                             std::find(kept.begin(), kept.end(), k) == kept.end();
        if (refused) continue;
        new_index[k] = std::uint32_t(storeys.size());
        storeys.push_back(std::move(plan.storeys[k]));
    }
    plan.storeys = std::move(storeys);
    for (std::uint32_t& k : kept) k = new_index[k];
    std::sort(kept.begin(), kept.end());
    chosen = std::move(kept);
    return plan;
}

}  // namespace

Building build(const plans::Plan& plan, const BuildOptions& options) {
    plans::Plan cleaned = plans::clean(plan, options.clean);
    if (cleaned.storeys.empty())
        throw InputError("P405", plan.name, "The plan holds no storey with walls: there is nothing to build.");
    plans::ArrangeOptions arrange = options.arrange;
    cleaned = without_unstackable(std::move(cleaned), arrange.storeys);
    const plans::Layout layout = plans::arrange(cleaned, arrange);

    std::vector<Finding> findings = cleaned.findings;
    findings.insert(findings.end(), layout.findings.begin(), layout.findings.end());
    Stack stacked = stack(cleaned, layout, findings);
    Building building = realise(std::move(stacked), {});
    building.name = plan.name;
    building.plan_json = plans::write_json(cleaned);
    building.lamps = plan_lamps(cleaned, building.storeys);
    building.opaque_glass = options.opaque_glass;
    building.sagitta = arrange.sagitta_mm / 1000;
    building.max_deviation = std::max(building.max_deviation, layout.graph.max_deviation);
    building.findings.insert(building.findings.begin(), findings.begin(), findings.end());
    return building;
}

}  // namespace enfilade::modeler
