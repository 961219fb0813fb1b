#include "render/embree_faces.h"

#include <algorithm>
#include <utility>

namespace enfilade::render::detail {

std::vector<PrimitiveLook> attach_faces(RTCDevice device, RTCScene to, const accel::SceneView& scene, EmbreeFaces faces,
                                        unsigned id) {
    FaceMesh mesh = face_mesh(scene, faces);
    const bool has_quads = faces == EmbreeFaces::Quads;
    const std::size_t corners = has_quads ? 4 : 3;
    RTCGeometry geometry = rtcNewGeometry(device, has_quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(accel::Vertex), mesh.vertices.size());
    void* indices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, has_quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3,
                                corners * sizeof(std::uint32_t), mesh.corners.size() / corners);
    if (vertices != nullptr && indices != nullptr) {
        std::ranges::copy(mesh.vertices, static_cast<accel::Vertex*>(vertices));
        std::ranges::copy(mesh.corners, static_cast<std::uint32_t*>(indices));
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(to, geometry, id);
    }
    rtcReleaseGeometry(geometry);
    return std::move(mesh.looks);
}

}  // namespace enfilade::render::detail
