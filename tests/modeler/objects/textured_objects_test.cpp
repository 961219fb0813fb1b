// Textures, mirrors and glass of furniture: from meshes into scenes, and back for those who edit them.
#include <gtest/gtest.h>

#include <algorithm>

#include "accel/texture_chain.h"
#include "modeler/certify.h"
#include "modeler/export_scene.h"
#include "modeler/model_group.h"
#include "modeler/objects/put_objects.h"
#include "tests/support/furnished_scenes.h"

namespace enfilade::modeler {
namespace {

std::shared_ptr<const accel::InputTexture> picture(const char* name, std::uint32_t side, std::uint8_t grey) {
    const std::vector<std::array<std::uint8_t, 4>> pixels(std::size_t{side} * side, {grey, grey, 9, 255});
    return std::make_shared<const accel::InputTexture>(accel::texture_chain(name, side, side, pixels, 64));
}

/// A furnished house whose first two meshes share a picture, one as a copy of its own, and are part mirror, part glass.
Building textured_house() {
    Building building = test::furnished(test::house(test::FurnishedHouse::Townhouse), 5, 60, ObjectCells::List);
    for (std::size_t k = 0; k < 2; ++k) {
        auto mesh = std::make_shared<ObjectMesh>(*building.furnishing.meshes[k]);
        mesh->textures = {picture("cloth.png", 8, 100)};
        if (k == 0) mesh->textures.insert(mesh->textures.begin(), picture("wood.jpg", 4, 200));
        for (std::size_t c = 0; c < 3 * mesh->triangles.size(); ++c)
            mesh->texcoords.push_back({float(c % 7) / 4, -float(c % 5)});
        mesh->materials[0].look.texture = 0;
        mesh->materials[1].look.texture = k == 0 ? 1 : 0;
        mesh->materials[1].look.through = {0.25f, 0.5f, 0.25f};
        mesh->materials[2].look.mirror = 0.5f;
        building.furnishing.meshes[k] = mesh;
    }
    return building;
}

TEST(TexturedObjects, EqualPicturesAreInTheSceneOnce) {
    const accel::Scene scene = export_scene(textured_house(), check(textured_house()), "{}");
    const accel::SceneView& view = scene.view();
    ASSERT_EQ(view.textures.size(), 2u);
    ASSERT_EQ(view.material_looks.size(), view.materials.size());
    std::size_t textured = 0, mirrors = 0, panes = 0;
    for (const accel::MaterialLook& look : view.material_looks) {
        textured += look.texture != none<accel::TextureId> ? 1 : 0;
        mirrors += look.mirror == 0.5f ? 1 : 0;
        panes += look.through[1] == 0.5f ? 1 : 0;
    }
    EXPECT_EQ(textured, 4u);
    EXPECT_EQ(mirrors, 1u) << "materials that are equal are one";
    EXPECT_EQ(panes, 2u);
    EXPECT_TRUE(view.face_frames.empty());
}

TEST(TexturedObjects, ComeBackFromTheFileAndAreCertified) {
    const Building building = textured_house();
    const accel::Scene scene = export_scene(building, check(building), "{}");
    const Building again = read_model(scene);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(again.furnishing.meshes[k]->texcoords, building.furnishing.meshes[k]->texcoords);
        for (const ObjectMaterial& material : again.furnishing.meshes[k]->materials) {
            if (material.look.texture == UINT32_MAX) continue;
            ASSERT_LT(material.look.texture, again.furnishing.meshes[k]->textures.size());
        }
    }
    const accel::Scene second = export_scene(again, check(again), "{}");
    EXPECT_TRUE(std::ranges::equal(scene.bytes(), second.bytes()));
    EXPECT_EQ(certify(scene).verdict, "certified");
}

}  // namespace
}  // namespace enfilade::modeler
