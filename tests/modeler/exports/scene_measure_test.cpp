// Areas, volumes and middles.

#include "modeler/exports/scene_measure.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::modeler {
namespace {

TEST(SceneMeasure, KnowsTwoCubesAndTheDoorBetween) {
    using accel::Label;
    using test::grid;
    const std::vector<test::Plot> plots = {
        {grid(0), grid(0), grid(2), grid(2), {{0, grid(2), Label::Room, 0}}},
        {grid(2), grid(0.5), grid(2.25), grid(1.5), {{0, grid(1.75), Label::Door, 1}}},
        {grid(2.25), grid(0), grid(4.25), grid(2), {{0, grid(2), Label::Room, 2}}}};
    const accel::Scene scene = accel::assemble(test::scene_from_plots(plots));
    ASSERT_EQ(scene.view().cells.size(), 3u);
    for (const std::size_t room : {0u, 2u}) {
        const CellMeasure cube = measure(scene.view(), accel::CellId(room));
        EXPECT_DOUBLE_EQ(cube.floor_area, 4);
        EXPECT_DOUBLE_EQ(cube.volume, 8);
    }
    EXPECT_DOUBLE_EQ(measure(scene.view(), accel::CellId(1)).volume, 0.25 * 1 * 1.75);
    EXPECT_EQ(measure(scene.view(), accel::CellId(0)).centre, (std::array{1.0, 1.0, 1.0}));
    EXPECT_EQ(portal_areas(scene.view()), (std::vector{1.75, 1.75}));
}

TEST(SceneMeasure, CentreLiesInItsCell) {
    const accel::Scene scene =
        accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .storeys = 2, .turn = 0.3}));
    for (std::size_t c = 0; c < scene.view().cells.size(); ++c) {
        const CellMeasure cell = measure(scene.view(), accel::CellId(c));
        EXPECT_EQ(accel::locate(scene.view(), cell.centre), accel::CellId(c));
    }
}

}  // namespace
}  // namespace enfilade::modeler
