// Textures of walls, floors and ceilings: where they lie, where their pictures come from, and that scenes give them
// back.
#include "modeler/surface_textures.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "accel/texture_chain.h"
#include "modeler/build.h"
#include "modeler/certify.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/face_label.h"
#include "modeler/model_group.h"
#include "plans/read.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::modeler {
namespace {

std::string png(std::uint8_t grey) {
    const std::vector<std::uint8_t> pixels(4 * 3, grey);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 2;
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr), 0);
    std::string bytes(size, '\0');
    EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr), 0);
    bytes.resize(size);
    return bytes;
}

/// A room of 4 x 3 m far from the origin of its plan's frame, in a wall of which is a door.
std::string room_plan(const std::string& south, const std::string& room) {
    return R"({"storeys": [{"id": "g", "name": "ground", "height": 2.5, "elevation": 1,
        "walls": [{"id": "s", "start": [10, 5], "end": [14, 5], "thickness": 0.2)" +
           south + R"(},
                  {"id": "e", "start": [14, 5], "end": [14, 8], "thickness": 0.2, "left_colour": "#3366ff"},
                  {"id": "n", "start": [14, 8], "end": [10, 8], "thickness": 0.2},
                  {"id": "w", "start": [10, 8], "end": [10, 5], "thickness": 0.2}],
        "openings": [{"id": "d", "kind": "door", "wall": "s", "offset": 1.5, "width": 1, "head": 2}],
        "rooms": [{"id": "r", "polygon": [[10, 5], [14, 5], [14, 8], [10, 8]])" +
           room + "}]}]}";
}

std::string texture(const std::string& key, const std::string& picture, const std::string& size) {
    return ", \"" + key + "\": {\"picture\": \"" + picture + "\", " + size + "}";
}

/// The convex building of a plan, its pictures made from nothing.
Building textured(const std::string& plan, const std::vector<std::string>& names) {
    Building building = convexify(build(plans::read_json(plan, "plan.json")));
    const std::vector<std::array<std::uint8_t, 4>> pixels(4, {200, 100, 50, 255});
    for (const std::string& name : names)
        building.pictures.push_back(
            std::make_shared<const accel::InputTexture>(accel::texture_chain(name, 2, 2, pixels, 64)));
    return building;
}

/// A corner of a textured face, in the plan's metres, and where it is on the texture, in repeats right and down.
struct LaidCorner {
    Surface surface;
    std::array<double, 3> at;
    double s, t;
};

std::vector<LaidCorner> laid_corners(const accel::SceneInput& input) {
    std::vector<LaidCorner> corners;
    for (std::size_t f = 0; f < input.source_faces.size(); ++f) {
        const accel::InputSourceFace& face = input.source_faces[f];
        const accel::InputLook& look = input.materials[face.material].look;
        if (look.texture == UINT32_MAX) continue;
        const std::size_t end =
            f + 1 < input.source_faces.size() ? input.source_faces[f + 1].first_vertex : input.vertices.size();
        const bool is_level = face.surface == Surface::Floor || face.surface == Surface::Ceiling;
        const auto& [x_u, y_u, u_0, v_0] = face.frame;
        const auto& m = look.texture_from_face;
        for (std::size_t k = face.first_vertex; k < end; ++k) {
            std::array<double, 3> p;  // of the scene's frame
            for (std::size_t i = 0; i < 3; ++i) p[i] = input.unit * input.vertices[k][i];
            const double u = x_u * p[0] + y_u * p[1] + u_0;
            const double v = v_0 + (is_level ? -y_u * p[0] + x_u * p[1] : p[2]);
            corners.push_back({face.surface,
                               {p[0] + input.origin[0], p[1] + input.origin[1], p[2] + input.origin[2]},
                               m[0] * u + m[1] * v + m[2],
                               m[3] * u + m[4] * v + m[5]});
        }
    }
    return corners;
}

TEST(SurfaceTextures, StandOnTheFloorFromTheStartOfTheirWall) {
    const std::string both = texture("left_texture", "brick", R"("width": 0.5, "height": 0.25)") +
                             texture("right_texture", "stone", R"("width": 2, "height": 1, "offset": [0.5, 0.25])");
    const accel::SceneInput input = scene_input(textured(room_plan(both, ""), {"brick", "stone"}));
    std::size_t inside = 0, outside = 0;
    for (const LaidCorner& corner : laid_corners(input)) {
        const double along = corner.at[0] - 10, up = corner.at[2] - 1;
        if (corner.surface == Surface::WallPaper) {  // looking south, west is on the right
            ++inside;
            EXPECT_NEAR(corner.s, -along / 0.5, 1e-3);
            EXPECT_NEAR(corner.t, -up / 0.25, 1e-3);
            EXPECT_NEAR(corner.at[1], 5.1, 1e-3) << "on another wall";
        } else {
            ++outside;
            EXPECT_EQ(corner.surface, Surface::Facade);
            EXPECT_NEAR(corner.s, (along - 1) / 2, 1e-3);
            EXPECT_NEAR(corner.t, -(up - 0.25) / 1, 1e-3);
            EXPECT_NEAR(corner.at[1], 4.9, 1e-3) << "on another wall";
        }
    }
    EXPECT_GE(inside, 12u) << "left of the door, right of it, and above";
    EXPECT_GE(outside, 12u);
}

TEST(SurfaceTextures, GoOnOverTheStepsOfASlope) {
    const std::string sloped = R"(, "height_at_start": 2.5, "height_at_end": 1.5)" +
                               texture("left_texture", "brick", R"("width": 0.5, "height": 0.25)") +
                               texture("right_texture", "stone", R"("width": 2, "height": 1, "angle_deg": 90)");
    const Building building = textured(room_plan(sloped, ""), {"brick", "stone"});
    std::size_t steps = 0;
    for (const Space& space : building.spaces) steps += space.label == Label::Wall && space.id.starts_with("s/");
    EXPECT_GE(steps, 3u);
    for (const LaidCorner& corner : laid_corners(scene_input(building))) {
        const double along = corner.at[0] - 10, up = corner.at[2] - 1;
        EXPECT_NEAR(corner.s, corner.surface == Surface::WallPaper ? -along / 0.5 : up / 2, 2e-3);
        EXPECT_NEAR(corner.t, corner.surface == Surface::WallPaper ? -up / 0.25 : along, 2e-3);
    }
}

TEST(SurfaceTextures, LieOnFloorsFromTheOriginOfThePlan) {
    const std::string floor = texture("floor_texture", "wood", R"("width": 1, "height": 2)");
    const std::string turned = texture("floor_texture", "wood", R"("width": 1, "height": 2, "angle_deg": 90,
                                       "offset": [0.25, 0])");
    const accel::SceneInput plain = scene_input(textured(room_plan("", floor), {"wood"}));
    ASSERT_FALSE(laid_corners(plain).empty());
    for (const LaidCorner& corner : laid_corners(plain)) {
        EXPECT_EQ(corner.surface, Surface::Floor);
        EXPECT_NEAR(corner.s, corner.at[0], 1e-3);
        EXPECT_NEAR(corner.t, -corner.at[1] / 2, 1e-3);
    }
    // A quarter to the left: the picture's right side looks north, its top west.
    for (const LaidCorner& corner : laid_corners(scene_input(textured(room_plan("", turned), {"wood"})))) {
        EXPECT_NEAR(corner.s, corner.at[1], 1e-3);
        EXPECT_NEAR(corner.t, (corner.at[0] - 0.25) / 2, 1e-3);
    }
}

TEST(SurfaceTextures, OfCeilingsAreUprightFromBelow) {
    const std::string ceiling = texture("ceiling_texture", "sky", R"("width": 1, "height": 1)");
    const auto corners = laid_corners(scene_input(textured(room_plan("", ceiling), {"sky"})));
    ASSERT_FALSE(corners.empty());
    for (const LaidCorner& corner : corners) {  // with north on top of what one sees, west is on the right
        EXPECT_EQ(corner.surface, Surface::Ceiling);
        EXPECT_NEAR(corner.s, -corner.at[0], 1e-3);
        EXPECT_NEAR(corner.t, -corner.at[1], 1e-3);
    }
}

TEST(SurfaceTextures, RunInMetresRoundArcs) {
    const std::string arc = R"(, "arc_extent_deg": 90)" + texture("left_texture", "a", R"("width": 1, "height": 1)") +
                            texture("right_texture", "a", R"("width": 1, "height": 1)");
    const accel::SceneInput input = scene_input(textured(room_plan(arc, ""), {"a"}));
    std::map<std::array<double, 3>, std::pair<double, double>> range;  // of s, by corner
    std::map<Surface, std::pair<double, double>> whole;
    for (const LaidCorner& corner : laid_corners(input)) {
        const auto widen = [&](auto& ranges, const auto& key) {
            const auto at = ranges.try_emplace(key, corner.s, corner.s).first;
            at->second = {std::min(at->second.first, corner.s), std::max(at->second.second, corner.s)};
        };
        widen(range, corner.at);
        widen(whole, corner.surface);
    }
    std::size_t shared = 0;
    for (const auto& [at, ends] : range) {
        EXPECT_NEAR(ends.first, ends.second, 3e-4) << "a seam at " << at[0] << ' ' << at[1];
        shared += ends.first != ends.second ? 1 : 0;
    }
    EXPECT_GT(shared, 10u);
    // Radius 2 sqrt(2) of the axis; the wall's outer face, on its right, is the longer one.
    const auto length = [&](Surface surface) { return whole.at(surface).second - whole.at(surface).first; };
    EXPECT_NEAR(length(Surface::Facade), (2 * std::sqrt(2.0) + 0.1) * std::numbers::pi / 2, 0.15);
    EXPECT_NEAR(length(Surface::WallPaper), (2 * std::sqrt(2.0) - 0.1) * std::numbers::pi / 2, 0.15);
}

TEST(SurfaceTextures, ComeBackFromTheFileAndAreCertified) {
    const std::string walls = texture("left_texture", "brick", R"("width": 0.5, "height": 0.25)");
    const std::string room = texture("floor_texture", "wood", R"("width": 1, "height": 2, "angle_deg": 30)");
    const Building building = textured(room_plan(walls, room), {"brick", "unseen", "wood"});
    const accel::Scene scene = export_scene(building, check(building), "{}");
    EXPECT_EQ(scene.view().textures.size(), 3u);
    EXPECT_EQ(scene.view().face_frames.size(), scene.view().source_face_count());
    const Building again = read_model(scene);
    const accel::Scene second = export_scene(again, check(again), "{}");
    EXPECT_TRUE(std::ranges::equal(scene.bytes(), second.bytes()));
    EXPECT_EQ(certify(scene).verdict, "certified");
}

TEST(SurfaceTextures, ThatNobodySeesComeBackToo) {
    const std::string nowhere = texture("ceiling_texture", "sky", R"("width": 1, "height": 1)") +
                                R"(, "kind": "courtyard")";  // open to the sky
    const Building building = textured(room_plan("", nowhere), {"sky"});
    const accel::Scene scene = export_scene(building, check(building), "{}");
    EXPECT_TRUE(scene.view().face_frames.empty());
    const Building again = read_model(scene);
    const accel::Scene second = export_scene(again, check(again), "{}");
    EXPECT_TRUE(std::ranges::equal(scene.bytes(), second.bytes()));
}

TEST(SurfaceTextures, AreReadFromBesideThePlanAndBelow) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "home/pictures");
    test::write_bytes(folder / "secret.png", png(10));
    test::write_bytes(folder / "home/pictures/wood.png", png(200));
    test::write_bytes(folder / "home/torn.png", png(90).substr(0, 40));
    const std::string walls = texture("left_texture", "../secret.png", R"("width": 1, "height": 1)") +
                              texture("right_texture", "torn.png", R"("width": 1, "height": 1)");
    const std::string room = texture("floor_texture", "pictures/wood.png", R"("width": 1, "height": 1)") +
                             texture("ceiling_texture", "absent.png", R"("width": 1, "height": 1)");
    test::write_bytes(folder / "home/plan.json", room_plan(walls, room));
    Building building = convexify(build(plans::read(folder / "home/plan.json")));
    read_surface_pictures(building, folder / "home/plan.json", 64);
    ASSERT_EQ(building.pictures.size(), 1u);
    EXPECT_EQ(building.pictures[0]->name, "pictures/wood.png");
    const auto told = std::ranges::count_if(building.findings, [](const Finding& f) { return f.code == "K160"; });
    EXPECT_EQ(told, 3);
    for (const LaidCorner& corner : laid_corners(scene_input(building))) EXPECT_EQ(corner.surface, Surface::Floor);
    building.pictures.clear();
    read_surface_pictures(building, folder / "home/plan.json", 0);
    EXPECT_TRUE(building.pictures.empty()) << "none were asked for";
}

TEST(SurfaceTextures, OfARealHomeLieOnItsWallsAndFloors) {
    const std::filesystem::path home = ENFILADE_SOURCE_DIR "/../shared/data/sh3d/andijcr_ristrutturazione_default.sh3d";
    if (!std::filesystem::exists(home)) GTEST_SKIP() << "no real homes beside this checkout (../shared/data/sh3d)";
    Building building = convexify(build(plans::read(home)));
    read_surface_pictures(building, home, 256);
    EXPECT_EQ(building.pictures.size(), 3u);
    std::map<Surface, std::size_t> corners;
    for (const LaidCorner& corner : laid_corners(scene_input(building))) ++corners[corner.surface];
    EXPECT_GT(corners[Surface::WallPaper] + corners[Surface::Facade], 80u);
    EXPECT_GT(corners[Surface::Floor], 10u);
    const accel::Scene scene = export_scene(building, check(building), "{}");
    const Building again = read_model(scene);
    EXPECT_TRUE(std::ranges::equal(scene.bytes(), export_scene(again, check(again), "{}").bytes()));
}

}  // namespace
}  // namespace enfilade::modeler
