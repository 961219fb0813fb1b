#include "tests/support/surface_places.h"

#include <cmath>

#include "plans/random.h"

namespace enfilade::test {
namespace {

using render::Vec3d;

/// A parallelogram or, with half of it, a triangle.
struct Patch {
    Vec3d corner, a, b;
    bool is_triangle;
    Vec3d normal;
    accel::CellId cell;
    accel::MaterialId material;
    double area;
};

class Patches {
public:
    explicit Patches(const accel::SceneView& scene) : scene_(scene) {
        for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
            add_level(c, scene.cells[c].floor, scene.cells[c].z_floor, 1);
            add_level(c, scene.cells[c].ceiling, scene.cells[c].z_ceiling, -1);
            add_sides(c);
        }
    }
    std::vector<Patch> all;

private:
    [[nodiscard]] bool is_surface(accel::Target target) const {
        return !target.is_portal() && scene_.source_faces[index(target.source_face())].surface != accel::Surface::Sky;
    }
    void add(Vec3d corner, Vec3d a, Vec3d b, bool is_triangle, Vec3d normal, std::uint32_t cell, accel::Target target) {
        const double area = length(cross(a, b)) * (is_triangle ? 0.5 : 1);
        all.push_back({corner, a, b, is_triangle, normal, static_cast<accel::CellId>(cell),
                       scene_.source_faces[index(target.source_face())].material, area});
    }
    [[nodiscard]] Vec3d line(std::uint32_t section, double z) const {
        return {double{scene_.section_x[section]}, double{scene_.section_y[section]}, z};
    }
    void add_level(std::uint32_t c, accel::Target target, double z, double up) {
        if (!is_surface(target)) return;
        const accel::Cell& cell = scene_.cells[c];
        const Vec3d first = line(cell.first_section, z);
        for (std::uint32_t i = 1; i + 1 < cell.section_count; ++i)
            add(first, line(cell.first_section + i, z) - first, line(cell.first_section + i + 1, z) - first, true,
                {0, 0, up}, c, target);
    }
    void add_sides(std::uint32_t c) {
        const accel::Cell& cell = scene_.cells[c];
        for (std::uint32_t i = 0; i < cell.section_count; ++i) {
            const std::uint32_t s = cell.first_section + i, q = cell.first_section + (i + 1u) % cell.section_count;
            double z = cell.z_floor;
            for (std::uint32_t f = scene_.section_tails[s].first_face; f < scene_.section_tails[s + 1].first_face;
                 ++f) {
                const double top = scene_.side_faces[f].z_top;
                const Vec3d along = line(q, z) - line(s, z);
                if (is_surface(scene_.side_faces[f].target))
                    add(line(s, z), along, {0, 0, top - z}, false, normalized(Vec3d{-along.y, along.x, 0}), c,
                        scene_.side_faces[f].target);
                z = top;
            }
        }
    }
    const accel::SceneView& scene_;
};

}  // namespace

SurfacePlaces surface_places(const accel::SceneView& scene, std::size_t count, std::uint64_t seed) {
    const Patches patches(scene);
    SurfacePlaces places;
    for (const Patch& patch : patches.all) places.area += patch.area;
    plans::Random random{seed};
    std::size_t i = 0;
    double before = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double wanted = (static_cast<double>(k) + random.uniform()) * places.area / static_cast<double>(count);
        while (i + 1 < patches.all.size() && before + patches.all[i].area < wanted) before += patches.all[i++].area;
        const Patch& patch = patches.all[i];
        double u = random.uniform(), v = random.uniform();
        if (patch.is_triangle && u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        places.points.push_back(render::vec_cast<float>(patch.corner + u * patch.a + v * patch.b));
        places.normals.push_back(render::vec_cast<float>(patch.normal));
        places.cells.push_back(patch.cell);
        places.materials.push_back(patch.material);
    }
    return places;
}

}  // namespace enfilade::test
