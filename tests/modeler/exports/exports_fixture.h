#pragma once
// Scenes and models that the writers' tests share.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/model_group.h"
#include "plans/read.h"
#include "tests/support/small_plans.h"

namespace enfilade::test {

/// A plan, its scene, and its model as it is read back from the scene: without stack.
struct BuiltPlan {
    accel::Scene scene;
    modeler::Building model;
};

[[nodiscard]] inline BuiltPlan built(const plans::Plan& plan) {
    BuiltPlan result;
    const modeler::Building building = modeler::convexify(modeler::build(plan));
    result.scene = modeler::export_scene(building, modeler::check(building), "{}");
    result.model = modeler::read_model(result.scene);
    return result;
}

[[nodiscard]] inline plans::Plan example(const std::string& name) {
    return plans::read(std::filesystem::path(ENFILADE_SOURCE_DIR) / "plans" / "examples" / name);
}

/// A name that breaks careless writers of XML, JSON and DOT.
inline const std::string nasty_name = "a\"b\\c<d>&e'f\ng\x01h\xEF\xBF\xBFi\xC3\xBC";

}  // namespace enfilade::test
