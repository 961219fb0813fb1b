#pragma once
// Inside of the reference: the faces of cells in a scene of Embree's.

#include <embree3/rtcore.h>

#include <vector>

#include "render/embree_reference.h"
#include "render/face_mesh.h"

namespace enfilade::render::detail {

/// Attaches the solid faces of all cells to `to` as geometry `id`, built with the highest quality; what its primitives
/// look like. Errors are the device's. Nothing is attached where there are no faces.
std::vector<PrimitiveLook> attach_faces(RTCDevice device, RTCScene to, const accel::SceneView& scene, EmbreeFaces faces,
                                        unsigned id);

}  // namespace enfilade::render::detail
