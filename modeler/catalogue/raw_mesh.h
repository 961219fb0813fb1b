#pragma once
// A model as its file has it: triangles in the axes and units of the file, with the materials that it names.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace enfilade::modeler {

struct RawMaterial {
    std::string name;
    std::array<float, 3> colour = {0.8f, 0.8f, 0.8f};  ///< diffuse reflectance, linear RGB
    float opacity = 1;                                 ///< 0: cannot be seen at all
};

enum class UpAxis : std::uint8_t { Y, Z };

struct RawMesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< into `points`; what they name exists and is finite
    std::vector<std::uint32_t> triangle_materials;        ///< [triangle count] into `materials`
    std::vector<RawMaterial> materials;                   ///< at least one where there is a triangle
    UpAxis up = UpAxis::Y;
    bool in_metres = false;           ///< the format says so (glTF)
    std::uint32_t dropped = 0;        ///< triangles left out: corners that do not exist, are no numbers or beyond 1e12
    std::uint32_t lines = 0;          ///< faces of fewer than three corners, which are no surface
    bool lacks_materials = false;     ///< a material library, or a material, that the file names is not there
    std::uint32_t unread_images = 0;  ///< textures that are absent or of no kind that is read
};

}  // namespace enfilade::modeler
