// Plans of other people and our own examples: built, checked, exported.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"

namespace enfilade::modeler {
namespace {

std::string errors(const CheckReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        if (finding.severity == Severity::Error) text += finding.code + " " + finding.sentence + "\n";
    return text;
}

std::size_t rooms_in(const Building& building) {
    return std::size_t(std::count_if(building.spaces.begin(), building.spaces.end(),
                                     [](const Space& space) { return space.label == Label::Room; }));
}

TEST(RealPlans, HomesAreBuiltSound) {
    const std::filesystem::path homes = ENFILADE_SOURCE_DIR "/../shared/data/sh3d";
    if (!std::filesystem::exists(homes)) GTEST_SKIP() << "no real homes beside this checkout (../shared/data/sh3d)";
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(homes)) {
        if (entry.path().extension() != ".sh3d") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const Building building = build(plans::read(entry.path()));
        EXPECT_EQ(errors(check(building)), "");
        const Building convex = convexify(building);
        const CheckReport report = check(convex);
        EXPECT_EQ(errors(report), "");
        EXPECT_GT(export_scene(convex, report, "{}").view().cells.size(), 0u);
        ++count;
    }
    EXPECT_GE(count, 14u);
}

class Example : public ::testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(Example, HasItsRoomsAndNoFindings) {
    const auto [name, rooms] = GetParam();
    const Building convex = convexify(build(plans::read(std::string(ENFILADE_SOURCE_DIR "/plans/examples/") + name)));
    const CheckReport report = check(convex);
    EXPECT_EQ(errors(report), "");
    EXPECT_TRUE(report.findings.empty());
    EXPECT_EQ(rooms_in(convex), rooms);
    for (const Space& space : convex.spaces)
        if (space.label == Label::Room) {
            EXPECT_NE(space.name, "") << space.id;
        }
}

INSTANTIATE_TEST_SUITE_P(RealPlans, Example,
                         ::testing::Values(std::pair("townhouse.json", 15), std::pair("office-46.json", 46),
                                           std::pair("office-135.json", 135)));

}  // namespace
}  // namespace enfilade::modeler
