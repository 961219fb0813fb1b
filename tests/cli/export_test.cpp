// What other programs read of an export.

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <pugixml.hpp>
#include <set>

#include "accel/scene_file.h"
#include "modeler/exports/scene_mesh.h"
#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

class Export : public OfficeTest {
protected:
    static std::size_t triangles_of(const aiScene& scene) {
        std::size_t count = 0;
        for (unsigned m = 0; m < scene.mNumMeshes; ++m) count += scene.mMeshes[m]->mNumFaces;
        return count;
    }
    static void collect_names(const aiNode& node, std::set<std::string>& names) {
        names.insert(node.mName.C_Str());
        for (unsigned c = 0; c < node.mNumChildren; ++c) collect_names(*node.mChildren[c], names);
    }
    /// Reads `file` by assimp: the triangles of the scene, and a node (or mesh) for every room.
    static void expect_loads(const std::string& file) {
        const Outcome outcome = run({"export", "office.enf", "-o", file});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        Assimp::Importer importer;
        const aiScene* loaded = importer.ReadFile((folder() / file).string(), 0);
        ASSERT_NE(loaded, nullptr) << importer.GetErrorString();
        const accel::Scene scene = accel::open(folder() / "office.enf");
        EXPECT_EQ(triangles_of(*loaded), modeler::scene_mesh(scene.view()).triangle_count());
        EXPECT_GT(triangles_of(*loaded), 12u * 12u);
        std::set<std::string> names;
        collect_names(*loaded->mRootNode, names);
        for (const accel::Space& space : scene.view().spaces) {
            if (space.label != accel::Label::Room) continue;
            std::string name(scene.view().string(space.name));
            if (file.ends_with(".obj")) std::replace(name.begin(), name.end(), ' ', '_');
            EXPECT_TRUE(names.contains(name)) << name;
        }
    }
};

TEST_F(Export, GlbLoadsAgainWithItsRoomsAndTriangles) { expect_loads("office.glb"); }

TEST_F(Export, ObjLoadsAgainWithItsRoomsAndTriangles) {
    expect_loads("office.obj");
    EXPECT_NE(read_bytes(folder() / "office.mtl").find("newmtl "), std::string::npos);
}

TEST_F(Export, TrianglesLookTowardsTheLight) {
    const accel::Scene scene = accel::open(folder() / "office.enf");
    for (const modeler::MeshSpace& space : modeler::scene_mesh(scene.view()).spaces)
        for (const modeler::MeshPart& part : space.parts)
            for (std::size_t i = 0; i < part.indices.size(); i += 3) {
                const auto& a = part.positions[part.indices[i]];
                const auto& b = part.positions[part.indices[i + 1]];
                const auto& c = part.positions[part.indices[i + 2]];
                const auto& n = part.normals[part.indices[i]];
                const double u[3] = {double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2]};
                const double v[3] = {double(c[0]) - a[0], double(c[1]) - a[1], double(c[2]) - a[2]};
                const double along = (u[1] * v[2] - u[2] * v[1]) * n[0] + (u[2] * v[0] - u[0] * v[2]) * n[1] +
                                     (u[0] * v[1] - u[1] * v[0]) * n[2];
                ASSERT_GT(along, 0) << space.name;
            }
}

TEST_F(Export, GraphHoldsTheCellsAndThePortals) {
    ASSERT_EQ(run({"export", "office.enf", "-o", "office.graphml"}).exit_code, 0);
    pugi::xml_document xml;
    ASSERT_TRUE(xml.load_file((folder() / "office.graphml").c_str()));
    const accel::Scene scene = accel::open(folder() / "office.enf");
    const pugi::xml_node cells = xml.child("graphml").find_child_by_attribute("graph", "id", "cells");
    const pugi::xml_node spaces = xml.child("graphml").find_child_by_attribute("graph", "id", "spaces");
    EXPECT_EQ(std::size_t(std::distance(cells.children("node").begin(), cells.children("node").end())),
              scene.view().cells.size());
    EXPECT_EQ(std::size_t(std::distance(cells.children("edge").begin(), cells.children("edge").end())),
              scene.view().portals.size());
    std::set<std::string> ids;
    std::size_t rooms = 0;
    for (const pugi::xml_node node : spaces.children("node")) {
        ids.insert(node.attribute("id").value());
        rooms += std::string(node.find_child_by_attribute("data", "key", "label").child_value()) == "room";
    }
    EXPECT_EQ(rooms, 12u);
    for (const pugi::xml_node edge : spaces.children("edge")) {
        EXPECT_TRUE(ids.contains(edge.attribute("source").value()));
        EXPECT_TRUE(ids.contains(edge.attribute("target").value()));
        EXPECT_STRNE(edge.attribute("source").value(), edge.attribute("target").value());
    }
}

}  // namespace
}  // namespace enfilade::test
