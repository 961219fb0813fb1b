#include "accel/locate.h"

#include <gtest/gtest.h>

#include <random>

#include "accel/assemble.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

/// All cells that hold the point, without the locator's boxes.
std::vector<CellId> holders(const SceneView& view, const std::array<double, 3>& point) {
    std::vector<CellId> cells;
    for (std::uint32_t c = 0; c < view.cells.size(); ++c)
        if (contains(view, static_cast<CellId>(c), point)) cells.push_back(static_cast<CellId>(c));
    return cells;
}

TEST(Locate, FindsTheCellOfEveryCentre) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 3, .storeys = 2, .turn = 0.2}));
    const SceneView& view = scene.view();
    for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
        const Cell& cell = view.cells[c];
        std::array<double, 3> centre = {0, 0, 0.5 * (double{cell.z_floor} + double{cell.z_ceiling})};
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            centre[0] += double{view.section_x[s]} / cell.section_count;
            centre[1] += double{view.section_y[s]} / cell.section_count;
        }
        EXPECT_EQ(locate(view, centre), static_cast<CellId>(c));
    }
}

TEST(Locate, GivesEveryBorderPointToAtMostOneCell) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.4}));
    const SceneView& view = scene.view();
    for (std::uint32_t s = 0; s < view.section_count(); ++s)
        for (const float z : {0.0f, 1.0f, 2.1f, 2.7f, 3.0f})
            EXPECT_LE(holders(view, {view.section_x[s], view.section_y[s], z}).size(), 1u) << "corner " << s;
}

TEST(Locate, GivesPointsOnPortalsToExactlyOneCell) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.4}));
    const SceneView& view = scene.view();
    int portals = 0;
    for (const Cell& cell : view.cells)
        for (std::uint32_t i = 0; i < cell.section_count; ++i) {
            const std::uint32_t a = cell.first_section + i;
            const std::uint32_t b = cell.first_section + (i + 1) % cell.section_count;
            const std::uint32_t face = view.section_tails[a].first_face;
            if (!view.side_faces[face].target.is_portal()) continue;
            const std::array<double, 3> middle = {0.5 * (double{view.section_x[a]} + double{view.section_x[b]}),
                                                  0.5 * (double{view.section_y[a]} + double{view.section_y[b]}),
                                                  0.5 * (double{cell.z_floor} + double{view.side_faces[face].z_top})};
            EXPECT_EQ(holders(view, middle).size(), 1u);
            EXPECT_TRUE(locate(view, middle));
            ++portals;
        }
    EXPECT_GT(portals, 10);
}

TEST(Locate, AgreesWithASearchOfAllCells) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 4, .storeys = 2, .turn = 0.1}));
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> x(-10, 35), z(-1, 11);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::array<double, 3> point = {x(random), x(random), z(random)};
        const std::vector<CellId> expected = holders(scene.view(), point);
        ASSERT_LE(expected.size(), 1u);
        const std::optional<CellId> found = locate(scene.view(), point);
        ASSERT_EQ(found.has_value(), !expected.empty());
        if (found) {
            ASSERT_EQ(*found, expected.front());
        }
        inside += found.has_value();
    }
    EXPECT_GT(inside, 5000);
    EXPECT_LT(inside, 19000);
}

TEST(Locate, FindsNothingInWallsBeyondTheSiteAndForNaN) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    EXPECT_FALSE(locate(scene.view(), {0.1, 3, 1}));   // outer wall
    EXPECT_FALSE(locate(scene.view(), {2, 3, 2.85}));  // slab
    EXPECT_FALSE(locate(scene.view(), {2, 3, -0.1}));  // ground
    EXPECT_FALSE(locate(scene.view(), {1000, 3, 1}));
    EXPECT_FALSE(locate(scene.view(), {std::nan(""), 3, 1}));
    EXPECT_FALSE(locate(scene.view(), {2, 3, std::numeric_limits<double>::infinity()}));
    EXPECT_TRUE(locate(scene.view(), {2, 3, 1}));
}

}  // namespace
}  // namespace enfilade::accel
