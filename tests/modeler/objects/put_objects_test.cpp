// Objects in a building: where they are seen, as lists and as volumes, and what a scene file keeps of them.

#include "modeler/objects/put_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/certify.h"
#include "modeler/export_scene.h"
#include "modeler/model_group.h"
#include "plans/random.h"
#include "tests/support/changed_scene.h"
#include "tests/support/furnished_scenes.h"

namespace enfilade::modeler {
namespace {

using accel::CellId;
using accel::SceneView;
using test::FurnishedHouse;

constexpr FurnishedHouse houses[] = {FurnishedHouse::Townhouse, FurnishedHouse::Office, FurnishedHouse::Curved};
constexpr ObjectCells both[] = {ObjectCells::List, ObjectCells::Cut};

bool lists(const SceneView& scene, std::uint32_t cell, std::uint32_t object) {
    const auto* first = scene.cell_objects.data() + scene.cell_object_offsets[cell];
    const auto* last = scene.cell_objects.data() + scene.cell_object_offsets[cell + 1];
    return std::binary_search(first, last, static_cast<accel::ObjectId>(object));
}

/// A point on a triangle of the object, in the scene's frame.
accel::Vertex point_on(const SceneView& scene, const accel::PlacedObject& object, plans::Random& random) {
    const accel::ObjectMesh& mesh = scene.meshes[index(object.mesh)];
    const accel::MeshTriangle& triangle = scene.mesh_triangles[mesh.first_triangle + random.below(mesh.triangle_count)];
    double u = random.uniform(), v = random.uniform(), at[3] = {0, 0, 0};
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const double weight[3] = {1 - u - v, u, v};
    for (std::size_t c = 0; c < 3; ++c) {
        const accel::Vertex& corner = scene.mesh_vertices[mesh.first_vertex + triangle.corners[c]];
        at[0] += weight[c] * corner.x, at[1] += weight[c] * corner.y, at[2] += weight[c] * corner.z;
    }
    float to[3];
    for (std::size_t r = 0; r < 3; ++r) {
        const float* row = object.scene_from_object.rows.data() + 4 * r;
        to[r] = float(row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3]);
    }
    return {to[0], to[1], to[2]};
}

TEST(PutObjects, EveryPointOfAnObjectInItsRoomIsInACellThatListsIt) {
    for (const FurnishedHouse which : houses) {
        const Building building = test::furnished(test::house(which), 3, 150, ObjectCells::List);
        const accel::Scene scene = accel::assemble(scene_input(building));
        const SceneView& view = scene.view();
        plans::Random random{17};
        std::size_t in_room = 0;
        for (std::uint32_t k = 0; k < view.objects.size(); ++k) {
            const accel::PlacedObject& object = view.objects[k];
            if (view.meshes[index(object.mesh)].triangle_count == 0) continue;
            for (int sample = 0; sample < 40; ++sample) {
                const accel::Vertex p = point_on(view, object, random);
                const auto cell = accel::locate(view, std::array<double, 3>{p.x, p.y, p.z});
                if (!cell || view.cells[index(*cell)].space != object.space) continue;
                ++in_room;
                ASSERT_TRUE(lists(view, std::uint32_t(index(*cell)), k)) << view.string(object.id);
            }
        }
        EXPECT_GT(in_room, 2000u);
    }
}

TEST(PutObjects, CellsListOnlyWhatSharesAPlaceWithThem) {
    const accel::Scene scene = test::furnished_scene(FurnishedHouse::Office, 4, 300);
    const SceneView& view = scene.view();
    std::size_t listed = 0, in_other_spaces = 0;
    for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
        const accel::Cell& cell = view.cells[c];
        float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f};
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            low[0] = std::min(low[0], view.section_x[s]), high[0] = std::max(high[0], view.section_x[s]);
            low[1] = std::min(low[1], view.section_y[s]), high[1] = std::max(high[1], view.section_y[s]);
        }
        for (std::uint32_t i = view.cell_object_offsets[c]; i < view.cell_object_offsets[c + 1]; ++i) {
            const accel::PlacedObject& object = view.objects[index(view.cell_objects[i])];
            const double reach = 2;  // metres: half of the largest diagonal, and the box need not be around the mesh
            for (int k = 0; k < 2; ++k) {
                EXPECT_LE(object.low[std::size_t(k)], high[k] + reach);
                EXPECT_GE(object.high[std::size_t(k)], low[k] - reach);
            }
            ++listed;
            in_other_spaces += cell.space != object.space;
        }
    }
    EXPECT_GT(listed, 300u);
    EXPECT_GT(in_other_spaces, 0u) << "no object stands in a doorway";
    EXPECT_LT(in_other_spaces, listed / 4);
}

