#pragma once
// A furnished office with everything that a picture may show: lamps, mirrors, glass and textures of walls and
// furniture.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "tests/support/lit_scene.h"
#include "tests/support/object_scenes.h"

namespace enfilade::test {

class RichScene {
public:
    explicit RichScene(accel::Scene scene, int lamps = 9, std::uint64_t seed = 4) : lit_(std::move(scene)) {
        lit_.add_random_lamps(lamps, seed);
        const accel::SceneView view = lit_.view();
        for (std::uint32_t m = 0; m < view.materials.size(); ++m) looks_.push_back(look(m));
        textures_ = {{0, 8, 4, 4, {}}, {43, 8, 4, 4, {}}};
        for (std::uint32_t i = 0; i < 86; ++i) {
            const auto byte = [&](std::uint32_t k) { return static_cast<std::uint8_t>(40 + (i * 53 + k * 71) % 200); };
            texels_.push_back({byte(0), byte(1), byte(2), i < 43 ? std::uint8_t{255} : byte(3)});
        }
        frames_.assign(view.source_face_count(), {0.8f, 0.6f, 0.25f, -0.5f});
        for (const accel::ObjectMesh& mesh : view.meshes) {
            meshes_.push_back(mesh);
            meshes_.back().texcoords = 1 + static_cast<std::uint32_t>(texcoords_.size());
            for (std::uint32_t k = 0; k < 3 * mesh.triangle_count; ++k)
                texcoords_.push_back({0.37f * static_cast<float>(k % 7), 0.21f * static_cast<float>(k % 11)});
        }
    }
    RichScene(const RichScene&) = delete;
    RichScene& operator=(const RichScene&) = delete;

    /// Colours and lamps alone.
    [[nodiscard]] accel::SceneView plain() const { return lit_.view(); }
    /// All of it.
    [[nodiscard]] accel::SceneView view() const {
        accel::SceneView view = lit_.view();
        view.material_looks = {looks_.data(), looks_.size()};
        view.textures = {textures_.data(), textures_.size()};
        view.texels = {texels_.data(), texels_.size()};
        view.face_frames = {frames_.data(), frames_.size()};
        view.meshes = {meshes_.data(), meshes_.size()};
        view.mesh_texcoords = {texcoords_.data(), texcoords_.size()};
        return view;
    }
    /// Without what stands in it.
    [[nodiscard]] static accel::SceneView bare(accel::SceneView view) {
        view.objects = {};
        view.cell_objects = {};
        view.cell_object_offsets = {};
        return view;
    }

private:
    static accel::MaterialLook look(std::uint32_t material) {
        accel::MaterialLook look = {};
        look.texture = none<accel::TextureId>;
        look.texture_from_face = {1, 0.1f, 0.3f, -0.2f, 0.9f, 0.6f};
        if (material % 5 == 0) look.mirror = 0.4f;
        if (material % 5 == 1) look.through = {0.5f, 0.6f, 0.3f};
        if (material % 5 == 2) look.texture = accel::TextureId{0};
        if (material % 5 == 3) {
            look.texture = accel::TextureId{1};
            look.mirror = 0.2f;
        }
        return look;
    }

    LitScene lit_;
    std::vector<accel::MaterialLook> looks_;
    std::vector<accel::Texture> textures_;
    std::vector<accel::Texel> texels_;
    std::vector<accel::FaceFrame> frames_;
    std::vector<accel::ObjectMesh> meshes_;
    std::vector<accel::TexCoord> texcoords_;
};

}  // namespace enfilade::test
