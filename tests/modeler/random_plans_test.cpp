// Whatever the plan, what is built is sound or refused with a reason.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "tests/support/random_plan.h"

namespace enfilade::modeler {
namespace {

/// Errors of the model itself: those of the plan's stages (P...) are about the plan, and so are stairs that it draws
/// where nothing is above them (S4).
std::string model_errors(const CheckReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        if (finding.severity == Severity::Error && finding.code[0] != 'P' && finding.code != "S4")
            text += finding.code + ": " + finding.sentence + "\n";
    return text;
}

RC_GTEST_PROP(RandomPlans, AreBuiltSoundOrRefused, ()) {
    const plans::Plan plan = testing::any_plan();
    RC_LOG() << plans::write_json(plan) << "\n";
    try {
        const Building building = build(plan);
        RC_ASSERT(model_errors(check(building)) == "");
        const Building convex = convexify(building);
        const CheckReport report = check(convex);
        RC_ASSERT(model_errors(report) == "");
        (void)export_scene(convex, report, "{}");
    } catch (const InputError& error) {
        RC_TAG("refused");
        RC_ASSERT(std::string(error.what()) != "");
        RC_ASSERT(error.code[0] == 'P');
    }
}

}  // namespace
}  // namespace enfilade::modeler