TEST(PutObjects, AFileReadBackExportsTheSameBytes) {
    for (const ObjectCells cells : both) {
        const Building building = test::furnished(test::house(FurnishedHouse::Townhouse), 5, 120, cells);
        const accel::Scene scene = export_scene(building, check(building), "{}");
        const Building again = read_model(scene);
        EXPECT_EQ(again.furnishing.objects, building.furnishing.objects);
        const accel::Scene second = export_scene(again, check(again), "{}");
        EXPECT_TRUE(std::ranges::equal(scene.bytes(), second.bytes()));
        const Certification certification = certify(scene);
        EXPECT_EQ(certification.verdict, "certified");
    }
}

TEST(PutObjects, AModelThatDoesNotFitItsSceneIsRefused) {
    const Building building = test::furnished(test::house(FurnishedHouse::Townhouse), 5, 20, ObjectCells::List);
    const accel::Scene scene = export_scene(building, check(building), "{}");
    const auto code_with = [&](const std::string& from, const std::string& to) -> std::string {
        EXPECT_EQ(from.size(), to.size());
        const accel::Scene damaged = testing::changed(scene, "m.objects", [&](std::byte* bytes, std::size_t size) {
            std::string text(reinterpret_cast<const char*>(bytes), size);
            const std::size_t at = text.find(from);
            ASSERT_NE(at, std::string::npos) << from;
            text.replace(at, from.size(), to);
            std::copy(text.begin(), text.end(), reinterpret_cast<char*>(bytes));
        });
        try {
            (void)read_model(damaged);
            return "";
        } catch (const InputError& error) {
            return error.code;
        }
    };
    EXPECT_EQ(code_with("\"Object 3\"", "\"Object 4\""), "");
    EXPECT_EQ(code_with("\"mesh\":0", "\"mesh\":9"), "F20");
    EXPECT_EQ(code_with("\"mesh\":0", "\"mash\":0"), "F20");
    EXPECT_EQ(code_with("object-000003", "object-000002"), "F20");
    EXPECT_EQ(code_with("\"size\":[0", "\"size\":[-"), "F20");
    EXPECT_EQ(code_with("\"objects\":[", "\"objects\":{"), "F20");
    EXPECT_EQ(code_with("\"position\":[", "\"position\":1"), "F20");
    EXPECT_EQ(code_with("\"angle\":", "\"angle\" "), "F20");
}

TEST(PutObjects, AnObjectThatIsNotItsModelsIsFoundByD3) {
    const Building building = test::furnished(test::house(FurnishedHouse::Townhouse), 5, 20, ObjectCells::List);
    const accel::Scene scene = export_scene(building, check(building), "{}");
    const auto verdict_with = [&](const char* array, std::size_t byte) -> std::string {
        try {
            return certify(testing::changed(scene, array,
                                            [&](std::byte* bytes, std::size_t) { bytes[byte] ^= std::byte{1}; }))
                .verdict;
        } catch (const InputError& error) {
            return "differs at once: " + error.code;
        }
    };
    EXPECT_EQ(verdict_with("objects", 3 * sizeof(accel::PlacedObject) + offsetof(accel::PlacedObject, name)),
              "differs at objects[3]");
    EXPECT_EQ(verdict_with("cell_objects", 0).substr(0, 10), "differs at");
    // Meshes are read back from the file itself: the certificate knows them.
    EXPECT_NE(verdict_with("mesh_triangles", offsetof(accel::MeshTriangle, material)), "certified");
    EXPECT_NE(verdict_with("mesh_vertices", 4), "certified");
}

TEST(PutObjects, AFurnishedBuildingIsAsSoundAsItWas) {
    for (const FurnishedHouse which : houses) {
        const Building bare = test::house(which);
        for (const ObjectCells cells : both)
            for (std::uint64_t seed = 6; seed < 10; ++seed) {
                const CheckReport report = check(test::furnished(bare, seed, 120, cells));
                for (const Finding& finding : report.findings)
                    EXPECT_NE(finding.severity, Severity::Error) << finding.code << ' ' << finding.sentence;
            }
    }
}

TEST(PutObjects, RefusesTwoOfOneName) {
    const Building bare = test::house(FurnishedHouse::Townhouse);
    Furnishing furnishing = test::random_furnishing(bare, 1, 2);
    furnishing.objects[1].id = furnishing.objects[0].id;
    std::vector<Finding> findings;
    EXPECT_THROW((void)put_objects(bare, furnishing, findings), InputError);
}

TEST(PutObjects, WhatItHeldBeforeGoes) {
    const Building bare = test::house(FurnishedHouse::Townhouse);
    std::vector<Finding> findings;
    const Building empty = put_objects(test::furnished(bare, 7, 60, ObjectCells::Cut), {}, findings);
    EXPECT_TRUE(
        std::ranges::equal(accel::assemble(scene_input(empty)).bytes(), accel::assemble(scene_input(bare)).bytes()));
}

}  // namespace
}  // namespace enfilade::modeler
