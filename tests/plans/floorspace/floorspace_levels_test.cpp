// Heights of stories, plenums, slabs, the ground, units.
#include <gtest/gtest.h>

#include "tests/plans/floorspace/floor_text.h"

namespace enfilade::plans {
namespace {

using testing::floor_findings;
using testing::floor_plan;
using testing::FloorText;
using testing::read_floor;

/// A story with one office and these heights.
std::string story(const std::string& id, const std::string& heights, const std::string& space_members = "") {
    FloorText text;
    text.box("Office " + id, 0, 0, 6, 4, space_members);
    return text.story("\"id\":\"" + id + "\",\"name\":\"Storey " + id + "\"" + (heights.empty() ? "" : "," + heights));
}

TEST(FloorspaceLevels, StandOnEachOther) {
    const Plan plan =
        read_floor({story("a", "\"floor_to_ceiling_height\":3"), story("b", "\"floor_to_ceiling_height\":4"),
                    story("c", "\"floor_to_ceiling_height\":2.5")});
    ASSERT_EQ(plan.storeys.size(), 3u);
    EXPECT_EQ(plan.storeys[0].elevation, 0);
    EXPECT_EQ(plan.storeys[1].elevation, 3);
    EXPECT_EQ(plan.storeys[2].elevation, 7);
    EXPECT_TRUE(plan.findings.empty());
}

TEST(FloorspaceLevels, GiveTheSlabFromTheRoomUnderIt) {
    const Plan plan =
        read_floor({story("a", "\"floor_to_ceiling_height\":3"), story("b", "\"floor_to_ceiling_height\":4")});
    EXPECT_NEAR(plan.storeys[0].height, 2.8, 1e-12);
    EXPECT_NEAR(plan.storeys[1].slab_thickness, 0.2, 1e-12);
    EXPECT_NEAR(plan.storeys[1].height, 4, 1e-12);  // nothing above
    EXPECT_EQ(plan.storeys[0].walls[0].height_at_start, plan.storeys[0].height);
}

TEST(FloorspaceLevels, KeepCeilingsUnderPlenums) {
    const Plan plan = read_floor(
        {story("a", "\"floor_to_ceiling_height\":3,\"above_ceiling_plenum_height\":0.6"),
         story("b",
               "\"floor_to_ceiling_height\":3,\"below_floor_plenum_height\":0.3,\"above_ceiling_plenum_height\":1")});
    EXPECT_NEAR(plan.storeys[0].height, 3, 1e-12);
    EXPECT_NEAR(plan.storeys[1].elevation, 3.9, 1e-12);
    EXPECT_NEAR(plan.storeys[1].slab_thickness, 0.2, 1e-12);
    ASSERT_EQ(floor_findings(plan, "P758").size(), 1u);  // the one under the roof fills nothing
    EXPECT_NE(floor_findings(plan, "P758")[0].sentence.find("0.9 m"), std::string::npos);
}

TEST(FloorspaceLevels, HaveThinSlabsInThinPlenums) {
    const Plan plan = read_floor({story("a", "\"floor_to_ceiling_height\":3,\"above_ceiling_plenum_height\":0.1"),
                                  story("b", "\"floor_to_ceiling_height\":3")});
    EXPECT_NEAR(plan.storeys[0].height, 3, 1e-12);
    EXPECT_NEAR(plan.storeys[1].slab_thickness, 0.1, 1e-12);
}

TEST(FloorspaceLevels, TakeTheUsualHeightWithoutTheirOwn) {
    ReadOptions options;
    options.storey_height = 2.75;
    const Plan plan = read_floor({story("a", "\"floor_to_ceiling_height\":0"), story("b", "")}, options);
    EXPECT_NEAR(plan.storeys[1].elevation, 2.75, 1e-12);
    EXPECT_EQ(floor_findings(plan, "P755").size(), 2u);
}

TEST(FloorspaceLevels, AreBuiltOnceWhateverTheirMultiplier) {
    const Plan plan = read_floor({story("a", "\"floor_to_ceiling_height\":3,\"multiplier\":4"),
                                  story("b", "\"floor_to_ceiling_height\":3,\"multiplier\":1"),
                                  story("c", "\"floor_to_ceiling_height\":3,\"multiplier\":0")});
    EXPECT_EQ(plan.storeys.size(), 3u);
    EXPECT_EQ(plan.storeys[1].elevation, 3);
    ASSERT_EQ(floor_findings(plan, "P756").size(), 1u);
    EXPECT_NE(floor_findings(plan, "P756")[0].sentence.find("4 equal storeys"), std::string::npos);
}

TEST(FloorspaceLevels, StandOverTheGroundAsTheProjectSays) {
    const Plan plan = read_floorspace(floor_plan({story("a", "\"floor_to_ceiling_height\":3")},
                                                 R"({"config":{"units":"ip"},"ground":{"floor_offset":-10}})"),
                                      "floor.json");
    EXPECT_NEAR(plan.storeys[0].elevation, -3.048, 1e-12);
    EXPECT_EQ(plan.ground_level, 0);
}

TEST(FloorspaceLevels, AreSharedBySpacesThatWantOthers) {
    const Plan plan = read_floor({story("a", "\"floor_to_ceiling_height\":3", "\"floor_to_ceiling_height\":5"),
                                  story("b", "\"floor_to_ceiling_height\":3", "\"floor_to_ceiling_height\":3"),
                                  story("c", "\"floor_to_ceiling_height\":3", "\"floor_offset\":-0.5")});
    const std::vector<Finding> findings = floor_findings(plan, "P757");
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].storey, "a");
    EXPECT_EQ(findings[1].storey, "c");
    EXPECT_NE(findings[0].sentence.find("\"Office a\""), std::string::npos);
}

