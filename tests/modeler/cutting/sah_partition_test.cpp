#include "modeler/cutting/sah_partition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "modeler/cutting/plane_check.h"
#include "modeler/cutting/section_split.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr double metre = 8192;

struct Room {
    std::vector<GridPoint> points;
    std::vector<PolygonSide> sides;

    /// Metres; counter-clockwise for an outer boundary, clockwise for a hole; every side its own line.
    Room& add(const std::vector<std::array<double, 2>>& loop) {
        const std::uint32_t base = std::uint32_t(points.size()), count = std::uint32_t(loop.size());
        for (std::uint32_t k = 0; k < count; ++k) {
            points.push_back(
                {std::int32_t(std::lround(loop[k][0] * metre)), std::int32_t(std::lround(loop[k][1] * metre))});
            sides.push_back({base + k, base + (k + 1) % count, base + k, base + k, base + k});
        }
        return *this;
    }
    [[nodiscard]] Partition cut(const SahOptions& options = {}, PartitionGoal goal = PartitionGoal::Convex) const {
        return sah_partition(points, sides, goal, options);
    }
    [[nodiscard]] std::vector<GridPoint> all_points(const Partition& partition) const {
        std::vector<GridPoint> all = points;
        all.insert(all.end(), partition.new_points.begin(), partition.new_points.end());
        return all;
    }
    /// Length of the cuts, metres.
    [[nodiscard]] double cut_length(const Partition& partition) const {
        const std::vector<GridPoint> all = all_points(partition);
        double sum = 0;
        for (const PolygonSide& side : partition.sides)
            if (side.tag == cut_tag)
                sum += std::hypot(all[side.to].x - all[side.from].x, all[side.to].y - all[side.from].y) / metre / 2;
        return sum;
    }
};

/// 6 m by 4 m, the right wall an arc of `chords` that bulges into the room by a metre.
Room room_with_a_bulge(int chords) {
    std::vector<std::array<double, 2>> loop = {{0, 0}, {6, 0}};
    const double radius = 2.5, half = std::asin(2 / radius);
    for (int k = 1; k < chords; ++k) {
        const double angle = half * (1 - 2.0 * k / chords);
        loop.push_back({6 + radius * std::cos(half) - radius * std::cos(angle), 2 - radius * std::sin(angle)});
    }
    loop.insert(loop.end(), {{6, 4}, {0, 4}});
    return Room().add(loop);
}

TEST(SahPartition, LeavesAConvexRoomWhole) {
    EXPECT_EQ(Room().add({{0, 0}, {5, 0}, {5, 4}, {0, 4}}).cut().piece_count(), 1u);
}

TEST(SahPartition, TakesTheShorterOfTwoProlongations) {
    const Room room = Room().add({{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 5}, {0, 5}});
    const Partition pieces = room.cut();
    EXPECT_EQ(pieces.piece_count(), 2u);
    EXPECT_NEAR(room.cut_length(pieces), 2, 1e-9);
}

TEST(SahPartition, ServesTwoCornersWithOneCut) {
    // An H: four reflex corners, two cuts across the bar.
    const Room room =
        Room().add({{0, 0}, {2, 0}, {2, 3}, {5, 3}, {5, 0}, {7, 0}, {7, 8}, {5, 8}, {5, 5}, {2, 5}, {2, 8}, {0, 8}});
    const Partition pieces = room.cut();
    EXPECT_EQ(pieces.piece_count(), 3u);
    EXPECT_NEAR(room.cut_length(pieces), 4, 1e-9);
    EXPECT_TRUE(pieces.new_points.empty());
}

TEST(SahPartition, BoxesACurvedWall) {
    for (const int chords : {6, 12, 40}) {
        const Room room = room_with_a_bulge(chords);
        const Partition pieces = room.cut();
        const Partition diagonals = delaunay_partition(room.points, room.sides, PartitionGoal::Convex);
        EXPECT_EQ(pieces.fallen_back, 0u);
        // The box is about as long as the wall, and each chord costs a few centimetres more.
        EXPECT_LT(room.cut_length(pieces), 4.5 + 0.25 * chords) << chords << " chords";
        EXPECT_LT(room.cut_length(pieces), 0.5 * room.cut_length(diagonals)) << chords << " chords";
        EXPECT_LE(pieces.piece_count(), std::uint32_t(chords) + 4);
    }
}

