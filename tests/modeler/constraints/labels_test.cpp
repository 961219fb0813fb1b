// S1: every volume and face has its one label.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::modeler {
namespace {

std::uint32_t volume_of(const Building& building, Label label) {
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].label == label) return v;
    return 0;
}

TEST(Labels, FindsEachRowThatDoesNotFitTheMap) { testing::expect_found(testing::inject_s1, 40); }

TEST(Labels, SaysWhatAVolumeIsLabelled) {
    Building building = build(testing::two_rooms());
    building.volumes[volume_of(building, Label::Door)].label = Label::Window;
    const CheckReport report = check(building);
    ASSERT_EQ(report.count("S1"), 1u);
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_NE(report.findings[0].sentence.find("labelled \"window\""), std::string::npos)
        << report.findings[0].sentence;
    EXPECT_EQ(report.findings[0].elements.front().kind, "door");
}

TEST(Labels, NamesAWrongSpaceOnce) {
    Building building = convexify(build(testing::ring_room()));
    for (Space& space : building.spaces)
        if (space.label == Label::Room) space.label = Label::Shaft;
    const CheckReport report = check(building);
    EXPECT_EQ(report.count("S1"), 1u);
    EXPECT_EQ(report.findings.size(), 1u);
}

TEST(Labels, ThereIsOneOutside) {
    Building building = build(testing::one_room());
    const std::uint32_t wall = volume_of(building, Label::Wall);
    building.volumes[wall].label = Label::Outside;
    building.volumes[wall].space = outside_space;
    const CheckReport report = check(building);
    EXPECT_EQ(report.count("S1"), 1u) << testing::all_of(report);
}

TEST(Labels, LeavesPortalsToD2) {
    Building building = build(testing::two_rooms());
    const std::uint32_t door = volume_of(building, Label::Door), wall = volume_of(building, Label::Wall);
    for (Face& face : building.faces)
        if (face.front == door && carries_light(building.volumes[face.back].label)) {
            face.front = wall;
            break;
        }
    const CheckReport report = check(building);
    EXPECT_EQ(report.count("S1"), 0u);
    EXPECT_EQ(report.count("D2"), 1u) << testing::all_of(report);
}

TEST(Labels, SeesAMapWithMoreVolumesThanRows) {
    Building building = build(testing::one_room());
    building.volumes.pop_back();
    building.volumes.back().label = Label::Outside;
    const CheckReport report = check(building);
    EXPECT_EQ(report.count("S1"), 1u);
    EXPECT_EQ(report.count("D2"), 0u);
}

}  // namespace
}  // namespace enfilade::modeler
