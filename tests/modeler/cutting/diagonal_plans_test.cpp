// Whole buildings cut by diagonals are as sound as they were before.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "plans/generate.h"
#include "plans/read.h"
#include "tests/support/random_plan.h"

namespace enfilade::modeler {
namespace {

std::string errors(const Building& building) {
    const CheckReport report = check(building);
    std::string text;
    for (const Finding& finding : report.findings)
        if (finding.severity == Severity::Error) text += finding.code + " " + finding.sentence + "\n";
    return text;
}

Building cut(const plans::Plan& plan) { return convexify(build(plan), {.convexifier = Convexifier::Diagonals}); }

RC_GTEST_PROP(DiagonalPlans, GeneratedOfficesAreSound, ()) {
    plans::GenerateOptions options{.rooms = *rc::gen::inRange(2u, 12u), .curved = 0.5, .oblique = 0.3};
    options.seed = *rc::gen::arbitrary<std::uint64_t>();
    RC_ASSERT(errors(cut(plans::generate(options))) == "");
}

RC_GTEST_PROP(DiagonalPlans, WhateverIsDrawnHasConvexCells, ()) {
    const plans::Plan plan = testing::any_plan();
    try {
        const Building building = build(plan);
        const CheckReport before = check(building);
        const CheckReport after = check(convexify(building, {.convexifier = Convexifier::Diagonals}));
        RC_ASSERT(after.count("G8") == 0u);
        RC_ASSERT(after.sound() || !before.sound());
    } catch (const InputError& error) {
        RC_TAG("refused");
        RC_ASSERT(error.code[0] == 'P');
    }
}

class DiagonalExample : public ::testing::TestWithParam<const char*> {};

TEST_P(DiagonalExample, IsSound) {
    EXPECT_EQ(errors(cut(plans::read(std::string(ENFILADE_SOURCE_DIR "/plans/examples/") + GetParam()))), "");
}

INSTANTIATE_TEST_SUITE_P(Plans, DiagonalExample, ::testing::Values("townhouse.json", "office-46.json"));

}  // namespace
}  // namespace enfilade::modeler
