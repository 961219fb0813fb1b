// Furniture in scene files: what is laid out, what is refused, and that no damage crashes.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "accel/assemble.h"
#include "accel/placement.h"
#include "accel/scene_file.h"
#include "accel/sha256.h"
#include "accel/stats.h"
#include "accel/validate.h"
#include "base/error.h"
#include "tests/support/damaged_scene.h"
#include "tests/support/synthetic_objects.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

SceneInput furnished_input() {
    return test::with_objects(test::synthetic_office({.rooms_per_row = 2, .rows = 2}), 1, 40);
}

std::vector<std::byte> sound_bytes() {
    const Scene scene = assemble(furnished_input());
    return {scene.bytes().begin(), scene.bytes().end()};
}

template <class T, class Change>
std::string defect_with(const char* name, std::size_t i, Change change) {
    static const test::DamagedScene scene(assemble(furnished_input()));
    return scene.first_defect<T>(name, i, change);
}

TEST(ObjectsInScenes, AreLaidOutAsTheyWereGiven) {
    const SceneInput input = furnished_input();
    const Scene scene = assemble(input);
    const SceneView& view = scene.view();
    ASSERT_EQ(view.objects.size(), 40u);
    ASSERT_EQ(view.meshes.size(), 4u);
    std::size_t listed = 0;
    for (std::size_t c = 0; c < view.cells.size(); ++c) {
        ASSERT_EQ(view.cell_object_offsets[c + 1] - view.cell_object_offsets[c], input.cell_objects[c].size());
        for (const std::uint32_t object : input.cell_objects[c]) EXPECT_EQ(index(view.cell_objects[listed++]), object);
    }
    for (std::size_t k = 0; k < view.objects.size(); ++k) {
        EXPECT_EQ(view.string(view.objects[k].id), input.objects[k].id);
        for (std::size_t r = 0; r < 12; ++r)
            EXPECT_EQ(view.objects[k].scene_from_object.rows[r], float(input.objects[k].scene_from_object[r]));
    }
    const SceneStats s = stats(scene);
    EXPECT_EQ(s.objects, 40u);
    EXPECT_EQ(s.unique_triangles, 12u + 4 + 3);
    EXPECT_EQ(s.object_bytes, 40 * sizeof(PlacedObject) + (view.cells.size() + 1 + listed) * 4);
    EXPECT_EQ(s.mesh_bytes, 4 * sizeof(ObjectMesh) + (8 + 4 + 3) * sizeof(Vertex) + 19 * sizeof(MeshTriangle));
    const SceneStats bare = stats(assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2})));
    EXPECT_EQ(bare.bytes_without_objects(), bare.trace_bytes);
    EXPECT_LT(s.bytes_without_objects(), bare.trace_bytes + 64 * 40) << "names and two materials";
}

TEST(ObjectsInScenes, WithoutThemNoArrayIsThere) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    for (const SceneArray& array : scene.arrays()) EXPECT_TRUE(array.id < 32 || array.id >= 900) << array.name;
    EXPECT_FALSE(scene.view().has_objects());
}

TEST(ObjectsInScenes, AllDescriptionsOfNoObjectAreRefused) {
    const auto code_with = [](auto change) -> std::string {
        SceneInput input = furnished_input();
        change(input);
        try {
            (void)assemble(input);
            return "";
        } catch (const InputError& error) {
            return error.code;
        }
    };
    EXPECT_EQ(code_with([](SceneInput&) {}), "");
    EXPECT_EQ(code_with([](SceneInput& s) { s.objects[3].mesh = 4; }), "F10");
    EXPECT_EQ(code_with([](SceneInput& s) { s.cell_objects.pop_back(); }), "F10");
    EXPECT_EQ(code_with([](SceneInput& s) { s.objects[3].scene_from_object[10] = 0; }), "F13");
    EXPECT_EQ(code_with([](SceneInput& s) { s.objects[3].scene_from_object[0] = nan; }), "F13");
    EXPECT_EQ(code_with([](SceneInput& s) { s.objects[3].space = 1u << 20; }), "F4");
    EXPECT_EQ(code_with([](SceneInput& s) { s.objects[3].material = 1u << 20; }), "F4");
    EXPECT_EQ(code_with([](SceneInput& s) { std::swap(s.objects[3].id, s.objects[4].id); }), "F4");
    EXPECT_EQ(code_with([](SceneInput& s) { s.objects[3].id = s.objects[4].id; }), "F4");
    EXPECT_EQ(code_with([](SceneInput& s) { s.cell_objects[0] = {2, 1}; }), "F4");
    EXPECT_EQ(code_with([](SceneInput& s) { s.cell_objects[0] = {40}; }), "F4");
    const auto with_mesh = [&](auto change) {
        return code_with([&](SceneInput& s) {
            InputMesh mesh = *s.meshes[0];
            change(mesh);
            s.meshes[0] = std::make_shared<const InputMesh>(std::move(mesh));
        });
    };
    EXPECT_EQ(with_mesh([](InputMesh& m) { m.triangles[5][1] = 8; }), "F4");
    EXPECT_EQ(with_mesh([](InputMesh& m) { m.triangle_materials[5] = 1u << 20; }), "F4");
    EXPECT_EQ(with_mesh([](InputMesh& m) { m.triangle_materials.pop_back(); }), "F10");
    EXPECT_EQ(with_mesh([](InputMesh& m) { m.vertices[5][2] = nan; }), "F5");
    EXPECT_EQ(with_mesh([](InputMesh& m) { m.vertices[5][2] = infinity; }), "F5");
    EXPECT_EQ(with_mesh([](InputMesh& m) { m.vertices[5][2] = 1e20f; }), "F5");
}

