#include "render/embree_objects.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

#include "base/error.h"
#include "render/mesh_soundness.h"

namespace enfilade::render::detail {
namespace {

static_assert(sizeof(ObjectRay) == sizeof(RTCRayHit) && alignof(ObjectRay) == alignof(RTCRayHit));
static_assert(offsetof(ObjectRay, near) == offsetof(RTCRayHit, ray.tnear));
static_assert(offsetof(ObjectRay, far) == offsetof(RTCRayHit, ray.tfar));
static_assert(offsetof(ObjectRay, flags) == offsetof(RTCRayHit, ray.flags));
static_assert(offsetof(ObjectRay, normal_x) == offsetof(RTCRayHit, hit.Ng_x));
static_assert(offsetof(ObjectRay, triangle) == offsetof(RTCRayHit, hit.primID));
static_assert(offsetof(ObjectRay, instance) == offsetof(RTCRayHit, hit.instID));
static_assert(offsetof(ObjectRays, far) == offsetof(RTCRay16, tfar));
static_assert(sizeof(ObjectRays) == sizeof(RTCRayHit16) && alignof(ObjectRays) >= alignof(RTCRayHit16));
static_assert(offsetof(ObjectRays, near) == offsetof(RTCRayHit16, ray.tnear));
static_assert(offsetof(ObjectRays, far) == offsetof(RTCRayHit16, ray.tfar));
static_assert(offsetof(ObjectRays, flags) == offsetof(RTCRayHit16, ray.flags));
static_assert(offsetof(ObjectRays, normal_x) == offsetof(RTCRayHit16, hit.Ng_x));
static_assert(offsetof(ObjectRays, triangle) == offsetof(RTCRayHit16, hit.primID));
static_assert(offsetof(ObjectRays, instance) == offsetof(RTCRayHit16, hit.instID));

RTCScene scene_of(const void* state, accel::MeshId mesh) {
    return static_cast<const RTCScene*>(state)[static_cast<std::uint32_t>(mesh)];
}

RTCIntersectContext context_of(RTCIntersectContextFlags flags) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = flags;
    return context;
}

void nearest(const void* state, accel::MeshId mesh, ObjectRay& ray) {
    const RTCScene scene = scene_of(state, mesh);
    if (scene == nullptr || !(ray.near <= ray.far)) return;
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    rtcIntersect1(scene, &context, reinterpret_cast<RTCRayHit*>(&ray));
}

template <RTCIntersectContextFlags flags>
void nearest16(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const RTCScene scene = scene_of(state, mesh);
    if (scene == nullptr) return;
    RTCIntersectContext context = context_of(flags);
    rtcIntersect16(valid, scene, &context, reinterpret_cast<RTCRayHit16*>(&rays));
}

bool blocked(const void* state, accel::MeshId mesh, const ObjectRay& ray) {
    const RTCScene scene = scene_of(state, mesh);
    if (scene == nullptr || !(ray.near <= ray.far)) return false;
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    RTCRay asked = {ray.origin_x,
                    ray.origin_y,
                    ray.origin_z,
                    ray.near,
                    ray.direction_x,
                    ray.direction_y,
                    ray.direction_z,
                    0,
                    ray.far,
                    ~0u,
                    0,
                    0};
    rtcOccluded1(scene, &context, &asked);
    return asked.tfar < 0;
}

/// Those that Embree calls occluded: `far` is -infinity then. Rays without a part that counts are never.
std::uint32_t blocked16(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const RTCScene scene = scene_of(state, mesh);
    if (scene == nullptr) return 0;
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
    rtcOccluded16(valid, scene, &context, reinterpret_cast<RTCRay16*>(&rays));
    std::uint32_t bits = 0;
    for (int i = 0; i < ObjectRays::count; ++i)
        bits |= (valid[i] != 0 && rays.far[i] == -std::numeric_limits<float>::infinity() ? 1u : 0u) << i;
    return bits;
}

class EmbreeObjects final : public ObjectAccel {
public:
    explicit EmbreeObjects(std::size_t mesh_count) : device_(rtcNewDevice(nullptr)), scenes_(mesh_count, nullptr) {
        if (device_ == nullptr) throw IoError("Embree cannot be started on this machine");
        rtcSetDeviceErrorFunction(device_, remember_error, this);
        rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
    }
    ~EmbreeObjects() override {
        for (const RTCScene scene : scenes_)
            if (scene != nullptr) rtcReleaseScene(scene);
        rtcReleaseDevice(device_);
    }
    EmbreeObjects(const EmbreeObjects&) = delete;
    EmbreeObjects& operator=(const EmbreeObjects&) = delete;

    [[nodiscard]] ObjectTracer tracer() const override {
        return {scenes_.data(),
                &nearest,
                &nearest16<RTC_INTERSECT_CONTEXT_FLAG_COHERENT>,
                &nearest16<RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT>,
                &blocked,
                &blocked16};
    }
    [[nodiscard]] std::string_view name() const override { return "embree"; }
    [[nodiscard]] std::size_t bytes() const override {
        const auto inside = bytes_.load();
        return scenes_.size() * sizeof(RTCScene) + (inside > 0 ? static_cast<std::size_t>(inside) : 0);
    }

