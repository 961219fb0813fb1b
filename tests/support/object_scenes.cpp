#include "tests/support/object_scenes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "accel/assemble.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::test {

using render::Vec3d;

accel::InputMesh soup(const std::vector<std::array<std::array<float, 3>, 3>>& triangles) {
    accel::InputMesh mesh;
    mesh.name = "soup";
    for (const auto& triangle : triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), triangle.begin(), triangle.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    return mesh;
}

accel::InputMesh box_mesh(std::array<float, 3> low, std::array<float, 3> high) {
    accel::InputMesh mesh;
    mesh.name = "box";
    for (unsigned i = 0; i < 8; ++i)
        mesh.vertices.push_back(
            {(i & 1u) != 0 ? high[0] : low[0], (i & 2u) != 0 ? high[1] : low[1], (i & 4u) != 0 ? high[2] : low[2]});
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    quad(0, 2, 3, 1);
    quad(4, 5, 7, 6);
    quad(0, 1, 5, 4);
    quad(2, 6, 7, 3);
    quad(0, 4, 6, 2);
    quad(1, 3, 7, 5);
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    return mesh;
}

accel::InputMesh ball_mesh(int rings, float radius) {
    accel::InputMesh mesh;
    mesh.name = "ball";
    const int around = 2 * rings;
    for (int i = 0; i <= rings; ++i) {
        for (int j = 0; j < around; ++j) {
            const double polar = std::numbers::pi * i / rings, turn = 2 * std::numbers::pi * j / around;
            const double r = radius * (1 + 0.05 * std::sin(9 * polar) * std::cos(11 * turn));
            const bool is_pole = i == 0 || i == rings;
            mesh.vertices.push_back({static_cast<float>(is_pole ? 0 : r * std::sin(polar) * std::cos(turn)),
                                     static_cast<float>(is_pole ? 0 : r * std::sin(polar) * std::sin(turn)),
                                     static_cast<float>(is_pole ? (i == 0 ? radius : -radius) : r * std::cos(polar))});
        }
    }
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < around; ++j) {
            const auto at = [&](int ring, int step) {
                return static_cast<std::uint32_t>((i + ring) * around + (j + step) % around);
            };
            mesh.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
            mesh.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
    }
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    return mesh;
}

accel::InputMesh random_soup(std::uint32_t count, float size, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto number = [&] { return static_cast<float>(random() >> 40) * 0x1p-23f - 1; };
    std::vector<std::array<std::array<float, 3>, 3>> triangles(count);
    for (auto& triangle : triangles) {
        const std::array<float, 3> middle = {number(), number(), number()};
        for (auto& corner : triangle)
            for (std::size_t k = 0; k < 3; ++k) corner[k] = middle[k] + size * number();
    }
    return soup(triangles);
}

accel::Scene room_of_meshes(const std::vector<accel::InputMesh>& meshes) {
    accel::SceneInput input =
        scene_from_plots({{grid(-4), grid(-4), grid(4), grid(4), {{.z_floor = grid(0), .z_ceiling = grid(4)}}}});
    input.cell_objects.resize(input.cells.size());
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        input.meshes.push_back(std::make_shared<accel::InputMesh>(meshes[i]));
        accel::InputObject object;
        object.id = "object " + std::to_string(i);
        object.mesh = i;
        object.scene_from_object = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        input.objects.push_back(object);
        input.cell_objects[0].push_back(i);
    }
    return accel::assemble(input);
}

std::optional<BruteHit> brute_nearest(const accel::SceneView& scene, accel::MeshId id, Vec3d origin, Vec3d direction,
                                      double near, double far) {
    const accel::ObjectMesh& mesh = scene.meshes[index(id)];
    std::optional<BruteHit> best;
    for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
        const auto& corners = scene.mesh_triangles[mesh.first_triangle + t].corners;
        std::array<Vec3d, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const accel::Vertex& v = scene.mesh_vertices[mesh.first_vertex + corners[k]];
            p[k] = {v.x, v.y, v.z};
        }
        const Vec3d e1 = p[1] - p[0], e2 = p[2] - p[0], q = cross(direction, e2), s = origin - p[0];
        const double det = dot(e1, q);
        if (!(det < 0 || det > 0)) continue;
        const double u = dot(s, q) / det;
        const Vec3d r = cross(s, e1);
        const double v = dot(direction, r) / det, distance = dot(e2, r) / det;
        if (!(u >= 0 && v >= 0 && u + v <= 1 && distance >= near && distance <= far)) continue;
        if (!best || distance < best->t) best = {distance, t, std::min({u, v, 1 - u - v})};
    }
    return best;
}

}  // namespace enfilade::test
