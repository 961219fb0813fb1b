// No ray that the walk traces enters a cell that the beam does not get to; and few cells are reported in vain.

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "tests/accel/beam_rays.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

using render::Vec3d;
using test::Misses;

std::uint32_t random_cell(const SceneView& view, std::mt19937_64& random) {
    return static_cast<std::uint32_t>(random() % view.cells.size());
}

class Beams : public testing::TestWithParam<double> {  // by how much the building is turned
protected:
    Scene scene = assemble(test::synthetic_office({.rooms_per_row = 6, .rows = 5, .storeys = 3, .turn = GetParam()}));
    const SceneView& view = scene.view();
    std::mt19937_64 random{20261122};
};

TEST_P(Beams, FromPointsMissNoCellOfARay) {
    Misses misses(view);
    std::size_t reached_cells = 0, entered_cells = 0;
    for (int k = 0; k < 300; ++k) {
        const std::uint32_t cell = random_cell(view, random);
        const Vec3d p = test::random_point(view, cell, random);
        const std::vector<CellId> reached = reachable_cells(view, source_at(view, CellId{cell}, {p.x, p.y, p.z}));
        misses.forget_entered();
        for (int r = 0; r < 1000; ++r) misses.judge(reached, {p, test::far_direction(random), cell});
        reached_cells += reached.size();
        entered_cells += misses.entered().size();
    }
    EXPECT_EQ(misses.count(), 0u) << misses.first();
    EXPECT_LT(double(reached_cells), 1.35 * double(entered_cells)) << "a thousand rays each find most of them";
}

TEST_P(Beams, FromCellsMissNoCellOfARay) {
    Misses misses(view);
    for (int k = 0; k < 100; ++k) {
        const std::uint32_t cell = random_cell(view, random);
        const std::vector<CellId> reached =
            reachable_cells(view, source_of_cell(view, CellId{cell}), {.max_beams = 16});
        for (int r = 0; r < 3000; ++r)
            misses.judge(reached, {test::random_point(view, cell, random), test::far_direction(random), cell});
    }
    EXPECT_EQ(misses.count(), 0u) << misses.first();
}

TEST_P(Beams, FromBoxesMissNoCellOfARay) {
    Misses misses(view);
    std::uniform_real_distribution<double> size(0.01, 3);
    for (int k = 0; k < 30; ++k) {
        const Vec3d p = test::random_point(view, random_cell(view, random), random);
        const std::array<double, 3> low = {p.x - size(random), p.y - size(random), p.z - size(random)};
        const std::array<double, 3> high = {p.x + size(random), p.y + size(random), p.z + size(random)};
        const std::vector<CellId> reached = reachable_cells(view, sources_of_box(view, low, high), {.max_beams = 8});
        for (int r = 0; r < 3000; ++r) {
            const auto between = [&](std::size_t i) {
                return std::uniform_real_distribution<double>(low[i], high[i])(random);
            };
            const Vec3d q = {between(0), between(1), between(2)};
            const std::optional<CellId> cell = locate(view, {q.x, q.y, q.z});
            if (!cell) continue;  // in a wall
            misses.judge(reached, {q, test::far_direction(random), static_cast<std::uint32_t>(*cell)});
        }
    }
    EXPECT_EQ(misses.count(), 0u) << misses.first();
    EXPECT_GT(misses.rays(), 20000u);
}

/// Where ties are: ends of sections at the levels of their faces.
std::vector<Vec3d> corners_of(const SceneView& view, std::uint32_t c) {
    std::vector<Vec3d> corners;
    const Cell& cell = view.cells[c];
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        corners.push_back({view.section_x[s], view.section_y[s], cell.z_floor});
        for (std::uint32_t f = view.section_tails[s].first_face; f < view.section_tails[s + 1].first_face; ++f)
            corners.push_back({view.section_x[s], view.section_y[s], view.side_faces[f].z_top});
    }
    return corners;
}

/// In the middle of a cell, on its corners, sides, floor and ceiling, on the grid.
std::vector<Vec3d> awkward_points(const SceneView& view, std::uint32_t c) {
    std::vector<Vec3d> points = corners_of(view, c);
    const std::size_t corner_count = points.size();
    for (std::size_t k = 0; k < corner_count; k += 3) {
        const Vec3d a = points[k], b = points[(k + 2) % corner_count];
        const auto on_grid = [&](double v) { return std::round(v / view.unit) * view.unit; };
        points.push_back({on_grid(0.5 * (a.x + b.x)), on_grid(0.5 * (a.y + b.y)), a.z});
    }
    const Vec3d middle = test::centre_of(view, c);
    const Cell& cell = view.cells[c];
    points.push_back(middle);
    points.push_back({middle.x, middle.y, cell.z_floor});
    points.push_back({middle.x, middle.y, cell.z_ceiling});
    return points;
}

