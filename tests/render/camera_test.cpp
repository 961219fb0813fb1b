#include "render/camera.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "accel/assemble.h"
#include "base/error.h"
#include "render/trace.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

template <class Call>
InputError refusal(const Call& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error;
    }
    return {"none", "", "was not refused"};
}

TEST(Camera, LooksThroughTheMiddleOfTheImageAtItsTarget) {
    Camera camera;
    camera.eye = {1, 2, 3};
    camera.target = {4, 6, 2};
    const CameraFrame frame = make_frame(camera);
    const Vec3f middle = normalized(frame.direction(512, 512));
    const Vec3d expected = normalized(camera.target - camera.eye);
    EXPECT_NEAR(middle.x, expected.x, 1e-6);
    EXPECT_NEAR(middle.y, expected.y, 1e-6);
    EXPECT_NEAR(middle.z, expected.z, 1e-6);
}

// A mirrored picture is the classic mistake.
TEST(Camera, ShowsWhatIsToTheRightOnTheRightAndWhatIsAboveAbove) {
    Camera camera;
    camera.eye = {0, 0, 0};
    camera.target = {0, 1, 0};  // north; east is to the right
    const CameraFrame frame = make_frame(camera);
    EXPECT_GT(frame.direction(1000, 512).x, 0.1f);
    EXPECT_GT(frame.direction(512, 10).z, 0.1f);
}

TEST(Camera, OpensItsFieldOfViewAcrossTheLongerSide) {
    Camera camera;
    camera.fov_deg = 90;
    camera.width = 200;
    camera.height = 100;
    const CameraFrame frame = make_frame(camera);
    const Vec3f left = normalized(frame.direction(0, 50)), right = normalized(frame.direction(200, 50));
    EXPECT_NEAR(dot(left, right), 0, 1e-6);
}

TEST(Camera, WithBadNumbersIsRefused) {
    const auto code_of = [](const auto& edit) {
        Camera camera;
        edit(camera);
        return refusal([&] { (void)make_frame(camera); }).code;
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code_of([](Camera& c) { c.eye.y = nan; }), "R1");
    EXPECT_EQ(code_of([](Camera& c) { c.target.z = std::numeric_limits<double>::infinity(); }), "R1");
    EXPECT_EQ(code_of([](Camera& c) { c.target = c.eye; }), "R1");
    EXPECT_EQ(code_of([](Camera& c) { c.target = c.eye + Vec3d{0, 0, 5}; }), "R1");
    EXPECT_EQ(code_of([](Camera& c) { c.fov_deg = 180; }), "R1");
    EXPECT_EQ(code_of([](Camera& c) { c.fov_deg = nan; }), "R1");
    EXPECT_EQ(code_of([](Camera& c) { c.width = 0; }), "R1");
    EXPECT_EQ(code_of([](Camera&) {}), "none");
}

TEST(StartCell, IsFoundInRoomsDoorwaysAndOutside) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    const auto label_at = [&](Vec3d eye) {
        Camera camera;
        camera.eye = eye;
        camera.target = eye + Vec3d{1, 0, 0};
        return scene.view().cells[index(start_cell(scene.view(), make_frame(camera)))].label;
    };
    EXPECT_EQ(label_at({2, 2, 1.6}), accel::Label::Room);
    EXPECT_EQ(label_at({2.2, 5.3, 1.6}), accel::Label::Door);
    EXPECT_EQ(label_at({2.2, 0.1, 1.6}), accel::Label::Window);
    EXPECT_EQ(label_at({-3, 3, 1.6}), accel::Label::Exterior);
}

TEST(StartCell, SaysWhereACameraInAWallOrOutsideTheSiteStands) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    Camera camera;
    camera.eye = {0.1, 3, 1.6};
    camera.target = {2, 3, 1.6};
    const InputError wall = refusal([&] { (void)trace(scene.view(), camera); });
    EXPECT_EQ(wall.code, "R2");
    EXPECT_NE(std::string(wall.what()).find("(0.100, 3.000, 1.600) stands inside a wall"), std::string::npos);
    camera.eye = {-300, 3, 1.6};
    const InputError outside = refusal([&] { (void)trace(scene.view(), camera); });
    EXPECT_EQ(outside.code, "R2");
    EXPECT_NE(std::string(outside.what()).find("outside the site"), std::string::npos);
}

TEST(StartCell, SaysPlacesInMetresOfThePlan) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    accel::SceneView moved = scene.view();
    moved.origin[0] = 1000;
    moved.origin[1] = -20;
    moved.origin[2] = 0.5;
    Camera camera;
    camera.eye = {0.1, 3, 1.6};
    camera.target = {2, 3, 1.6};
    const std::string wall = refusal([&] { (void)trace(moved, camera); }).what();
    EXPECT_NE(wall.find("(1000.100, -17.000, 2.100) stands inside a wall"), std::string::npos) << wall;
    camera.eye = {-300, 3, 1.6};
    const std::string here = refusal([&] { (void)trace(scene.view(), camera); }).what();
    const std::string outside = refusal([&] { (void)trace(moved, camera); }).what();
    EXPECT_NE(outside.find("(700.000, -17.000, 2.100) stands outside"), std::string::npos) << outside;
    EXPECT_NE(outside.substr(outside.find("reaches")), here.substr(here.find("reaches")))
        << "its bounds are the plan's";
    EXPECT_NE(outside.find("--room"), std::string::npos) << outside;
}

}  // namespace
}  // namespace enfilade::render
