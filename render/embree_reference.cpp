#include "render/embree_reference.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "render/shade.h"

namespace enfilade::render {
namespace {

struct Triangle {
    std::uint32_t a, b, c;
};

/// Triangles of the solid faces of all cells. Cells are convex, so their floors and ceilings are fans.
class Mesh {
public:
    explicit Mesh(const accel::SceneView& scene) : scene_(scene) {
        for (std::size_t c = 0; c < scene.cells.size(); ++c) add_cell(scene.cells[c]);
    }
    std::vector<accel::Vertex> vertices;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> source_faces;  ///< [triangle_count]

private:
    std::uint32_t add_vertex(float x, float y, float z) {
        vertices.push_back({x, y, z});
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, accel::Target target) {
        triangles.push_back({a, b, c});
        source_faces.push_back(target.bits);
    }

    void add_level(const accel::Cell& cell, float z, accel::Target target, bool up) {
        if (target.is_portal()) return;
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s)
            add_vertex(scene_.section_x[s], scene_.section_y[s], z);
        for (std::uint32_t i = 2; i < cell.section_count; ++i)
            add_triangle(first, first + (up ? i - 1 : i), first + (up ? i : i - 1), target);
    }

    void add_cell(const accel::Cell& cell) {
        add_level(cell, cell.z_floor, cell.floor, true);
        add_level(cell, cell.z_ceiling, cell.ceiling, false);
        for (std::uint32_t i = 0; i < cell.section_count; ++i) {
            const std::uint32_t s = cell.first_section + i;
            const std::uint32_t next = i + 1 == cell.section_count ? cell.first_section : s + 1;
            float below = cell.z_floor;
            for (std::uint32_t f = scene_.section_tails[s].first_face; f < scene_.section_tails[s + 1].first_face;
                 ++f) {
                const accel::SideFace& face = scene_.side_faces[f];
                if (!face.target.is_portal()) {
                    const std::uint32_t a = add_vertex(scene_.section_x[next], scene_.section_y[next], below);
                    const std::uint32_t b = add_vertex(scene_.section_x[s], scene_.section_y[s], below);
                    const std::uint32_t c = add_vertex(scene_.section_x[s], scene_.section_y[s], face.z_top);
                    const std::uint32_t d = add_vertex(scene_.section_x[next], scene_.section_y[next], face.z_top);
                    add_triangle(a, b, c, face.target);
                    add_triangle(a, c, d, face.target);
                }
                below = face.z_top;
            }
        }
    }

    const accel::SceneView& scene_;
};

void remember_error(void* text, RTCError code, const char* message) {
    if (code != RTC_ERROR_NONE) *static_cast<std::string*>(text) = message != nullptr ? message : "unknown error";
}

Vec3f lambert(const accel::SceneView& scene, const Look& look, std::uint32_t source_face, Vec3f normal,
              Vec3f direction) {
    const accel::SourceFace& face = scene.source_faces[source_face];
    if (face.surface == accel::Surface::Sky) return sky_colour(look, direction);
    const float cosine = magnitude(dot(normal, direction)) / root(dot(normal, normal) * dot(direction, direction));
    return cosine * colour_of(scene, face);
}

void store(Framebuffer& image, int x, int y, Vec3f colour) {
    image.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + x] = encoded(colour);
}

}  // namespace

struct EmbreeReference::State {
    accel::SceneView view;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> source_faces;
    std::string error;

    explicit State(const accel::SceneView& view_) : view(view_) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void build() {
        device = rtcNewDevice(nullptr);
        if (device == nullptr) throw IoError("Embree cannot be started on this machine");
        rtcSetDeviceErrorFunction(device, remember_error, &error);
        scene = rtcNewScene(device);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
        Mesh mesh(view);
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 sizeof(accel::Vertex), mesh.vertices.size());
        void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                  sizeof(Triangle), mesh.triangles.size());
        if (vertices == nullptr || triangles == nullptr) throw IoError("Embree cannot hold the scene: " + error);
        std::ranges::copy(mesh.vertices, static_cast<accel::Vertex*>(vertices));
        std::ranges::copy(mesh.triangles, static_cast<Triangle*>(triangles));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        if (!error.empty()) throw IoError("Embree cannot build the scene: " + error);
        source_faces = std::move(mesh.source_faces);
    }
};

