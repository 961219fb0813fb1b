// What is counted as wrong with a mesh.

#include <gtest/gtest.h>

#include <cmath>

#include "modeler/catalogue/object_mesh.h"

namespace enfilade::modeler::test {
namespace {

ObjectMesh mesh_of(std::vector<std::array<float, 3>> vertices, std::vector<std::array<std::uint32_t, 3>> triangles) {
    ObjectMesh mesh;
    mesh.vertices = std::move(vertices);
    mesh.triangles = std::move(triangles);
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    mesh.materials.resize(1);
    return mesh;
}

ObjectMesh tetrahedron() {
    return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

TEST(Defects, AreNoneOfAClosedMesh) { EXPECT_EQ(defects_of(tetrahedron()), MeshDefects{}); }

TEST(Defects, AreNoneOfAnEmptyMesh) { EXPECT_EQ(defects_of(ObjectMesh{}), MeshDefects{}); }

TEST(Defects, AMissingTriangleOpensThreeEdges) {
    ObjectMesh mesh = tetrahedron();
    mesh.triangles.pop_back();
    EXPECT_EQ(defects_of(mesh), (MeshDefects{.open_edges = 3}));
}

TEST(Defects, VerticesAtOnePlaceAreOne) {
    // Each triangle with vertices of its own, one zero of them negative.
    const ObjectMesh whole = tetrahedron();
    ObjectMesh soup = mesh_of({}, {});
    for (const auto& corners : whole.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t corner : corners) soup.vertices.push_back(whole.vertices[corner]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    soup.vertices[0][0] = -0.0f;
    EXPECT_EQ(defects_of(soup), MeshDefects{});
}

TEST(Defects, ATriangleThatIsThereTwiceIsADuplicateWhicheverWayItLooks) {
    ObjectMesh mesh = tetrahedron();
    mesh.triangles.push_back({1, 2, 0});
    EXPECT_EQ(defects_of(mesh), (MeshDefects{.duplicate = 1, .crowded_edges = 3}));
}

TEST(Defects, ThreeTrianglesOnAnEdgeAreACrowd) {
    const ObjectMesh fan =
        mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    EXPECT_EQ(defects_of(fan), (MeshDefects{.open_edges = 6, .crowded_edges = 1}));
}

TEST(Defects, TrianglesOfTwoPlacesHaveNoAreaAndNoEdges) {
    ObjectMesh mesh = tetrahedron();
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({2, 2, 2});
    EXPECT_EQ(defects_of(mesh), (MeshDefects{.degenerate = 2}));
}

TEST(Defects, ALineHasNoAreaAndASliverHas) {
    // Thirds of a metre: the three points are on one line only if nothing is rounded.
    const float step = 0.33333334f;
    const ObjectMesh line = mesh_of({{0, 0, 0}, {step, step, step}, {2 * step, 2 * step, 2 * step}}, {{0, 1, 2}});
    EXPECT_EQ(defects_of(line), (MeshDefects{.degenerate = 1, .open_edges = 3}));
    ObjectMesh sliver = line;
    sliver.vertices[1][2] = std::nextafter(step, 1.0f);
    EXPECT_EQ(defects_of(sliver), (MeshDefects{.open_edges = 3}));
}

}  // namespace
}  // namespace enfilade::modeler::test