TEST(SahPartition, EndsCutsOnPointsOfTheGridThatBothSidesShare) {
    const Room room = room_with_a_bulge(9);
    const Partition pieces = room.cut();
    EXPECT_FALSE(pieces.new_points.empty());
    const std::vector<GridPoint> all = room.all_points(pieces);
    EXPECT_TRUE(is_plane(all, std::uint32_t(room.points.size()), pieces));
    std::int64_t sum = 0;
    for (std::uint32_t k = 0; k < pieces.piece_count(); ++k) sum += area2(all, pieces.piece(k));
    // Rounded points bend the room's own sides by half a unit at most.
    EXPECT_LT(std::abs(double(sum - area2(room.points, room.sides))), 12 * metre);
}

TEST(SahPartition, CutsARingInTwoDiscs) {
    const Room room = Room().add({{0, 0}, {9, 0}, {9, 9}, {0, 9}}).add({{3, 3}, {3, 6}, {6, 6}, {6, 3}});
    const Partition discs = room.cut({}, PartitionGoal::Disc);
    EXPECT_EQ(discs.piece_count(), 2u);
    EXPECT_NEAR(room.cut_length(discs), 6, 1e-9);
    EXPECT_EQ(room.cut().piece_count(), 4u);
}

TEST(SahPartition, IsTheSameEveryTime) {
    const Room room = room_with_a_bulge(17);
    const Partition a = room.cut(), b = room.cut();
    ASSERT_EQ(a.sides.size(), b.sides.size());
    EXPECT_EQ(a.new_points, b.new_points);
    for (std::size_t k = 0; k < a.sides.size(); ++k) {
        EXPECT_EQ(a.sides[k].from, b.sides[k].from);
        EXPECT_EQ(a.sides[k].line, b.sides[k].line);
    }
}

TEST(SahPartition, CutsAwayThePartsOfARoundRoomWhereSectionsCost) {
    std::vector<std::array<double, 2>> loop;
    for (int k = 0; k < 200; ++k)
        loop.push_back({3 * std::cos(2 * std::numbers::pi * k / 200), 3 * std::sin(2 * std::numbers::pi * k / 200)});
    const Room room = Room().add(loop);
    EXPECT_EQ(room.cut({.cost = {1, 0, 0}}).piece_count(), 1u);
    const SahOptions dear = {.cost = {1, 0.2, 0}};
    const Partition pieces = room.cut(dear);
    EXPECT_GT(pieces.piece_count(), 5u);
    Partition whole;
    whole.sides = room.sides;
    whole.first_side.push_back(200);
    EXPECT_LT(sah_sum(room.points, pieces, dear.unit, dear.height, dear.cost),
              0.5 * sah_sum(room.points, whole, dear.unit, dear.height, dear.cost));
}

TEST(SahSum, IsTheVisitsOfARay) {
    // A room of 4 by 4 by 2.5 m cut in the middle: each half has (2 * (4 + 2) * 2.5 + 2 * 8) of surface.
    const Room room = Room().add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    Partition halves;
    halves.new_points = {{std::int32_t(2 * metre), 0}, {std::int32_t(2 * metre), std::int32_t(4 * metre)}};
    halves.sides = {
        {0, 4, 0, 0}, {4, 5, first_cut_line, cut_tag}, {5, 3, 2, 2}, {3, 0, 3, 3}, {4, 1, 0, 0}, {1, 2, 1, 1},
        {2, 5, 2, 2}, {5, 4, first_cut_line, cut_tag}};
    halves.first_side = {0, 4, 8};
    const double half = 2 * (4 + 2) * 2.5 + 2 * 8, all = 4 * 4 * 2.5 + 2 * 16;
    EXPECT_NEAR(sah_sum(room.points, halves, 1 / metre, 2.5, {1, 0, 0}), 2 * half / all, 1e-12);
    EXPECT_NEAR(sah_sum(room.points, halves, 1 / metre, 2.5, {1, 0.1, 0.01}), 2 * half * 1.44 / all, 1e-12);
}

TEST(PlaneCheck, SeesCutsThatMeet) {
    const Room room = Room().add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    Partition pieces;
    const auto cut = [](std::uint32_t a, std::uint32_t b) {
        return PolygonSide{a, b, first_cut_line + a + b, cut_tag};
    };
    pieces.sides = {room.sides[0], room.sides[1], cut(2, 0), cut(0, 2), room.sides[2], room.sides[3]};
    pieces.first_side = {0, 3, 6};
    EXPECT_TRUE(is_plane(room.points, 4, pieces));
    // Both diagonals at once.
    pieces.sides.insert(pieces.sides.end(), {room.sides[0], cut(1, 3), room.sides[3]});
    pieces.first_side.push_back(9);
    EXPECT_FALSE(is_plane(room.points, 4, pieces));
}

}  // namespace
}  // namespace enfilade::modeler
