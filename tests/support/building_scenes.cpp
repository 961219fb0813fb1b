#include "tests/support/building_scenes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "plans/read.h"

namespace enfilade::test {
namespace {

constexpr const char* generated_names[] = {"generated_curved", "generated_oblique", "generated_mixed",
                                           "generated_storeys"};

plans::Plan plan_of(const BuildingScene& building) {
    if (!building.plan.empty()) return plans::read(building.plan);
    if (building.name == generated_names[0]) return plans::generate({.rooms = 30, .curved = 1, .seed = 3});
    if (building.name == generated_names[1]) return plans::generate({.rooms = 30, .oblique = 1, .seed = 4});
    if (building.name == generated_names[2])
        return plans::generate({.rooms = 70, .curved = 0.4, .oblique = 0.4, .seed = 5});
    return plans::generate({.rooms = 60, .storeys = 3, .curved = 0.3, .oblique = 0.2, .seed = 6});
}

std::string name_for(const std::filesystem::path& file) {
    std::string name = file.stem().string();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

}  // namespace

std::vector<BuildingScene> building_scenes() {
    namespace fs = std::filesystem;
    std::vector<BuildingScene> scenes;
    for (const char* name : generated_names) scenes.push_back({name, ""});
    const auto add_folder = [&](const std::string& folder, const char* ending) {
        std::error_code absent;
        std::vector<BuildingScene> found;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent))
            // plans/examples holds tours as well: NAME.views.json
            if (entry.path().extension() == ending && entry.path().stem().extension() != ".views")
                found.push_back({name_for(entry.path()), entry.path().string()});
        std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.plan < b.plan; });
        scenes.insert(scenes.end(), found.begin(), found.end());
    };
    add_folder(ENFILADE_SOURCE_DIR "/plans/examples", ".json");
    add_folder(ENFILADE_SOURCE_DIR "/../shared/data/sh3d", ".sh3d");
    return scenes;
}

accel::SceneInput scene_of(const BuildingScene& building) {
    return modeler::scene_input(modeler::convexify(modeler::build(plan_of(building))));
}

}  // namespace enfilade::test
