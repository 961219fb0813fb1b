// Walks through buildings.

#include "tools/tour.h"

#include <cmath>
#include <map>
#include <set>

#include "accel/locate.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "render/image_file.h"
#include "render/move_camera.h"
#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using accel::Label;
using render::Vec3d;
using tools::SavedView;

accel::Scene scene_of(const plans::Plan& plan) {
    const modeler::Building building = modeler::convexify(modeler::build(plan));
    return modeler::export_scene(building, modeler::check(building), "{}");
}

std::string example(const std::string& name) { return ENFILADE_SOURCE_DIR "/plans/examples/" + name; }

const accel::Scene& townhouse() {
    static const accel::Scene scene = scene_of(plans::read(example("townhouse.json")));
    return scene;
}

/// Metres, at most one, from the eye to the nearest wall, in 16 level directions.
double room_around(const accel::SceneView& scene, const SavedView& view) {
    double least = 1;
    for (int k = 0; k < 16; ++k) {
        const double angle = k * 0.39269908169872414;
        const render::Place end =
            render::move_camera(scene, {view.camera.eye, view.cell}, {std::cos(angle), std::sin(angle), 0}, 0);
        least = std::min(least, render::length(end.point - view.camera.eye));
    }
    return least;
}

/// Metres from the eye down to the floor.
double height_above_floor(const accel::SceneView& scene, const SavedView& view) {
    const render::Place floor = render::move_camera(scene, {view.camera.eye, view.cell}, {0, 0, -10}, 0);
    return view.camera.eye.z - floor.point.z;
}

TEST(Tour, StandsWhereAPersonCanStand) {
    const accel::SceneView& scene = townhouse().view();
    const std::vector<SavedView> views = tools::make_tour(scene, {60, 10});
    ASSERT_EQ(views.size(), 60u);
    for (const SavedView& view : views) {
        const render::Vec3f eye = render::vec_cast<float>(view.camera.eye);
        EXPECT_TRUE(accel::contains(scene, view.cell, {eye.x, eye.y, eye.z})) << view.name;
        EXPECT_GE(room_around(scene, view), 0.1) << view.name;
        const Label label = scene.cells[index(view.cell)].label;
        EXPECT_TRUE(label == Label::Room || label == Label::Door || label == Label::Opening || label == Label::Stair)
            << view.name;
        if (label == Label::Room && scene.cells[index(view.cell)].floor.is_portal()) continue;  // above the stairs
        if (label == Label::Stair) continue;
        EXPECT_NEAR(height_above_floor(scene, view), 1.6, 0.01) << view.name;
    }
}

TEST(Tour, LeadsFromTheDoorToEveryStoreyWithoutAJump) {
    const accel::SceneView& scene = townhouse().view();
    const std::vector<SavedView> views = tools::make_tour(scene, {2000, 10});
    std::set<std::uint32_t> storeys;
    std::set<accel::SpaceId> rooms;
    for (std::size_t k = 0; k < views.size(); ++k) {
        const accel::Cell& cell = scene.cells[index(views[k].cell)];
        storeys.insert(scene.spaces[index(cell.space)].storey_index);
        if (cell.label == Label::Room) rooms.insert(cell.space);
        if (k == 0) continue;
        // A film: small steps, nothing between one eye and the next, and no turn that startles.
        const Vec3d step = views[k].camera.eye - views[k - 1].camera.eye;
        EXPECT_LT(render::length(step), 0.3) << k;
        const render::Place next = render::move_camera(scene, {views[k - 1].camera.eye, views[k - 1].cell}, step, 0);
        EXPECT_LT(render::length(next.point - views[k].camera.eye), 1e-6) << k;
        const Vec3d look = render::normalized(views[k].camera.target - views[k].camera.eye);
        const Vec3d before = render::normalized(views[k - 1].camera.target - views[k - 1].camera.eye);
        EXPECT_GT(render::dot(look, before), 0.85) << k << ' ' << views[k].name;
    }
    EXPECT_EQ(storeys, (std::set<std::uint32_t>{0, 1}));
    EXPECT_GE(rooms.size(), 10u);
    EXPECT_EQ(scene.cells[index(views.front().cell)].label, Label::Door);
}

