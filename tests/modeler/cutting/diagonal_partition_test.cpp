// The cutter by diagonals: convex pieces that sum to the polygon, whatever its shape.
#include "modeler/cutting/diagonal_partition.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "modeler/cutting/delaunay_partition.h"
#include "modeler/cutting/merge_diagonals.h"
#include "tests/modeler/cutting/sample_polygons.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;
using samples::Polygon;

/// What is wrong with a partition; empty if it is what a convex partition has to be.
std::string fault(const Polygon& polygon, const Partition& partition) {
    std::int64_t sum = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts;
    std::map<std::uint32_t, std::uint32_t> lines;
    std::set<std::uint32_t> kept;
    for (std::uint32_t k = 0; k < partition.piece_count(); ++k) {
        const auto ring = partition.piece(k);
        std::vector<RingCorner> corners;
        std::set<std::uint32_t> visited;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const PolygonSide& side = ring[i];
            if (side.to != ring[(i + 1) % ring.size()].from) return "a ring is open";
            if (!visited.insert(side.from).second) return "a piece visits a point twice";
            corners.push_back({polygon.points[side.from], side.line});
            if (side.tag == cut_tag) {
                if (side.line < first_cut_line) return "a cut has a line of the polygon";
                if (!cuts.emplace(std::pair(side.from, side.to), side.line).second) return "a cut comes twice";
                ++lines[side.line];
                continue;
            }
            const PolygonSide& given = polygon.sides[side.tag - 100];
            if (given.from != side.from || given.to != side.to || given.line != side.line || given.look != side.look ||
                given.faces != side.faces)
                return "a side is not handed through";
            if (!kept.insert(side.tag).second) return "a side comes twice";
        }
        if (reflex_corner(corners)) return "a piece is not convex";
        if (area2(polygon.points, ring) <= 0) return "a piece has no area";
        sum += area2(polygon.points, ring);
    }
    for (const auto& [ends, line] : cuts) {
        const auto back = cuts.find({ends.second, ends.first});
        if (back == cuts.end() || back->second != line) return "a cut has no other side";
        if (lines[line] != 2) return "cuts share a line";
    }
    if (kept.size() != polygon.sides.size()) return "a side is missing";
    if (sum != area2(polygon.points, polygon.sides)) return "the pieces do not sum to the polygon";
    if (partition.piece_count() != cuts.size() / 2 + 1) return "the pieces are not those of a disc";
    if (!partition.new_points.empty()) return "there are new points";
    return "";
}

