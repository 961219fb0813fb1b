// S3: a room is bounded by walls, slabs, openings, objects and portals alone.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::modeler {
namespace {

plans::Room room(std::string id, double x0, double y0, double x1, double y1) {
    plans::Room result;
    result.id = result.name = std::move(id);
    result.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    return result;
}

TEST(RoomBounds, FindsEachWallThatIsNone) { testing::expect_found(testing::inject_s3, 30); }

TEST(RoomBounds, AcceptsRoomsThatPolygonsPart) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].rooms = {room("kitchen", 0.1, 0.1, 2, 2.9), room("living", 2.1, 0.1, 3.9, 2.9)};
    const Building building = build(plan);
    EXPECT_EQ(check(building).findings.size(), 0u) << testing::all_of(check(building));
    EXPECT_EQ(check(convexify(building)).count("S3"), 0u);
}

TEST(RoomBounds, NamesBothRoomsThatRunIntoEachOther) {
    Building building = build(testing::two_rooms());
    std::uint32_t wall = 0, room = 0;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        if (building.spaces[building.volumes[v].space].id == "m") wall = v;
        if (building.volumes[v].label == Label::Room) room = v;
    }
    building.volumes[wall].label = Label::Room;
    building.volumes[wall].space = building.volumes[room].space;
    const CheckReport report = check(building);
    ASSERT_EQ(report.count("S3"), 1u) << testing::all_of(report);
    EXPECT_EQ(report.findings[0].severity, Severity::Error);
    EXPECT_EQ(report.findings[0].elements.size(), 2u);
}

TEST(RoomBounds, WarnsOfARoomThatThePlanOpensToACourtyard) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].rooms = {room("living", 0.1, 0.1, 2, 2.9), room("patio", 2.0, 0.1, 3.9, 2.9)};
    plan.storeys[0].rooms[1].kind = "courtyard";
    const CheckReport report = check(build(plan));
    EXPECT_EQ(report.count("S3"), 1u) << testing::all_of(report);
    EXPECT_TRUE(report.sound()) << testing::all_of(report);
}

TEST(RoomBounds, AcceptsLowWallsToTheOpenAir) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls[1].height_at_start = plan.storeys[0].walls[1].height_at_end = 1.0;
    EXPECT_EQ(check(build(plan)).count("S3"), 0u);
}

}  // namespace
}  // namespace enfilade::modeler
