// Textures of models: pictures, how they lie on triangles, what is mirrored and let through; and that the cache and
// scenes give them back.
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>

#include "accel/srgb.h"
#include "accel/texture_chain.h"
#include "modeler/catalogue/cache.h"
#include "modeler/catalogue/decimate.h"
#include "modeler/catalogue/fit_mesh.h"
#include "modeler/catalogue/own_pieces.h"
#include "modeler/catalogue/picture.h"
#include "modeler/catalogue/read_model.h"
#include "tests/modeler/catalogue/memory_files.h"

namespace enfilade::modeler::test {
namespace {

/// A PNG of `width` x `height` pixels: red grows to the right, green downward.
std::string ramp_png(std::uint32_t width, std::uint32_t height) {
    std::vector<std::uint8_t> pixels;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (const std::uint32_t part : {x * 255 / width, y * 255 / height, 7u, 255u})
                pixels.push_back(static_cast<std::uint8_t>(part));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = 0;
    EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr), 0);
    std::string bytes(size, '\0');
    EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr), 0);
    bytes.resize(size);
    return bytes;
}

MemoryFiles textured_square(const std::string& picture) {
    return {{"a.obj",
             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 3\nvt 0 3\n"
             "usemtl cloth\nf 1/1 2/2 3/3 4/4\nusemtl plain\nf 1 2 4\nusemtl cloth\nf 1/-4 2/9 3/bad\n"},
            {"a.mtl", "newmtl cloth\nKd 0 1 0\nmap_Kd cloth.png\nnewmtl plain\nKd 1 0 0\n"},
            {"cloth.png", picture}};
}

TEST(Pictures, OfPngKeepTheirPixels) {
    const auto texture = read_texture("ramp", ramp_png(20, 10), 1024);
    ASSERT_NE(texture, nullptr);
    EXPECT_EQ(texture->width, 20u);
    EXPECT_EQ(texture->height, 10u);
    EXPECT_EQ(texture->texels.size(), accel::texel_count(20, 10));
    EXPECT_EQ(texture->texels[3 * 20 + 5], (std::array<std::uint8_t, 4>{5 * 255 / 20, 3 * 255 / 10, 7, 255}));
}

TEST(Pictures, AreScaledDownToTheSizeAskedFor) {
    const auto texture = read_texture("ramp", ramp_png(300, 200), 30);
    ASSERT_NE(texture, nullptr);
    EXPECT_EQ(texture->width, 30u);
    EXPECT_EQ(texture->height, 20u);
}

TEST(Pictures, ThatAreDamagedAreNone) {
    const std::string png = ramp_png(40, 40);
    EXPECT_EQ(read_texture("x", "", 16), nullptr);
    EXPECT_EQ(read_texture("x", "GIF89a", 16), nullptr);
    EXPECT_EQ(read_texture("x", png.substr(0, 30), 16), nullptr);
    EXPECT_EQ(read_texture("x", "\xFF\xD8\xFF\xE0 no jpeg at all", 16), nullptr);
    for (std::size_t at = 0; at < png.size(); at += 3) {  // never a crash
        std::string bad = png;
        bad[at] = static_cast<char>(bad[at] ^ 0x55);
        (void)read_texture("x", bad, 16);
    }
}

TEST(TexturedModel, ObjLaysItsPictureByItsCorners) {
    const RawMesh mesh = read_model(textured_square(ramp_png(8, 8)), "a.obj", ReadImages::Yes, 64);
    ASSERT_EQ(mesh.textures.size(), 1u);
    EXPECT_EQ(mesh.textures[0]->name, "cloth.png");
    ASSERT_EQ(mesh.triangles.size(), 4u);
    ASSERT_EQ(mesh.texcoords.size(), 12u);
    for (std::size_t t = 0; t < 2; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& p = mesh.points[mesh.triangles[t][k]];
            EXPECT_EQ(mesh.texcoords[3 * t + k], (std::array<float, 2>{float(2 * p[0]), float(3 * p[1])}));
        }
    EXPECT_EQ(mesh.texcoords[9], (std::array<float, 2>{0, 0})) << "counted back";
    EXPECT_EQ(mesh.texcoords[10], (std::array<float, 2>{0, 0})) << "there is no ninth";
    EXPECT_EQ(mesh.materials[mesh.triangle_materials[0]].look.texture, 0u);
    EXPECT_EQ(mesh.materials[mesh.triangle_materials[2]].look.texture, UINT32_MAX);
}

