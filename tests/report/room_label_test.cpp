#include "tools/report/room_label.h"

#include <gtest/gtest.h>

namespace enfilade::tools {
namespace {

std::vector<std::vector<Mm>> box(std::int64_t width, std::int64_t height) {
    return {{{0, 0}, {width, 0}, {width, height}, {0, height}}};
}

TEST(RoomLabel, StandsLargeInTheMiddleOfARoom) {
    const RoomLabel label = fit_label(box(4000, 3000), {2000, 1500}, "Kitchen", "12.0 m²");
    EXPECT_EQ(label.at, (Mm{2000, 1500}));
    EXPECT_EQ(label.size, 340);
    EXPECT_TRUE(label.with_area);
    EXPECT_FALSE(label.upright);
}

TEST(RoomLabel, IsSmallInASmallRoomAndAbsentInATinyOne) {
    const RoomLabel small = fit_label(box(1100, 900), {550, 450}, "Storage", "1.0 m²");
    EXPECT_GT(small.size, 0);
    EXPECT_LT(small.size, 230);
    EXPECT_EQ(fit_label(box(200, 200), {100, 100}, "Storage", "0.04 m²").size, 0);
}

TEST(RoomLabel, TurnsInANarrowCorridor) {
    const RoomLabel label = fit_label(box(700, 6000), {350, 3000}, "Corridor west", "4.2 m²");
    EXPECT_TRUE(label.upright);
    EXPECT_GT(label.size, 0);
}

TEST(RoomLabel, BreaksALongNameInTwo) {
    const RoomLabel label = fit_label(box(1900, 2500), {950, 1250}, "Children and guests", "4.8 m²");
    EXPECT_EQ(label.lines, (std::vector<std::string>{"Children", "and guests"}));
}

TEST(RoomLabel, KeepsOffWhatADoorSweeps) {
    MmBox swept;
    swept.add({1500, 1000});
    swept.add({2500, 2000});
    const RoomLabel label = fit_label(box(4000, 3000), {2000, 1500}, "Study", "12.0 m²", std::vector<MmBox>{swept});
    EXPECT_GE(label.size, 190);
    EXPECT_TRUE(label.at.x < 1500 || label.at.x > 2500 || label.at.y < 1000 || label.at.y > 2000)
        << label.at.x << ' ' << label.at.y;
}

TEST(RoomLabel, KeepsOffAColumn) {
    std::vector<std::vector<Mm>> ring = box(4000, 3000);
    ring.push_back({{1800, 1300}, {1800, 1700}, {2200, 1700}, {2200, 1300}});
    const RoomLabel label = fit_label(ring, {1000, 1500}, "Hall", "11.8 m²");
    EXPECT_GT(label.size, 0);
    EXPECT_TRUE(label.at.x < 1800 || label.at.x > 2200 || label.at.y < 1300 || label.at.y > 1700);
}

TEST(RoomLabel, ARoomWithoutANameShowsItsArea) {
    const RoomLabel label = fit_label(box(4000, 3000), {2000, 1500}, "", "12.0 m²");
    EXPECT_TRUE(label.lines.empty());
    EXPECT_TRUE(label.with_area);
    EXPECT_GT(label.size, 0);
}

}  // namespace
}  // namespace enfilade::tools
