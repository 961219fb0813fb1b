#include "modeler/lighting/spread.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enfilade::modeler {
namespace {

using plans::Point;

double area_of(const std::vector<Point>& ring) {
    double twice = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) twice += plans::cross(ring[k], ring[(k + 1) % ring.size()]);
    return twice / 2;
}

double distance_to(const std::vector<Point>& ring, Point p) {
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < ring.size(); ++k)
        least = std::min(least, plans::distance(p, ring[k], ring[(k + 1) % ring.size()]));
    return least;
}

bool holds(const std::vector<Point>& ring, Point p) {
    bool inside = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point a = ring[k], b = ring[(k + 1) % ring.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

SpreadRegion region_of(std::vector<Point> ring) {
    SpreadRegion region;
    for (std::size_t k = 0; k < ring.size(); ++k) region.sides.push_back({ring[k], ring[(k + 1) % ring.size()]});
    region.area = area_of(ring);
    region.is_free = [ring](Point p, double clearance) { return holds(ring, p) && distance_to(ring, p) >= clearance; };
    return region;
}

std::vector<Point> rectangle(double width, double depth) { return {{0, 0}, {width, 0}, {width, depth}, {0, depth}}; }

std::vector<Point> turned(std::vector<Point> ring, double angle) {
    for (Point& p : ring)
        p = {p.x * std::cos(angle) - p.y * std::sin(angle) + 7, p.x * std::sin(angle) + p.y * std::cos(angle) - 3};
    return ring;
}

double nearest_pair(const std::vector<Point>& places) {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) least = std::min(least, plans::distance(places[i], places[k]));
    return least;
}

TEST(Spread, HangsAGridInARectangleHalfAPitchOffItsWalls) {
    const std::vector<Point> places = spread(region_of(rectangle(6, 4)), 6, false);
    ASSERT_EQ(places.size(), 6u);
    EXPECT_NEAR(places[0].x, 1, 1e-9);
    EXPECT_NEAR(places[0].y, 1, 1e-9);
    EXPECT_NEAR(places[5].x, 5, 1e-9);
    EXPECT_NEAR(places[5].y, 3, 1e-9);
}

TEST(Spread, TurnsTheGridWithTheWalls) {
    const double angle = 0.4;
    const std::vector<Point> places = spread(region_of(turned(rectangle(6, 4), angle)), 6, false);
    const std::vector<Point> wanted = turned({{1, 1}, {3, 1}, {5, 1}, {1, 3}, {3, 3}, {5, 3}}, angle);
    ASSERT_EQ(places.size(), 6u);
    for (const Point w : wanted)
        EXPECT_TRUE(std::ranges::any_of(places, [&](Point p) { return plans::distance(p, w) < 1e-6; }));
}

TEST(Spread, FollowsTheMiddleLineOfACorridor) {
    for (const Point p : spread(region_of(rectangle(20, 2)), 3, false)) EXPECT_NEAR(p.y, 1, 1e-9);
    // Around a corner: 12 m along and 10 m up, 2 m wide.
    const std::vector<Point> corner = {{0, 0}, {12, 0}, {12, 10}, {10, 10}, {10, 2}, {0, 2}};
    const std::vector<Point> places = spread(region_of(corner), 5, true);
    ASSERT_EQ(places.size(), 5u);
    for (const Point p : places)
        EXPECT_GT(distance_to(corner, p), 0.6) << p.x << ' ' << p.y << ": near the middle between the walls";
}

TEST(Spread, OneLampIsInTheMiddle) {
    const std::vector<Point> places = spread(region_of(rectangle(5, 3)), 1, true);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].x, 2.5, 1e-9);
    EXPECT_NEAR(places[0].y, 1.5, 1e-9);
}

TEST(Spread, KeepsOutOfAColumnInTheMiddle) {
    SpreadRegion region = region_of(rectangle(4, 4));
    const auto free_floor = region.is_free;
    region.is_free = [&](Point p, double clearance) {
        return free_floor(p, clearance) && std::max(std::abs(p.x - 2), std::abs(p.y - 2)) > 0.5 + clearance;
    };
    const std::vector<Point> places = spread(region, 1, true);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_TRUE(region.is_free(places[0], 0.29));
}

TEST(Spread, NarrowPlacesHaveLampsAsFarFromTheirWallsAsTheyLet) {
    const std::vector<Point> places = spread(region_of(rectangle(0.4, 0.4)), 1, true);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_TRUE(spread(region_of(rectangle(0.01, 4)), 1, true).empty()) << "no lamp hangs in a crack";
}

RC_GTEST_PROP(Spread, GivesExactlyAsManyPlacesAsAskedForFreeAndApart, ()) {
    const double width = *rc::gen::inRange(30, 200) / 10.0, depth = *rc::gen::inRange(30, 200) / 10.0;
    const double notch_x = width * *rc::gen::inRange(3, 8) / 10, notch_y = depth * *rc::gen::inRange(3, 8) / 10;
    const std::vector<Point> ring =
        turned({{0, 0}, {width, 0}, {width, notch_y}, {notch_x, notch_y}, {notch_x, depth}, {0, depth}},
               *rc::gen::inRange(0, 628) / 100.0);
    const auto count = std::size_t(*rc::gen::inRange(1, 30));
    const SpreadRegion region = region_of(ring);
    const std::vector<Point> places = spread(region, count, true);
    RC_ASSERT(places.size() == count);
    for (const Point p : places) RC_ASSERT(region.is_free(p, 0.009));
    RC_ASSERT(count == 1 || nearest_pair(places) > 0.25 * std::sqrt(region.area / double(count)));
    RC_ASSERT(spread(region, count, true) == places);
}

TEST(Spread, GivesExactlyAsManyPlacesOfThousands) {
    const std::vector<Point> ring = {{0, 0}, {60, 0}, {60, 20}, {30, 20}, {30, 50}, {0, 50}};
    const SpreadRegion region = region_of(ring);
    for (const std::size_t count : {201u, 997u, 2500u}) {
        const std::vector<Point> places = spread(region, count, true);
        EXPECT_EQ(places.size(), count);
        EXPECT_GT(nearest_pair(places), 0.4 * std::sqrt(region.area / double(count)));
    }
}

}  // namespace
}  // namespace enfilade::modeler
