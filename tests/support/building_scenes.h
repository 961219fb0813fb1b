#pragma once
// Buildings as people draw them: the examples, generated ones with curved walls, and other people's homes.

#include <string>
#include <vector>

#include "accel/scene_input.h"

namespace enfilade::test {

struct BuildingScene {
    std::string name;  ///< letters, digits and underscores
    std::string plan;  ///< a file, or empty: generated
};

/// The examples, four generated plans, and the homes of ../shared/data/sh3d where they are.
[[nodiscard]] std::vector<BuildingScene> building_scenes();

/// Reads or generates the plan, builds it and cuts it. \throws InputError if it cannot be built
[[nodiscard]] accel::SceneInput scene_of(const BuildingScene& building);

}  // namespace enfilade::test
