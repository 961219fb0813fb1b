#include "render/embree_instances.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>
#include <vector>

#include "render/embree_device.h"
#include "render/embree_faces.h"
#include "render/embree_jobs.h"
#include "render/embree_lamps.h"

namespace enfilade::render {
namespace {

bool add_bytes(void* total, ssize_t bytes, bool) {
    static_cast<std::atomic<std::int64_t>*>(total)->fetch_add(bytes);
    return true;
}

class EmbreeWorld {
public:
    explicit EmbreeWorld(RTCDevice device) : scene_(rtcNewScene(device)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_NONE);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    }
    ~EmbreeWorld() {
        if (scene_ != nullptr) rtcReleaseScene(scene_);
    }
    EmbreeWorld(EmbreeWorld&& other) noexcept : scene_(std::exchange(other.scene_, nullptr)) {}
    EmbreeWorld& operator=(EmbreeWorld&&) = delete;

    [[nodiscard]] RTCScene get() const { return scene_; }

private:
    RTCScene scene_;
};

constexpr std::array<float, 12> in_place = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

std::span<const accel::MeshTriangle> triangles_of(const accel::SceneView& scene, const accel::ObjectMesh& mesh) {
    return {scene.mesh_triangles.begin() + mesh.first_triangle, mesh.triangle_count};
}

/// A mesh as a geometry of `to`, its vertices where `placement` takes them.
void attach_mesh(RTCDevice device, RTCScene to, const accel::SceneView& scene, const accel::ObjectMesh& mesh,
                 const std::array<float, 12>& placement, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    auto* vertices = static_cast<accel::Vertex*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(accel::Vertex), mesh.vertex_count));
    auto* corners = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangle_count));
    if (vertices != nullptr && corners != nullptr) {
        const auto moved = [&](const accel::Vertex& v) {
            const auto row = [&](std::size_t r) {
                return static_cast<float>(double{placement[4 * r]} * double{v.x} +
                                          double{placement[4 * r + 1]} * double{v.y} +
                                          double{placement[4 * r + 2]} * double{v.z} + double{placement[4 * r + 3]});
            };
            return accel::Vertex{row(0), row(1), row(2)};
        };
        const accel::Vertex* from = scene.mesh_vertices.begin() + mesh.first_vertex;
        std::transform(from, from + mesh.vertex_count, vertices, moved);
        std::ranges::transform(triangles_of(scene, mesh), corners, &accel::MeshTriangle::corners);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(to, geometry, id);
    }
    rtcReleaseGeometry(geometry);
}

void attach_instance(RTCDevice device, RTCScene to, RTCScene of, const std::array<float, 12>& placement, unsigned id) {
    RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, of);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, placement.data());
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(to, instance, id);
    rtcReleaseGeometry(instance);
}

/// What faces, triangles and whole objects look like, and what objects do to normals.
class Looks {
public:
    Looks(const accel::SceneView& scene, std::vector<detail::PrimitiveLook> faces, bool is_flat)
        : looks_(std::move(faces)) {
        std::vector<std::uint32_t> first(scene.meshes.size());
        for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
            first[m] = static_cast<std::uint32_t>(looks_.size());
            for (const accel::MeshTriangle& triangle : triangles_of(scene, scene.meshes[m]))
                looks_.push_back(detail::look_of(scene, triangle.material));
        }
        for (const accel::PlacedObject& object : scene.objects) {
            detail::EmbreePlace place = place_at(is_flat ? in_place : object.object_from_scene.rows);
            place.first_look = first[index(object.mesh)];
            if (object.material != none<accel::MaterialId>) {
                place.first_look = static_cast<std::uint32_t>(looks_.size());
                place.look_mask = 0;
                looks_.push_back(detail::look_of(scene, object.material));
            }
            places_.push_back(place);
        }
        places_.push_back(place_at(in_place));
    }
    [[nodiscard]] detail::EmbreeScene asked(RTCScene scene, bool is_flat, bool coherent) const {
        return {scene,   looks_.data(), places_.data(), static_cast<std::uint32_t>(places_.size() - 1),
                is_flat, coherent};
    }

private:
    /// Normals are turned by the transposed inverse of what turns points.
    static detail::EmbreePlace place_at(const std::array<float, 12>& inverse) {
        detail::EmbreePlace place = {};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) place.normal[3 * i + j] = inverse[4 * j + i];
        place.look_mask = ~0u;
        return place;
    }

    std::vector<detail::PrimitiveLook> looks_;
    std::vector<detail::EmbreePlace> places_;
};

