// Many points at once are found where one by one finds them.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "accel/assemble.h"
#include "accel/point_grid.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

using Points = std::vector<std::array<double, 3>>;

std::vector<CellId> one_by_one(const SceneView& view, const Points& points) {
    std::vector<CellId> cells;
    for (const auto& p : points) cells.push_back(locate(view, p).value_or(none<CellId>));
    return cells;
}

std::vector<CellId> at_once(const SceneView& view, const Points& points, const Executor* executor = nullptr) {
    std::vector<CellId> cells(points.size());
    locate(view, points, cells, executor);
    return cells;
}

Scene office() { return assemble(test::synthetic_office({.rooms_per_row = 6, .rows = 4, .storeys = 3, .turn = 0.3})); }

Points scattered(std::size_t count) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> x(-15, 45), z(-1, 12);
    Points points;
    while (points.size() < count) points.push_back({x(random), x(random), z(random)});
    return points;
}

TEST(LocateMany, FindsScatteredPoints) {
    const Scene scene = office();
    const Points points = scattered(30000);
    const std::vector<CellId> expected = one_by_one(scene.view(), points);
    EXPECT_GT(std::count(expected.begin(), expected.end(), none<CellId>), 1000);
    EXPECT_EQ(at_once(scene.view(), points), expected);
}

TEST(LocateMany, FindsFewPointsWithoutAGrid) {
    const Scene scene = office();
    const Points points = scattered(scene.view().cells.size() / 2);
    EXPECT_EQ(at_once(scene.view(), points), one_by_one(scene.view(), points));
}

// Where a search begins decides nothing about what it finds.
TEST(PointGrid, FindsTheSameFromAnyCell) {
    const Scene scene = office();
    const PointGrid grid(scene.view());
    std::mt19937_64 random(13);
    for (const auto& p : scattered(2000))
        EXPECT_EQ(grid.find(p, static_cast<CellId>(random() % scene.view().cells.size())), grid.find(p));
}

TEST(LocateMany, FindsPointsAlongPaths) {
    const Scene scene = office();
    std::mt19937_64 random(12);
    std::normal_distribution<double> step(0, 0.05);
    Points points = {{4, 4, 1}};
    while (points.size() < 30000) {
        std::array<double, 3> p = points.back();
        for (double& v : p) v += step(random);
        points.push_back(p);
    }
    EXPECT_EQ(at_once(scene.view(), points), one_by_one(scene.view(), points));
}

// Corners, where a rule decides between up to eight cells, and their neighbourhood of a few grid units.
TEST(LocateMany, KeepsTheRuleOfBorders) {
    const Scene scene = office();
    const SceneView& view = scene.view();
    Points points;
    for (const Cell& cell : view.cells)
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s)
            for (const float z : {cell.z_floor, cell.z_ceiling})
                for (const double off : {-2 * view.unit, 0.0, view.unit})
                    points.push_back({double{view.section_x[s]} + off, double{view.section_y[s]} - off, double{z}});
    EXPECT_EQ(at_once(view, points), one_by_one(view, points));
}

TEST(LocateMany, DoesNotDependOnTheThreads) {
    const Scene scene = office();
    const Points points = scattered(30000);
    const ThreadExecutor threads(4);
    EXPECT_EQ(at_once(scene.view(), points, &threads), at_once(scene.view(), points));
}

TEST(LocateMany, FindsNothingForWhatIsNoPlace) {
    const Scene scene = office();
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    const Points points = {{nan, 1, 1},       {1, nan, 1},        {1, 1, nan},  {infinity, 1, 1},
                           {-infinity, 1, 1}, {1, 1e300, -1e300}, {1, 1, -1e9}, {nan, nan, nan}};
    for (const CellId cell : at_once(scene.view(), points)) EXPECT_EQ(cell, none<CellId>);
    const PointGrid grid(scene.view());
    for (const auto& p : points) EXPECT_EQ(grid.find(p), none<CellId>);
    EXPECT_TRUE(at_once(scene.view(), {}).empty());
}

}  // namespace
}  // namespace enfilade::accel
