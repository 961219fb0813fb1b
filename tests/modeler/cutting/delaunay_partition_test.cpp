#include "modeler/cutting/delaunay_partition.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

struct Polygon {
    std::vector<GridPoint> points;
    std::vector<PolygonSide> sides;

    /// Appends a loop, counter-clockwise for an outer boundary, clockwise for a hole; every side its own line.
    void add_loop(const std::vector<GridPoint>& loop) {
        const std::uint32_t base = std::uint32_t(points.size()), count = std::uint32_t(loop.size());
        for (std::uint32_t k = 0; k < count; ++k) {
            points.push_back(loop[k]);
            sides.push_back({base + k, base + (k + 1) % count, base + k, base + k});
        }
    }
};

bool visits_no_point_twice(std::span<const PolygonSide> ring) {
    std::set<std::uint32_t> seen;
    return std::all_of(ring.begin(), ring.end(),
                       [&](const PolygonSide& side) { return seen.insert(side.from).second; });
}

bool is_reflex(std::span<const GridPoint> points, const PolygonSide& in, const PolygonSide& out) {
    return in.line != out.line && orientation(points[in.from], points[in.to], points[out.to]) < 0;
}

bool is_convex(std::span<const GridPoint> points, std::span<const PolygonSide> ring) {
    for (std::size_t k = 0; k < ring.size(); ++k)
        if (is_reflex(points, ring[k], ring[(k + 1) % ring.size()])) return false;
    return true;
}

/// A star-shaped polygon around the origin with `corners` corners, some of them reflex, and perhaps a square hole.
Polygon random_polygon() {
    const int corners = *rc::gen::inRange(3, 40);
    Polygon polygon;
    std::vector<GridPoint> outer;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners, radius = *rc::gen::inRange(2000, 9000);
        outer.push_back(
            {std::int32_t(std::lround(radius * std::cos(angle))), std::int32_t(std::lround(radius * std::sin(angle)))});
    }
    polygon.add_loop(outer);
    if (corners > 6 && *rc::gen::arbitrary<bool>()) {
        const std::int32_t half = *rc::gen::inRange(1, 1000);
        polygon.add_loop({{-half, -half}, {-half, half}, {half, half}, {half, -half}});
    }
    return polygon;
}

