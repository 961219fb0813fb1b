#include "tests/support/synthetic_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "tests/support/box_triangles.h"

namespace enfilade::test {
namespace {

accel::InputMesh coloured(const char* name, std::vector<std::array<float, 3>> vertices,
                          std::vector<std::array<std::uint32_t, 3>> triangles, std::uint32_t first_material) {
    accel::InputMesh mesh{name, std::move(vertices), std::move(triangles), {}};
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) mesh.triangle_materials.push_back(first_material + t % 2);
    return mesh;
}

std::vector<accel::InputMesh> meshes(std::uint32_t first_material) {
    std::vector<std::array<float, 3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.push_back({(k & 1) ? 0.5f : -0.5f, (k & 2) ? 0.4f : -0.4f, (k & 4) ? 0.9f : 0.0f});
    return {coloured("box", corners, box_triangles(), first_material),
            coloured("tetrahedron", {{-0.4f, -0.3f, 0}, {0.4f, -0.3f, 0}, {0, 0.3f, 0}, {0, 0, 0.7f}},
                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, first_material),
            coloured("flat", {{0, 0, 0}, {1, 0, 0}, {0.5f, 0, 0}}, {{0, 1, 2}, {0, 0, 0}, {1, 1, 2}}, first_material),
            coloured("nothing", {}, {}, first_material)};
}

std::array<double, 12> placed(double x, double y, double z, double angle, double size, bool mirrored) {
    const double c = std::cos(angle) * size, s = std::sin(angle) * size, sign = mirrored ? -1 : 1;
    return {sign * c, -s, 0, x, sign * s, c, 0, y, 0, 0, size, z};
}

}  // namespace

accel::SceneInput with_objects(accel::SceneInput input, std::uint64_t seed, std::size_t count) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto first_material = static_cast<std::uint32_t>(input.materials.size());
    input.materials.push_back({"cloth", {0.6f, 0.2f, 0.2f}});
    input.materials.push_back({"steel", {0.5f, 0.5f, 0.6f}});
    for (accel::InputMesh& mesh : meshes(first_material))
        input.meshes.push_back(std::make_shared<const accel::InputMesh>(std::move(mesh)));
    input.cell_objects.assign(input.cells.size(), {});
    for (std::size_t k = 0; k < count; ++k) {
        const auto c = static_cast<std::uint32_t>(random() % input.cells.size());
        const accel::InputSection& corner = input.sections[input.cells[c].first_section];
        const double at[3] = {corner.x * input.unit + 2 * uniform(), corner.y * input.unit + 2 * uniform(),
                              input.cells[c].z_floor * input.unit + uniform()};
        const double size = 0.2 + uniform();
        accel::InputObject object;
        object.id = "object " + std::to_string(100000 + k);
        object.name = "Object";
        object.mesh = static_cast<std::uint32_t>(random() % input.meshes.size());
        if (random() % 3 == 0) object.material = first_material + 1;
        object.space = input.cells[c].space;
        object.scene_from_object = placed(at[0], at[1], at[2], 7 * uniform(), size, random() % 2 == 0);
        for (std::uint32_t other = 0; other < input.cells.size(); ++other) {
            const std::size_t end =
                other + 1 < input.cells.size() ? input.cells[other + 1].first_section : input.sections.size();
            double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
            for (std::size_t s = input.cells[other].first_section; s < end; ++s) {
                const double p[2] = {input.sections[s].x * input.unit, input.sections[s].y * input.unit};
                for (int i = 0; i < 2; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
            }
            if (at[0] + size >= low[0] && at[0] - size <= high[0] && at[1] + size >= low[1] && at[1] - size <= high[1])
                input.cell_objects[other].push_back(static_cast<std::uint32_t>(k));
        }
        input.objects.push_back(std::move(object));
    }
    return input;
}

}  // namespace enfilade::test
