// Meshes of fewer triangles, and how far their surface moved.

#include "modeler/catalogue/decimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "modeler/catalogue/manifold.h"
#include "modeler/catalogue/nearest_surface.h"

namespace enfilade::modeler::test {
namespace {

/// A sphere of radius 1 around the origin; each half of another material.
ObjectMesh sphere(std::uint32_t rings, std::uint32_t sectors) {
    ObjectMesh mesh;
    mesh.materials = {{"south", {1, 0, 0}}, {"north", {0, 0, 1}}};
    mesh.vertices.push_back({0, 0, -1});
    for (std::uint32_t r = 1; r < rings; ++r)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const double u = M_PI * r / rings - M_PI / 2;
            const double v = 2 * M_PI * s / sectors;
            mesh.vertices.push_back(
                {float(std::cos(u) * std::cos(v)), float(std::cos(u) * std::sin(v)), float(std::sin(u))});
        }
    mesh.vertices.push_back({0, 0, 1});
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto at = [&](std::uint32_t r, std::uint32_t s) { return 1 + (r - 1) * sectors + s % sectors; };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, bool north) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangle_materials.push_back(north);
    };
    for (std::uint32_t s = 0; s < sectors; ++s) {
        add(0, at(1, s + 1), at(1, s), false);
        add(last, at(rings - 1, s), at(rings - 1, s + 1), true);
        for (std::uint32_t r = 1; r + 1 < rings; ++r) {
            add(at(r, s), at(r, s + 1), at(r + 1, s), r >= rings / 2);
            add(at(r, s + 1), at(r + 1, s + 1), at(r + 1, s), r >= rings / 2);
        }
    }
    return mesh;
}

/// A square sheet in the plane, n x n cells.
ObjectMesh sheet(std::uint32_t n) {
    ObjectMesh mesh;
    mesh.materials = {{"paper"}};
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x) mesh.vertices.push_back({float(x) / float(n), float(y) / float(n), 0});
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x;
            mesh.triangles.push_back({a, a + 1, a + n + 1});
            mesh.triangles.push_back({a + 1, a + n + 2, a + n + 1});
        }
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    return mesh;
}

double area_of(const ObjectMesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        std::array<double, 3> u{}, v{};
        for (std::size_t k = 0; k < 3; ++k) {
            u[k] = double(mesh.vertices[b][k]) - mesh.vertices[a][k];
            v[k] = double(mesh.vertices[c][k]) - mesh.vertices[a][k];
        }
        area += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
    }
    return area;
}

TEST(Decimation, LeavesMeshesAloneThatAreSmallEnough) {
    const ObjectMesh mesh = sphere(8, 12);
    for (const std::uint32_t wanted : {0u, std::uint32_t(mesh.triangles.size()), 1000000u}) {
        const LoadedMesh loaded = decimated(mesh, wanted);
        EXPECT_EQ(loaded.mesh, mesh);
        EXPECT_EQ(loaded.error, 0);
        EXPECT_EQ(loaded.refused, "");
    }
}

TEST(Decimation, MeasuresHowFarTheSurfaceOfASphereMoved) {
    const ObjectMesh mesh = sphere(60, 90);
    const LoadedMesh loaded = decimated(mesh, 1000);
    EXPECT_EQ(loaded.triangles_before, mesh.triangles.size());
    EXPECT_EQ(loaded.refused, "");
    EXPECT_LE(loaded.mesh.triangles.size(), 1000u);
    EXPECT_GE(loaded.mesh.triangles.size(), 990u);
    EXPECT_EQ(why_no_manifold(loaded.mesh), "");
    EXPECT_EQ(defects_of(loaded.mesh), MeshDefects{});
    // Corners stay on the sphere: the farthest point of the surface is inside of a triangle, which is what is measured.
    double deepest = 0;
    for (const auto& [a, b, c] : loaded.mesh.triangles) {
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x =
                (double(loaded.mesh.vertices[a][k]) + loaded.mesh.vertices[b][k] + loaded.mesh.vertices[c][k]) / 3;
            length += x * x;
        }
        deepest = std::max(deepest, 1 - std::sqrt(length));
    }
    EXPECT_GE(loaded.error, deepest - 0.002);  // the sphere itself lies up to 0.002 within the ideal one
    EXPECT_LT(loaded.error, 0.05);
}