TEST(DelaunayPartition, LeavesAConvexPolygonWhole) {
    Polygon square;
    square.add_loop({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    EXPECT_EQ(delaunay_partition(square.points, square.sides, PartitionGoal::Convex).piece_count(), 1u);
    EXPECT_EQ(delaunay_partition(square.points, square.sides, PartitionGoal::Disc).piece_count(), 1u);
}

TEST(DelaunayPartition, CutsAnLInFewConvexPieces) {
    Polygon l;
    l.add_loop({{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}});
    const std::uint32_t pieces = delaunay_partition(l.points, l.sides, PartitionGoal::Convex).piece_count();
    EXPECT_GE(pieces, 2u);
    EXPECT_LE(pieces, 3u) << "2 r + 1 at most (Hertel and Mehlhorn)";
    EXPECT_EQ(delaunay_partition(l.points, l.sides, PartitionGoal::Disc).piece_count(), 1u);
}

TEST(DelaunayPartition, CutsARingInTwoDiscs) {
    Polygon ring;
    ring.add_loop({{0, 0}, {30, 0}, {30, 30}, {0, 30}});
    ring.add_loop({{10, 10}, {10, 20}, {20, 20}, {20, 10}});
    const Partition discs = delaunay_partition(ring.points, ring.sides, PartitionGoal::Disc);
    EXPECT_EQ(discs.piece_count(), 2u);
    std::size_t cuts = 0;
    for (const PolygonSide& side : discs.sides) cuts += side.tag == cut_tag;
    EXPECT_EQ(cuts, 4u) << "two virtual faces, each seen from both sides";
}

TEST(DelaunayPartition, CutsAHoleThatTouchesTheOuterRingInAPoint) {
    Polygon pinched;
    pinched.points = {{0, 0}, {20, 0}, {40, 0}, {40, 30}, {0, 30}, {30, 15}, {10, 15}};
    const std::uint32_t loop[] = {0, 1, 2, 3, 4}, hole[] = {1, 6, 5};
    for (std::uint32_t k = 0; k < 5; ++k) pinched.sides.push_back({loop[k], loop[(k + 1) % 5], k, k});
    for (std::uint32_t k = 0; k < 3; ++k) pinched.sides.push_back({hole[k], hole[(k + 1) % 3], 5 + k, 5 + k});
    const Partition discs = delaunay_partition(pinched.points, pinched.sides, PartitionGoal::Disc);
    EXPECT_GE(discs.piece_count(), 2u);
    for (std::uint32_t k = 0; k < discs.piece_count(); ++k) EXPECT_TRUE(visits_no_point_twice(discs.piece(k)));
}

TEST(DelaunayPartition, CountsEdgesOfOneLineAsStraight) {
    Polygon bent;  // the corner at (10, 1) is reflex by one unit, along one line
    bent.points = {{0, 0}, {10, 1}, {20, 0}, {20, 20}, {0, 20}};
    for (std::uint32_t k = 0; k < 5; ++k) bent.sides.push_back({k, (k + 1) % 5, k == 1 ? 0 : k, k});
    EXPECT_EQ(delaunay_partition(bent.points, bent.sides, PartitionGoal::Convex).piece_count(), 1u);
    bent.sides[1].line = 1;
    EXPECT_EQ(delaunay_partition(bent.points, bent.sides, PartitionGoal::Convex).piece_count(), 2u);
}

RC_GTEST_PROP(DelaunayPartition, PiecesSumToThePolygonAndMeetTheGoal, ()) {
    const Polygon polygon = random_polygon();
    for (const PartitionGoal goal : {PartitionGoal::Disc, PartitionGoal::Convex}) {
        const Partition pieces = delaunay_partition(polygon.points, polygon.sides, goal);
        std::int64_t sum = 0;
        std::multiset<std::pair<std::uint32_t, std::uint32_t>> cuts;
        for (std::uint32_t k = 0; k < pieces.piece_count(); ++k) {
            const auto ring = pieces.piece(k);
            RC_ASSERT(area2(polygon.points, ring) > 0);
            RC_ASSERT(visits_no_point_twice(ring));
            if (goal == PartitionGoal::Convex) RC_ASSERT(is_convex(polygon.points, ring));
            sum += area2(polygon.points, ring);
            for (const PolygonSide& side : ring)
                if (side.tag == cut_tag) cuts.emplace(side.from, side.to);
        }
        RC_ASSERT(sum == area2(polygon.points, polygon.sides));
        for (const auto& [from, to] : cuts) RC_ASSERT(cuts.count({to, from}) == 1u);
    }
}

RC_GTEST_PROP(DelaunayPartition, StaysWithinFourTimesTheLeastNumberOfConvexPieces, ()) {
    const Polygon polygon = random_polygon();
    std::uint32_t reflex = 0;
    std::vector<std::uint32_t> into(polygon.points.size());
    for (std::uint32_t k = 0; k < polygon.sides.size(); ++k) into[polygon.sides[k].to] = k;
    for (const PolygonSide& out : polygon.sides) {
        const PolygonSide& in = polygon.sides[into[out.from]];
        reflex += is_reflex(polygon.points, in, out);
    }
    // At least ceil(r / 2) + 1 - holes pieces are needed; Hertel and Mehlhorn leave at most 2 r + 1.
    RC_ASSERT(delaunay_partition(polygon.points, polygon.sides, PartitionGoal::Convex).piece_count() <= 2 * reflex + 1);
}

}  // namespace
}  // namespace enfilade::modeler
