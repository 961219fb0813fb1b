#include "modeler/convexify.h"

#include <algorithm>

#include "base/check.h"
#include "modeler/realise.h"

namespace enfilade::modeler {

Building convexify(const Building& building, const ConvexifyOptions& options, const accel::Executor& executor) {
    ENFILADE_CHECK(!building.stack.regions.empty());
    Building convex = realise(building.stack, {true, options.convexifier, options.cost}, executor);
    convex.name = building.name;
    convex.plan_json = building.plan_json;
    convex.lamps = building.lamps;
    convex.pictures = building.pictures;
    convex.sagitta = building.sagitta;
    convex.opaque_glass = building.opaque_glass;
    convex.max_deviation = std::max(convex.max_deviation, building.max_deviation);
    convex.findings.insert(convex.findings.begin(), building.findings.begin(), building.findings.end());
    return convex;
}

}  // namespace enfilade::modeler