TEST(TexturedModel, WithoutTexturesAskedForShowsMeans) {
    const RawMesh mesh = read_model(textured_square(ramp_png(8, 8)), "a.obj", ReadImages::Yes);
    EXPECT_TRUE(mesh.textures.empty());
    EXPECT_TRUE(mesh.texcoords.empty());
    EXPECT_EQ(mesh.materials[0].look.texture, UINT32_MAX);
    EXPECT_NE(mesh.materials[0].colour, (std::array<float, 3>{0, 1, 0})) << "the picture's mean";
}

TEST(TexturedModel, WithADamagedPictureShowsItsColour) {
    const RawMesh mesh = read_model(textured_square("no picture"), "a.obj", ReadImages::Yes, 64);
    EXPECT_TRUE(mesh.textures.empty());
    EXPECT_EQ(mesh.unread_images, 1u);
    EXPECT_EQ(mesh.materials[0].colour, (std::array<float, 3>{0, 1, 0}));
}

TEST(TexturedModel, MtlSaysWhatIsGlassAndMirror) {
    const MemoryFiles files = {
        {"a.obj",
         "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl pane\nf 1 2 3\nusemtl silver\nf 1 2 3\nusemtl "
         "gloss\nf 1 2 3\n"},
        {"a.mtl",
         "newmtl pane\nKd 0.5 1 1\nd 0.25\nnewmtl silver\nKd 0 0 0\nKs 0.9 0.9 0.9\nillum 3\n"
         "newmtl gloss\nKd 0 0 0\nKs 0.9 0.9 0.9\nillum 2\n"}};
    const RawMesh mesh = read_model(files, "a.obj", ReadImages::Yes, 64);
    EXPECT_NEAR(mesh.materials[0].look.through[1], 0.75f, 1e-6);
    EXPECT_LT(mesh.materials[0].look.through[0], 0.75f) << "in the hue of its colour";
    EXPECT_NEAR(mesh.materials[1].look.mirror, 0.9f, 1e-6);
    EXPECT_EQ(mesh.materials[2].look.mirror, 0);
}

LoadedMesh loaded_square() {
    LoadedMesh loaded;
    loaded.mesh = fitted(read_model(textured_square(ramp_png(8, 6)), "a.obj", ReadImages::Yes, 64), {}, "square");
    return loaded;
}

TEST(TexturedModel, ComesBackFromTheCache) {
    const LoadedMesh loaded = loaded_square();
    ASSERT_EQ(loaded.mesh.texcoords.size(), 3 * loaded.mesh.triangles.size());
    const CacheKey key{"place", "state"};
    const std::string bytes = mesh_bytes(key, loaded);
    const auto again = read_mesh_bytes(bytes, key);
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->mesh, loaded.mesh);
    for (std::size_t size = 0; size < bytes.size(); size += 7)
        EXPECT_FALSE(read_mesh_bytes(std::string_view(bytes).substr(0, size), key).has_value());
}

TEST(TexturedModel, DecimatedShowsMeans) {
    ObjectMesh grid;
    grid.name = "sheet";
    constexpr std::uint32_t n = 12;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x) grid.vertices.push_back({float(x), float(y), 0});
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x;
            grid.triangles.push_back({a, a + 1, a + n + 2});
            grid.triangles.push_back({a, a + n + 2, a + n + 1});
        }
    grid.triangle_materials.assign(grid.triangles.size(), 0);
    grid.texcoords.assign(3 * grid.triangles.size(), {0.5f, 0.5f});
    grid.textures.push_back(read_texture("ramp", ramp_png(4, 4), 16));
    grid.materials = {{"cloth", {0.2f, 0.3f, 0.4f}, {.texture = 0}}};
    const LoadedMesh loaded = decimated(grid, 20);
    EXPECT_LE(loaded.mesh.triangles.size(), 20u);
    EXPECT_TRUE(loaded.mesh.texcoords.empty());
    EXPECT_EQ(loaded.mesh.materials[0].look.texture, UINT32_MAX);
    EXPECT_EQ(decimated(grid, 1000).mesh, grid) << "what is small enough stays as it is";
}

TEST(OwnPieces, HaveMirrorsThatMirror) {
    for (const OwnPiece& piece : own_pieces()) {
        if (piece.entry.kind != "mirror") continue;
        const ObjectMesh mesh = piece.make(1);
        float most = 0;
        for (const ObjectMaterial& material : mesh.materials) most = std::max(most, material.look.mirror);
        EXPECT_GT(most, 0.8f) << piece.entry.id;
    }
}

}  // namespace
}  // namespace enfilade::modeler::test
