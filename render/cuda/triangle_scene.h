#pragma once
// A scene as general ray tracers see it: triangles of faces, triangles of meshes, and meshes at their places. Nothing
// of its cells is left.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/cuda/triangle_record.h"
#include "render/face_mesh.h"
#include "render/sah_tree.h"

namespace enfilade::render::cuda {

struct SceneTriangle {
    accel::Vertex a, b, c;
};

/// Triangles are numbered through: those of faces, then those of each mesh in the order of the scene, so that triangle
/// t of a mesh is `first_triangle + t`.
struct TriangleScene {
    std::vector<SceneTriangle> triangles;
    std::vector<detail::PrimitiveLook> looks;  ///< [triangle], then of whole objects
    std::vector<bool> can_be_hit;              ///< [triangle]: it has an area, and its corners are places
    std::uint32_t face_triangles = 0;
    std::vector<accel::ObjectMesh> meshes;
    std::vector<std::uint32_t> mesh_first;  ///< [mesh + 1]: first triangle
    std::vector<BvhInstance> instances;     ///< [object]; roots are not set
    std::vector<SahBox> instance_boxes;     ///< [object]
    std::vector<std::uint32_t> mesh_of;     ///< [object]

    /// One mesh alone, in its own space: its triangles stand for those of faces.
    [[nodiscard]] static TriangleScene of_mesh(const accel::SceneView& scene, accel::MeshId mesh);

    /// The triangles of all solid faces, each once, as Embree is given them; of meshes, as they lie in the scene; all
    /// objects that have a triangle. is_bare: without meshes and objects. \throws IoError if there are more than
    /// 2^30
    explicit TriangleScene(const accel::SceneView& scene, bool is_bare = false);

    [[nodiscard]] SahBox box_of(std::uint32_t triangle) const;

private:
    TriangleScene() = default;
    void add_triangles(const accel::SceneView& scene, const accel::ObjectMesh& mesh);
    void add_object(const accel::SceneView& scene, const accel::PlacedObject& object);
    void find_those_to_hit();
};

/// For trees over triangles [begin, end) that can be hit. Triangles whose boxes are much larger than themselves are
/// given several boxes, each of a part of them, as Karras and Aila split them (Fast Parallel Construction of
/// High-Quality Bounding Volume Hierarchies, 2013): up to `split_share` more boxes than triangles, most for the largest
/// gains.
[[nodiscard]] std::vector<SahEntry> triangle_entries(const TriangleScene& scene, std::uint32_t begin, std::uint32_t end,
                                                     float split_share);

}  // namespace enfilade::render::cuda
