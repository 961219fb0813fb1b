#include "tests/support/tried_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/mesh_soundness.h"
#include "render/near_ray.h"
#include "render/triangle_test.h"

namespace enfilade::test {
namespace {

using render::ObjectRay;
using render::Vec3d;

double distance_to_segment(Vec3d p, Vec3d a, Vec3d b) {
    const Vec3d along = b - a;
    const double square = dot(along, along);
    const double share = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return length(p - (a + share * along));
}

double distance_to_triangle(Vec3d p, Vec3d a, Vec3d b, Vec3d c) {
    const Vec3d normal = cross(b - a, c - a);
    const double square = dot(normal, normal);
    const double beside[3] = {dot(cross(b - a, p - a), normal), dot(cross(c - b, p - b), normal),
                              dot(cross(a - c, p - c), normal)};
    if (square > 0 && std::ranges::all_of(beside, [](double side) { return side >= 0; }))
        return std::abs(dot(p - a, normal)) / std::sqrt(square);
    return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// The corners of a triangle as the test wants them.
struct Placed {
    Placed(const TriedMesh& mesh, std::uint32_t triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            const accel::Vertex& v = mesh.places()[mesh.triangles()[triangle].corners[i]];
            p[i][0] = v.x;
            p[i][1] = v.y;
            p[i][2] = v.z;
        }
    }
    [[nodiscard]] render::TriangleAt at() const { return {p[0], p[1], p[2]}; }
    float p[3][3];
};

}  // namespace

TriedMesh::TriedMesh(const accel::InputMesh& mesh) {
    for (const auto& v : mesh.vertices) places_.push_back({v[0], v[1], v[2]});
    for (const auto& corners : mesh.triangles) triangles_.push_back({corners, accel::MaterialId{0}});
    accel::SceneView view;
    view.mesh_vertices = {places_.data(), places_.size()};
    view.mesh_triangles = {triangles_.data(), triangles_.size()};
    const accel::ObjectMesh whole = {};
    std::ranges::fill(low_, std::numeric_limits<float>::max());
    std::ranges::fill(high_, -std::numeric_limits<float>::max());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        if (!render::can_be_hit(view, whole, t)) continue;
        used_.push_back(t);
        for (const std::uint32_t corner : triangles_[t].corners) {
            const accel::Vertex& v = places_[corner];
            const float p[3] = {v.x, v.y, v.z};
            for (std::size_t k = 0; k < 3; ++k) {
                low_[k] = std::min(low_[k], p[k]);
                high_[k] = std::max(high_[k], p[k]);
            }
        }
    }
}

double TriedMesh::size() const {
    double size = 0;
    for (int k = 0; k < 3; ++k) size = std::max(size, double{high_[k]} - low_[k]);
    return size;
}

Vec3d TriedMesh::corner(std::uint32_t triangle, std::size_t k) const {
    const accel::Vertex& v = places_[triangles_[triangle].corners[k]];
    return {v.x, v.y, v.z};
}

ObjectRay TriedMesh::nearest(const ObjectRay& ray) const {
    if (used_.empty() || !(ray.near <= ray.far)) return ray;
    ObjectRay asked = ray;
    const float moved = render::bring_near(low_, high_, asked);
    const render::ShearedRay sheared = render::sheared_ray(asked);
    for (const std::uint32_t t : used_) {
        const Placed p(*this, t);
        render::TriangleMeeting meeting;
        if (!render::meets_triangle(sheared, p.at(), meeting) || !(meeting.t >= asked.near)) continue;
        if (!(meeting.t < asked.far || (meeting.t == asked.far && t < asked.triangle))) continue;
        asked.far = meeting.t;
        asked.triangle = t;
        render::describe_meeting(p.at(), meeting, asked);
    }
    if (asked.triangle == ray.triangle) return ray;
    ObjectRay answer = asked;
    answer.origin_x = ray.origin_x, answer.origin_y = ray.origin_y, answer.origin_z = ray.origin_z;
    answer.near = ray.near;
    answer.far = asked.far + moved;
    return answer;
}

double TriedMesh::off_triangle(const ObjectRay& ray, std::uint32_t triangle) const {
    ObjectRay asked = ray;
    render::bring_near(low_, high_, asked);
    render::TriangleMeeting meeting;
    const Placed placed(*this, triangle);
    if (!render::meets_triangle(render::sheared_ray(asked), placed.at(), meeting)) return -1;
    const Vec3d p = Vec3d{asked.origin_x, asked.origin_y, asked.origin_z} +
                    double{meeting.t} * Vec3d{asked.direction_x, asked.direction_y, asked.direction_z};
    return distance_to_triangle(p, corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)) / size();
}

TriedOctree::TriedOctree(const TriedMesh& mesh, const accel::OctreeOptions& options)
    : tree_(accel::build_octree(mesh.part(), options, accel::SerialExecutor())),
      linked_(tree_, mesh.part(), accel::SerialExecutor()),
      stored_ropes_(tree_, mesh.part(), {.is_balanced = options.is_balanced, .has_stored_boxes = true},
                    accel::SerialExecutor()),
      free_ropes_(tree_, mesh.part(), {.is_balanced = false, .has_stored_boxes = false}, accel::SerialExecutor()) {}

}  // namespace enfilade::test
