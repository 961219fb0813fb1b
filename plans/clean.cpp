// What people draw -> what later stages expect (clean_steps.h).

#include <algorithm>

#include "plans/clean_steps.h"

namespace enfilade::plans {
namespace {

constexpr int kMostRounds = 16;

std::unordered_set<std::string> wall_ids(const Plan& plan) {
    std::unordered_set<std::string> ids;
    for (const Storey& storey : plan.storeys)
        for (const Wall& wall : storey.walls) ids.insert(wall.id);
    return ids;
}

/// Repairs may make others possible (a wall extended onto its twin): the steps run until they find nothing.
void clean_all_walls(Storey& storey, const CleanOptions& options, std::unordered_set<std::string>& ids,
                     CleanReport& report) {
    for (int round = 0; round < kMostRounds; ++round) {
        bool changed = clean_walls(storey, report);
        changed = drop_duplicate_walls(storey, report) || changed;
        changed = join_walls(storey, options.join_gap, report) || changed;
        changed = cut_slopes(storey, options.step, ids, report) || changed;
        if (!changed) return;
    }
}

}  // namespace

Plan clean(Plan plan, const CleanOptions& options) {
    CleanReport report(plan.findings);
    clean_storeys(plan, report);
    std::unordered_set<std::string> ids = wall_ids(plan);
    for (Storey& storey : plan.storeys) {
        clean_all_walls(storey, options, ids, report);
        note_high_walls(storey, report);
        clean_openings(storey, report);
        clean_rooms(storey, report);
    }
    drop_empty_storeys(plan, report);
    report.finish();
    return plan;
}

}  // namespace enfilade::plans
