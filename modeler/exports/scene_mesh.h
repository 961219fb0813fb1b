#pragma once
// The faces of a scene as triangles, sorted as people know them: by storey, space and material.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "accel/scene.h"

namespace enfilade::modeler {

/// Triangles of one space that look alike. Positions in metres, in the frame of the scene, z up.
struct MeshPart {
    std::uint32_t material = 0;  ///< into SceneMesh::materials
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 3>> normals;  ///< [positions.size()] towards the light side
    std::vector<std::uint32_t> indices;         ///< three a triangle, counter-clockwise seen from the light side
};

struct MeshSpace {
    accel::SpaceId space = {};
    std::string name;  ///< the space's name, else its id, else its label; unique in the mesh
    std::vector<MeshPart> parts;
};

struct MeshMaterial {
    std::string name;                  ///< unique in the mesh
    std::array<float, 3> colour = {};  ///< linear RGB
    float opacity = 1;
};

struct SceneMesh {
    std::vector<MeshMaterial> materials;
    std::vector<MeshSpace> spaces;  ///< those that have faces, in the order of the scene
    [[nodiscard]] std::size_t triangle_count() const;
};

/// All source faces but the sky's, and a pane for each glass portal.
[[nodiscard]] SceneMesh scene_mesh(const accel::SceneView& scene);

}  // namespace enfilade::modeler