EmbreeReference::EmbreeReference(const accel::SceneView& scene) : state_(std::make_unique<State>(scene)) {
    state_->build();
}
EmbreeReference::~EmbreeReference() = default;
EmbreeReference::EmbreeReference(EmbreeReference&&) noexcept = default;
EmbreeReference& EmbreeReference::operator=(EmbreeReference&&) noexcept = default;

void EmbreeReference::trace(std::span<const RayQuery> rays, std::span<RayHit> hits) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3f o = vec_cast<float>(rays[i].origin), d = vec_cast<float>(rays[i].direction);
        const float metres = length(d);
        RTCRayHit query = {};
        query.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, std::numeric_limits<float>::infinity(), ~0u, 0, 0};
        if (rays[i].max_distance < 1e30) query.ray.tfar = static_cast<float>(rays[i].max_distance) / metres;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(state_->scene, &context, &query);
        hits[i] = {};
        hits[i].status = query.hit.geomID == RTC_INVALID_GEOMETRY_ID
                             ? (rays[i].max_distance < 1e30 ? WalkStatus::Reached : WalkStatus::Leak)
                             : WalkStatus::Hit;
        hits[i].throughput = {1, 1, 1};
        if (hits[i].status != WalkStatus::Hit) continue;
        hits[i].source_face = static_cast<accel::SourceFaceId>(state_->source_faces[query.hit.primID]);
        hits[i].distance = double{query.ray.tfar} * double{metres};
    }
}

void EmbreeReference::trace_lambert(const CameraFrame& frame, Framebuffer& image) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const Look look;
    const Vec3f o = frame.origin;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Vec3f d = frame.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            RTCRayHit query;
            query.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, std::numeric_limits<float>::infinity(), ~0u, 0, 0};
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(state_->scene, &context, &query);
            Vec3f colour = {1, 0, 1};
            if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID)
                colour = lambert(state_->view, look, state_->source_faces[query.hit.primID],
                                 {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z}, d);
            store(image, x, y, colour);
        }
    }
}

void EmbreeReference::trace_lambert_packets(const CameraFrame& frame, Framebuffer& image) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const Look look;
    alignas(64) int valid[16];
    std::ranges::fill(valid, -1);
    for (int y = 0; y + 3 < image.height; y += 4) {
        for (int x = 0; x + 3 < image.width; x += 4) {
            alignas(64) RTCRayHit16 query;
            for (int k = 0; k < 16; ++k) {
                const Vec3f d =
                    frame.direction(static_cast<float>(x + k % 4) + 0.5f, static_cast<float>(y + k / 4) + 0.5f);
                query.ray.org_x[k] = frame.origin.x;
                query.ray.org_y[k] = frame.origin.y;
                query.ray.org_z[k] = frame.origin.z;
                query.ray.dir_x[k] = d.x;
                query.ray.dir_y[k] = d.y;
                query.ray.dir_z[k] = d.z;
                query.ray.tnear[k] = 0;
                query.ray.time[k] = 0;
                query.ray.tfar[k] = std::numeric_limits<float>::infinity();
                query.ray.mask[k] = ~0u;
                query.ray.flags[k] = 0;
                query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
                query.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect16(valid, state_->scene, &context, &query);
            for (int k = 0; k < 16; ++k) {
                Vec3f colour = {1, 0, 1};
                if (query.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID)
                    colour = lambert(state_->view, look, state_->source_faces[query.hit.primID[k]],
                                     {query.hit.Ng_x[k], query.hit.Ng_y[k], query.hit.Ng_z[k]},
                                     {query.ray.dir_x[k], query.ray.dir_y[k], query.ray.dir_z[k]});
                store(image, x + k % 4, y + k / 4, colour);
            }
        }
    }
}

}  // namespace enfilade::render
