// Pictures of mirrors, glass and textures: what a pixel shows is known from where its ray goes.
#include <gtest/gtest.h>

#include <cmath>

#include "accel/assemble.h"
#include "accel/srgb.h"
#include "accel/texture_chain.h"
#include "render/trace.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using test::grid;

/// Colours as they are: light that comes from everywhere, and nothing that darkens.
TraceOptions flat_light() {
    TraceOptions options;
    options.look.ambient = {1, 1, 1};
    options.look.ambient_samples = 0;
    options.look.sun = {0, 0, 0};
    options.look.headlight = 0;
    options.look.shoulder = 1;
    return options;
}

/// A closed room of 8 x 8 x 4 m about (0, 0, 2), every source face with a material of its own: floor, walls, ceiling.
accel::SceneInput room() {
    accel::SceneInput input =
        test::scene_from_plots({{grid(-4), grid(-4), grid(4), grid(4), {{.z_floor = grid(0), .z_ceiling = grid(4)}}}});
    input.cell_objects.resize(input.cells.size());
    input.materials.clear();
    for (std::size_t f = 0; f < input.source_faces.size(); ++f) {
        input.source_faces[f].material = static_cast<std::uint32_t>(f);
        input.materials.push_back({"face " + std::to_string(f), {0.125f * float(f + 1), 0.5f, 0.25f}});
    }
    return input;
}

/// The material behind the point (x, y, z) of the room's border.
std::uint32_t material_at(const accel::SceneInput& input, double x, double y, double z) {
    for (const accel::InputSourceFace& face : input.source_faces) {
        const auto* v = input.vertices.data() + face.first_vertex;
        const auto all = [&](std::size_t axis, double value) {
            for (std::size_t k = 0; k < 4; ++k)
                if (v[k][axis] != grid(value)) return false;
            return true;
        };
        if (all(0, x) || all(1, y) || all(2, z)) return face.material;
    }
    ADD_FAILURE() << "no face there";
    return 0;
}

constexpr double nowhere = 1e4;

void add(accel::SceneInput& input, accel::InputMesh mesh) {
    const auto i = static_cast<std::uint32_t>(input.meshes.size());
    input.meshes.push_back(std::make_shared<accel::InputMesh>(std::move(mesh)));
    accel::InputObject object;
    object.id = "object " + std::to_string(1000 + i);
    object.mesh = i;
    object.scene_from_object = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    input.objects.push_back(object);
    input.cell_objects[0].push_back(i);
}

/// A sheet across the room at x.
accel::InputMesh sheet(float x, std::uint32_t material) {
    accel::InputMesh mesh =
        test::soup({{{{x, -3, 0.5f}, {x, 3, 0.5f}, {x, 3, 3.5f}}}, {{{x, -3, 0.5f}, {x, 3, 3.5f}, {x, -3, 3.5f}}}});
    mesh.triangle_materials.assign(2, material);
    return mesh;
}

std::uint32_t add_material(accel::SceneInput& input, std::array<float, 3> colour, accel::InputLook look) {
    input.materials.push_back({"m" + std::to_string(input.materials.size()), colour, look});
    return static_cast<std::uint32_t>(input.materials.size() - 1);
}

/// What one looks at from (0, 0, 2) along a direction.
Vec3f seen(const accel::SceneInput& input, Vec3d way, TraceOptions options = flat_light(), Vec3d eye = {0, 0, 2}) {
    const accel::Scene scene = accel::assemble(input);
    Camera camera;
    camera.eye = eye;
    camera.target = eye + way;
    camera.up = std::abs(way.z) > 0.9 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
    camera.fov_deg = 0.01;
    camera.width = camera.height = 1;
    return trace(scene.view(), camera, options).pixel(0, 0);
}

void expect_near(Vec3f a, Vec3f b, float by) {
    EXPECT_NEAR(a.x, b.x, by);
    EXPECT_NEAR(a.y, b.y, by);
    EXPECT_NEAR(a.z, b.z, by);
}

Vec3f colour(const accel::SceneInput& input, std::uint32_t material) {
    const auto& c = input.materials[material].colour;
    return {c[0], c[1], c[2]};
}

TEST(Surfaces, WithoutLooksShowTheirColours) {
    const accel::SceneInput input = room();
    expect_near(seen(input, {1, 0, 0}), colour(input, material_at(input, 4, nowhere, nowhere)), 1e-5f);
    expect_near(seen(input, {0, 0, -1}), colour(input, material_at(input, nowhere, nowhere, 0)), 1e-5f);
}

TEST(Mirrors, OnWallsShowTheWallBehindTheEye) {
    accel::SceneInput input = room();
    const std::uint32_t east = material_at(input, 4, nowhere, nowhere);
    const Vec3f west = colour(input, material_at(input, -4, nowhere, nowhere));
    input.materials[east].look.mirror = 0.75f;
    expect_near(seen(input, {1, 0.1, 0.05}), 0.75f * west + 0.25f * colour(input, east), 1e-5f);
}

