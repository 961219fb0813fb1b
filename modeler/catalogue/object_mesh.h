#pragma once
// The mesh of a piece of furniture, as the tracer gets it.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "accel/scene_input.h"

namespace enfilade::modeler {

struct ObjectMaterial {
    std::string name;
    std::array<float, 3> colour = {0.8f, 0.8f, 0.8f};  ///< diffuse reflectance, linear RGB; under a texture its mean
    accel::InputLook look = {};                        ///< its texture is one of ObjectMesh::textures
    friend bool operator==(const ObjectMaterial&, const ObjectMaterial&) = default;
};

/// Triangles of any kind: open, crossing, without area; corners are always vertices of the mesh, coordinates always
/// numbers. Metres, z up, the front towards -y, the middle of the bottom of its box at the origin, at the size that its
/// catalogue states.
struct ObjectMesh {
    std::string name;
    std::vector<std::array<float, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> triangle_materials;  ///< [triangle count] into `materials`
    std::vector<ObjectMaterial> materials;
    std::vector<std::array<float, 2>> texcoords;  ///< [3 * triangle count] or empty: u to the right, v up, in repeats
    std::vector<std::shared_ptr<const accel::InputTexture>> textures;
    friend bool operator==(const ObjectMesh& a, const ObjectMesh& b) { return a.is_like(b); }

private:
    /// Textures by what they show.
    [[nodiscard]] bool is_like(const ObjectMesh& other) const;
};

/// What is wrong with a mesh; none of it keeps it from being traced.
struct MeshDefects {
    std::uint32_t degenerate = 0;     ///< triangles without area
    std::uint32_t duplicate = 0;      ///< triangles that are there twice
    std::uint32_t open_edges = 0;     ///< edges of one triangle (vertices at one place count as one)
    std::uint32_t crowded_edges = 0;  ///< edges of three triangles or more
    std::uint32_t dropped = 0;        ///< triangles left out: corners that do not exist, are no numbers or beyond 1e12
    friend bool operator==(const MeshDefects&, const MeshDefects&) = default;
};

/// \pre the mesh is as described above
[[nodiscard]] MeshDefects defects_of(const ObjectMesh& mesh);

}  // namespace enfilade::modeler
