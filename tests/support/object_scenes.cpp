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
        object.id = "object " + std::to_string(1000 + i);
        object.mesh = i;
        object.scene_from_object = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        input.objects.push_back(object);
        input.cell_objects[0].push_back(i);
    }
    return accel::assemble(input);
}

namespace {

using Rows = std::array<double, 12>;

/// Low and high corner of the mesh where it is placed, a millimetre wider.
std::array<Vec3d, 2> box_of(const accel::InputMesh& mesh, const Rows& m) {
    Vec3d low = {1e30, 1e30, 1e30}, high = {-1e30, -1e30, -1e30};
    for (const auto& v : mesh.vertices) {
        const auto row = [&](std::size_t r) { return m[r] * v[0] + m[r + 1] * v[1] + m[r + 2] * v[2] + m[r + 3]; };
        const Vec3d p = {row(0), row(4), row(8)};
        low = {std::min(low.x, p.x - 1e-3), std::min(low.y, p.y - 1e-3), std::min(low.z, p.z - 1e-3)};
        high = {std::max(high.x, p.x + 1e-3), std::max(high.y, p.y + 1e-3), std::max(high.z, p.z + 1e-3)};
    }
    return {low, high};
}

/// Whether the box shares a place with the cell: no side of either has the other beyond it.
bool overlaps(const accel::SceneInput& input, std::size_t cell, const std::array<Vec3d, 2>& box) {
    const accel::InputCell& c = input.cells[cell];
    const auto& [low, high] = box;
    if (low.z > c.z_ceiling * input.unit || high.z < c.z_floor * input.unit) return false;
    const std::size_t end = cell + 1 < input.cells.size() ? input.cells[cell + 1].first_section : input.sections.size();
    double x0 = 1e30, y0 = 1e30, x1 = -1e30, y1 = -1e30;
    for (std::size_t i = c.first_section; i < end; ++i) {
        const std::size_t j = i + 1 < end ? i + 1 : c.first_section;
        const double ax = input.sections[i].x * input.unit, ay = input.sections[i].y * input.unit;
        const double ex = input.sections[j].x * input.unit - ax, ey = input.sections[j].y * input.unit - ay;
        x0 = std::min(x0, ax), x1 = std::max(x1, ax), y0 = std::min(y0, ay), y1 = std::max(y1, ay);
        const auto side = [&](double x, double y) { return ex * (y - ay) - ey * (x - ax); };  // left is inside
        if (std::max({side(low.x, low.y), side(high.x, low.y), side(high.x, high.y), side(low.x, high.y)}) < 0)
            return false;
    }
    return low.x <= x1 && high.x >= x0 && low.y <= y1 && high.y >= y0;
}

/// A turn about z, now and then about any axis, with sizes along the object's own axes.
Rows random_placement(std::mt19937_64& random, Vec3d at, const FurnishedOptions& options) {
    const auto number = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const double angle = random() % 3 == 0   ? 0.5 * std::numbers::pi * static_cast<double>(random() % 4)
                         : random() % 5 == 0 ? 1e-7
                                             : 7 * number();
    const double lean = random() % 4 == 0 ? 7 * number() : 0;
    const double c = std::cos(angle), s = std::sin(angle), cl = std::cos(lean), sl = std::sin(lean);
    const std::array<double, 9> turn = {c, -s * cl, s * sl, s, c * cl, -c * sl, 0, sl, cl};
    const double size = 0.25 + 0.75 * number();
    std::array<double, 3> scale = {size, size, size};
    if (options.stretched) scale = {size, size * (0.2 + number()), size * (0.2 + number())};
    if (random() % 3 == 0) scale[0] = -scale[0];
    Rows rows{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t k = 0; k < 3; ++k) rows[4 * r + k] = turn[3 * r + k] * scale[k] / options.mesh_scale;
    rows[3] = at.x, rows[7] = at.y, rows[11] = at.z;
    return rows;
}

}  // namespace

void list_objects(accel::SceneInput& input) {
    input.cell_objects.assign(input.cells.size(), {});
    for (std::uint32_t i = 0; i < input.objects.size(); ++i) {
        const accel::InputMesh& mesh = *input.meshes[input.objects[i].mesh];
        if (mesh.vertices.empty()) continue;
        const auto box = box_of(mesh, input.objects[i].scene_from_object);
        for (std::size_t cell = 0; cell < input.cells.size(); ++cell)
            if (overlaps(input, cell, box)) input.cell_objects[cell].push_back(i);
    }
}

accel::Scene furnished_office(const FurnishedOptions& options) {
    accel::SceneInput input = synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = options.turn});
    const auto s = static_cast<float>(options.mesh_scale);
    std::vector<accel::InputMesh> meshes = {box_mesh({-s, -s, -s}, {s, s, s}), ball_mesh(6, s),
                                            random_soup(40, 0.5f, options.seed), box_mesh({-s, 0, -s}, {s, 0, s})};
    for (auto& v : meshes[2].vertices)
        for (float& number : v) number *= s;
    for (const char* name : {"red", "green", "blue"})
        input.materials.push_back({name, {name[0] == 'r' ? 0.8f : 0.1f, name[0] == 'g' ? 0.8f : 0.1f, 0.3f}});
    const auto first = static_cast<std::uint32_t>(input.materials.size() - 3);
    for (accel::InputMesh& mesh : meshes) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            mesh.triangle_materials[t] = first + static_cast<std::uint32_t>(t % 3);
        input.meshes.push_back(std::make_shared<accel::InputMesh>(std::move(mesh)));
    }
    std::mt19937_64 random(options.seed);
    for (int i = 0; i < options.objects; ++i) {
        const accel::InputCell& cell = input.cells[random() % input.cells.size()];
        const accel::InputSection& corner = input.sections[cell.first_section];
        const auto near = [&](std::int32_t from) {
            return from * input.unit + 4 * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        accel::InputObject object;
        object.id = "object " + std::to_string(1000 + i);
        object.mesh = static_cast<std::uint32_t>(random() % input.meshes.size());
        object.material = random() % 4 == 0 ? first : UINT32_MAX;
        const Vec3d at = {near(corner.x), near(corner.y), near(cell.z_floor) * 0.5};
        object.scene_from_object = random_placement(random, at, options);
        input.objects.push_back(object);
    }
    list_objects(input);
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
