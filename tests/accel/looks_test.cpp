// Mirrors, glass and textures in scene files: what is laid out, what is refused, and that no damage crashes.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "accel/stats.h"
#include "accel/texture_chain.h"
#include "accel/validate.h"
#include "base/error.h"
#include "tests/support/damaged_scene.h"
#include "tests/support/synthetic_objects.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Two textures on materials of walls and objects, a mirror and a glass.
SceneInput input_with_looks() {
    SceneInput input = test::with_objects(test::synthetic_office({.rooms_per_row = 2, .rows = 2}), 1, 40);
    for (const std::uint32_t side : {8u, 5u})
        input.textures.push_back(std::make_shared<const InputTexture>(
            texture_chain("t" + std::to_string(side), side, 3,
                          std::vector<std::array<std::uint8_t, 4>>(std::size_t{side} * 3, {9, 99, 199, 255}), 1024)));
    input.materials[0].look.texture = 0;
    input.materials[1].look.mirror = 0.5f;
    input.materials.back().look.through = {0.25f, 0.5f, 0.75f};
    input.materials.back().look.texture = 1;
    auto mesh = std::make_shared<InputMesh>(*input.meshes[1]);
    mesh->texcoords.assign(3 * mesh->triangles.size(), {0.25f, -2.5f});
    input.meshes[1] = mesh;
    return input;
}

std::vector<std::byte> sound_bytes() {
    const Scene scene = assemble(input_with_looks());
    return {scene.bytes().begin(), scene.bytes().end()};
}

template <class T, class Change>
std::string defect_with(const char* name, std::size_t i, Change change) {
    static const test::DamagedScene scene(assemble(input_with_looks()));
    return scene.first_defect<T>(name, i, change);
}

TEST(LooksInScenes, AreLaidOutAsTheyWereGiven) {
    const SceneInput input = input_with_looks();
    const Scene scene = assemble(input);
    const SceneView& view = scene.view();
    ASSERT_EQ(view.material_looks.size(), input.materials.size());
    EXPECT_EQ(view.material_looks[1].mirror, 0.5f);
    EXPECT_EQ(view.material_looks[1].texture, none<TextureId>);
    EXPECT_EQ(view.material_looks[input.materials.size() - 1].through[1], 0.5f);
    ASSERT_EQ(view.textures.size(), 2u);
    EXPECT_EQ(view.string(view.textures[1].name), "t5");
    EXPECT_EQ(view.textures[1].first_texel, input.textures[0]->texels.size());
    EXPECT_EQ(view.texels[3].b, 199);
    EXPECT_EQ(view.meshes[0].texcoords, 0u);
    EXPECT_EQ(view.meshes[1].texcoords, 1u);
    EXPECT_EQ(view.mesh_texcoords.size(), 3u * view.meshes[1].triangle_count);
    EXPECT_EQ(view.face_frames.size(), view.source_face_count());
    EXPECT_EQ(stats(scene).textures, 2u);
    EXPECT_EQ(stats(scene).texture_bytes, view.material_looks.size() * 48 + 2 * 16 + view.texels.size() * 4 +
                                              view.mesh_texcoords.size() * 8 + view.face_frames.size() * 16);
}

TEST(LooksInScenes, PlainColoursTakeNoArray) {
    const Scene scene = assemble(test::with_objects(test::synthetic_office({.rooms_per_row = 2, .rows = 2}), 1, 40));
    EXPECT_FALSE(scene.view().has_looks());
    EXPECT_EQ(scene.find("material_looks"), nullptr);
    EXPECT_EQ(scene.find("face_frames"), nullptr);
    EXPECT_EQ(stats(scene).texture_bytes, 0u);
}

TEST(LooksInScenes, FaceFramesAreThereForFacesAlone) {
    SceneInput input = input_with_looks();
    input.materials[0].look.texture = UINT32_MAX;
    EXPECT_TRUE(assemble(input).view().face_frames.empty());
}