TEST(Decimation, KeepsMaterialsAndTheirBorders) {
    const LoadedMesh loaded = decimated(sphere(60, 90), 1200);
    std::map<std::uint32_t, std::pair<float, float>> range;
    for (std::size_t t = 0; t < loaded.mesh.triangles.size(); ++t)
        for (const std::uint32_t v : loaded.mesh.triangles[t]) {
            auto& [low, high] = range.try_emplace(loaded.mesh.triangle_materials[t], 9.f, -9.f).first->second;
            low = std::min(low, loaded.mesh.vertices[v][2]);
            high = std::max(high, loaded.mesh.vertices[v][2]);
        }
    ASSERT_EQ(range.size(), 2u);
    EXPECT_NEAR(range[0].second, 0, 1e-6);
    EXPECT_NEAR(range[1].first, 0, 1e-6);
}

TEST(Decimation, KeepsTheOutlineOfAnOpenSheet) {
    const LoadedMesh loaded = decimated(sheet(40), 100);
    EXPECT_LE(loaded.mesh.triangles.size(), 100u);
    EXPECT_NEAR(area_of(loaded.mesh), 1, 1e-6);
    EXPECT_NEAR(loaded.error, 0, 1e-6);
}

TEST(Decimation, RefusesWhatIsNoManifoldAndSaysWhy) {
    ObjectMesh fan = sheet(10);
    fan.triangles.push_back({0, 1, 50});
    fan.triangle_materials.push_back(0);
    const LoadedMesh crowded = decimated(fan, 20);
    EXPECT_EQ(crowded.mesh, fan);
    EXPECT_NE(crowded.refused, "");
    ObjectMesh twice = sheet(10);
    twice.triangles.push_back(twice.triangles[3]);
    twice.triangle_materials.push_back(0);
    EXPECT_NE(decimated(twice, 20).refused, "");
    // Two sheets that share one vertex.
    ObjectMesh bow = sheet(10);
    const auto first = static_cast<std::uint32_t>(bow.vertices.size());
    bow.vertices.push_back({-1, 0, 0});
    bow.vertices.push_back({0, -1, 0});
    bow.triangles.push_back({0, first, first + 1});
    bow.triangle_materials.push_back(0);
    EXPECT_NE(decimated(bow, 20).refused.find("sheets meet"), std::string::npos);
}

TEST(Decimation, CollapsedTrianglesDoNotKeepTheOthersFromIt) {
    ObjectMesh mesh = sheet(20);
    mesh.triangles.push_back({7, 7, 8});
    mesh.triangle_materials.push_back(0);
    const LoadedMesh loaded = decimated(mesh, 60);
    EXPECT_EQ(loaded.refused, "");
    EXPECT_LE(loaded.mesh.triangles.size(), 60u);
}

TEST(Decimation, IsTheSameEachTime) {
    EXPECT_EQ(decimated(sphere(30, 40), 500).mesh, decimated(sphere(30, 40), 500).mesh);
}

TEST(NearestSurface, AgreesWithTryingEveryTriangle) {
    const ObjectMesh mesh = sphere(12, 16);
    const NearestSurface tree(mesh);
    for (int k = 0; k < 200; ++k) {
        const std::array<double, 3> p = {std::sin(k * 1.3) * 2, std::cos(k * 2.1) * 2, std::sin(k * 0.7 + 1) * 2};
        double least = 1e9;
        for (const auto& triangle : mesh.triangles) {
            ObjectMesh one{
                .vertices = mesh.vertices, .triangles = {triangle}, .triangle_materials = {0}, .materials = {{}}};
            least = std::min(least, NearestSurface(one).distance_squared(p, 1e9));
        }
        EXPECT_DOUBLE_EQ(tree.distance_squared(p, 1e9), least);
    }
}

}  // namespace
}  // namespace enfilade::modeler::test