TEST(FloorspaceLevels, AreOpenBelowAtriums) {
    const Plan plan = read_floor({story("a", "\"floor_to_ceiling_height\":3", "\"open_to_below\":true"),
                                  story("b", "\"floor_to_ceiling_height\":3", "\"open_to_below\":true")});
    ASSERT_EQ(plan.storeys[0].shafts.size(), 1u);
    EXPECT_EQ(plan.storeys[0].shafts[0].polygon.size(), 4u);
    EXPECT_TRUE(plan.storeys[1].shafts.empty());
    EXPECT_EQ(floor_findings(plan, "P757").size(), 1u);  // under the lowest is nothing
}

TEST(FloorspaceUnits, AreFeetOrMetres) {
    for (const auto& [name, metres] :
         {std::pair("ip", 0.3048), std::pair("ft", 0.3048), std::pair("si", 1.0), std::pair("m", 1.0)}) {
        const Plan plan = read_floorspace(floor_plan({story("a", "\"floor_to_ceiling_height\":10")},
                                                     "{\"config\":{\"units\":\"" + std::string(name) + "\"}}"),
                                          "floor.json");
        EXPECT_NEAR(plan.storeys[0].height, 10 * metres, 1e-12) << name;
        EXPECT_NEAR(plan.storeys[0].rooms[0].polygon[2].x, 6 * metres, 1e-12) << name;
        EXPECT_TRUE(plan.findings.empty());
    }
}

TEST(FloorspaceUnits, AreWhatIsAskedFor) {
    ReadOptions options;
    options.unit = Unit::Inch;
    const std::string text =
        floor_plan({story("a", "\"floor_to_ceiling_height\":100")}, R"({"config":{"units":"ip"}})");
    EXPECT_NEAR(read_floorspace(text, "floor.json", options).storeys[0].height, 2.54, 1e-12);
    const std::string odd =
        floor_plan({story("a", "\"floor_to_ceiling_height\":100")}, R"({"config":{"units":"ell"}})");
    EXPECT_NEAR(read_floorspace(odd, "floor.json", options).storeys[0].height, 2.54, 1e-12);
}

TEST(FloorspaceUnits, AreMetresWithAWarningWhereNoneIsNamed) {
    const Plan plan = read_floorspace(floor_plan({story("a", "\"floor_to_ceiling_height\":3")}, "{}"), "floor.json");
    EXPECT_EQ(plan.storeys[0].height, 3);
    EXPECT_EQ(floor_findings(plan, "P754").size(), 1u);
}

}  // namespace
}  // namespace enfilade::plans
