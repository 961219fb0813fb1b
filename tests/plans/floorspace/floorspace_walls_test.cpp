// Spaces and their edges: rooms and walls.
#include <gtest/gtest.h>

#include <algorithm>

#include "plans/layout.h"
#include "plans/vector2.h"
#include "tests/plans/floorspace/floor_text.h"

namespace enfilade::plans {
namespace {

using testing::floor_findings;
using testing::FloorText;
using testing::read_floor;

/// Areas of the rooms that lie between the walls, largest first.
std::vector<double> found_areas(const Plan& plan) {
    const Layout layout = arrange(clean(plan));
    std::vector<double> areas;
    for (const StoreyLayout& storey : layout.storeys)
        for (const FoundRoom& room : storey.rooms) areas.push_back(room.area_m2);
    std::sort(areas.rbegin(), areas.rend());
    return areas;
}

TEST(FloorspaceWalls, SurroundASpace) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    const Plan plan = read_floor({text.story()});
    ASSERT_EQ(plan.storeys.size(), 1u);
    const Storey& storey = plan.storeys[0];
    EXPECT_EQ(storey.name, "Ground");
    EXPECT_EQ(storey.walls.size(), 4u);
    ASSERT_EQ(storey.rooms.size(), 1u);
    EXPECT_EQ(storey.rooms[0].name, "Office");
    EXPECT_EQ(storey.rooms[0].id, "s0");
    EXPECT_EQ(storey.rooms[0].polygon.size(), 4u);
    EXPECT_TRUE(plan.findings.empty());
    const std::vector<double> areas = found_areas(plan);
    ASSERT_EQ(areas.size(), 1u);
    EXPECT_NEAR(areas[0], 3.9 * 2.9, 0.01);
}

}  // namespace
}  // namespace enfilade::plans
