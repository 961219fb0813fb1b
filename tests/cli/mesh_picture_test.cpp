// `render MESH`: a mesh by itself, in light and in what it costs to find its triangles.

#include <sys/stat.h>

#include <cmath>
#include <fstream>

#include "render/image_file.h"
#include "render/octree_counter.h"
#include "render/ray_counts.h"
#include "render/trace_rays.h"
#include "tests/cli/program.h"
#include "tests/support/box_triangles.h"
#include "tools/mesh_scene.h"
#include "tools/object_accel.h"
#include "tools/output_file.h"
#include "tools/view.h"

namespace enfilade::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// A box of 2 x 1 x 3 units, its corners in the order of their bits.
std::string box_corners(const char* before) {
    std::string text;
    for (int k = 0; k < 8; ++k)
        text += std::string(before) + (k & 1 ? "2 " : "0 ") + (k & 2 ? "1 " : "0 ") + (k & 4 ? "3\n" : "0\n");
    return text;
}
std::string box_faces(const char* before, std::uint32_t first) {
    std::string text;
    for (const auto& t : box_triangles())
        text += before + std::to_string(t[0] + first) + ' ' + std::to_string(t[1] + first) + ' ' +
                std::to_string(t[2] + first) + '\n';
    return text;
}
std::string box_obj() { return box_corners("v ") + box_faces("f ", 1); }
std::string box_off() { return "OFF\n8 12 0\n" + box_corners("") + box_faces("3 ", 0); }
std::string box_ply() {
    return "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 12\nproperty list uchar int vertex_indices\nend_header\n" +
           box_corners("") + box_faces("3 ", 0);
}

class MeshPicture : public testing::Test {
protected:
    std::filesystem::path file(const std::string& name, const std::string& bytes) {
        tools::write_text(folder_ / name, bytes);
        return folder_ / name;
    }
    Outcome render(const std::string& mesh, const std::string& picture, const Words& more) {
        Words words = {"render", mesh, "-o", picture, "--size", "64x48"};
        words.insert(words.end(), more.begin(), more.end());
        return enfilade_in(folder_.path(), words);
    }
    json said(const std::string& mesh, Words more) {
        more.emplace_back("--json");
        const Outcome outcome = render(mesh, "any.png", more);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out, nullptr, false);
    }
    TemporaryFolder folder_;
};

TEST_F(MeshPicture, IsMadeOfEveryFormat) {
    const Words lamp = {"--shading", "lambert", "--up", "z", "--spp", "1"};
    file("box.obj", box_obj());
    file("box.off", box_off());
    file("box.ply", box_ply());
    ASSERT_EQ(render("box.obj", "obj.png", lamp).exit_code, 0);
    const render::Image first = render::read_image(folder_ / "obj.png");
    // The lamp at the eye lights the box, red clay, in the middle of the picture; around it is the plain.
    const render::Vec3f middle = first.pixel(32, 24), corner = first.pixel(0, 0);
    EXPECT_GT(middle.x, 1.15f * middle.z);
    EXPECT_GT(std::abs(corner.x - middle.x), 0.02f);
    for (const char* other : {"box.off", "box.ply"}) {
        ASSERT_EQ(render(other, "other.png", lamp).exit_code, 0) << other;
        EXPECT_EQ(render::read_image(folder_ / "other.png").rgb, first.rgb) << other;
    }
}

TEST_F(MeshPicture, StandsAsItsFormatUsuallyDoesOrAsAsked) {
    file("box.obj", box_obj());
    file("box.ply", box_ply());
    EXPECT_EQ(said("box.ply", {}).at("mesh").at("size"), json({2, 1, 3}));
    EXPECT_EQ(said("box.obj", {}).at("mesh").at("size"), json({2, 3, 1}));
    EXPECT_EQ(said("box.ply", {"--up", "y"}).at("mesh").at("size"), json({2, 3, 1}));
    EXPECT_EQ(said("box.obj", {"--up", "z"}).at("mesh").at("size"), json({2, 1, 3}));
    EXPECT_NEAR(said("box.obj", {}).at("mesh").at("scale"), tools::shown_mesh_size / 3, 1e-12);
}

