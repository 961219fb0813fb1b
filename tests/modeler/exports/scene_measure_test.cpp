// Areas, volumes and middles.

#include "modeler/exports/scene_measure.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::modeler {
namespace {

TEST(SceneMeasure, KnowsARowOfCubes) {
    const accel::Scene scene = accel::assemble(test::synthetic_corridor(4));
    for (const double area : portal_areas(scene.view())) EXPECT_NEAR(area, 2, 1e-3);  // doors of 1 m x 2 m
    std::size_t cubes = 0;
    for (std::size_t c = 0; c < scene.view().cells.size(); ++c) {
        if (scene.view().cells[c].label != accel::Label::Room) continue;
        const CellMeasure cube = measure(scene.view(), accel::CellId(c));
        EXPECT_NEAR(cube.floor_area, 4, 1e-6);
        EXPECT_NEAR(cube.volume, 8, 1e-6);
        ++cubes;
    }
    EXPECT_EQ(cubes, 4u);
    EXPECT_GE(scene.view().portals.size(), 3u);
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
