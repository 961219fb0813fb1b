#include "render/face_mesh.h"

#include <algorithm>
#include <utility>

#include "render/math.h"

namespace enfilade::render::detail {
namespace {

class MeshWriter {
public:
    MeshWriter(const accel::SceneView& scene, FaceShapes shapes) : scene_(scene), shapes_(shapes) {
        for (const accel::Cell& cell : scene.cells) {
            add_level(cell, cell.z_floor, cell.floor, true);
            add_level(cell, cell.z_ceiling, cell.ceiling, false);
            for (std::uint32_t i = 0; i < cell.section_count; ++i)
                add_section(cell, cell.first_section + i,
                            cell.first_section + (i + 1u == cell.section_count ? 0 : i + 1));
        }
    }
    FaceMesh mesh;

private:
    std::uint32_t add_vertex(std::uint32_t section, float z) {
        mesh.vertices.push_back({scene_.section_x[section], scene_.section_y[section], z});
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    }

    void add_primitive(std::initializer_list<std::uint32_t> corners, accel::Target target) {
        mesh.corners.insert(mesh.corners.end(), corners);
        const accel::SourceFace& face = scene_.source_faces[target.bits];
        const auto& colour = scene_.materials[index(face.material)].colour;
        const std::uint32_t sky = face.surface == accel::Surface::Sky ? sky_bit : 0;
        mesh.looks.push_back({root(colour[0]), root(colour[1]), root(colour[2]), target.bits | sky});
    }

    /// The convex polygon whose corners are the vertices from `first`.
    void add_fan(std::uint32_t first, std::uint32_t count, accel::Target target, bool is_reversed) {
        const auto corner = [&](std::uint32_t i) { return first + (is_reversed ? count - 1 - i : i); };
        if (shapes_ == FaceShapes::Triangles) {
            for (std::uint32_t i = 2; i < count; ++i) add_primitive({corner(0), corner(i - 1), corner(i)}, target);
            return;
        }
        for (std::uint32_t i = 2; i < count; i += 2)
            add_primitive({corner(0), corner(i - 1), corner(i), corner(std::min(i + 1, count - 1))}, target);
    }

    void add_level(const accel::Cell& cell, float z, accel::Target target, bool is_floor) {
        if (target.is_portal()) return;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) add_vertex(s, z);
        add_fan(first, cell.section_count, target, !is_floor);
    }

    void add_section(const accel::Cell& cell, std::uint32_t section, std::uint32_t next) {
        float below = cell.z_floor;
        for (std::uint32_t f = scene_.section_tails[section].first_face;
             f < scene_.section_tails[section + 1].first_face; ++f) {
            const accel::SideFace& face = scene_.side_faces[f];
            if (!face.target.is_portal()) {
                const std::uint32_t first = add_vertex(next, below);
                add_vertex(section, below);
                add_vertex(section, face.z_top);
                add_vertex(next, face.z_top);
                add_fan(first, 4, face.target, false);
            }
            below = face.z_top;
        }
    }

    const accel::SceneView& scene_;
    FaceShapes shapes_;
};

}  // namespace

FaceMesh face_mesh(const accel::SceneView& scene, FaceShapes shapes) {
    return std::move(MeshWriter(scene, shapes).mesh);
}

PrimitiveLook look_of(const accel::SceneView& scene, accel::MaterialId material) {
    const auto& colour = scene.materials[index(material)].colour;
    return {root(colour[0]), root(colour[1]), root(colour[2]), index(none<accel::SourceFaceId>) & ~sky_bit};
}

}  // namespace enfilade::render::detail
