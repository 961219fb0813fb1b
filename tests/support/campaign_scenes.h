#pragma once
// The buildings of campaigns, and how many tries one asks for.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "accel/assemble.h"
#include "base/error.h"
#include "tests/support/building_scenes.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::test {

/// The number in an environment variable; `otherwise` where it is not set.
inline std::uint64_t asked(const char* variable, std::uint64_t otherwise) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

struct CampaignScene {
    std::string name;
    accel::Scene scene;
};

/// Straight, turned and bent walls; and buildings with curved ones.
inline std::vector<CampaignScene> campaign_scenes(bool with_homes) {
    std::vector<CampaignScene> all;
    for (const double turn : {0.0, 0.0001, 0.3, 0.785398163397448})
        all.push_back({"office turned by " + std::to_string(turn),
                       accel::assemble(synthetic_office(
                           {.rooms_per_row = 5, .rows = 4, .storeys = turn == 0.3 ? 3 : 1, .turn = turn}))});
    for (const BuildingScene& building : building_scenes()) {
        if (!building.plan.empty() && !with_homes) continue;
        try {
            all.push_back({building.name, accel::assemble(scene_of(building))});
        } catch (const InputError&) {  // a plan that is refused
        }
    }
    return all;
}

}  // namespace enfilade::test
