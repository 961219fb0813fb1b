#pragma once
// A model as its file has it: triangles in the axes and units of the file, with the materials that it names.

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "accel/scene_input.h"

namespace enfilade::modeler {

struct RawMaterial {
    std::string name;
    std::array<float, 3> colour = {0.8f, 0.8f, 0.8f};  ///< diffuse reflectance, linear RGB
    float opacity = 1;                                 ///< 0: cannot be seen at all
    accel::InputLook look;                             ///< its texture is one of RawMesh::textures
};

enum class UpAxis : std::uint8_t { Y, Z };

struct RawMesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< into `points`; what they name exists and is finite
    std::vector<std::uint32_t> triangle_materials;        ///< [triangle count] into `materials`
    std::vector<std::array<float, 2>> texcoords;          ///< [3 * triangle count] or empty: u to the right, v up
    std::vector<std::shared_ptr<const accel::InputTexture>> textures;
    std::vector<RawMaterial> materials;  ///< at least one where there is a triangle
    UpAxis up = UpAxis::Y;
    bool in_metres = false;           ///< the format says so (glTF)
    std::uint32_t dropped = 0;        ///< triangles left out: corners that do not exist, are no numbers or beyond 1e12
    std::uint32_t lines = 0;          ///< faces of fewer than three corners, which are no surface
    bool lacks_materials = false;     ///< a material library, or a material, that the file names is not there
    std::uint32_t unread_images = 0;  ///< textures that are absent or of no kind that is read
};

/// What the material's opacity lacks to 1 is seen through it, in the hue of its colour.
inline void make_glass(RawMaterial& material) {
    const auto& c = material.colour;
    const float most = std::max({c[0], c[1], c[2]});
    for (std::size_t k = 0; k < 3; ++k)
        material.look.through[k] = (1 - material.opacity) * (most > 0 ? c[k] / most : 1.0f);
}

/// Where no material has a texture nobody needs to know how it lies.
inline void drop_unused_texcoords(RawMesh& mesh) {
    if (mesh.textures.empty()) mesh.texcoords.clear();
    if (!mesh.texcoords.empty()) return;
    for (RawMaterial& material : mesh.materials) material.look.texture = UINT32_MAX;
    mesh.textures.clear();
}

}  // namespace enfilade::modeler
