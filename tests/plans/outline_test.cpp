// Strips, corners and jambs of single joints, in metres.

#include "plans/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/plans/arrangement.h"

namespace enfilade::plans {
namespace {

Wall wall(std::string id, Point a, Point b, double thickness = 0.2, double arc = 0) {
    return testing::wall(std::move(id), a, b, thickness, arc);
}

StoreyOutlines outlines_of(std::vector<Wall> walls, std::vector<Opening> openings = {}) {
    Storey storey;
    storey.walls = std::move(walls);
    storey.openings = std::move(openings);
    return outlines(storey, {});
}

double area(const std::vector<OutlinePoint>& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i].at;
        const Point b = ring[(i + 1) % ring.size()].at;
        sum += (a.x * b.y - a.y * b.x) / 2;
    }
    return sum;
}

bool has_point(const std::vector<OutlinePoint>& ring, Point p) {
    return std::any_of(ring.begin(), ring.end(),
                       [&](const OutlinePoint& q) { return std::hypot(q.at.x - p.x, q.at.y - p.y) < 1e-12; });
}

TEST(WallAxis, AnArcEndsWhereItsChordDoes) {
    for (const double extent : {0.3, -0.3, 2.0, -3.1, 3.1, 4.5, -6.0}) {
        const WallAxis axis({1, 2}, {4, -1}, extent, 1e-6);
        EXPECT_NEAR(std::hypot(axis.at(1 - 1e-12).x - 4, axis.at(1 - 1e-12).y + 1), 0, 1e-9) << extent;
        EXPECT_NEAR(axis.length(), axis.radius() * std::abs(extent), 1e-12) << extent;
    }
}

TEST(WallAxis, APositiveArcTurnsLeft) {
    // From east to north to west about the origin.
    const WallAxis axis({1, 0}, {-1, 0}, std::numbers::pi, 1e-6);
    EXPECT_NEAR(axis.at(0.5).x, 0, 1e-12);
    EXPECT_NEAR(axis.at(0.5).y, 1, 1e-12);
    EXPECT_NEAR(axis.normal(0.5).y, -1, 1e-12);  // left of travel is the centre
}

TEST(WallAxis, NearestIsTheInverseOfAt) {
    for (const double extent : {0.0, 0.8, -2.5, 4.0, -5.5}) {
        const WallAxis axis({0, 0}, {3, 1}, extent, 1e-6);
        for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0})
            EXPECT_NEAR(axis.nearest(axis.offset(t, 0.05)), t, 1e-9) << extent;
    }
}

TEST(Outline, ALoneWallIsARectangle) {
    const StoreyOutlines result = outlines_of({wall("a", {0, 0}, {2, 0})});
    EXPECT_EQ(result.walls[0].ring.size(), 4u);
    EXPECT_DOUBLE_EQ(area(result.walls[0].ring), 0.4);
    EXPECT_EQ(result.free_ends.size(), 2u);
}

TEST(Outline, ACornerIsMitred) {
    const StoreyOutlines result = outlines_of({wall("a", {0, 0}, {2, 0}), wall("b", {2, 0}, {2, 2})});
    for (const std::size_t w : {0, 1}) {
        EXPECT_TRUE(has_point(result.walls[w].ring, {2.1, -0.1}));
        EXPECT_TRUE(has_point(result.walls[w].ring, {1.9, 0.1}));
        EXPECT_TRUE(has_point(result.walls[w].ring, {2, 0}));
    }
    EXPECT_NEAR(area(result.walls[0].ring) + area(result.walls[1].ring), 2 * 0.4, 1e-12);
}

TEST(Outline, CornersOfUnequalWallsLieOnBothFaces) {
    const StoreyOutlines result = outlines_of({wall("a", {0, 0}, {2, 0}, 0.2), wall("b", {2, 0}, {2, 2}, 0.4)});
    for (const std::size_t w : {0, 1}) {
        EXPECT_TRUE(has_point(result.walls[w].ring, {2.2, -0.1}));
        EXPECT_TRUE(has_point(result.walls[w].ring, {1.8, 0.1}));
    }
}

TEST(Outline, TheDirectionOfWallsDoesNotMatter) {
    for (int turned = 0; turned < 4; ++turned) {
        Wall a = wall("a", {0, 0}, {2, 0});
        Wall b = wall("b", {2, 0}, {2, 2});
        if (turned & 1) std::swap(a.start, a.end);
        if (turned & 2) std::swap(b.start, b.end);
        const StoreyOutlines result = outlines_of({a, b});
        EXPECT_TRUE(has_point(result.walls[0].ring, {2.1, -0.1})) << turned;
        EXPECT_TRUE(has_point(result.walls[1].ring, {1.9, 0.1})) << turned;
        EXPECT_GT(area(result.walls[0].ring), 0) << turned;
        EXPECT_GT(area(result.walls[1].ring), 0) << turned;
    }
}