TEST(ObjectsInScenes, EveryIndexIsChecked) {
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 1, [](ObjectMesh&) {}), "");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 1, [](ObjectMesh& m) { m.first_vertex += 1; }), "F4");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 1, [](ObjectMesh& m) { m.first_triangle -= 1; }), "F4");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 1, [](ObjectMesh& m) { m.vertex_count = UINT32_MAX; }), "F4");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 3, [](ObjectMesh& m) { m.triangle_count = 1; }), "F4");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 3, [](ObjectMesh& m) { m.name = TextId{1u << 30}; }), "F4");
    EXPECT_EQ(defect_with<MeshTriangle>("mesh_triangles", 13, [](MeshTriangle& t) { t.corners[2] = 4; }), "F4");
    EXPECT_EQ(defect_with<MeshTriangle>("mesh_triangles", 18, [](MeshTriangle& t) { t.material = none<MaterialId>; }),
              "F4");
    EXPECT_EQ(defect_with<PlacedObject>("objects", 7, [](PlacedObject& o) { o.mesh = MeshId{4}; }), "F4");
    EXPECT_EQ(defect_with<PlacedObject>("objects", 7, [](PlacedObject& o) { o.material = MaterialId{999}; }), "F4");
    EXPECT_EQ(defect_with<PlacedObject>("objects", 7, [](PlacedObject& o) { o.space = none<SpaceId>; }), "F4");
    EXPECT_EQ(defect_with<PlacedObject>("objects", 7, [](PlacedObject& o) { o.id = none<TextId>; }), "F4");
    EXPECT_EQ(defect_with<PlacedObject>("objects", 7, [](PlacedObject& o) { o.name = none<TextId>; }), "F4");
    EXPECT_EQ(defect_with<PlacedObject>("objects", 7, [](PlacedObject& o) { o.id = TextId{0}; }), "F4");
    EXPECT_EQ(defect_with<std::uint32_t>("cell_object_off", 2, [](std::uint32_t& n) { n = 1u << 30; }), "F4");
    EXPECT_EQ(defect_with<std::uint32_t>("cell_object_off", 0, [](std::uint32_t& n) { n = 1; }), "F4");
    EXPECT_EQ(defect_with<std::uint32_t>("cell_objects", 0, [](std::uint32_t& n) { n = 40; }), "F4");
}