TEST(Tour, ClimbsTheStairsEvenly) {
    const accel::SceneView& scene = townhouse().view();
    const std::vector<SavedView> views = tools::make_tour(scene, {2000, 10});
    double climbed = 0, run = 0;
    for (std::size_t k = 1; k < views.size(); ++k) {
        const Vec3d step = views[k].camera.eye - views[k - 1].camera.eye;
        if (!(step.z > 0.001)) continue;
        climbed += step.z;
        run += std::hypot(step.x, step.y);
    }
    EXPECT_NEAR(climbed, 2.9, 0.05) << "the upper floor lies at 2.9 m";
    EXPECT_GT(run, 1.8) << "the stairwell is 3.2 m long";
}

TEST(Tour, NamesAreThoseOfTheRoomsAndNoneTwice) {
    const std::vector<SavedView> views = tools::make_tour(townhouse().view(), {40, 10});
    std::set<std::string> names;
    for (const SavedView& view : views) EXPECT_TRUE(names.insert(view.name).second) << view.name;
    EXPECT_TRUE(names.contains("Landing"));
    EXPECT_TRUE(names.contains("Landing 2"));
}

TEST(Tour, OneViewAndOneRoomAreATourToo) {
    const std::vector<SavedView> views = tools::make_tour(townhouse().view(), {1, 1});
    ASSERT_EQ(views.size(), 1u);
    EXPECT_EQ(townhouse().view().cells[index(views[0].cell)].label, Label::Door);
}

TEST(Tour, ABuildingWithoutARoomToWalkInIsRefused) {
    const accel::Scene scene = scene_of(plans::read_json(R"({"format_version": 1, "storeys": [{"id": "g",
        "elevation": 0, "height": 1.2, "walls": [
        {"id": "a", "start": [0, 0], "end": [4, 0], "thickness": 0.2, "height": 1.2},
        {"id": "b", "start": [4, 0], "end": [4, 4], "thickness": 0.2, "height": 1.2},
        {"id": "c", "start": [4, 4], "end": [0, 4], "thickness": 0.2, "height": 1.2},
        {"id": "d", "start": [0, 4], "end": [0, 0], "thickness": 0.2, "height": 1.2}],
        "rooms": [{"id": "r", "name": "Crawl space", "polygon": [[0.2, 0.2], [3.8, 0.2], [3.8, 3.8], [0.2, 3.8]]}]}]})",
                                                         "low.json"));
    try {
        (void)tools::make_tour(scene.view());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, "F137");
    }
}

class TourCommand : public OfficeTest {};

TEST_F(TourCommand, WritesAFileThatRenderTakes) {
    const Outcome outcome = run({"tour", "office.enf", "-o", "office.views.json", "--views", "5", "--rooms", "3"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("5 views"), std::string::npos) << outcome.out;
    EXPECT_EQ(nlohmann::json::parse(read_bytes(folder() / "office.views.json"))["views"].size(), 5u);
    const Outcome pictures =
        run({"render", "office.enf", "--views", "office.views.json", "-o", "office/", "--size", "16x16", "--spp", "1"});
    ASSERT_EQ(pictures.exit_code, 0) << pictures.err;
    EXPECT_EQ(pictures.err, "") << "no cell is stale";
}

TEST_F(TourCommand, SaysTheSameTwiceAndAsJson) {
    ASSERT_EQ(run({"tour", "office.enf", "-o", "a.json", "--quiet"}).out, "");
    const Outcome outcome = run({"tour", "office.enf", "-o", "b.json", "--json"});
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["views"].size(), 24u);
    EXPECT_EQ(read_bytes(folder() / "a.json"), read_bytes(folder() / "b.json"));
}

TEST_F(TourCommand, RefusesWhatIsWrong) {
    EXPECT_EQ(run({"tour", "office.enf"}).exit_code, 2);
    EXPECT_EQ(run({"tour", "office.enf", "-o", "x.json", "--views", "0"}).exit_code, 2);
    EXPECT_EQ(run({"tour", "office.enf", "-o", "x.json", "--rooms", "0"}).exit_code, 2);
    EXPECT_EQ(run({"tour", "office.enf", "-o", "absent/x.json"}).exit_code, 3);
    EXPECT_EQ(run({"tour", "absent.enf", "-o", "x.json"}).exit_code, 3);
    EXPECT_EQ(run({"tour", "office.json", "-o", "x.json"}).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder() / "x.json"));
}

}  // namespace
}  // namespace enfilade::test