TEST(Outline, EndsAFewTenthsOfAMillimetreApartMeet) {
    const StoreyOutlines result = outlines_of({wall("a", {0, 0}, {2, 0}), wall("b", {2.0003, 0.0002}, {2, 2})});
    EXPECT_EQ(result.free_ends.size(), 2u);
    EXPECT_EQ(result.walls[0].axis.at(1), result.walls[1].axis.at(0));
}

TEST(Outline, AcuteCornersAreCutOffNotDrawnOut) {
    const double angle = 3 * std::numbers::pi / 180;
    const StoreyOutlines result =
        outlines_of({wall("a", {0, 0}, {4, 0}), wall("b", {0, 0}, {4 * std::cos(angle), 4 * std::sin(angle)})});
    for (const WallOutline& w : result.walls)
        for (const OutlinePoint& p : w.ring) EXPECT_GT(p.at.x, -0.41);
}

TEST(Outline, AWallIntoAnotherEndsOnItsAxisWhateverTheAngle) {
    const StoreyOutlines result =
        outlines_of({wall("host", {0, 0}, {6, 0}, 0.3), wall("branch", {3, 0.02}, {5, 2}, 0.2)});
    std::size_t on_axis = 0;
    for (const OutlinePoint& p : result.walls[1].ring) {
        EXPECT_GE(p.at.y, -1e-12);
        on_axis += std::abs(p.at.y) < 1e-12;
    }
    EXPECT_EQ(on_axis, 2u);
    EXPECT_EQ(result.free_ends.size(), 3u);  // both of the host, one of the branch
}

TEST(Outline, FacetsOfArcsKeepTheSagitta) {
    OutlineOptions options;
    options.sagitta = 0.001;
    Storey storey;
    storey.walls = {wall("arc", {3, 0}, {-3, 0}, 0.3, std::numbers::pi)};
    const WallOutline arc = outlines(storey, options).walls[0];
    double worst = 0;
    for (std::size_t k = 0; k + 1 < arc.stations.size(); ++k) {
        const Point a = arc.axis.offset(arc.stations[k], -arc.half);
        const Point b = arc.axis.offset(arc.stations[k + 1], -arc.half);
        worst = std::max(worst, 3.15 - std::hypot((a.x + b.x) / 2, (a.y + b.y) / 2));
    }
    EXPECT_LE(worst, 0.001 + 1e-12);
    EXPECT_GT(worst, 0.0008);  // no finer than needed
}

TEST(Outline, SmallArcsHaveAFewFacets) {
    const StoreyOutlines result = outlines_of({wall("arc", {0.1, 0}, {-0.1, 0}, 0.05, std::numbers::pi)});
    EXPECT_GE(result.walls[0].stations.size(), 7u);
}

TEST(Outline, AWallThickerThanItsArcEndsInTheCentre) {
    const StoreyOutlines result = outlines_of({wall("arc", {0.1, 0}, {-0.1, 0}, 0.5, std::numbers::pi)});
    for (const OutlinePoint& p : result.walls[0].ring) EXPECT_LE(std::hypot(p.at.x, p.at.y), 0.35 + 1e-12);
}

TEST(Outline, JambsAreVerticesOfBothTheWallAndTheOpening) {
    Opening door;
    door.id = "door";
    door.wall = "a";
    door.offset = 1;
    door.width = 0.8;
    const StoreyOutlines result = outlines_of({wall("a", {0, 0}, {2, 0})}, {door});
    ASSERT_EQ(result.openings[0].ring.size(), 4u);
    for (const OutlinePoint& p : result.openings[0].ring) EXPECT_TRUE(has_point(result.walls[0].ring, p.at));
    EXPECT_NEAR(area(result.openings[0].ring), 0.16, 1e-12);
}

TEST(Outline, AnOpeningWithoutItsWallHasNoRing) {
    Opening door;
    door.id = "door";
    door.wall = "nowhere";
    EXPECT_TRUE(outlines_of({wall("a", {0, 0}, {2, 0})}, {door}).openings[0].ring.empty());
}

}  // namespace
}  // namespace enfilade::plans
