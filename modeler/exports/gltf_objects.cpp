#include "modeler/exports/gltf_objects.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace enfilade::modeler {
namespace {

using Json = GltfFile::Json;
using Point3 = GltfFile::Point3;
using Rows = std::array<float, 12>;

/// glTF has y up: (x, y, z) becomes (x, z, -y).
Point3 y_up(const Point3& p) { return {p[0], p[2], 0.0f - p[1]}; }

/// Whether its columns stand at right angles: what a translation, a rotation and a scale make.
bool is_unsheared(const Rows& m) {
    const auto dot = [&](std::size_t a, std::size_t b) {
        return double(m[a]) * m[b] + double(m[4 + a]) * m[4 + b] + double(m[8 + a]) * m[8 + b];
    };
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>(0, 1), {1, 2}, {2, 0}})
        if (std::abs(dot(a, b)) > 1e-5 * std::sqrt(dot(a, a) * dot(b, b))) return false;
    return true;
}

/// Column by column, between points with y up on both sides.
Json matrix(const Rows& m) {
    const std::array<std::size_t, 3> from = {0, 2, 1};
    const std::array<double, 3> sign = {1, 1, -1};
    Json numbers = Json::array();
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r) {
            if (r == 3) numbers.push_back(c == 3 ? 1 : 0);
            else if (c == 3) numbers.push_back(sign[r] * m[4 * from[r] + 3]);
            else numbers.push_back(sign[r] * sign[c] * m[4 * from[r] + from[c]]);
        }
    return numbers;
}

class ObjectNodes {
public:
    ObjectNodes(const accel::SceneView& scene, GltfFile& file) : scene_(scene), file_(file) {}

    Json node(const accel::PlacedObject& object) {
        const std::string_view name = scene_.string(object.name), id = scene_.string(object.id);
        Json json = {{"name", name.empty() ? id : name}};
        const bool is_shared = is_unsheared(object.scene_from_object.rows);
        if (scene_.meshes[index(object.mesh)].triangle_count > 0) json["mesh"] = mesh(object, is_shared);
        if (is_shared) json["matrix"] = matrix(object.scene_from_object.rows);
        json["extras"] = {{"label", "furniture"}, {"id", id}};
        return json;
    }

private:
    std::size_t mesh(const accel::PlacedObject& object, bool is_shared) {
        if (!is_shared) return add_mesh(object, &object.scene_from_object.rows);
        const auto [at, fresh] = meshes_.try_emplace({object.mesh, object.material}, 0);
        if (fresh) at->second = add_mesh(object, nullptr);
        return at->second;
    }

    std::size_t add_mesh(const accel::PlacedObject& object, const Rows* placed) {
        const accel::ObjectMesh& mesh = scene_.meshes[index(object.mesh)];
        std::map<accel::MaterialId, std::vector<std::uint32_t>> corners;
        for (std::uint32_t t = mesh.first_triangle; t < mesh.first_triangle + mesh.triangle_count; ++t) {
            const accel::MeshTriangle& triangle = scene_.mesh_triangles[t];
            auto& own = corners[object.material == none<accel::MaterialId> ? triangle.material : object.material];
            own.insert(own.end(), triangle.corners.begin(), triangle.corners.end());
        }
        const std::size_t position = placed == nullptr ? shared_positions(object.mesh) : positions(mesh, placed);
        Json primitives = Json::array();
        for (const auto& [material, indices] : corners)
            primitives.push_back({{"attributes", {{"POSITION", position}}},  // flat, where no normals are given
                                  {"indices", file_.add_indices(indices)},
                                  {"material", this->material(material)}});
        return file_.add("meshes", {{"name", scene_.string(mesh.name)}, {"primitives", std::move(primitives)}});
    }

    std::size_t shared_positions(accel::MeshId mesh) {
        const auto [at, fresh] = positions_.try_emplace(mesh, 0);
        if (fresh) at->second = positions(scene_.meshes[index(mesh)], nullptr);
        return at->second;
    }

    std::size_t positions(const accel::ObjectMesh& mesh, const Rows* placed) {
        std::vector<Point3> points;
        points.reserve(mesh.vertex_count);
        for (std::uint32_t v = mesh.first_vertex; v < mesh.first_vertex + mesh.vertex_count; ++v) {
            Point3 p = {scene_.mesh_vertices[v].x, scene_.mesh_vertices[v].y, scene_.mesh_vertices[v].z};
            if (placed != nullptr) {
                const Rows& m = *placed;
                Point3 moved;
                for (std::size_t r = 0; r < 3; ++r)
                    moved[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
                p = moved;
            }
            points.push_back(y_up(p));
        }
        return file_.add_positions(points);
    }

    std::size_t material(accel::MaterialId id) {
        const auto [at, fresh] = materials_.try_emplace(id, 0);
        if (fresh) {
            const accel::Material& from = scene_.materials[index(id)];
            at->second =
                file_.add("materials", {{"name", scene_.string(from.name)},
                                        {"pbrMetallicRoughness",
                                         {{"baseColorFactor", {from.colour[0], from.colour[1], from.colour[2], 1}},
                                          {"metallicFactor", 0},
                                          {"roughnessFactor", 1}}},
                                        {"doubleSided", true}});
        }
        return at->second;
    }

    const accel::SceneView& scene_;
    GltfFile& file_;
    std::map<std::pair<accel::MeshId, accel::MaterialId>, std::size_t> meshes_;
    std::map<accel::MeshId, std::size_t> positions_;
    std::map<accel::MaterialId, std::size_t> materials_;
};

}  // namespace

void add_objects(const accel::SceneView& scene, const std::vector<std::size_t>& space_nodes, GltfFile& file) {
    ObjectNodes nodes(scene, file);
    for (const accel::PlacedObject& object : scene.objects) {
        const std::size_t child = file.add("nodes", nodes.node(object));
        Json& parent = file["nodes"][space_nodes[index(object.space)]];
        if (!parent.contains("children")) parent["children"] = Json::array();
        parent["children"].push_back(child);
    }
}

}  // namespace enfilade::modeler
