// G3: every face is flat.

#include <gtest/gtest.h>

#include "modeler/constraints/culprits.h"
#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::modeler {
namespace {

TEST(Planarity, FindsEachVertexOutOfPlane) { testing::expect_found(testing::inject_g3, 40); }

TEST(Planarity, AcceptsFacesThatMoveAsAWhole) {
    Building building = build(testing::two_rooms());
    for (Point3& p : building.vertices)
        if (p[2] == building.site_max[2]) p[2] += 7;
    EXPECT_EQ(check(building).count("G3"), 0u);
}

TEST(Planarity, AcceptsAPlaneThatIsTilted) {
    Building building = build(testing::one_room());
    // The head of the door, from 0.5 to 1.5 m, goes up at one jamb.
    const std::int32_t x = building.frame.grid_x(0.5), z = building.frame.grid_z(2);
    int moved = 0;
    for (Point3& p : building.vertices)
        if (p[0] == x && p[2] == z) p[2] += 7, ++moved;
    EXPECT_EQ(moved, 2);
    EXPECT_EQ(check(building).count("G3"), 0u);
}

TEST(Planarity, SaysHowFarAndHowMuchTheFaceTurns) {
    Building building = build(testing::one_room());
    // A corner of the site box, 100 units up: the level face there is a quad of known size.
    std::uint32_t corner = 0;
    for (std::uint32_t v = 0; v < building.vertices.size(); ++v)
        if (building.vertices[v] == building.site_min) corner = v;
    building.vertices[corner][2] -= 819;
    const CheckReport report = check(building);
    ASSERT_EQ(report.count("G3"), 1u);
    const Finding& finding = report.findings.front();
    EXPECT_EQ(finding.code, "G3");
    EXPECT_NE(finding.sentence.find("mm out of the plane"), std::string::npos) << finding.sentence;
    EXPECT_NE(finding.sentence.find("degrees"), std::string::npos) << finding.sentence;
    // 819 units are 99.98 mm; the plane of the other three corners passes at the cosine of its slope, almost 1.
    EXPECT_NE(finding.sentence.find("lies 100 mm"), std::string::npos) << finding.sentence;
}

TEST(BentCorners, AreThoseWithoutWhichTheRestIsFlat) {
    const std::vector<Point3> points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {5, 12, 0}, {0, 10, 1}};
    EXPECT_EQ(bent_corners(std::vector<std::uint32_t>{0, 1, 2, 3, 4}, points), (std::vector<std::uint32_t>{4}));
    EXPECT_EQ(bent_corners(std::vector<std::uint32_t>{4, 0, 1, 2, 3}, points), (std::vector<std::uint32_t>{4}));
    EXPECT_EQ(bent_corners(std::vector<std::uint32_t>{0, 1, 2, 4}, points), (std::vector<std::uint32_t>{0, 1, 2, 4}));
    EXPECT_TRUE(bent_corners(std::vector<std::uint32_t>{0, 1, 2, 3}, points).empty());
}

}  // namespace
}  // namespace enfilade::modeler
