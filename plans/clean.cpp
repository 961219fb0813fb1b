// What people draw -> what later stages expect (clean_steps.h).

#include <algorithm>

#include "plans/clean_steps.h"

namespace enfilade::plans {
namespace {

std::unordered_set<std::string> wall_ids(const Plan& plan) {
    std::unordered_set<std::string> ids;
    for (const Storey& storey : plan.storeys)
        for (const Wall& wall : storey.walls) ids.insert(wall.id);
    return ids;
}

}  // namespace

Plan clean(Plan plan, const CleanOptions& options) {
    CleanReport report(plan.findings);
    std::stable_sort(plan.storeys.begin(), plan.storeys.end(),
                     [](const Storey& l, const Storey& r) { return l.elevation < r.elevation; });
    std::unordered_set<std::string> ids = wall_ids(plan);
    for (Storey& storey : plan.storeys) {
        clean_walls(storey, report);
        cut_slopes(storey, options.step, ids, report);
        clean_openings(storey, report);
    }
    return plan;
}

}  // namespace enfilade::plans