    /// Gives a mesh its tree, instead of the one that it has. For several meshes at once, by any number of threads.
    void add(const accel::SceneView& view, std::size_t mesh, bool is_compact) {
        if (scenes_[mesh] != nullptr) rtcReleaseScene(scenes_[mesh]);
        scenes_[mesh] = nullptr;
        const RTCScene scene = rtcNewScene(device_);
        if (scene == nullptr) return;
        scenes_[mesh] = scene;
        rtcSetSceneFlags(scene, is_compact ? RTC_SCENE_FLAG_COMPACT : RTC_SCENE_FLAG_NONE);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
        share_buffers(view, view.meshes[mesh], geometry);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }

    void require_success() const {
        if (!error_.empty()) throw IoError("Embree cannot build the objects: " + error_);
    }

private:
    /// The scene's own arrays: Embree reads 16 bytes at each vertex of 12, and a scene's arrays end in 64 more
    /// (accel/README.md). Only where triangles without area must not be hit, corners are copied.
    static void share_buffers(const accel::SceneView& view, const accel::ObjectMesh& mesh, RTCGeometry geometry) {
        const accel::MeshTriangle* triangles = view.mesh_triangles.data() + mesh.first_triangle;
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   view.mesh_vertices.data() + mesh.first_vertex, 0, sizeof(accel::Vertex),
                                   mesh.vertex_count);
        std::uint32_t unsound = 0;
        for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) unsound += can_be_hit(view, mesh, t) ? 0u : 1u;
        if (unsound == 0) {
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles, 0,
                                       sizeof(accel::MeshTriangle), mesh.triangle_count);
            return;
        }
        auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangle_count));
        if (corners == nullptr) return;
        for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
            const auto& from = triangles[t].corners;
            const bool is_sound = can_be_hit(view, mesh, t);
            for (std::size_t k = 0; k < 3; ++k) corners[3 * t + k] = is_sound ? from[k] : no_triangle;
        }
    }

    static void remember_error(void* self, RTCError code, const char* message) {
        if (code == RTC_ERROR_NONE) return;
        auto& objects = *static_cast<EmbreeObjects*>(self);
        const std::lock_guard lock(objects.error_mutex_);
        objects.error_ = message != nullptr ? message : "unknown error";
    }

    static bool count_bytes(void* self, ssize_t bytes, bool) {
        static_cast<EmbreeObjects*>(self)->bytes_ += bytes;
        return true;
    }

    RTCDevice device_;
    std::vector<RTCScene> scenes_;  ///< [mesh]; nullptr: nothing of it is ever hit
    std::atomic<std::ptrdiff_t> bytes_ = 0;
    std::mutex error_mutex_;
    std::string error_;
};

/// Bytes a triangle: of scanned and of drawn meshes; regular ones take some 12 more either way.
constexpr double fast_bytes = 67, compact_bytes = 36;

/// Meshes that need trees, those first that stand in most places for their size.
std::vector<std::size_t> by_use(const accel::SceneView& scene, const std::vector<bool>& used) {
    std::vector<double> places(scene.meshes.size(), 0);
    for (const accel::PlacedObject& object : scene.objects) ++places[index(object.mesh)];
    std::vector<std::size_t> order;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m)
        if (used[m] && scene.meshes[m].triangle_count > 0) order.push_back(m);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return places[a] * scene.meshes[b].triangle_count > places[b] * scene.meshes[a].triangle_count;
    });
    return order;
}

/// Which meshes get the small trees, by what trees usually take.
std::vector<bool> compact_ones(const accel::SceneView& scene, const std::vector<std::size_t>& order, double budget) {
    std::vector<bool> compact(scene.meshes.size(), true);
    for (const std::size_t m : order) budget -= compact_bytes * scene.meshes[m].triangle_count;
    for (const std::size_t m : order) {
        const double more = (fast_bytes - compact_bytes) * scene.meshes[m].triangle_count;
        if (more > budget) continue;
        budget -= more;
        compact[m] = false;
    }
    return compact;
}

/// Large trees that the budget does not hold after all, the least used first.
std::vector<std::size_t> too_large(const accel::SceneView& scene, const std::vector<std::size_t>& order,
                                   std::vector<bool>& compact, double excess) {
    std::vector<std::size_t> again;
    for (std::size_t k = order.size(); k-- > 0 && excess > 0;) {
        const std::size_t m = order[k];
        if (compact[m]) continue;
        compact[m] = true;
        again.push_back(m);
        excess -= (fast_bytes - compact_bytes) * scene.meshes[m].triangle_count;
    }
    return again;
}

}  // namespace

std::unique_ptr<ObjectAccel> build_embree_objects(const accel::SceneView& scene, const std::vector<bool>& used,
                                                  const accel::Executor& executor, const EmbreeObjectOptions& options) {
    auto objects = std::make_unique<EmbreeObjects>(scene.meshes.size());
    std::vector<std::size_t> meshes = by_use(scene, used);
    const std::vector<std::size_t> order = meshes;
    double budget = 0;
    for (const std::size_t m : order) budget += options.bytes_a_triangle * scene.meshes[m].triangle_count;
    std::vector<bool> compact = compact_ones(scene, order, budget);
    while (!meshes.empty()) {
        executor.run(meshes.size(), [&](std::size_t k) { objects->add(scene, meshes[k], compact[meshes[k]]); });
        meshes = too_large(scene, order, compact, static_cast<double>(objects->bytes()) - budget);
    }
    objects->require_success();
    return objects;
}

}  // namespace enfilade::render::detail
