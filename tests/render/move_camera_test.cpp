#include "render/move_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

class MoveCamera : public testing::Test {
protected:
    MoveCamera() : scene_(accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2}))) {}
    [[nodiscard]] Place at(Vec3d p) const { return {p, *accel::locate(scene_.view(), {p.x, p.y, p.z})}; }
    [[nodiscard]] accel::Label label(const Place& place) const { return scene_.view().cells[index(place.cell)].label; }
    accel::Scene scene_;
};

TEST_F(MoveCamera, GoesThroughADoor) {
    const Place there = move_camera(scene_.view(), at({2.2, 4, 1.6}), {0, 2.5, 0});
    EXPECT_DOUBLE_EQ(there.point.y, 6.5);
    EXPECT_EQ(there.cell, at({2.2, 6.5, 1.6}).cell);
}

TEST_F(MoveCamera, StopsBeforeAWall) {
    const Place there = move_camera(scene_.view(), at({1, 4, 1.6}), {0, 20, 0}, 0.05);
    EXPECT_NEAR(there.point.y, 5.2 - 0.05, 1e-4);  // to the grid
    EXPECT_EQ(label(there), accel::Label::Room);
}

TEST_F(MoveCamera, StopsBeforeAPane) {
    const Place there = move_camera(scene_.view(), at({2.2, 2, 1.6}), {0, -20, 0}, 0.05);
    EXPECT_NEAR(there.point.y, 0.05, 1e-9);
    EXPECT_EQ(label(there), accel::Label::Window);
}

TEST_F(MoveCamera, StaysForNoStepAndForNaN) {
    const Place here = at({2.2, 2, 1.6});
    EXPECT_EQ(move_camera(scene_.view(), here, {0, 0, 0}).point, here.point);
    EXPECT_EQ(move_camera(scene_.view(), here, {std::nan(""), 0, 0}).point, here.point);
}

TEST_F(MoveCamera, StaysInItsCellOnALongRandomTour) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> step(-2, 2);
    Place place = at({2.2, 2, 1.6});
    std::set<accel::CellId> visited;
    for (int i = 0; i < 5000; ++i) {
        place = move_camera(scene_.view(), place, {step(random), step(random), 0.2 * step(random)});
        ASSERT_TRUE(accel::contains(scene_.view(), place.cell, {place.point.x, place.point.y, place.point.z})) << i;
        visited.insert(place.cell);
    }
    EXPECT_GT(visited.size(), 8u);
}

}  // namespace
}  // namespace enfilade::render