TEST(DiagonalPartition, LeavesAConvexPolygonWhole) {
    const Polygon square({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const Partition whole = diagonal_partition(square.points, square.sides);
    EXPECT_EQ(fault(square, whole), "");
    EXPECT_EQ(whole.piece_count(), 1u);
}

TEST(DiagonalPartition, CutsAnLInTwo) {
    const Polygon l({{0, 0}, {200, 0}, {200, 100}, {100, 100}, {100, 200}, {0, 200}});
    const Partition pieces = diagonal_partition(l.points, l.sides);
    EXPECT_EQ(fault(l, pieces), "");
    EXPECT_EQ(pieces.piece_count(), 2u);
    EXPECT_EQ(pieces.fallen_back, 0u);
}

/// Draws a polygon by a seed of its own.
plans::Random any_random() { return plans::Random({*rc::gen::arbitrary<std::uint64_t>()}); }

void expect_sound(const Polygon& polygon) {
    const Partition pieces = diagonal_partition(polygon.points, polygon.sides);
    RC_ASSERT(fault(polygon, pieces) == "");
    RC_ASSERT(pieces.fallen_back == 0u);
}

RC_GTEST_PROP(DiagonalPartition, CutsStars, ()) {
    plans::Random random = any_random();
    expect_sound(samples::star(random, 3 + int(random.below(198)), *rc::gen::element(20000, 500), 90000));
}

RC_GTEST_PROP(DiagonalPartition, CutsSpirals, ()) {
    plans::Random random = any_random();
    const double turns = random.uniform(0.3, 6);
    expect_sound(samples::spiral(turns, 4 + int(random.below(30)), random.uniform(500, 9000)));
}

RC_GTEST_PROP(DiagonalPartition, CutsCombs, ()) {
    plans::Random random = any_random();
    expect_sound(samples::comb(random, 2 + int(random.below(50))));
}

RC_GTEST_PROP(DiagonalPartition, CutsRoomsWithArcsBulgingInAndOut, ()) {
    plans::Random random = any_random();
    expect_sound(samples::arched_room(random, 1 + int(random.below(50))));
}

RC_GTEST_PROP(DiagonalPartition, CutsAxisAlignedRooms, ()) {
    plans::Random random = any_random();
    const Polygon room = samples::polyomino(random, 1 + random.below(60), 4000, 0);
    expect_sound(room);
    expect_sound(samples::joined(random, room));
}

RC_GTEST_PROP(DiagonalPartition, CutsSidesThatRoundingBent, ()) {
    plans::Random random = any_random();
    expect_sound(samples::bent(random, samples::star(random, 3 + int(random.below(30)), 20000, 90000), 8));
    expect_sound(samples::bent(random, samples::arched_room(random, 10), 8));
}

RC_GTEST_PROP(DiagonalPartition, CutsRoomsAsSmallAsTheGrid, ()) {
    plans::Random random = any_random();
    const std::int32_t size = 1 + std::int32_t(random.below(12));
    const Polygon tiny = samples::polyomino(random, 1 + random.below(60), size, size / 3);
    const Polygon room = samples::joined(random, tiny), star = samples::star(random, 3 + int(random.below(20)), 30, 90);
    for (const Polygon& polygon : {tiny, room, samples::bent(random, star, 6)})  // some have no piece to cut off
        RC_ASSERT(fault(polygon, diagonal_partition(polygon.points, polygon.sides)) == "");
}

RC_GTEST_PROP(DiagonalPartition, TakesSidesInAnyOrder, ()) {
    plans::Random random = any_random();
    Polygon polygon = samples::arched_room(random, 20);
    const std::vector<PolygonSide> sides = polygon.sides;
    for (std::size_t k = sides.size(); k > 1; --k)
        std::swap(polygon.sides[k - 1], polygon.sides[random.below(std::uint32_t(k))]);
    const Partition pieces = diagonal_partition(polygon.points, polygon.sides);
    polygon.sides = sides;  // `fault` finds sides by their tags
    RC_ASSERT(fault(polygon, pieces) == "");
}

TEST(DiagonalPartition, MakesFewerPiecesThanHertelAndMehlhorn) {
    plans::Random random({4});
    std::uint32_t ours = 0, theirs = 0, least = 0;
    for (int k = 0; k < 50; ++k)
        for (const Polygon& polygon : {samples::star(random, 100, 20000, 90000), samples::comb(random, 25),
                                       samples::arched_room(random, 25), samples::polyomino(random, 40, 4000, 0)}) {
            ours += diagonal_partition(polygon.points, polygon.sides).piece_count();
            theirs += delaunay_partition(polygon.points, polygon.sides, PartitionGoal::Convex).piece_count();
            least += (polygon.reflex_count() + 1) / 2 + 1;
        }
    EXPECT_LT(ours, theirs);
    EXPECT_LT(ours, 2 * least) << "1.85 times as many when measured";
    EXPECT_GE(ours, least);
}

TEST(DiagonalPartition, CutsTenThousandCornersInSeconds) {
    plans::Random random({5});
    for (const Polygon& polygon : {samples::star(random, 10000, 2e6, 8e6), samples::star(random, 10000, 1e4, 8e6),
                                   samples::spiral(1249, 4, 3000), samples::spiral(9.99, 500, 10000),
                                   samples::arched_room(random, 5000), samples::comb(random, 5000)}) {
        const auto begin = std::chrono::steady_clock::now();
        const Partition pieces = diagonal_partition(polygon.points, polygon.sides);
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << "0.5 s at most when measured";
        EXPECT_EQ(fault(polygon, pieces), "");
        EXPECT_EQ(pieces.fallen_back, 0u);
    }
}

TEST(DiagonalPartition, CountsWhatItCutsOtherwise) {
    // Lines that turn twice at right angles, which no rounding makes: no corner has a piece that can be cut off.
    Polygon tangled({{-1, -1}, {0, -1}, {0, -2}, {0, -3}, {1, -3}, {2, -3}, {2, -2}, {3, -2},
                     {3, -1},  {3, 0},  {3, 1},  {2, 1},  {2, 0},  {1, 0},  {1, 1},  {1, 2},
                     {2, 2},   {2, 3},  {1, 3},  {0, 3},  {-1, 3}, {-1, 2}, {-1, 1}, {-1, 0}});
    const std::uint32_t lines[] = {0, 1, 1, 3, 3, 3, 3, 7, 8, 8, 8, 8, 8, 13, 13, 15, 15, 15, 15, 15, 15, 15, 22, 22};
    for (std::size_t k = 0; k < 24; ++k) tangled.sides[k].line = lines[k];
    const Partition pieces = diagonal_partition(tangled.points, tangled.sides);
    EXPECT_EQ(fault(tangled, pieces), "");
    EXPECT_EQ(pieces.fallen_back, 1u);
}

TEST(MergeDiagonals, KeepsOnlyThoseThatAreEssential) {
    const Polygon arrow({{0, 0}, {100, 100}, {0, 200}, {20, 100}});  // reflex at its last corner
    Partition triangles;
    const std::uint32_t line = first_cut_line + 7;
    triangles.sides = {arrow.sides[0], {1, 3, line, cut_tag}, arrow.sides[3],
                       arrow.sides[1], arrow.sides[2],        {3, 1, line, cut_tag}};
    triangles.first_side = {0, 3, 6};
    EXPECT_EQ(merge_diagonals(arrow.points, triangles).piece_count(), 2u);
    Polygon kite = arrow;
    kite.points[3].x = -20;
    const Partition merged = merge_diagonals(kite.points, triangles);
    EXPECT_EQ(merged.piece_count(), 1u);
    EXPECT_EQ(fault(kite, merged), "");
}

}  // namespace
}  // namespace enfilade::modeler
