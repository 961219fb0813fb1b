#pragma once
// The same scene with a colour for each face and triangle: a picture then tells which one a pixel shows.

#include <vector>

#include "accel/scene.h"

namespace enfilade::tools::gpu {

/// Owns what is coloured anew and borrows the rest from the scene it was made of, which must outlive it. Faces and
/// triangles with neighbouring numbers have colours that lie far apart; triangles of an object that is of one material
/// share one. Every colour has green, so a leak's magenta is none of them. What light does otherwise at a material
/// (mirrors, glass, textures) stays what it was.
class OwnColours {
public:
    /// has_clear_panes: glass between rooms tints nothing, for tracers that know of faces alone
    explicit OwnColours(const accel::SceneView& scene, bool has_clear_panes = false);
    [[nodiscard]] const accel::SceneView& view() const { return view_; }

private:
    std::vector<accel::Material> materials_;
    std::vector<accel::MaterialLook> looks_;
    std::vector<accel::SourceFace> faces_;
    std::vector<accel::MeshTriangle> triangles_;
    std::vector<accel::PlacedObject> objects_;
    std::vector<accel::Vertex> tints_;
    accel::SceneView view_;
};

}  // namespace enfilade::tools::gpu
