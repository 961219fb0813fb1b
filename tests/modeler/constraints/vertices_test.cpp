// G1: no two vertices at one point.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::modeler {
namespace {

TEST(Vertices, FindsEachVertexThatLiesOnAnotherOne) { testing::expect_found(testing::inject_g1, 20); }

TEST(Vertices, AcceptsVerticesAUnitApart) {
    Building building = build(testing::two_rooms());
    ASSERT_NE(building.vertices[0], building.vertices[1]);
    building.vertices[0] = building.vertices[1];
    building.vertices[0][2] -= 1;
    EXPECT_EQ(check(building).count("G1"), 0u);
}

TEST(Vertices, SaysHowManyThereAreAndWhatMeetsThere) {
    Building building = build(testing::two_rooms());
    const auto point = building.vertices[5];
    building.vertices[6] = building.vertices[7] = point;
    const CheckReport report = check(building);
    ASSERT_EQ(report.count("G1"), 1u);
    const Finding& finding = report.findings.front();
    EXPECT_EQ(finding.sentence.substr(0, 10), "3 vertices") << finding.sentence;
    EXPECT_FALSE(finding.elements.empty());
    EXPECT_EQ(finding.point, (std::array{building.frame.world_x(point[0]), building.frame.world_y(point[1]),
                                         building.frame.world_z(point[2])}));
}

}  // namespace
}  // namespace enfilade::modeler