TEST(Mirrors, OnFurnitureShowTheWallBehindTheEye) {
    accel::SceneInput input = room();
    const std::uint32_t silver = add_material(input, {0.5f, 0.5f, 0.5f}, {.mirror = 1});
    add(input, sheet(2, silver));
    expect_near(seen(input, {1, 0.1, 0.05}), colour(input, material_at(input, -4, nowhere, nowhere)), 1e-5f);
}

TEST(Mirrors, InMirrorsEnd) {
    accel::SceneInput input = room();
    for (accel::InputMaterial& material : input.materials) material.look.mirror = 1;
    const Vec3f all_mirrors = seen(input, {1, 0.3, 0.2});
    EXPECT_TRUE(std::isfinite(all_mirrors.x) && all_mirrors.x >= 0 && all_mirrors.x <= 1);
    // Two that face each other at a half: the sum of what is left at each.
    accel::SceneInput two = room();
    const std::uint32_t east = material_at(two, 4, nowhere, nowhere), west = material_at(two, -4, nowhere, nowhere);
    two.materials[east].look.mirror = two.materials[west].look.mirror = 0.5f;
    const Vec3f limit = (2.0f / 3) * colour(two, east) + (1.0f / 3) * colour(two, west);
    expect_near(seen(two, {1, 0, 0}), limit, 1.0f / 256);
}

TEST(Mirrors, OnFloorsBesideThoseAskedForByShare) {
    accel::SceneInput input = room();
    const std::uint32_t floor = material_at(input, nowhere, nowhere, 0);
    const Vec3f ceiling = colour(input, material_at(input, nowhere, nowhere, 4));
    input.materials[floor].look.mirror = 0.5f;
    expect_near(seen(input, {0.1, 0, -1}), 0.5f * ceiling + 0.5f * colour(input, floor), 1e-5f);
    TraceOptions options = flat_light();
    options.mirror_floor = 0.25f;
    expect_near(seen(input, {0.1, 0, -1}, options), 0.25f * ceiling + 0.75f * colour(input, floor), 1e-5f);
}

TEST(Glass, OfFurnitureTintsLayerByLayer) {
    for (const int layers : {1, 2, 5, 12}) {
        accel::SceneInput input = room();
        const std::uint32_t glass = add_material(input, {0.5f, 0.5f, 0.5f}, {.through = {0.9f, 0.95f, 1}});
        for (int i = 0; i < layers; ++i) add(input, sheet(1 + 0.01f * float(i), glass));
        const Vec3f wall = colour(input, material_at(input, 4, nowhere, nowhere));
        const auto part = [&](float tint) { return std::pow(tint, float(layers)); };
        expect_near(seen(input, {1, 0.1, 0.05}), Vec3f{part(0.9f), part(0.95f), 1} * wall, 1e-4f);
    }
}

TEST(Glass, ThatIsHalfThereShowsItsColour) {
    accel::SceneInput input = room();
    const std::uint32_t veil = add_material(input, {1, 0, 0}, {.through = {0.25f, 0.25f, 0.25f}});
    add(input, sheet(2, veil));
    const Vec3f wall = colour(input, material_at(input, 4, nowhere, nowhere));
    expect_near(seen(input, {1, 0.1, 0.05}), 0.75f * Vec3f{1, 0, 0} + 0.25f * wall, 1e-4f);
}

TEST(Glass, OfFurnitureLetsLampsShineThrough) {
    const auto lit = [](std::array<float, 3> through) {
        accel::SceneInput input = room();
        const std::uint32_t pane = add_material(input, {0.5f, 0.5f, 0.5f}, {.through = through});
        add(input, sheet(2, pane));
        add(input, sheet(1.9f, pane));
        input.lights.push_back({.id = "lamp", .position = {3, 0, 2}, .intensity = {100, 100, 100}});
        TraceOptions options = flat_light();
        options.shading = Shading::Lambert;
        options.lamps = LampOptions{.search = LampSearch::Naive};
        return seen(input, {-1, 0.2, -0.1}, options).x;
    };
    EXPECT_EQ(lit({0, 0, 0}), 0);
    EXPECT_GT(lit({0.9f, 0.9f, 0.9f}), 0.01f);
}

std::uint32_t add_stripes(accel::SceneInput& input) {
    // Columns of red, green, blue and grey; the lower half is dark.
    std::vector<std::array<std::uint8_t, 4>> pixels;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const auto b = static_cast<std::uint8_t>(y < 32 ? 255 : 100);
            const int column = x / 16;
            pixels.push_back({column == 0 || column == 3 ? b : std::uint8_t{0}, column % 2 == 1 ? b : std::uint8_t{0},
                              column >= 2 ? b : std::uint8_t{0}, 255});
        }
    input.textures.push_back(std::make_shared<accel::InputTexture>(accel::texture_chain("s", 64, 64, pixels, 4096)));
    return static_cast<std::uint32_t>(input.textures.size() - 1);
}

/// The colour of a column of those stripes.
Vec3f stripe(int column, bool is_upper) {
    const float b = accel::linear_of_byte(is_upper ? 255 : 100);
    return {column == 0 || column == 3 ? b : 0.0f, column % 2 == 1 ? b : 0.0f, column >= 2 ? b : 0.0f};
}