TEST_F(MeshPicture, DoesNotDependOnTheUnitOfTheFile) {
    std::vector<render::Image> pictures;
    for (const double unit : {1.0, 1048576.0, 0.0625}) {
        std::string corners;
        for (int k = 0; k < 8; ++k)
            corners += "v " + std::to_string((k & 1) * unit) + ' ' + std::to_string((k >> 1 & 1) * unit) + ' ' +
                       std::to_string((k >> 2) * unit) + '\n';
        file("box.obj", corners + box_faces("f ", 1));
        ASSERT_EQ(render("box.obj", "box.png", {}).exit_code, 0) << unit;
        pictures.push_back(render::read_image(folder_ / "box.png"));
        EXPECT_EQ(pictures.back().rgb, pictures.front().rgb) << unit;
    }
}

TEST_F(MeshPicture, OfWhateverTrianglesThereAre) {
    // Three triangles at one edge, one of them twice, one without area, one with a corner that is not there.
    file("odd.off",
         "OFF\n6 6 0\n0 0 0\n0 0 2\n1 0 1\n-1 0 1\n0 1 1\n0 0 1\n"
         "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 1 4\n3 0 1 5\n3 0 1 99\n");
    const Outcome text = render("odd.off", "odd.png", {});
    ASSERT_EQ(text.exit_code, 0) << text.err;
    EXPECT_NE(text.out.find("odd.off: 5 triangles, 1 of them without area, 1 there twice, "), std::string::npos)
        << text.out;
    EXPECT_NE(text.out.find("1 more left out"), std::string::npos) << text.out;
    for (const char* kind : {"plain", "octree"})
        ASSERT_EQ(render("odd.off", std::string(kind) + ".exr", {"--object-accel", kind}).exit_code, 0);
    EXPECT_EQ(render::read_image(folder_ / "plain.exr").rgb, render::read_image(folder_ / "octree.exr").rgb);
}

TEST_F(MeshPicture, IsRefusedWithAReasonWhereThereIsNothingToSee) {
    const std::vector<std::pair<std::string, std::string>> files = {
        {"empty.obj", ""},
        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
        {"lines.obj", "v 0 0 0\nv 1 0 0\nf 1 2\nf 2 1\n"},
        {"flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n"},
        {"point.obj", "v 5 5 5\nv 5 5 5\nv 5 5 5\nf 1 2 3\n"},
        {"far.obj", "v -1e308 0 0\nv 1e308 0 0\nv 0 1e308 0\nf 1 2 3\n"},
        {"short.ply", box_ply().substr(0, 230)},
        {"wrong.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"},
        {"no.glb", "glTF and then nothing"},
        {"scene.obj", std::string("\x7f"
                                  "ELF\0\0\0",
                                  7)},
    };
    for (const auto& [name, bytes] : files) {
        file(name, bytes);
        const Outcome outcome = render(name, "none.png", {});
        EXPECT_EQ(outcome.exit_code, 2) << name << outcome.out;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(render("absent.obj", "none.png", {}).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "none.png"));
}

