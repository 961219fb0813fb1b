#include "modeler/exports/scene_mesh.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "modeler/exports/triangulate.h"

namespace enfilade::modeler {

namespace {

using Point3 = std::array<float, 3>;
constexpr float glass_opacity = 0.25f;

/// Normal of a flat ring by Newell's sum, not of unit length.
std::array<double, 3> newell_normal(std::span<const Point3> ring) {
    std::array<double, 3> normal = {};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point3& p = ring[i];
        const Point3& q = ring[(i + 1) % ring.size()];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            normal[axis] += (double(p[u]) - q[u]) * (double(p[v]) + q[v]);
        }
    }
    return normal;
}

/// Fills a mesh, space by space.
class Builder {
public:
    explicit Builder(const accel::SceneView& scene) : scene_(scene), parts_(scene.spaces.size()) {
        std::set<std::string> taken;
        for (const accel::Material& material : scene.materials)
            mesh_.materials.push_back({unique(std::string(scene.string(material.name)), taken), material.colour, 1});
    }

    void add_source_faces() {
        for (std::size_t f = 0; f < scene_.source_face_count(); ++f) {
            const accel::SourceFace& face = scene_.source_faces[f];
            if (face.surface == accel::Surface::Sky) continue;
            std::vector<Point3> ring;
            for (std::uint32_t v = face.first_vertex; v < scene_.source_faces[f + 1].first_vertex; ++v)
                ring.push_back({scene_.vertices[v].x, scene_.vertices[v].y, scene_.vertices[v].z});
            add_ring(ring, face.space, std::uint32_t(index(face.material)));
        }
    }

    /// The glass portals, each once, from the cell in front of it. They are always side faces: windows stand.
    void add_panes() {
        for (std::size_t c = 0; c < scene_.cells.size(); ++c) {
            const accel::Cell& cell = scene_.cells[c];
            for (std::uint32_t k = 0; k < cell.section_count; ++k) {
                const std::uint32_t here = cell.first_section + k;
                const std::uint32_t next = cell.first_section + (k + 1u == cell.section_count ? 0 : k + 1);
                float low = cell.z_floor;
                for (std::uint32_t f = scene_.section_tails[here].first_face;
                     f < scene_.section_tails[here + 1].first_face; ++f) {
                    const float high = scene_.side_faces[f].z_top;
                    const accel::PortalId portal = scene_.side_face_portals[f];
                    if (scene_.side_faces[f].target.is_glass() && index(scene_.portals[index(portal)].front) == c)
                        add_pane(here, next, low, high, cell.space, scene_.portals[index(portal)].tint());
                    low = high;
                }
            }
        }
    }

    SceneMesh take() {
        std::set<std::string> taken;
        for (std::size_t s = 0; s < parts_.size(); ++s) {
            if (parts_[s].empty()) continue;
            MeshSpace space{accel::SpaceId(s), unique(name(s), taken), {}};
            for (auto& [material, part] : parts_[s]) space.parts.push_back(std::move(part));
            mesh_.spaces.push_back(std::move(space));
        }
        return std::move(mesh_);
    }

private:
    std::string name(std::size_t s) const {
        const accel::Space& space = scene_.spaces[s];
        for (const accel::TextId text : {space.name, space.id})
            if (!scene_.string(text).empty()) return std::string(scene_.string(text));
        return accel::name_of(space.label);
    }

    static std::string unique(std::string name, std::set<std::string>& taken) {
        if (name.empty()) name = "unnamed";
        std::string candidate = name;
        for (int k = 2; !taken.insert(candidate).second; ++k) candidate = name + " (" + std::to_string(k) + ")";
        return candidate;
    }

    MeshPart& part(accel::SpaceId space, std::uint32_t material) {
        MeshPart& part = parts_[index(space)][material];
        part.material = material;
        return part;
    }

    void add_ring(std::span<const Point3> ring, accel::SpaceId space, std::uint32_t material) {
        const std::array<double, 3> normal = newell_normal(ring);
        const double length = std::hypot(normal[0], normal[1], normal[2]);
        if (!(length > 0)) return;
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
        // Seen along the largest axis of the normal, from the side where the ring runs counter-clockwise.
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        const double side = normal[axis] > 0 ? 1 : -1;
        std::vector<GridPoint2> flat;
        for (const Point3& point : ring)
            flat.push_back({std::llround(side * point[u] / scene_.unit), std::llround(point[v] / scene_.unit)});

        MeshPart& into = part(space, material);
        const auto first = std::uint32_t(into.positions.size());
        into.positions.insert(into.positions.end(), ring.begin(), ring.end());
        const Point3 unit = {float(normal[0] / length), float(normal[1] / length), float(normal[2] / length)};
        into.normals.insert(into.normals.end(), ring.size(), unit);
        for (const auto& triangle : triangulate(flat))
            for (const std::uint32_t corner : triangle) into.indices.push_back(first + corner);
    }

    void add_pane(std::uint32_t here, std::uint32_t next, float low, float high, accel::SpaceId space,
                  std::uint32_t tint) {
        const auto [found, fresh] = glass_.try_emplace(tint, std::uint32_t(mesh_.materials.size()));
        if (fresh) {
            const accel::Vertex colour = scene_.tints[tint];
            mesh_.materials.push_back({"glass " + std::to_string(tint), {colour.x, colour.y, colour.z}, glass_opacity});
        }
        const auto corner = [&](std::uint32_t section, float z) {
            return Point3{scene_.section_x[section], scene_.section_y[section], z};
        };
        // Sections run counter-clockwise: seen from inside the cell, from right to left.
        const std::array ring = {corner(next, low), corner(here, low), corner(here, high), corner(next, high)};
        add_ring(ring, space, found->second);
    }

    const accel::SceneView& scene_;
    SceneMesh mesh_;
    std::vector<std::map<std::uint32_t, MeshPart>> parts_;  ///< [space_count], by material
    std::map<std::uint32_t, std::uint32_t> glass_;          ///< material of a tint
};

}  // namespace

std::size_t SceneMesh::triangle_count() const {
    std::size_t count = 0;
    for (const MeshSpace& space : spaces)
        for (const MeshPart& part : space.parts) count += part.indices.size() / 3;
    return count;
}

SceneMesh scene_mesh(const accel::SceneView& scene) {
    Builder builder(scene);
    builder.add_source_faces();
    builder.add_panes();
    return builder.take();
}

}  // namespace enfilade::modeler
