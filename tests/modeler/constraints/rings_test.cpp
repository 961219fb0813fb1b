// G2: every face is bounded by one simple ring.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "modeler/constraints/ring_crossings.h"
#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/face_oracle.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

TEST(Rings, FindsEachFaceThatCrossesItself) { testing::expect_found(testing::inject_g2, 20); }

TEST(Rings, AcceptsACornerThatStopsAUnitShort) {
    // The room's floor seen as a ring, one corner pulled to within a unit of the opposite side.
    const std::vector<GridPoint> ring = {{0, 0}, {100, 0}, {100, 100}, {50, 1}, {0, 100}};
    EXPECT_TRUE(ring_crossings(ring).empty());
    std::vector<GridPoint> touching = ring;
    touching[3].y = 0;
    EXPECT_EQ(ring_crossings(touching), (std::vector<RingCrossing>{{0, 2}, {0, 3}}));
}

TEST(Rings, AcceptsCornersOnOneLine) {
    EXPECT_TRUE(ring_crossings(std::vector<GridPoint>{{0, 0}, {1, 0}, {2, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 3}}).empty());
}

TEST(Rings, SeesASideThatFoldsBack) {
    const std::vector<GridPoint> spike = {{0, 0}, {9, 0}, {4, 0}, {4, 5}};
    EXPECT_FALSE(ring_crossings(spike).empty());
    const std::vector<GridPoint> line = {{0, 0}, {5, 0}, {9, 0}};
    EXPECT_FALSE(ring_crossings(line).empty());
}

TEST(Rings, SeesARingThatGoesAroundTwice) {
    const std::vector<GridPoint> twice = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {8, 1}, {8, 8}, {1, 8}};
    EXPECT_FALSE(ring_crossings(twice).empty());
    const std::vector<GridPoint> star = {{0, 0}, {10, 4}, {-2, 4}, {8, 0}, {4, 8}};
    EXPECT_FALSE(ring_crossings(star).empty());
}

/// Corners on a small raster, so that they touch and line up often.
std::vector<GridPoint> any_ring(std::size_t most) {
    const int size = *rc::gen::inRange(3, 12);
    const auto corner = rc::gen::map(rc::gen::pair(rc::gen::inRange(0, size), rc::gen::inRange(0, size)),
                                     [](const std::pair<int, int>& p) {
                                         return GridPoint{p.first, p.second};
                                     });
    return *rc::gen::container<std::vector<GridPoint>>(std::size_t(*rc::gen::inRange(3, int(most))), corner);
}

RC_GTEST_PROP(RingCrossings, AreThereExactlyWhereAllPairsSaySo, ()) {
    const std::vector<GridPoint> ring = any_ring(8);
    RC_ASSERT(ring_crossings(ring).empty() == testing::is_simple_ring(ring));
}

/// A star of many corners around a centre is simple; with two of them exchanged it mostly is not.
RC_GTEST_PROP(RingCrossings, AgreeWithAllPairsOnLargeRings, ()) {
    const int n = *rc::gen::inRange(30, 120);
    std::vector<GridPoint> ring;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * 3.141592653589793 * k / n, radius = *rc::gen::inRange(20, 400);
        ring.push_back(
            {std::int32_t(std::lround(radius * std::cos(angle))), std::int32_t(std::lround(radius * std::sin(angle)))});
    }
    if (*rc::gen::arbitrary<bool>())
        std::swap(ring[std::size_t(*rc::gen::inRange(0, n))], ring[std::size_t(*rc::gen::inRange(0, n))]);
    RC_ASSERT(ring_crossings(ring).empty() == testing::is_simple_ring(ring));
}

TEST(RingCrossings, NameEveryPairOfCrossingEdges) {
    // A comb whose spine is cut by one long edge through all teeth.
    std::vector<GridPoint> comb;
    for (std::int32_t k = 0; k < 40; ++k)
        comb.insert(comb.end(), {{4 * k, 0}, {4 * k, 10}, {4 * k + 2, 10}, {4 * k + 2, 0}});
    comb.insert(comb.end(), {{158, 5}, {-1, 5}});
    const auto all = ring_crossings(comb, 1000);
    // The long edge crosses the two sides of each tooth; the ring comes to it by folding back on the last side.
    EXPECT_EQ(all.size(), 81u);
    EXPECT_EQ(ring_crossings(comb, 10).size(), 10u);
}

}  // namespace
}  // namespace enfilade::modeler