TEST(ObjectsInScenes, EveryNumberIsChecked) {
    for (const float bad : {nan, infinity, -infinity, 3e30f}) {
        EXPECT_EQ(defect_with<Vertex>("mesh_vertices", 9, [&](Vertex& v) { v.y = bad; }), "F5");
        EXPECT_EQ(defect_with<ObjectMesh>("meshes", 0, [&](ObjectMesh& m) { m.low[1] = bad; }), "F5");
        EXPECT_EQ(defect_with<ObjectMesh>("meshes", 0, [&](ObjectMesh& m) { m.high[1] = bad; }), "F5");
        EXPECT_EQ(defect_with<PlacedObject>("objects", 3, [&](PlacedObject& o) { o.low[1] = bad; }), "F5");
        for (std::size_t k = 0; k < 12; ++k) {
            const auto scene_rows = [&](PlacedObject& o) { o.scene_from_object.rows[k] = bad; };
            EXPECT_EQ(defect_with<PlacedObject>("objects", 3, scene_rows), "F5");
            const auto object_rows = [&](PlacedObject& o) { o.object_from_scene.rows[k] = bad; };
            EXPECT_EQ(defect_with<PlacedObject>("objects", 3, object_rows), "F5");
        }
    }
    EXPECT_EQ(defect_with<PlacedObject>("objects", 3, [](PlacedObject& o) { o.high[0] = o.low[0]; }), "F5");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 1, [](ObjectMesh& m) { m.high[2] = 0.5f; }), "F5");
    EXPECT_EQ(defect_with<ObjectMesh>("meshes", 3, [](ObjectMesh& m) { m.low = m.high = {}; }), "F5");
    // A thousandth is no rounding.
    EXPECT_EQ(defect_with<PlacedObject>("objects", 3, [](PlacedObject& o) { o.object_from_scene.rows[3] += 0.001f; }),
              "F5");
    EXPECT_EQ(defect_with<PlacedObject>("objects", 3, [](PlacedObject& o) { o.object_from_scene.rows[0] *= 1.001f; }),
              "F5");
}

TEST(ObjectsInScenes, AMissingArrayIsRefused) {
    const std::vector<std::byte> sound = sound_bytes();
    for (const char* name :
         {"meshes", "mesh_vertices", "mesh_triangles", "objects", "cell_object_off", "cell_objects"}) {
        std::vector<std::byte> bytes = sound;
        FileHeader header;
        std::memcpy(&header, bytes.data(), sizeof header);
        const std::size_t table = header.section_count * sizeof(SectionEntry);
        for (std::size_t at = sizeof header; at < sizeof header + table; at += sizeof(SectionEntry)) {
            SectionEntry entry;
            std::memcpy(&entry, bytes.data() + at, sizeof entry);
            if (std::string_view(entry.name.data()) == name) entry.id = 63;  // something of a later version
            std::memcpy(bytes.data() + at, &entry, sizeof entry);
        }
        header.header_sha256 = {};
        std::memcpy(bytes.data(), &header, sizeof header);
        header.header_sha256 = sha256(std::span(bytes).first(sizeof header + table));
        std::memcpy(bytes.data(), &header, sizeof header);
        EXPECT_THROW((void)read(bytes), InputError) << name;
    }
}

TEST(ObjectsInScenes, NoDamageCrashes) {
    const std::vector<std::byte> sound = sound_bytes();
    const Scene scene = read(sound);
    std::mt19937_64 random(43);
    int refused = 0;
    const SerialExecutor serial;
    for (int round = 0; round < 3000; ++round) {
        std::vector<std::byte> bytes = sound;
        for (std::uint64_t k = random() % 4 + 1; k > 0; --k) {
            const char* const names[] = {"meshes",  "mesh_vertices",   "mesh_triangles",
                                         "objects", "cell_object_off", "cell_objects"};
            const SceneArray& array = *scene.find(names[random() % 6]);
            const auto first = static_cast<std::size_t>(array.bytes.data() - scene.bytes().data());
            const std::size_t at = first + random() % (array.bytes.size() / 4) * 4;
            const std::uint32_t values[] = {0,          1,          0x7fffffff,
                                            0xffffffff, 0x7f800000, static_cast<std::uint32_t>(random())};
            std::memcpy(bytes.data() + at, &values[random() % 6], 4);
        }
        try {
            (void)stats(read(bytes, {.executor = &serial}));
        } catch (const InputError& error) {
            EXPECT_FALSE(error.code.empty());
            ++refused;
        }
    }
    EXPECT_GT(refused, 2000);
}

TEST(Placement, TheInverseUndoesIt) {
    std::mt19937_64 random(5);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
    for (int round = 0; round < 200; ++round) {
        std::array<double, 12> rows;
        for (double& number : rows) number = uniform();
        const auto inverse = inverse_of(rows);
        ASSERT_TRUE(inverse);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 4; ++c) {
                double sum = c == 3 ? rows[4 * r + 3] : 0;
                for (std::size_t k = 0; k < 3; ++k) sum += rows[4 * r + k] * (*inverse)[4 * k + c];
                EXPECT_NEAR(sum, r == c ? 1 : 0, 1e-9);
            }
    }
    EXPECT_FALSE(inverse_of({1, 2, 3, 0, 2, 4, 6, 0, 0, 0, 1, 0}));
    EXPECT_FALSE(inverse_of({nan, 2, 3, 0, 2, 4, 6, 0, 0, 0, 1, 0}));
}

}  // namespace
}  // namespace enfilade::accel