TEST_F(MeshPicture, RefusesFlagsThatMeanNothingToIt) {
    file("box.obj", box_obj());
    for (const Words& more : {Words{"--tracer", "oracle"}, Words{"--room", "Kitchen"}, Words{"--up", "x"},
                              Words{"--camera", "dollhouse"}, Words{"--camera", "dollhouse:1"}, Words{"--no-objects"},
                              Words{"--mirror-floor", "0.6"}, Words{"--camera", "1000,0,1:0,0,1"}}) {
        const Outcome outcome = render("box.obj", "none.png", more);
        EXPECT_EQ(outcome.exit_code, 2) << more[0];
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        // What helps with scenes helps here as little.
        for (const char* remedy : {"--room NAME", "room with --room", "info SCENE"})
            EXPECT_EQ(outcome.err.find(remedy), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(render("absent.enf", "none.png", {"--up", "z"}).exit_code, 2);
}

TEST_F(MeshPicture, WhatIsNeitherMeshNorSceneIsToldWhatIsRead) {
    for (const char* name : {"city.json", "model.3ds", "plain"}) {
        file(name, "neither of them");
        const Outcome outcome = render(name, "none.png", {});
        EXPECT_EQ(outcome.exit_code, 2) << name;
        EXPECT_NE(outcome.err.find(".obj, .gltf, .glb, .ply, .off and .stl are read"), std::string::npos)
            << outcome.err;
    }
    file("box.ply.gz", "packed");
    EXPECT_NE(render("box.ply.gz", "none.png", {}).err.find("unpack it first"), std::string::npos);
    file("damaged.enf", "neither of them");
    EXPECT_NE(render("damaged.enf", "none.png", {}).err.find("no scene file"), std::string::npos);
}

TEST_F(MeshPicture, SaysOpenEdges) {
    const std::string faces = box_faces("3 ", 0);
    file("open.off", "OFF\n8 11 0\n" + box_corners("") + faces.substr(faces.find('\n') + 1));
    file("box.off", box_off());
    EXPECT_NE(render("open.off", "open.png", {}).out.find("11 triangles, 3 open edges."), std::string::npos);
    EXPECT_EQ(render("box.off", "box.png", {}).out.find("open"), std::string::npos);
}

TEST_F(MeshPicture, RefusalsNameTheFileAndWhatItIs) {
    file("words.gltf", "hello");
    file("bare.glb", "glTFxx");
    file("bufferless.gltf", R"({"asset":{"version":"2.0"}})");
    for (const char* name : {"words.gltf", "bare.glb", "bufferless.gltf"}) {
        const std::string said = render(name, "none.png", {}).err;
        EXPECT_NE(said.find(name), std::string::npos) << said;
        EXPECT_EQ(said.find("\"model.gl"), std::string::npos) << said;
    }
    std::filesystem::create_directory(folder_ / "folder.obj");
    EXPECT_NE(render("folder.obj", "none.png", {}).err.find("it is a folder"), std::string::npos);
    ASSERT_EQ(mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
    EXPECT_NE(render("pipe.obj", "none.png", {}).err.find("no regular file"), std::string::npos);
    EXPECT_NE(render("absent.obj", "none.png", {}).err.find("no such file"), std::string::npos);
}

TEST_F(MeshPicture, SaysHowLargeCoordinatesMayBe) {
    for (const char* x : {"1e30", "1e15"}) {
        file("huge.obj", "v 0 0 0\nv " + std::string(x) + " 0 0\nv 0 1 0\nf 1 2 3\n");
        const Outcome outcome = render("huge.obj", "none.png", {});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_NE(outcome.err.find("beyond 1e12"), std::string::npos) << outcome.err;
    }
    file("large.obj", "v 0 0 0\nv 9e11 0 0\nv 0 9e11 0\nf 1 2 3\n");
    EXPECT_EQ(render("large.obj", "large.png", {}).exit_code, 0);
}

TEST_F(MeshPicture, CountsOneLeafWhereTheOctreeIsOne) {
    const tools::MeshScene box = tools::scene_of_mesh(file("box.obj", box_obj()), {});
    const accel::SceneView& scene = box.scene.view();
    const tools::View view = tools::named_view(scene, "exterior", 64, 48);
    const tools::PreparedObjects objects = tools::prepare_objects(
        scene, tools::object_accel_choice({.kind = "octree", .octree_leaf = 4096}), accel::SerialExecutor());
    ASSERT_EQ(objects.summary.octrees->leaves, 1u);
    const auto counted = [&](render::RayCount count) {
        return render::count_by_pixel(scene, view.camera, count, {}, nullptr, objects.accel->octrees()).of_pixel;
    };
    const std::vector<float> leaves = counted(render::RayCount::Leaves), blocks = counted(render::RayCount::Blocks);
    // A box fills its box: who enters the one leaf hits one of its twelve triangles, which are one block.
    const render::CameraFrame frame = render::make_frame(view.camera);
    const render::ObjectTracer tracer = objects.accel->tracer();
    std::size_t hits = 0;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        const render::Vec3f direction = frame.direction(float(k % 64) + 0.5f, float(k / 64) + 0.5f);
        const render::RayQuery ray = {render::vec_cast<double>(frame.origin), render::vec_cast<double>(direction),
                                      accel::CellId(0)};
        render::RayHit hit;
        render::trace_rays(scene, {&ray, 1}, {&hit, 1}, render::Precision::Float, nullptr, &tracer);
        const bool is_hit = hit.status == render::WalkStatus::Object;
        hits += is_hit;
        EXPECT_EQ(leaves[k], is_hit ? 1 : 0) << k;
        EXPECT_EQ(blocks[k], is_hit ? 1 : 0) << k;
    }
    EXPECT_GT(hits, leaves.size() / 8);
}

/// A wavy sheet of 2 n^2 triangles.
std::string sheet_off(int n) {
    std::string text = "OFF\n" + std::to_string((n + 1) * (n + 1)) + ' ' + std::to_string(2 * n * n) + " 0\n";
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x)
            text +=
                std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(3 * std::sin(0.4 * x * y)) + '\n';
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const auto at = [&](int dx, int dy) { return ' ' + std::to_string((n + 1) * (y + dy) + x + dx); };
            text += '3' + at(0, 0) + at(1, 0) + at(1, 1) + "\n3" + at(0, 0) + at(1, 1) + at(0, 1) + '\n';
        }
    }
    return text;
}

