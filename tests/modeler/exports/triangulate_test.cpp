// Rings cut into triangles.

#include "modeler/exports/triangulate.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <set>

namespace enfilade::modeler {
namespace {

using Ring = std::vector<GridPoint2>;

std::int64_t area2(const GridPoint2& a, const GridPoint2& b, const GridPoint2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

std::int64_t area2(const Ring& ring) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const GridPoint2& p = ring[i];
        const GridPoint2& q = ring[(i + 1) % ring.size()];
        sum += p[0] * q[1] - q[0] * p[1];
    }
    return sum;
}

/// Every corner used, triangles of positive area that sum to the ring's.
void expect_sound(const Ring& ring) {
    const auto triangles = triangulate(ring);
    ASSERT_EQ(triangles.size(), ring.size() - 2);
    std::int64_t sum = 0;
    std::set<std::uint32_t> used;
    for (const auto& [a, b, c] : triangles) {
        const std::int64_t area = area2(ring[a], ring[b], ring[c]);
        EXPECT_GT(area, 0);
        sum += area;
        used.insert({a, b, c});
    }
    EXPECT_EQ(sum, area2(ring));
    EXPECT_EQ(used.size(), ring.size());
}

TEST(Triangulate, CutsASquareInTwo) { expect_sound({{0, 0}, {4, 0}, {4, 4}, {0, 4}}); }

TEST(Triangulate, KeepsCornersOnStraightSides) {
    expect_sound({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}});
    expect_sound({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}});
}

TEST(Triangulate, CutsAComb) {
    Ring comb;
    for (std::int64_t tooth = 0; tooth < 40; ++tooth) {
        comb.push_back({tooth * 4, 0});
        comb.push_back({tooth * 4 + 2, 0});
        comb.push_back({tooth * 4 + 2, 10});
        comb.push_back({tooth * 4 + 4, 10});
    }
    comb.push_back({160, 12});
    comb.push_back({0, 12});
    expect_sound(comb);
}

TEST(Triangulate, HasNothingToDoForLessThanThreeCorners) {
    EXPECT_TRUE(triangulate({}).empty());
    EXPECT_TRUE(triangulate(Ring{{0, 0}, {1, 1}}).empty());
}

TEST(Triangulate, KeepsItsCountWhereTheRingIsNotSimple) {
    const Ring bow_tie = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
    EXPECT_EQ(triangulate(bow_tie).size(), 2u);
    const Ring line = {{0, 0}, {1, 0}, {2, 0}, {1, 0}};
    EXPECT_EQ(triangulate(line).size(), 2u);
}

/// Radii around the origin at rising angles: always simple, and reflex wherever a radius is short.
TEST(Triangulate, CutsRandomStars) {
    EXPECT_TRUE(rc::check([] {
        const int count = *rc::gen::inRange(3, 60);
        Ring ring;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            const double radius = *rc::gen::inRange(5000, 1000000);
            ring.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
        }
        const auto triangles = triangulate(ring);
        RC_ASSERT(triangles.size() == ring.size() - 2);
        std::int64_t sum = 0;
        for (const auto& [a, b, c] : triangles) {
            RC_ASSERT(area2(ring[a], ring[b], ring[c]) > 0);
            sum += area2(ring[a], ring[b], ring[c]);
        }
        RC_ASSERT(sum == area2(ring));
    }));
}

/// Staircases up and down with extra corners in line: what floors with many doors look like.
TEST(Triangulate, CutsRandomStaircases) {
    EXPECT_TRUE(rc::check([] {
        const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 5));
        Ring ring = {{0, 0}};
        std::int64_t x = 0;
        for (const int step : steps) {
            x += step;
            ring.push_back({x, 0});
        }
        ring.push_back({x + 1, 0});
        std::int64_t y = 5;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            ring.push_back({x + 1, y});
            y += steps[i] % 2 == 0 ? 3 : 0;
            if (ring.back()[1] != y) ring.push_back({x + 1, y});
            x -= steps[i];
            ring.push_back({x + 1, y});
            y += 1;
        }
        ring.push_back({x + 1, y});
        ring.push_back({0, y});
        Ring distinct;
        for (const GridPoint2& p : ring)
            if (distinct.empty() || distinct.back() != p) distinct.push_back(p);
        const auto triangles = triangulate(distinct);
        std::int64_t sum = 0;
        for (const auto& [a, b, c] : triangles) {
            RC_ASSERT(area2(distinct[a], distinct[b], distinct[c]) > 0);
            sum += area2(distinct[a], distinct[b], distinct[c]);
        }
        RC_ASSERT(sum == area2(distinct));
    }));
}

}  // namespace
}  // namespace enfilade::modeler
