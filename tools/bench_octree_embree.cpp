// Embree over one mesh, asked directly: no budget of memory keeps it from its fastest trees.

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "base/error.h"
#include "tools/bench_octree.h"

namespace enfilade::tools {

struct EmbreeMesh::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::atomic<std::int64_t> bytes{0};
    double seconds = 0;
};

namespace {

// The forms of object_tracer.h are Embree's (render/embree_objects.cpp asserts it).
static_assert(sizeof(render::ObjectRay) == sizeof(RTCRayHit) && sizeof(render::ObjectRays) == sizeof(RTCRayHit16));

RTCScene scene_of(const void* state) { return static_cast<RTCScene>(const_cast<void*>(state)); }

RTCIntersectContext context_of(RTCIntersectContextFlags flags) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = flags;
    return context;
}

void nearest(const void* state, accel::MeshId, render::ObjectRay& ray) {
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    rtcIntersect1(scene_of(state), &context, reinterpret_cast<RTCRayHit*>(&ray));
}

template <RTCIntersectContextFlags flags>
void nearest16(const void* state, accel::MeshId, const std::int32_t* valid, render::ObjectRays& rays) {
    RTCIntersectContext context = context_of(flags);
    rtcIntersect16(valid, scene_of(state), &context, reinterpret_cast<RTCRayHit16*>(&rays));
}

bool blocked(const void* state, accel::MeshId, const render::ObjectRay& ray) {
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    RTCRay asked = reinterpret_cast<const RTCRayHit&>(ray).ray;
    rtcOccluded1(scene_of(state), &context, &asked);
    return asked.tfar < 0;
}

bool count_bytes(void* given, ssize_t bytes, bool) {
    static_cast<std::atomic<std::int64_t>*>(given)->fetch_add(bytes);
    return true;
}

}  // namespace

EmbreeMesh::EmbreeMesh(const accel::SceneView& scene, Quality quality) : state_(std::make_unique<State>()) {
    state_->device = rtcNewDevice(nullptr);
    if (state_->device == nullptr) throw IoError("Embree cannot be started on this machine");
    rtcSetDeviceMemoryMonitorFunction(state_->device, count_bytes, &state_->bytes);
    state_->scene = rtcNewScene(state_->device);
    const RTCBuildQuality asked = quality == Quality::High ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
    rtcSetSceneBuildQuality(state_->scene, asked);
    const RTCGeometry geometry = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, asked);
    // Behind the last place there is more memory: Embree reads 16 bytes at each.
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, scene.mesh_vertices.data(), 0,
                               sizeof(accel::Vertex), scene.mesh_vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, scene.mesh_triangles.data(), 0,
                               sizeof(accel::MeshTriangle), scene.mesh_triangles.size());
    state_->seconds = seconds_of([&] {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(state_->scene, geometry);
        rtcCommitScene(state_->scene);
    });
    rtcReleaseGeometry(geometry);
    if (rtcGetDeviceError(state_->device) != RTC_ERROR_NONE) throw IoError("Embree cannot build a mesh's tree");
}

EmbreeMesh::~EmbreeMesh() {
    rtcReleaseScene(state_->scene);
    rtcReleaseDevice(state_->device);
}

render::ObjectTracer EmbreeMesh::tracer() const {
    return {state_->scene, &nearest, &nearest16<RTC_INTERSECT_CONTEXT_FLAG_COHERENT>,
            &nearest16<RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT>, &blocked};
}

std::size_t EmbreeMesh::bytes() const { return std::size_t(state_->bytes.load()); }
double EmbreeMesh::build_seconds() const { return state_->seconds; }

}  // namespace enfilade::tools
