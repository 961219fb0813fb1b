#pragma once
// The solid faces of all cells as triangles or quads: what general ray tracers are given, Embree and those on cards.

#include <cstdint>
#include <vector>

#include "accel/scene.h"

namespace enfilade::render {

/// What the faces of cells are made of for tracers that know no cells.
enum class FaceShapes { Triangles, Quads };

namespace detail {

/// What a primitive looks like: one 16-byte load.
struct PrimitiveLook {
    float red, green, blue;     ///< square roots of the diffuse reflectance, as framebuffers hold it
    std::uint32_t source_face;  ///< with `sky_bit` where it is sky
};
inline constexpr std::uint32_t sky_bit = 1u << 31;

/// Corners of primitives, counter-clockwise on the side of light.
struct FaceMesh {
    std::vector<accel::Vertex> vertices;
    std::vector<std::uint32_t> corners;  ///< [primitive_count][3 or 4]; quads may repeat their last corner
    std::vector<PrimitiveLook> looks;    ///< [primitive_count]
};

/// Walls as one quad or two triangles a face; floors and ceilings, which are convex, as fans: of quads with at most one
/// triangle, or of triangles.
[[nodiscard]] FaceMesh face_mesh(const accel::SceneView& scene, FaceShapes shapes);

/// What triangles of objects look like: they are of no source face.
[[nodiscard]] PrimitiveLook look_of(const accel::SceneView& scene, accel::MaterialId material);

}  // namespace detail
}  // namespace enfilade::render
