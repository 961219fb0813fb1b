// Models of each format, from bytes to triangles in their own frame.

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "modeler/catalogue/face_triangles.h"
#include "modeler/catalogue/image_mean.h"
#include "modeler/catalogue/read_model.h"
#include "tests/modeler/catalogue/memory_files.h"

namespace enfilade::modeler::test {
namespace {

RawMesh read(const MemoryFiles& files, const std::string& name) { return read_model(files, name, ReadImages::Yes); }

std::string refusal_of(const MemoryFiles& files, const std::string& name) {
    try {
        (void)read(files, name);
    } catch (const InputError& error) {
        EXPECT_TRUE(error.code == "K107" || error.code == "K109") << error.code;
        return error.what();
    }
    return "";
}

TEST(Model, ObjKeepsItsTrianglesAndTheirMaterials) {
    const MemoryFiles files = {{"a/b.obj",
                                "mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1/1/1 2/2/2 3/3/3 "
                                "4/4/4\nusemtl blue\nf 1 2 4\n"},
                               {"a/b.mtl", "newmtl blue\nKd 0 0 1\nnewmtl red\nKd 1 0 0\nd 0.5\n"}};
    const RawMesh mesh = read(files, "a/b.obj");
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}}));
    EXPECT_EQ(mesh.triangle_materials, (std::vector<std::uint32_t>{0, 0, 1}));
    ASSERT_EQ(mesh.materials.size(), 2u);
    EXPECT_EQ(mesh.materials[0].name, "red");
    EXPECT_EQ(mesh.materials[0].colour, (std::array<float, 3>{1, 0, 0}));
    EXPECT_EQ(mesh.materials[0].opacity, 0.5f);
    EXPECT_EQ(mesh.materials[1].colour, (std::array<float, 3>{0, 0, 1}));
    EXPECT_FALSE(mesh.lacks_materials);
}

TEST(Model, ColoursOfMaterialLibrariesAreSrgb) {
    const MemoryFiles files = {{"b.obj", "mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n"},
                               {"b.mtl", "newmtl m\nKd 0.5 0.5 0.5\n"}};
    EXPECT_NEAR(read(files, "b.obj").materials[0].colour[0], 0.2140f, 1e-4);
}

TEST(Model, FacesWithCornersThatDoNotExistOrAreNoNumbersAreDroppedAndCounted) {
    const MemoryFiles files = {
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 nan\nv 0 1 0\nf 1 2 9\nf 1 2 3\nf 1 2 4\nf 0 1 2\nf -9 1 2\nf 1 2 4 9 4\n"},
        {"a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n"},
        {"a.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 3\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
         "3 0 1 2\n3 0 1 7\n3 0 1 -1\n"},
        {"a.stl",
         "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
         "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 inf\nvertex 0 1 0\nendloop\nendfacet\n"
         "endsolid s\n"}};
    EXPECT_EQ(read(files, "a.obj").dropped, 7u);
    EXPECT_EQ(read(files, "a.off").dropped, 1u);
    EXPECT_EQ(read(files, "a.ply").dropped, 2u);
    EXPECT_EQ(read(files, "a.stl").dropped, 1u);
    for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl"})
        EXPECT_EQ(read(files, name).triangles.size(), 1u) << name;
}

TEST(Model, TrianglesWithoutAreaAreKept) {
    const MemoryFiles files = {{"a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\nf 3 3 3\n"}};
    EXPECT_EQ(read(files, "a.obj").triangles.size(), 3u);
}

TEST(Model, IsRefusedWithAReasonWhereThereIsNoTriangle) {
    const MemoryFiles files = {{"empty.obj", ""},
                               {"points.obj", "v 0 0 0\nv 1 0 0\np 1\n"},
                               {"lines.obj", "v 0 0 0\nv 1 0 0\nf 1 2\nf 1\n"},
                               {"absent.obj", "v 0 0 0\nf 1 2 3\n"},
                               {"half.off", "OFF\n8 9 0\n0 0 0\n"},
                               {"chair.3ds", std::string("MM\0\0\0\0xxxxxxxxxxxxxxxxxxxxx", 27)},
                               {"chair.dae", "<?xml version=\"1.0\"?><COLLADA>"},
                               {"bad.glb", "glTF\2\0\0\0\xFF\xFF\xFF\xFF"},
                               {"bad.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"meshes\": 7}"},
                               {"text.zip", archive({{"readme.txt", "no model"}})}};
    EXPECT_NE(refusal_of(files, "empty.obj").find("no face"), std::string::npos);
    EXPECT_NE(refusal_of(files, "points.obj").find("no face"), std::string::npos);
    EXPECT_NE(refusal_of(files, "lines.obj").find("fewer than three corners"), std::string::npos);
    EXPECT_NE(refusal_of(files, "absent.obj").find("exist"), std::string::npos);
    EXPECT_NE(refusal_of(files, "half.off").find("complete"), std::string::npos);
    EXPECT_NE(refusal_of(files, "chair.3ds").find("3DS"), std::string::npos);
    EXPECT_NE(refusal_of(files, "chair.dae").find("Collada"), std::string::npos);
    EXPECT_NE(refusal_of(files, "text.zip").find("holds no OBJ"), std::string::npos);
    EXPECT_NE(refusal_of(files, "bad.glb"), "");
    EXPECT_NE(refusal_of(files, "bad.gltf"), "");
    EXPECT_NE(refusal_of(files, "none.obj").find("no such file"), std::string::npos);
}

