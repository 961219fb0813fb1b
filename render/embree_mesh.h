#pragma once
// Inside of the reference: the solid faces of all cells, as Embree wants them.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/embree_reference.h"

namespace enfilade::render::detail {

/// What a primitive looks like: one 16-byte load.
struct PrimitiveLook {
    float red, green, blue;     ///< square roots of the diffuse reflectance, as framebuffers hold it
    std::uint32_t source_face;  ///< with `sky_bit` where it is sky
};
inline constexpr std::uint32_t sky_bit = 1u << 31;

/// Corners of primitives, counter-clockwise on the side of light.
struct EmbreeMesh {
    std::vector<accel::Vertex> vertices;
    std::vector<std::uint32_t> corners;  ///< [primitive_count][3 or 4]; quads may repeat their last corner
    std::vector<PrimitiveLook> looks;    ///< [primitive_count]
};

/// Walls as one quad or two triangles a face; floors and ceilings, which are convex, as fans: of quads with at most one
/// triangle, or of triangles.
[[nodiscard]] EmbreeMesh embree_mesh(const accel::SceneView& scene, EmbreeFaces faces);

}  // namespace enfilade::render::detail
