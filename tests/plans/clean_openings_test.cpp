#include <gtest/gtest.h>

#include "tests/plans/clean_support.h"

namespace enfilade::plans {
namespace {

using testing::codes_of;
using testing::opening;
using testing::opening_of;
using testing::plan_of;
using testing::wall;

/// A wall of 4 m with these openings.
Plan with(std::vector<Opening> openings) {
    Plan plan = plan_of({wall("w", {0, 0}, {4, 0})});
    plan.storeys[0].openings = std::move(openings);
    return plan;
}

Opening door(const char* id, double offset, double width) {
    return opening(id, OpeningKind::Door, "w", offset, width, 0, 2);
}

void expect_span(const Plan& plan, const char* id, double from, double to) {
    const Opening* found = opening_of(plan, id);
    ASSERT_NE(found, nullptr) << id;
    EXPECT_NEAR(found->offset - found->width / 2, from, 1e-9) << id;
    EXPECT_NEAR(found->offset + found->width / 2, to, 1e-9) << id;
}

TEST(CleanOpenings, AtTheVeryEndOfTheirWallAreFine) {
    EXPECT_EQ(codes_of(clean(with({door("a", 0.5, 1), door("b", 3.5, 1)}))), "");
}

TEST(CleanOpenings, WithoutTheirWallAreErrors) {
    Plan plan = with({door("a", 2, 1)});
    plan.storeys[0].openings[0].wall = "gone";
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P220");
    EXPECT_TRUE(has_errors(cleaned.findings));
    EXPECT_TRUE(cleaned.storeys[0].openings.empty());
}

TEST(CleanOpenings, BeyondOneEndAreCutToLeaveAJamb) {
    const Plan cleaned = clean(with({door("a", 3.75, 1)}));
    ASSERT_EQ(codes_of(cleaned), "P221");
    expect_span(cleaned, "a", 3.25, 3.95);
    EXPECT_NEAR(cleaned.findings[0].moved_mm, 300, 1e-9);
}

TEST(CleanOpenings, WiderThanTheirWallAreCutAtBothEnds) {
    const Plan cleaned = clean(with({door("a", 2, 5)}));
    EXPECT_EQ(codes_of(cleaned), "P221");
    expect_span(cleaned, "a", 0.05, 3.95);
}

TEST(CleanOpenings, InAWallTooShortForJambsFillIt) {
    Plan plan = with({door("a", 0.06, 1)});
    plan.storeys[0].walls[0].end.x = 0.12;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P221");
    expect_span(cleaned, "a", 0, 0.12);
}

TEST(CleanOpenings, WhollyBeyondAreErrors) {
    EXPECT_EQ(codes_of(clean(with({door("a", 5, 1), door("b", -3, 1)}))), "P222 P222");
}

TEST(CleanOpenings, HigherThanTheirWallAreCutAtItsTop) {
    Plan plan = with({door("a", 2, 1)});
    plan.storeys[0].openings[0].head = 3;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P223");
    EXPECT_DOUBLE_EQ(opening_of(cleaned, "a")->head, 2.5);
}

TEST(CleanOpenings, UnderTheFloorAreCutAtIt) {
    Plan plan = with({door("a", 2, 1)});
    plan.storeys[0].openings[0].sill = -0.2;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P223");
    EXPECT_DOUBLE_EQ(opening_of(cleaned, "a")->sill, 0);
}

TEST(CleanOpenings, WithoutHeightOrAboveTheirWallAreErrors) {
    Plan plan = with({door("a", 1, 0.5), door("b", 3, 0.5)});
    plan.storeys[0].openings[0].sill = 2;
    plan.storeys[0].openings[1].sill = 2.6;
    plan.storeys[0].openings[1].head = 3;
    EXPECT_EQ(codes_of(clean(plan)), "P224 P224");
}

TEST(CleanOpenings, AsHighAsTheirWallAreFine) {
    Plan plan = with({door("a", 2, 1)});
    plan.storeys[0].openings[0].head = 2.5;
    EXPECT_EQ(codes_of(clean(plan)), "");
}

TEST(CleanOpenings, NarrowerThanACentimetreAreErrors) {
    EXPECT_EQ(codes_of(clean(with({door("a", 2, 0.009)}))), "P225");
    EXPECT_EQ(codes_of(clean(with({door("a", 2, 0.01)}))), "");
}

TEST(CleanOpenings, SideBySideAreFine) { EXPECT_EQ(codes_of(clean(with({door("a", 1.5, 1), door("b", 2.5, 1)}))), ""); }

TEST(CleanOpenings, ThatOverlapAreCutFromTheLaterOne) {
    const Plan cleaned = clean(with({door("b", 2.5, 1), door("a", 1.75, 1)}));
    ASSERT_EQ(codes_of(cleaned), "P226");
    expect_span(cleaned, "a", 1.25, 2.25);
    expect_span(cleaned, "b", 2.25, 3);
}

TEST(CleanOpenings, WithinAnotherAreLeftOut) {
    const Plan cleaned = clean(with({door("a", 2, 3), door("b", 2.5, 1)}));
    ASSERT_EQ(codes_of(cleaned), "P227");
    EXPECT_EQ(cleaned.findings[0].severity, Severity::Warning);
    EXPECT_EQ(opening_of(cleaned, "b"), nullptr);
}

TEST(CleanOpenings, AtTheSamePlaceKeepTheLowerId) {
    const Plan cleaned = clean(with({door("b", 2, 1), door("a", 2, 1)}));
    EXPECT_EQ(codes_of(cleaned), "P227");
    EXPECT_NE(opening_of(cleaned, "a"), nullptr);
}

TEST(CleanOpenings, BehindAWideOneAreComparedWithTheWideOne) {
    // c lies beside b but within a, which reaches farther than b.
    const Plan cleaned = clean(with({door("a", 1.6, 3), door("b", 1.7, 0.2), door("c", 3, 0.4)}));
    EXPECT_EQ(codes_of(cleaned), "P226 P227");
    expect_span(cleaned, "c", 3.1, 3.2);
}

TEST(CleanOpenings, RunAlongTheArcOfACurvedWall) {
    // Half a circle of radius 2: 6.28 m of wall over a chord of 4 m.
    Plan plan = with({door("a", 5, 1), door("b", 6.2, 1)});
    plan.storeys[0].walls[0].arc_extent = 3.141592653589793;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P221");
    expect_span(cleaned, "a", 4.5, 5.5);
    expect_span(cleaned, "b", 5.7, 2 * 3.141592653589793 - 0.05);
}

TEST(CleanOpenings, WithNumbersThatAreNoneAreErrors) {
    Plan plan = with({door("a", 2, 1), door("b", 2, 1)});
    plan.storeys[0].openings[0].offset = std::numeric_limits<double>::infinity();
    plan.storeys[0].openings[1].depth_left = -1;
    EXPECT_EQ(codes_of(clean(plan)), "P228 P228");
}

}  // namespace
}  // namespace enfilade::plans