/// Embree's scene of a whole scene, and what its hits look like.
class FurnishedWorld {
public:
    /// meshes: by MeshId; not asked for where objects are flattened
    FurnishedWorld(RTCDevice device, const accel::SceneView& scene, EmbreeFaces faces, EmbreeObjects objects,
                   std::span<const EmbreeWorld> meshes)
        : is_flat_(objects == EmbreeObjects::Flattened), top_(device), faces_(device) {
        const auto faces_id = static_cast<unsigned>(scene.objects.size());
        const bool is_one_level = objects == EmbreeObjects::OneLevel;
        looks_ = std::make_unique<Looks>(
            scene, detail::attach_faces(device, is_one_level ? faces_.get() : top_.get(), scene, faces, faces_id),
            is_flat_);
        rtcCommitScene(faces_.get());
        if (is_one_level) attach_instance(device, top_.get(), faces_.get(), in_place, faces_id);
        for (unsigned k = 0; k < scene.objects.size(); ++k) {
            const accel::PlacedObject& object = scene.objects[k];
            const accel::ObjectMesh& mesh = scene.meshes[index(object.mesh)];
            if (mesh.triangle_count == 0) continue;
            const auto& rows = object.scene_from_object.rows;
            if (is_flat_) attach_mesh(device, top_.get(), scene, mesh, rows, k);
            else attach_instance(device, top_.get(), meshes[index(object.mesh)].get(), rows, k);
        }
        rtcCommitScene(top_.get());
    }
    [[nodiscard]] detail::EmbreeScene asked(bool coherent) const {
        return looks_->asked(top_.get(), is_flat_, coherent);
    }

private:
    bool is_flat_;
    EmbreeWorld top_;
    EmbreeWorld faces_;
    std::unique_ptr<Looks> looks_;
};

}  // namespace

struct EmbreeInstances::State {
    std::atomic<std::int64_t> bytes = 0;  ///< before the device, which counts here until its end
    bool is_flat;
    detail::EmbreeDevice device;
    std::vector<EmbreeWorld> meshes;
    std::unique_ptr<FurnishedWorld> triangles;  ///< nullptr where objects are flattened
    std::unique_ptr<FurnishedWorld> quads;

    State(const accel::SceneView& scene, EmbreeObjects objects) : is_flat(objects == EmbreeObjects::Flattened) {
        rtcSetDeviceMemoryMonitorFunction(device.get(), add_bytes, &bytes);
        if (!is_flat) {
            for (const accel::ObjectMesh& mesh : scene.meshes) {
                meshes.emplace_back(device.get());
                if (mesh.triangle_count > 0) attach_mesh(device.get(), meshes.back().get(), scene, mesh, in_place, 0);
                rtcCommitScene(meshes.back().get());
            }
            triangles = std::make_unique<FurnishedWorld>(device.get(), scene, EmbreeFaces::Triangles, objects, meshes);
        }
        // Of triangles alone, the flattened scene is one structure.
        const EmbreeFaces last = is_flat ? EmbreeFaces::Triangles : EmbreeFaces::Quads;
        quads = std::make_unique<FurnishedWorld>(device.get(), scene, last, objects, meshes);
        device.require_success();
    }
    [[nodiscard]] detail::EmbreeScene asked(EmbreeWay way) const {
        return (way.faces == EmbreeFaces::Quads || triangles == nullptr ? quads : triangles)->asked(way.coherent);
    }
};

EmbreeInstances::EmbreeInstances(const accel::SceneView& scene, EmbreeObjects objects)
    : state_(std::make_unique<State>(scene, objects)) {}
EmbreeInstances::~EmbreeInstances() = default;
EmbreeInstances::EmbreeInstances(EmbreeInstances&&) noexcept = default;
EmbreeInstances& EmbreeInstances::operator=(EmbreeInstances&&) noexcept = default;

void EmbreeInstances::trace_lambert(const CameraFrame& frame, EmbreeWay way, const accel::Executor& executor,
                                    Framebuffer& image) const {
    detail::embree_picture(state_->asked(way), frame, way.lanes, executor, image);
}

void EmbreeInstances::trace_lit(const CameraFrame& frame, const EmbreeLamps& lamps, const EmbreeLitWay& way,
                                const accel::Executor& executor, Framebuffer& image) const {
    // As in `visible`.
    EmbreeLitWay asked = way;
    if (!state_->is_flat) asked.coherent_shadows = false;
    detail::embree_lit_picture(state_->asked(way.primary), frame, lamps, asked, executor, image);
}

SeenPlaces EmbreeInstances::seen_places(const CameraFrame& frame, int width, int height,
                                        const accel::Executor& executor) const {
    return detail::embree_places(state_->asked({.lanes = 16}), frame, width, height, executor);
}

void EmbreeInstances::nearest(const RayColumns& rays, const HitColumns& hits, EmbreeWay way,
                              const accel::Executor& executor, float skin) const {
    detail::embree_nearest(state_->asked(way), rays, hits, way.lanes, executor, skin);
}

void EmbreeInstances::visible(const SegmentColumns& segments, std::span<std::uint8_t> visible, EmbreeWay way,
                              const accel::Executor& executor, float skin) const {
    // Embree 3.13 may never return from packets of shadow rays through instances that are said to be coherent.
    if (!state_->is_flat) way.coherent = false;
    detail::embree_visible(state_->asked(way), segments, visible, way.lanes, executor, skin);
}

std::size_t EmbreeInstances::bytes() const { return static_cast<std::size_t>(state_->bytes.load()); }

}  // namespace enfilade::render
