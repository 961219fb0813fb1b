// The triangles of a scene.

#include "modeler/exports/scene_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "accel/assemble.h"
#include "modeler/catalogue/image_mean.h"
#include "modeler/catalogue/mtl.h"
#include "modeler/exports/obj.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::modeler {
namespace {

accel::Scene office() { return accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2, .storeys = 2})); }

/// Area of a mesh's triangles.
double area(const SceneMesh& mesh) {
    double sum = 0;
    for (const MeshSpace& space : mesh.spaces)
        for (const MeshPart& part : space.parts)
            for (std::size_t i = 0; i < part.indices.size(); i += 3) {
                const auto& a = part.positions[part.indices[i]];
                const auto& b = part.positions[part.indices[i + 1]];
                const auto& c = part.positions[part.indices[i + 2]];
                const double u[3] = {double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2]};
                const double v[3] = {double(c[0]) - a[0], double(c[1]) - a[1], double(c[2]) - a[2]};
                const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
                sum += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
            }
    return sum;
}

/// Area of the scene's solid faces but the sky's, from the cells: another way to the same number.
double solid_area(const accel::SceneView& scene) {
    double sum = 0;
    const auto add = [&](accel::Target target, double area) {
        if (!target.is_portal() && scene.source_faces[index(target.source_face())].surface != accel::Surface::Sky)
            sum += area;
    };
    for (const accel::Cell& cell : scene.cells) {
        double floor2 = 0;
        for (std::uint32_t k = 0; k < cell.section_count; ++k) {
            const std::uint32_t p = cell.first_section + k;
            const std::uint32_t q = cell.first_section + (k + 1u == cell.section_count ? 0 : k + 1);
            floor2 += double(scene.section_x[p]) * scene.section_y[q] - double(scene.section_x[q]) * scene.section_y[p];
            const double width = std::hypot(double(scene.section_x[q]) - scene.section_x[p],
                                            double(scene.section_y[q]) - scene.section_y[p]);
            double low = cell.z_floor;
            for (std::uint32_t f = scene.section_tails[p].first_face; f < scene.section_tails[p + 1].first_face; ++f) {
                add(scene.side_faces[f].target, width * (scene.side_faces[f].z_top - low));
                low = scene.side_faces[f].z_top;
            }
        }
        add(cell.floor, floor2 / 2);
        add(cell.ceiling, floor2 / 2);
    }
    return sum;
}

TEST(SceneMesh, CoversWhatTheCellsSee) {
    const accel::Scene scene = office();
    const SceneMesh mesh = scene_mesh(scene.view());
    double panes = 0;
    for (const MeshSpace& space : mesh.spaces)
        for (const MeshPart& part : space.parts)
            if (mesh.materials[part.material].opacity < 1)
                panes += area({mesh.materials, {{space.space, space.name, {part}}}});
    EXPECT_NEAR(area(mesh) - panes, solid_area(scene.view()), 1e-3);
}

TEST(SceneMesh, NamesAreUniqueAndNotEmpty) {
    const accel::Scene scene = office();
    std::set<std::string> names;
    const SceneMesh mesh = scene_mesh(scene.view());
    for (const MeshSpace& space : mesh.spaces) {
        EXPECT_FALSE(space.name.empty());
        EXPECT_TRUE(names.insert(space.name).second) << space.name;
    }
    EXPECT_GT(names.size(), 8u);
}

TEST(SceneMesh, NormalsAreOfLengthOne) {
    const accel::Scene scene = office();
    for (const MeshSpace& space : scene_mesh(scene.view()).spaces)
        for (const MeshPart& part : space.parts)
            for (const auto& [x, y, z] : part.normals)
                ASSERT_NEAR(double(x) * x + double(y) * y + double(z) * z, 1, 1e-6);
}

TEST(Obj, IndicesStayWithinItsVertices) {
    const accel::Scene scene = office();
    const ObjText text = to_obj(scene.view(), "office.mtl");
    EXPECT_TRUE(text.obj.starts_with("mtllib office.mtl\n"));
    std::size_t vertices = 0, largest = 0, faces = 0;
    std::size_t at = 0;
    while (at < text.obj.size()) {
        const std::size_t end = text.obj.find('\n', at);
        const std::string line = text.obj.substr(at, end - at);
        at = end + 1;
        vertices += line.starts_with("v ");
        if (!line.starts_with("f ")) continue;
        ++faces;
        for (std::size_t k = 2; k < line.size();
             k = line.find(' ', k) == std::string::npos ? line.size() : line.find(' ', k) + 1)
            largest = std::max(largest, std::size_t(std::stoul(line.substr(k))));
    }
    EXPECT_EQ(largest, vertices);
    EXPECT_EQ(faces, scene_mesh(scene.view()).triangle_count());
}

TEST(Obj, ColoursComeBackAsOurReaderOfModelsTakesThem) {
    const accel::Scene scene = office();
    const auto read = read_mtl(to_obj(scene.view(), "office.mtl").mtl);
    std::size_t between = 0;  // colours that linear numbers in the file would darken
    for (const MeshMaterial& material : scene_mesh(scene.view()).materials) {
        std::string name = material.name;
        std::ranges::replace(name, ' ', '_');
        ASSERT_TRUE(read.contains(name) && read.at(name).diffuse) << name;
        const std::array<float, 3> colour = linear_colour(*read.at(name).diffuse);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(colour[k], material.colour[k], 2e-6) << material.name;
            between += material.colour[k] > 0.05f && material.colour[k] < 0.95f ? 1 : 0;
        }
    }
    EXPECT_GT(between, 0u);
}

}  // namespace
}  // namespace enfilade::modeler
