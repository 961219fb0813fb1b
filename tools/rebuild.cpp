#include "tools/rebuild.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "plans/read.h"
#include "tools/convexifiers.h"

namespace enfilade::tools {

namespace {

/// The rooms, walls, doors ... without what stands in them.
std::vector<std::string> fixed_spaces(const modeler::Building& building) {
    std::vector<std::string> ids;
    for (const modeler::Space& space : building.spaces)
        if (space.label != accel::Label::Object) ids.push_back(space.id);
    return ids;
}

}  // namespace

modeler::Building rebuilt(const modeler::Building& read, const std::string& options_json) {
    const nlohmann::json options = nlohmann::json::parse(options_json, nullptr, false);
    modeler::BuildOptions build;
    modeler::ConvexifyOptions convexify;
    if (options.is_object()) {
        build.arrange.snap_mm = options.value("snap_mm", build.arrange.snap_mm);
        build.arrange.sagitta_mm = options.value("sagitta_mm", build.arrange.sagitta_mm);
        build.clean.step = options.value("step_mm", 1000 * build.clean.step) / 1000;
        build.arrange.storeys = options.value("storeys", std::vector<std::uint32_t>{});
        build.opaque_glass = options.value("glass", "clear") == std::string("opaque");
        convexify.convexifier = convexifier_of(options.value("convexify", "sah"));
    }
    modeler::Building building =
        modeler::convexify(modeler::build(plans::read_json(read.plan_json, "the scene's plan"), build), convexify);
    if (fixed_spaces(building) != fixed_spaces(read) || building.frame.unit != read.frame.unit ||
        building.frame.origin_x != read.frame.origin_x || building.frame.origin_y != read.frame.origin_y ||
        building.frame.origin_z != read.frame.origin_z)
        throw InputError("F123", "",
                         "The scene's plan does not give its rooms again, so they cannot be cut anew: build it again "
                         "from its plan, or with --objects list.");
    building.findings.clear();
    building.lamps = read.lamps;
    building.pictures = read.pictures;
    return building;
}

}  // namespace enfilade::tools