TEST_F(MeshPicture, CountsLeavesAndBlocksOfTheOctreeThatIsAskedFor) {
    file("sheet.off", sheet_off(16));
    const auto counts = [&](const char* what, Words more) {
        more.insert(more.end(), {"--show", what});
        return said("sheet.off", more).at("counts");
    };
    const json one = counts("leaves", {"--octree-leaf", "4096"}), many = counts("leaves", {"--octree-leaf", "2"});
    EXPECT_EQ(one.at("shown"), "leaves");
    EXPECT_EQ(one.at("rays"), 64 * 48);
    EXPECT_EQ(one.at("least"), 0);
    EXPECT_EQ(one.at("most"), 1);
    EXPECT_GT(many.at("most"), 1);
    EXPECT_GT(many.at("mean"), one.at("mean"));
    EXPECT_EQ(counts("blocks", {"--octree-leaf", "4096"}).at("most"), 16 * 16 * 2 / 16);
    EXPECT_LT(counts("blocks", {"--object-accel", "octree"}).at("mean"),
              counts("blocks", {"--octree-leaf", "4096"}).at("mean"));
}

TEST_F(MeshPicture, CountsInThePapersLayoutAsWell) {
    file("sheet.off", sheet_off(16));
    for (const char* layout : {"ropes", "stored"}) {
        for (const char* real : {"float", "double"}) {
            const json all = said("sheet.off", {"--show", "leaves", "--octree-layout", layout, "--octree-real", real,
                                                "--octree-balance", "--octree-leaf", "2"});
            EXPECT_GT(all.at("counts").at("most"), 1) << layout << real;
            EXPECT_EQ(all.at("objects").at("accel"), "ropes");
            EXPECT_GT(all.at("objects").at("octree").at("leaves"), 8);
        }
    }
}

TEST_F(MeshPicture, CountsInOctreesAlone) {
    file("box.obj", box_obj());
    for (const Words& more :
         {Words{"--show", "leaves", "--object-accel", "bvh"}, Words{"--show", "leaves", "--no-objects"},
          Words{"--show", "blocks", "--object-accel", "plain"}, Words{"--show", "leaves", "--tracer", "packet"},
          Words{"--show", "blocks", "--octree-depth", "21"}}) {
        const Outcome outcome = render("box.obj", "none.png", more);
        EXPECT_EQ(outcome.exit_code, 2) << more[1];
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    }
}

TEST_F(MeshPicture, OfOtherPeoplesMeshesIsThatOfBruteForceTrees) {
    const std::filesystem::path meshes = std::filesystem::path(ENFILADE_SOURCE_DIR) / ".." / "shared" / "data" / "mesh";
    if (!std::filesystem::exists(meshes)) GTEST_SKIP() << "there is no " << meshes;
    std::size_t pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(meshes)) {
        const std::string mesh = std::filesystem::canonical(entry.path()).string();
        if (!tools::is_mesh_file(mesh)) continue;
        const Outcome octree = render(mesh, "octree.exr", {"--object-accel", "octree", "--spp", "1"});
        if (octree.exit_code == 2) {
            EXPECT_EQ(line_count(octree.err), 1u) << octree.err;
            continue;
        }
        ASSERT_EQ(octree.exit_code, 0) << mesh << octree.err;
        ASSERT_EQ(render(mesh, "plain.exr", {"--object-accel", "plain", "--spp", "1"}).exit_code, 0);
        EXPECT_EQ(render::read_image(folder_ / "plain.exr").rgb, render::read_image(folder_ / "octree.exr").rgb)
            << mesh;
        ++pictures;
    }
    EXPECT_GT(pictures, 20u);
}

}  // namespace
}  // namespace enfilade::test
