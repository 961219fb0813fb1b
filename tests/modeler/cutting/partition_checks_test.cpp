// The judge of partitions itself: a sound one passes, each way of being unsound is found.

#include "tests/support/partition_checks.h"

#include <gtest/gtest.h>

#include "tests/support/crossings.h"
#include "tests/support/room.h"

namespace enfilade::testing {
namespace {

using modeler::cut_tag;
using modeler::first_cut_line;
using modeler::Partition;
using plans::GridPoint;
using plans::Segment;

/// An L, cut from its reflex corner (10, 10) to a new point on the side from (0, 20) to (0, 0).
struct CutL {
    Room room;
    Partition partition;

    CutL() {
        room.points = {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}};
        for (std::uint32_t k = 0; k < 6; ++k) room.sides.push_back({k, (k + 1) % 6, k, 100 + k, 7, 2});
        auto s = room.sides;
        partition.new_points = {{0, 10}};
        s[5].from = 6;
        partition.sides = {s[0], s[1], s[2], {3, 6, first_cut_line, cut_tag}, s[5]};
        s[5].from = 5, s[5].to = 6;
        const auto rest = {s[3], s[4], s[5], {6, 3, first_cut_line, cut_tag}};
        partition.sides.insert(partition.sides.end(), rest.begin(), rest.end());
        partition.first_side = {0, 5, 9};
    }

    [[nodiscard]] PartitionVerdict verdict(bool new_points = true) const {
        return judge_partition(room.points, room.sides, partition, {modeler::PartitionGoal::Convex, new_points});
    }
};

TEST(PartitionChecks, PassASoundPartition) {
    const PartitionVerdict verdict = CutL().verdict();
    EXPECT_EQ(verdict.text(), "");
    EXPECT_EQ(verdict.thin_cuts + verdict.thin_corners + verdict.thin_walls, 0u);
}

TEST(PartitionChecks, FindNewPointsWhereNoneWereAskedFor) { EXPECT_NE(CutL().verdict(false).text(), ""); }

TEST(PartitionChecks, FindACutRunInOneDirectionOnly) {
    CutL l;
    l.partition.sides.resize(5);
    l.partition.first_side = {0, 5};
    EXPECT_NE(l.verdict().text().find("not run once in each direction"), std::string::npos);
}

TEST(PartitionChecks, FindAPieceThatIsReflex) {
    CutL l;
    l.partition.sides = l.room.sides;
    l.partition.first_side = {0, 6};
    l.partition.new_points.clear();
    EXPECT_NE(l.verdict().text().find("reflex at (10, 10)"), std::string::npos);
}

TEST(PartitionChecks, FindANewPointBesideItsSide) {
    CutL l;
    l.partition.new_points[0].x = 1;
    EXPECT_NE(l.verdict().text().find("which is not on it"), std::string::npos);
}

TEST(PartitionChecks, FindAPartThatChangedItsLook) {
    CutL l;
    l.partition.sides[4].look = 8;
    EXPECT_NE(l.verdict().text().find("changed its line, look or faces"), std::string::npos);
}

TEST(PartitionChecks, FindALostPart) {
    CutL l;
    l.partition.sides[4].tag = cut_tag;
    EXPECT_NE(l.verdict().text(), "");
}

TEST(PartitionChecks, FindACutOnALineOfNothing) {
    CutL l;
    l.partition.sides[3].line = l.partition.sides[8].line = 77;
    EXPECT_NE(l.verdict().text().find("does not have"), std::string::npos);
}

TEST(PartitionChecks, FindAReflexCornerHiddenOnALine) {
    CutL l;  // the whole L, said to be straight around its reflex corner
    l.room.sides[3].line = l.room.sides[2].line;
    l.partition.sides = l.room.sides;
    l.partition.first_side = {0, 6};
    l.partition.new_points.clear();
    EXPECT_NE(l.verdict().text().find("leaves one of its lines"), std::string::npos);
}

TEST(PartitionChecks, FindPiecesThatOverlap) {
    Room room;  // two cuts through each other in the middle
    room.points = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
    for (std::uint32_t k = 0; k < 4; ++k) room.sides.push_back({k, (k + 1) % 4, k, k});
    const auto& s = room.sides;
    Partition partition;
    const std::uint32_t a = first_cut_line, b = a + 1;
    partition.sides = {s[0], {1, 3, a, cut_tag}, s[3], s[1], s[2], {3, 1, a, cut_tag}};
    partition.first_side = {0, 3, 6};
    const PartitionWish wish{};
    EXPECT_EQ(judge_partition(room.points, room.sides, partition, wish).text(), "");
    partition.sides = {s[0], {1, 2, b, cut_tag}, {2, 0, a, cut_tag}, s[1], s[2],
                       s[3], {0, 2, a, cut_tag}, {2, 1, b, cut_tag}};
    partition.first_side = {0, 3, 8};
    EXPECT_NE(judge_partition(room.points, room.sides, partition, wish).text(), "");
}

TEST(PartitionChecks, TellThinPiecesApart) {
    Room room;
    room.points = {{0, 0}, {100, 0}, {100, 1}, {0, 1}};
    for (std::uint32_t k = 0; k < 4; ++k) room.sides.push_back({k, (k + 1) % 4, k, k});
    Partition partition;
    partition.sides = room.sides;
    partition.first_side = {0, 4};
    const PartitionVerdict verdict = judge_partition(room.points, room.sides, partition, {});
    EXPECT_EQ(verdict.text(), "");
    EXPECT_EQ(verdict.thin_walls, 1u);
}

TEST(Crossings, AreFoundAndCommonEndsAreNone) {
    const auto meet = [](Segment s, Segment t) { return first_crossing(std::vector{s, t}).has_value(); };
    EXPECT_FALSE(meet({{0, 0}, {10, 0}}, {{10, 0}, {10, 10}}));
    EXPECT_FALSE(meet({{0, 0}, {10, 0}}, {{10, 0}, {20, 0}}));
    EXPECT_TRUE(meet({{0, 0}, {10, 10}}, {{0, 10}, {10, 0}}));
    EXPECT_TRUE(meet({{0, 0}, {10, 0}}, {{5, 0}, {5, 5}})) << "a T";
    EXPECT_TRUE(meet({{0, 0}, {10, 0}}, {{0, 0}, {5, 0}})) << "one on the other";
    EXPECT_TRUE(meet({{0, 0}, {10, 0}}, {{10, 0}, {0, 0}})) << "the same";
    EXPECT_FALSE(meet({{0, 0}, {10, 0}}, {{0, 1}, {10, 1}}));
    EXPECT_FALSE(meet({{0, 0}, {1000000, 1}}, {{500000, 1}, {500001, 1}}));
}

}  // namespace
}  // namespace enfilade::testing
