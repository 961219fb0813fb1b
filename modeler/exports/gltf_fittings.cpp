#include "modeler/exports/gltf_fittings.h"

#include <cmath>
#include <map>
#include <utility>

namespace enfilade::modeler {

namespace {

using Json = GltfFile::Json;
using Point3 = GltfFile::Point3;

constexpr plans::Colour furniture_colour = {0.55f, 0.45f, 0.36f};

/// glTF has y up: (x, y, z) becomes (x, z, -y).
Point3 y_up(const std::array<double, 3>& p) { return {float(p[0]), float(p[2]), float(0 - p[1])}; }

void hang(GltfFile& file, std::size_t parent, Json node) {
    const std::size_t child = file.add("nodes", std::move(node));
    file["nodes"][parent]["children"].push_back(child);
}

/// Positions, normals and indices of a box of edge 1 whose underside has its middle at the origin.
Json unit_box(GltfFile& file) {
    std::vector<Point3> positions;
    std::vector<Point3> normals;
    std::vector<std::uint32_t> indices;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            const auto first = std::uint32_t(positions.size());
            // Counter-clockwise seen from outside.
            for (const auto& [a, b] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
                Point3 point = {};
                point[axis] = side / 2;
                point[u] = side * a / 2;
                point[v] = b / 2;
                point[1] += 0.5f;
                positions.push_back(point);
                Point3 normal = {};
                normal[axis] = side;
                normals.push_back(normal);
            }
            for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + corner);
        }
    const std::size_t position = file.add_positions(positions);
    const std::size_t normal = file.add_normals(normals);
    const std::size_t index = file.add_indices(indices);
    return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"indices", index}};
}

void add_furniture(const Fittings& fittings, const std::vector<std::size_t>& storey_nodes, GltfFile& file) {
    if (fittings.furniture.empty()) return;
    const Json box = unit_box(file);
    std::map<plans::Colour, std::size_t> materials;
    std::map<std::pair<std::string, plans::Colour>, std::size_t> meshes;
    for (const PlacedFurniture& piece : fittings.furniture) {
        const plans::Colour colour = piece.colour.value_or(furniture_colour);
        const auto [material, fresh_material] = materials.try_emplace(colour, 0);
        if (fresh_material)
            material->second = file.add("materials", {{"name", "furniture " + std::to_string(materials.size())},
                                                      {"pbrMetallicRoughness",
                                                       {{"baseColorFactor", {colour[0], colour[1], colour[2], 1}},
                                                        {"metallicFactor", 0},
                                                        {"roughnessFactor", 1}}}});
        const auto [mesh, fresh_mesh] = meshes.try_emplace({piece.model, colour}, 0);
        if (fresh_mesh) {
            Json primitive = box;
            primitive["material"] = material->second;
            mesh->second = file.add("meshes", {{"name", piece.model.empty() ? "box" : piece.model},
                                               {"primitives", Json::array({std::move(primitive)})}});
        }
        Json extras = {{"label", "furniture"}, {"id", piece.id}};
        if (piece.mirrored) extras["mirrored"] = true;
        Json node = {{"name", piece.name.empty() ? piece.id : piece.name},
                     {"mesh", mesh->second},
                     {"translation", y_up(piece.foot)},
                     {"scale", {float(piece.size[0]), float(piece.size[2]), float(piece.size[1])}},
                     {"extras", std::move(extras)}};
        if (piece.angle != 0) node["rotation"] = {0, std::sin(piece.angle / 2), 0, std::cos(piece.angle / 2)};
        hang(file, storey_nodes[piece.storey], std::move(node));
    }
}

}  // namespace

void add_fittings(const Fittings& fittings, const std::vector<std::size_t>& storey_nodes, GltfFile& file) {
    add_furniture(fittings, storey_nodes, file);
}

}  // namespace enfilade::modeler