TEST(LooksInScenes, EveryIndexIsChecked) {
    EXPECT_EQ(defect_with<MaterialLook>("material_looks", 0, [](MaterialLook&) {}), "");
    EXPECT_EQ(defect_with<MaterialLook>("material_looks", 0, [](MaterialLook& l) { l.texture = TextureId{2}; }), "F4");
    EXPECT_EQ(defect_with<Texture>("textures", 1, [](Texture& t) { t.first_texel += 1; }), "F4");
    EXPECT_EQ(defect_with<Texture>("textures", 1, [](Texture& t) { t.width = 65535; }), "F4");
    EXPECT_EQ(defect_with<Texture>("textures", 1, [](Texture& t) { t.height = 0; }), "F4");
    EXPECT_EQ(defect_with<Texture>("textures", 1, [](Texture& t) { t.level_count -= 1; }), "F4");
    EXPECT_EQ(defect_with<Texture>("textures", 0, [](Texture& t) { t.name = none<TextId>; }), "F4");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 1, [](ObjectMesh& m) { m.texcoords = 2; }), "F4");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 1, [](ObjectMesh& m) { m.texcoords = 0; }), "F4");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 0, [](ObjectMesh& m) { m.texcoords = UINT32_MAX; }), "F4");
}

TEST(LooksInScenes, EveryNumberIsChecked) {
    for (const float bad : {nan, -0.5f, 1.5f, std::numeric_limits<float>::infinity()}) {
        EXPECT_EQ(defect_with<MaterialLook>("material_looks", 1, [&](MaterialLook& l) { l.mirror = bad; }), "F5");
        EXPECT_EQ(defect_with<MaterialLook>("material_looks", 1, [&](MaterialLook& l) { l.through[2] = bad; }), "F5");
    }
    EXPECT_EQ(defect_with<MaterialLook>("material_looks", 1, [](MaterialLook& l) { l.through[0] = 0.625f; }), "F5")
        << "more light than there is";
    for (const float bad : {nan, 1e30f}) {
        const auto row = [&](MaterialLook& l) { l.texture_from_face[5] = bad; };
        EXPECT_EQ(defect_with<MaterialLook>("material_looks", 1, row), "F5");
        EXPECT_EQ(defect_with<TexCoord>("mesh_texcoords", 4, [&](TexCoord& t) { t.v = bad; }), "F5");
        EXPECT_EQ(defect_with<FaceFrame>("face_frames", 4, [&](FaceFrame& f) { f.u_0 = bad; }), "F5");
    }
    EXPECT_EQ(defect_with<FaceFrame>("face_frames", 4, [](FaceFrame& f) { f.x_u = 2; }), "F5");
}

TEST(LooksInScenes, DescriptionsOfNoTextureAreRefused) {
    const auto code_with = [](auto change) -> std::string {
        SceneInput input = input_with_looks();
        change(input);
        try {
            (void)assemble(input);
            return "";
        } catch (const InputError& error) {
            return error.code;
        }
    };
    EXPECT_EQ(code_with([](SceneInput&) {}), "");
    EXPECT_EQ(code_with([](SceneInput& s) { s.textures.pop_back(); }), "F4");
    EXPECT_EQ(code_with([](SceneInput& s) {
                  auto t = std::make_shared<InputTexture>(*s.textures[0]);
                  t->texels.pop_back();
                  s.textures[0] = t;
              }),
              "F4");
    EXPECT_EQ(code_with([](SceneInput& s) {
                  auto m = std::make_shared<InputMesh>(*s.meshes[1]);
                  m->texcoords.pop_back();
                  s.meshes[1] = m;
              }),
              "F10");
}

// Damage anywhere in these arrays is refused or harmless: whatever passes can be read without leaving an array.
TEST(LooksInScenes, RandomDamageNeverPassesOutOfRange) {
    const std::vector<std::byte> bytes = sound_bytes();
    std::mt19937_64 random(8);
    for (int i = 0; i < 3000; ++i) {
        const Scene scene = read(bytes);
        const char* names[] = {"material_looks", "textures", "mesh_texcoords", "face_frames", "meshes"};
        const SceneArray& array = *scene.find(names[random() % 5]);
        auto* at = const_cast<std::byte*>(array.bytes.data()) + random() % array.bytes.size();
        *at = static_cast<std::byte>(random());
        if (!validate(scene.view()).empty()) continue;
        const SceneView& v = scene.view();
        for (const Texture& t : v.textures) ASSERT_LE(t.first_texel + texel_count(t.width, t.height), v.texels.size());
        for (const MaterialLook& look : v.material_looks)
            ASSERT_TRUE(look.texture == none<TextureId> || index(look.texture) < v.textures.size());
        for (const ObjectMesh& mesh : v.meshes) {
            ASSERT_TRUE(mesh.texcoords == 0 ||
                        mesh.texcoords - 1 + 3 * std::uint64_t{mesh.triangle_count} <= v.mesh_texcoords.size());
        }
    }
}

}  // namespace
}  // namespace enfilade::accel
