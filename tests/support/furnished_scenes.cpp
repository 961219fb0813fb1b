#include "tests/support/furnished_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "accel/assemble.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/objects/put_objects.h"
#include "plans/generate.h"
#include "plans/random.h"
#include "plans/read.h"
#include "tests/support/box_triangles.h"

namespace enfilade::test {
namespace {

using modeler::ObjectMesh;
using Point = std::array<float, 3>;
using Corners = std::array<std::uint32_t, 3>;

ObjectMesh coloured(std::string name, std::vector<Point> vertices, std::vector<Corners> triangles) {
    ObjectMesh mesh{std::move(name), std::move(vertices), std::move(triangles), {}, {}};
    mesh.materials = {{mesh.name + " a", {0.7f, 0.3f, 0.2f}}, {mesh.name + " b", {0.2f, 0.5f, 0.7f}}, {"wood", {}}};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        mesh.triangle_materials.push_back(static_cast<std::uint32_t>(t * 7 % 3));
    return mesh;
}

ObjectMesh box_mesh() {
    std::vector<Point> vertices;
    for (int k = 0; k < 8; ++k)
        vertices.push_back({(k & 1) ? 0.5f : -0.5f, (k & 2) ? 0.3f : -0.3f, (k & 4) ? 0.8f : 0.0f});
    return coloured("box", vertices, box_triangles());
}

/// An octahedron's or icosahedron's faces halved again and again, on the unit sphere.
ObjectMesh sphere_mesh(int halvings) {
    const float t = (1 + std::sqrt(5.0f)) / 2;
    std::vector<Point> vertices = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                                   {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    std::vector<Corners> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int k = 0; k < halvings; ++k) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, vertices.size());
            if (is_new)
                vertices.push_back({(vertices[a][0] + vertices[b][0]) / 2, (vertices[a][1] + vertices[b][1]) / 2,
                                    (vertices[a][2] + vertices[b][2]) / 2});
            return at->second;
        };
        std::vector<Corners> finer;
        for (const Corners& c : triangles) {
            const std::uint32_t ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), ca = middle(c[2], c[0]);
            finer.insert(finer.end(), {{c[0], ab, ca}, {c[1], bc, ab}, {c[2], ca, bc}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    for (Point& p : vertices) {
        const float length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        p = {0.4f * p[0] / length, 0.4f * p[1] / length, 0.4f + 0.4f * p[2] / length};
    }
    return coloured("sphere " + std::to_string(triangles.size()), vertices, triangles);
}

/// Triangles that are none: points, lines, twice the same, slivers on one vertex.
ObjectMesh degenerate_mesh() {
    std::vector<Point> vertices = {{-0.4f, -0.4f, 0}, {0.4f, -0.4f, 0}, {0, 0.4f, 0.5f}, {0, 0, 0.5f}, {0.4f, 0.4f, 1}};
    std::vector<Corners> triangles = {{0, 0, 0}, {0, 1, 1}, {0, 3, 3}, {0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {1, 4, 2}};
    for (std::uint32_t k = 0; k < 40; ++k) triangles.push_back({0, 1, 2});
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (int k = 0; k <= 64; ++k) vertices.push_back({0.4f, -0.4f + 1e-6f * static_cast<float>(k), 1});
    for (std::uint32_t k = 0; k < 64; ++k) triangles.push_back({0, first + k, first + k + 1});
    return coloured("degenerate", vertices, triangles);
}

plans::GridPoint corner_of(const modeler::Building& building, const modeler::Piece& piece, std::uint32_t k) {
    return building.points[building.corners[piece.first_corner + k].vertex];
}

/// A place over the floor of a cell; often on its border.
plans::Point place_in(const modeler::Building& building, const modeler::Volume& cell, plans::Random& random) {
    const modeler::Piece& piece = building.pieces[cell.piece];
    std::array<plans::GridPoint, 3> p;
    for (plans::GridPoint& point : p) point = corner_of(building, piece, random.below(piece.corner_count));
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return {building.frame.world_x(p[0].x) + building.frame.unit * (u * (p[1].x - p[0].x) + v * (p[2].x - p[0].x)),
            building.frame.world_y(p[0].y) + building.frame.unit * (u * (p[1].y - p[0].y) + v * (p[2].y - p[0].y))};
}

void give_looks(modeler::FurnishedObject& object, plans::Random& random) {
    object.angle = random.chance(0.4) ? 1.5707963267948966 * random.below(4) : random.uniform(-7, 7);
    object.mirrored = random.chance(0.3);
    if (random.chance(0.2)) object.turned = {1, 0, 0, 0, 0, -1, 0, 1, 0};               // on its back
    else if (random.chance(0.2)) object.turned = {1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8};  // leaning
    if (random.chance(0.3))
        object.colour = std::array<float, 3>{0.1f * static_cast<float>(random.below(10)), 0.5f, 0.4f};
}

}  // namespace

std::vector<std::shared_ptr<const ObjectMesh>> test_meshes() {
    std::vector<ObjectMesh> meshes;
    meshes.push_back(box_mesh());
    meshes.push_back(coloured("tetrahedron", {{-0.4f, -0.3f, 0}, {0.4f, -0.3f, 0}, {0, 0.3f, 0}, {0, 0, 0.7f}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    for (const int halvings : {1, 3, 5}) meshes.push_back(sphere_mesh(halvings));
    meshes.push_back(
        coloured("square", {{-0.5f, 0, 0}, {0.5f, 0, 0}, {0.5f, 0, 1}, {-0.5f, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}));
    meshes.push_back(degenerate_mesh());
    meshes.push_back(coloured("tiny", {{-4e-7f, -3e-7f, 0}, {4e-7f, -3e-7f, 0}, {0, 3e-7f, 7e-7f}}, {{0, 1, 2}}));
    meshes.push_back(coloured("vertex", {{0, 0, 0}}, {}));
    meshes.push_back(coloured("nothing", {}, {}));
    std::vector<std::shared_ptr<const ObjectMesh>> shared;
    for (ObjectMesh& mesh : meshes) shared.push_back(std::make_shared<const ObjectMesh>(std::move(mesh)));
    return shared;
}

modeler::Furnishing random_furnishing(const modeler::Building& building, std::uint64_t seed, std::size_t count) {
    modeler::Furnishing furnishing;
    furnishing.meshes = test_meshes();
    plans::Random random{seed, 0x0b7ec7};
    std::vector<std::uint32_t> cells;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].label == accel::Label::Room ||
            (building.volumes[v].label == accel::Label::Exterior && v % 7 == 0))
            cells.push_back(v);
    for (std::size_t k = 0; k < count && !cells.empty(); ++k) {
        const modeler::Volume& cell = building.volumes[cells[random.below(static_cast<std::uint32_t>(cells.size()))]];
        modeler::FurnishedObject object;
        object.id = "object-" + std::to_string(1000000 + k).substr(1);
        object.name = "Object " + std::to_string(k);
        // Most are whole; the last four meshes are none that one sees.
        object.mesh = random.chance(0.9) ? random.below(6) : 6 + random.below(4);
        object.model = "test/" + furnishing.meshes[object.mesh]->name;
        object.space = cell.space;
        const plans::Point at = place_in(building, cell, random);
        const double floor = building.frame.world_z(cell.z_low),
                     height = building.frame.unit * (cell.z_high - cell.z_low);
        object.size = {random.uniform(0.05, 1.2), random.uniform(0.05, 1.2), random.uniform(0.05, 1.2)};
        object.position = {at.x, at.y, random.chance(0.7) ? floor : floor + random.uniform() * std::min(height, 2.5)};
        give_looks(object, random);
        furnishing.objects.push_back(std::move(object));
    }
    return furnishing;
}

modeler::Building furnished(const modeler::Building& building, std::uint64_t seed, std::size_t count,
                            modeler::ObjectCells cells) {
    modeler::Furnishing furnishing = random_furnishing(building, seed, count);
    furnishing.cells = cells;
    std::vector<Finding> findings;
    return modeler::put_objects(building, std::move(furnishing), findings);
}

modeler::Building house(FurnishedHouse which) {
    const auto plan = [&] {
        if (which == FurnishedHouse::Townhouse)
            return plans::read(ENFILADE_SOURCE_DIR "/plans/examples/townhouse.json");
        if (which == FurnishedHouse::Office) return plans::generate({.rooms = 12, .seed = 5});
        return plans::generate({.rooms = 8, .curved = 0.5, .oblique = 0.5, .seed = 6});
    };
    return modeler::convexify(modeler::build(plan()));
}

accel::Scene furnished_scene(FurnishedHouse which, std::uint64_t seed, std::size_t count, modeler::ObjectCells cells) {
    return accel::assemble(modeler::scene_input(furnished(house(which), seed, count, cells)));
}

}  // namespace enfilade::test