// A texture of 4 m a repeat on the east wall: u to the right as one looks at it, that is towards -y.
TEST(Textures, LieOnWallsUprightAndUnmirrored) {
    accel::SceneInput input = room();
    const std::uint32_t east = material_at(input, 4, nowhere, nowhere);
    input.materials[east].look.texture = add_stripes(input);
    input.materials[east].look.texture_from_face = {0.25f, 0, 0, 0, -0.25f, 0};
    for (accel::InputSourceFace& face : input.source_faces)
        if (face.material == east) face.frame = {0, -1, 0, 0};
    // Metres to the right of the middle, and up from the floor.
    for (const double right : {-3.5, -2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5})
        for (const double up : {0.5, 1.5, 2.5, 3.5}) {
            const int column = static_cast<int>(std::floor(right + 4)) % 4;
            expect_near(seen(input, {4, -right, up - 2}), stripe(column, up > 2), 1e-4f);
        }
}

TEST(Textures, LieOnFloorsByOffsetAndAngle) {
    accel::SceneInput input = room();
    const std::uint32_t floor = material_at(input, nowhere, nowhere, 0);
    input.materials[floor].look.texture = add_stripes(input);
    // Turned by a quarter: its right is the plan's y; 4 m a repeat, moved by one column.
    input.materials[floor].look.texture_from_face = {0, 0.25f, 0.25f, 0.25f, 0, 0};
    for (const double y : {-3.5, -2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5})
        for (const double x : {-3.0, -1.0, 1.0, 3.0}) {
            const int column = static_cast<int>(std::floor(y + 4) + 1) % 4;
            const bool is_upper = std::fmod(x + 8, 4) < 2;
            expect_near(seen(input, {x, y, -2}), stripe(column, is_upper), 1e-4f);
        }
}

TEST(Textures, LieOnTrianglesByTheirCorners) {
    accel::SceneInput input = room();
    accel::InputLook look;
    look.texture = add_stripes(input);
    accel::InputMesh mesh = sheet(2, add_material(input, {0, 0, 0}, look));
    // Seen from -x its right is -y: u from 0 at y = 3 to 1 at y = -3, v from 0 at the bottom to 1 at the top.
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            mesh.texcoords.push_back({(3 - mesh.vertices[v][1]) / 6, (mesh.vertices[v][2] - 0.5f) / 3});
    add(input, mesh);
    for (int column = 0; column < 4; ++column)
        for (const bool is_upper : {false, true}) {
            const double y = 3 - 1.5 * (column + 0.5), z = is_upper ? 2.75 : 1.25;
            expect_near(seen(input, {2, y, z - 2}), stripe(column, is_upper), 1e-4f);
        }
}

TEST(Textures, WithHolesShowWhatIsBehind) {
    accel::SceneInput input = room();
    input.textures.push_back(std::make_shared<accel::InputTexture>(
        accel::texture_chain("hole", 1, 1, std::vector<std::array<std::uint8_t, 4>>{{255, 255, 255, 0}}, 16)));
    accel::InputMesh mesh = sheet(2, add_material(input, {0, 0, 0}, {.texture = 0}));
    mesh.texcoords.assign(6, {0.5f, 0.5f});
    add(input, mesh);
    expect_near(seen(input, {1, 0.1, 0.05}), colour(input, material_at(input, 4, nowhere, nowhere)), 1e-5f);
}

// From afar and aslant a pixel covers many repeats: it shows their mean, whichever way the picture is sampled.
TEST(Textures, FromAfarAreCalm) {
    accel::SceneInput input = room();
    const std::uint32_t floor = material_at(input, nowhere, nowhere, 0);
    input.materials[floor].look.texture = add_stripes(input);
    input.materials[floor].look.texture_from_face = {200, 0, 0, 0, -200, 0};  // 5 mm a repeat
    const accel::Scene scene = accel::assemble(input);
    const float half = 0.5f * 0.5f * (1 + accel::linear_of_byte(100));
    const Vec3f mean = {half, half, half};
    Camera camera;
    camera.eye = {-3.5, 0, 1.5};
    camera.target = {-1.5, 0, 0};
    camera.fov_deg = 30;
    camera.width = camera.height = 24;
    const Image image = trace(scene.view(), camera, flat_light());
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) expect_near(image.pixel(x, y), mean, 0.02f);
}

TEST(Textures, DoNotChangePicturesByThreads) {
    accel::SceneInput input = room();
    for (accel::InputMaterial& material : input.materials) material.look.texture = 0;
    (void)add_stripes(input);
    const accel::Scene scene = accel::assemble(input);
    Camera camera;
    camera.width = camera.height = 150;
    TraceOptions serial = flat_light();
    const accel::SerialExecutor one;
    serial.executor = &one;
    const Image a = trace(scene.view(), camera, serial), b = trace(scene.view(), camera, flat_light());
    EXPECT_EQ(a.rgb, b.rgb);
}

}  // namespace
}  // namespace enfilade::render