TEST(Model, IsFoundInsideAnArchiveWithItsMaterials) {
    const std::string inner =
        archive({{"readme.txt", "hello"},
                 {"chair/chair.obj", "mtllib chair.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"},
                 {"chair/chair.mtl", "newmtl m\nKd 0 1 0\n"}});
    const MemoryFiles files = {{"12", inner}, {"13", archive({{"a.zip", inner}})}};
    for (const char* name : {"12", "13"}) {
        const RawMesh mesh = read(files, name);
        EXPECT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(mesh.materials[0].colour, (std::array<float, 3>{0, 1, 0}));
    }
}

TEST(Archive, ReadsEveryEntryThatItNamesWhateverItIsCalled) {
    const auto files = open_archive(
        archive({{"/rooted", "1"}, {"//a/./b.obj", "2"}, {"../up", "3"}, {"%41", "4"}, {"/", "5"}, {"a//b", "6"}}),
        "test");
    EXPECT_GE(files->names().size(), 5u);
    for (const std::string& name : files->names()) EXPECT_TRUE(files->read(name).has_value()) << name;
    EXPECT_EQ(files->read("rooted"), "1");
    EXPECT_EQ(files->read("/ROOTED"), "1");
}

TEST(Model, MaterialsThatNoFileDefinesTakeTheColourOfTheirName) {
    const MemoryFiles files = {{"12",
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl dkgrey\nf 1 2 3\nusemtl "
                                "ltgrey\nf 1 2 3\nusemtl qwerty\nf 1 2 3\n"}};
    const RawMesh mesh = read(files, "12");
    EXPECT_TRUE(mesh.lacks_materials);
    ASSERT_EQ(mesh.materials.size(), 4u);
    EXPECT_GT(mesh.materials[0].colour[0], 5 * mesh.materials[0].colour[1]);
    EXPECT_LT(mesh.materials[1].colour[0], mesh.materials[2].colour[0] / 2);
    EXPECT_EQ(mesh.materials[3].colour, RawMaterial{}.colour);
}

TEST(Model, GltfPlacesEachMeshAtEachOfItsNodes) {
    // One triangle in a buffer of its own, at two nodes, the second twice as large and moved, below the first.
    const MemoryFiles files = {
        {"a/t.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
          "nodes":[{"mesh":0,"translation":[10,0,0],"children":[1]},{"mesh":0,"scale":[2,2,2],"translation":[0,5,0]}],
          "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
          "materials":[{"name":"m","pbrMetallicRoughness":{"baseColorFactor":[0.25,0.5,1,1]}}],
          "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
          "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":"t.bin","byteLength":36}]})"},
        {"a/t.bin",
         std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0", 36)}};
    const RawMesh mesh = read(files, "a/t.gltf");
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(mesh.in_metres);
    EXPECT_EQ(mesh.up, UpAxis::Y);
    EXPECT_EQ(mesh.points, (std::vector<std::array<double, 3>>{
                               {10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {10, 5, 0}, {12, 5, 0}, {10, 7, 0}}));
    EXPECT_EQ(mesh.materials[mesh.triangle_materials[0]].colour, (std::array<float, 3>{0.25f, 0.5f, 1}));
}

double area_of(const std::vector<std::array<double, 3>>& corners, int& count) {
    FaceTriangles cutter;
    double area = 0;
    count = 0;
    cutter.cut(corners, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        ++count;
        const auto& p = corners[a];
        const auto& q = corners[b];
        const auto& r = corners[c];
        area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
    });
    return area;
}

TEST(FaceTriangles, CoverConcavePolygonsOnceWhicheverWayTheyTurn) {
    std::vector<std::array<double, 3>> comb;  // ten teeth
    for (int k = 0; k < 10; ++k) {
        comb.push_back({2.0 * k, 0, 0});
        comb.push_back({2.0 * k + 1, 5, 0});
    }
    comb.push_back({19, -1, 0});
    comb.push_back({0, -1, 0});
    double expected = 0;
    for (std::size_t k = 0; k < comb.size(); ++k) {
        const auto& p = comb[k];
        const auto& q = comb[(k + 1) % comb.size()];
        expected += (p[0] * q[1] - p[1] * q[0]) / 2;
    }
    int count = 0;
    EXPECT_NEAR(area_of(comb, count), expected, 1e-9);
    EXPECT_EQ(count, 20);
    std::reverse(comb.begin(), comb.end());
    EXPECT_NEAR(area_of(comb, count), -expected, 1e-9);
}

TEST(FaceTriangles, AConcaveQuadrangleIsCutAtItsNotch) {
    int count = 0;
    for (std::size_t shift = 0; shift < 4; ++shift) {
        std::vector<std::array<double, 3>> arrow = {{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}};
        std::rotate(arrow.begin(), arrow.begin() + static_cast<std::ptrdiff_t>(shift), arrow.end());
        FaceTriangles cutter;
        double sum = 0;
        cutter.cut(arrow, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const double area = (arrow[b][0] - arrow[a][0]) * (arrow[c][1] - arrow[a][1]) -
                                (arrow[b][1] - arrow[a][1]) * (arrow[c][0] - arrow[a][0]);
            EXPECT_GT(area, 0);
            sum += area / 2;
        });
        EXPECT_NEAR(sum, area_of(arrow, count), 1e-12);
        EXPECT_EQ(count, 2);
    }
}

TEST(FaceTriangles, PolygonsWithoutAreaLoseNoTriangle) {
    int count = 0;
    EXPECT_EQ(area_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, count), 0);
    EXPECT_EQ(count, 3);
    EXPECT_EQ(area_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, count), 0);
    EXPECT_EQ(count, 2);
    const std::vector<std::array<double, 3>> many(5000, {1, 2, 3});
    area_of(many, count);
    EXPECT_EQ(count, 4998);
}

}  // namespace
}  // namespace enfilade::modeler::test