/// From a point towards every corner in sight and past it, along walls and floors, along the axes, up and down.
std::vector<Vec3d> awkward_directions(const SceneView& view, const Vec3d& p, const std::vector<CellId>& reached) {
    std::vector<Vec3d> all = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0},
                              {0, 1, 0}, {0, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    for (const CellId id : reached) {
        const auto c = static_cast<std::uint32_t>(id);
        const std::vector<Vec3d> corners = corners_of(view, c);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            all.push_back(corners[k] - p);
            all.push_back({corners[k].x - p.x, corners[k].y - p.y, 0});
            const Vec3d along = corners[(k + 1) % corners.size()] - corners[k];
            all.push_back({along.x, along.y, 0});
            all.push_back({-along.x, -along.y, 0});
        }
    }
    return all;
}

TEST_P(Beams, WithAMarginMissNoCellOfARayThatTouchesEdges) {
    Misses misses(view);
    while (misses.rays() < 300000) {
        const std::uint32_t near = random_cell(view, random);
        const std::vector<Vec3d> points = awkward_points(view, near);
        const Vec3d p = points[random() % points.size()];
        const std::optional<CellId> cell = locate(view, {p.x, p.y, p.z});
        if (!cell) continue;
        const std::vector<CellId> reached =
            reachable_cells(view, source_at(view, *cell, {p.x, p.y, p.z}), {.margin = 1});
        for (const Vec3d& d : awkward_directions(view, p, reached))
            if (render::length(d) > 0) misses.judge(reached, {p, d, static_cast<std::uint32_t>(*cell)});
    }
    EXPECT_EQ(misses.count(), 0u) << misses.first();
}

/// Numbers on the grid and no rounding: the shift that breaks the walk's ties is the one that beams leave ends out by.
TEST(BeamsOfAnUprightBuilding, NeedNoMarginForEdges) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 3, .storeys = 2}));
    const SceneView& view = scene.view();
    std::mt19937_64 random(5);
    Misses misses(view);
    while (misses.rays() < 200000) {
        const std::vector<Vec3d> points = awkward_points(view, random_cell(view, random));
        const Vec3d p = points[random() % points.size()];
        const std::optional<CellId> cell = locate(view, {p.x, p.y, p.z});
        if (!cell) continue;
        const std::vector<CellId> reached = reachable_cells(view, source_at(view, *cell, {p.x, p.y, p.z}));
        for (const Vec3d& d : awkward_directions(view, p, reached))
            if (render::length(d) > 0) misses.judge(reached, {p, d, static_cast<std::uint32_t>(*cell)});
    }
    EXPECT_EQ(misses.count(), 0u) << misses.first();
}

/// Two points that see each other are in each other's cells.
TEST_P(Beams, OfPointsThatSeeEachOtherMeet) {
    std::size_t pairs = 0;
    while (pairs < 300) {
        const std::uint32_t a = random_cell(view, random);
        const Vec3d p = test::random_point(view, a, random);
        const auto path = test::cells_of(view, {p, test::far_direction(random), a});
        const std::uint32_t b = path[random() % path.size()];
        const Vec3d q = test::random_point(view, b, random);
        const auto there = test::cells_of(view, {p, q - p, a});
        if (b == a || std::ranges::find(there, b) == there.end()) continue;
        ++pairs;
        const auto from_p = reachable_cells(view, source_at(view, CellId{a}, {p.x, p.y, p.z}));
        const auto from_q = reachable_cells(view, source_at(view, CellId{b}, {q.x, q.y, q.z}));
        EXPECT_TRUE(std::ranges::binary_search(from_p, CellId{b}));
        EXPECT_TRUE(std::ranges::binary_search(from_q, CellId{a}));
    }
}

/// A cell sees another if and only if it is seen by it: followed one by one, in a building of one height where heights
/// decide nothing, beams are exact both ways.
TEST(BeamsOfAnUprightBuilding, AreMutual) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 4}));
    const SceneView& view = scene.view();
    std::vector<std::vector<CellId>> reached;
    for (std::uint32_t c = 0; c < view.cells.size(); ++c)
        reached.push_back(reachable_cells(view, source_of_cell(view, CellId{c}), {.max_beams = 0}));
    std::size_t pairs = 0;
    for (std::uint32_t c = 0; c < reached.size(); ++c)
        for (const CellId to : reached[c]) {
            ++pairs;
            EXPECT_TRUE(std::ranges::binary_search(reached[index(to)], CellId{c})) << c << " and " << index(to);
        }
    EXPECT_GT(pairs, 3 * reached.size());
}

INSTANTIATE_TEST_SUITE_P(Turned, Beams, testing::Values(0.0, 0.1, 0.7));

}  // namespace
}  // namespace enfilade::accel
