#include "render/object_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/locate.h"

namespace enfilade::render {
namespace {

constexpr double least_sine = 1e-4;    ///< of the angle at which a surface is grazed
constexpr double border_slack = 3e-4;  ///< as much of the way, and metres: what walks add to their stretches, and more

Vec3d placed(const accel::Placement& at, const accel::Vertex& v) {
    const auto& m = at.rows;
    const auto row = [&](std::size_t r) {
        return double{m[r]} * v.x + double{m[r + 1]} * v.y + double{m[r + 2]} * v.z + double{m[r + 3]};
    };
    return {row(0), row(4), row(8)};
}

/// Metres from the point to the segment a b.
double segment_distance(Vec3d point, Vec3d a, Vec3d b) {
    const Vec3d e = b - a;
    const double ee = dot(e, e);
    const double s = ee > 0 ? std::clamp(dot(point - a, e) / ee, 0.0, 1.0) : 0.0;
    return length(point - a - s * e);
}

}  // namespace

ObjectOracle::ObjectOracle(const accel::SceneView& scene, double band) : scene_(scene), faces_(scene), band_(band) {
    bodies_.resize(scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        bodies_[i].first = static_cast<std::uint32_t>(triangles_.size());
        add_triangles(scene.objects[i]);
        bodies_[i].count = static_cast<std::uint32_t>(triangles_.size()) - bodies_[i].first;
    }
    for (std::uint32_t cell = 0; cell < scene.cells.size() && scene.has_objects(); ++cell)
        for (std::uint32_t k = scene.cell_object_offsets[cell]; k < scene.cell_object_offsets[cell + 1]; ++k)
            bodies_[index(scene.cell_objects[k])].cells.push_back(cell);
}

void ObjectOracle::add_triangles(const accel::PlacedObject& object) {
    const accel::ObjectMesh& mesh = scene_.meshes[index(object.mesh)];
    for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
        std::array<Vec3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = placed(
                object.scene_from_object,
                scene_.mesh_vertices[mesh.first_vertex + scene_.mesh_triangles[mesh.first_triangle + t].corners[k]]);
        triangles_.push_back(corners);
    }
}

Vec3d ObjectOracle::normal(accel::ObjectId object, std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[bodies_[index(object)].first + triangle];
    const Vec3d n = cross(b - a, c - a);
    const double size = length(n);
    return size > 0 ? (1 / size) * n : Vec3d{0, 0, 0};
}

/// Where the line meets the triangle's plane, if that is in it or within the band of it.
std::optional<PossibleEnd> ObjectOracle::meet(const std::array<Vec3d, 3>& triangle, Vec3d origin, Vec3d unit) const {
    const auto& [a, b, c] = triangle;
    Vec3d n = cross(b - a, c - a);
    const double size = length(n);
    if (!(size > 0)) return {};
    n = (1 / size) * n;
    const double den = dot(n, unit), sine = std::max(std::abs(den), least_sine);
    const double distance = std::abs(den) >= least_sine ? dot(n, a - origin) / den : dot(a - origin, unit);
    const Vec3d p = origin + distance * unit;
    const double rim = std::min({segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
    const bool is_inside =
        dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 && dot(cross(a - c, p - c), n) >= 0;
    if (std::abs(dot(n, p - a)) > band_ + least_sine * segment_distance(p, a, b)) return {};  // parallel, beside it
    // Across the ray by the band is along the surface by the band over the sine.
    const double reach = band_ / sine;
    if (!is_inside && rim > reach) return {};
    return PossibleEnd{distance, reach, is_inside && rim > reach && std::abs(den) >= least_sine};
}

/// How deep the point lies in the cells that list the object; negative outside of all of them.
double ObjectOracle::depth_in(const Body& body, Vec3d point) const {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t cell : body.cells)
        deepest =
            std::max(deepest, accel::depth(scene_, static_cast<accel::CellId>(cell), {point.x, point.y, point.z}));
    return deepest;
}

void ObjectOracle::meet_object(std::uint32_t id, Vec3d origin, Vec3d unit, double farthest,
                               std::vector<PossibleEnd>& ends) const {
    const Body& body = bodies_[id];
    if (body.cells.empty()) return;
    const accel::PlacedObject& object = scene_.objects[id];
    const Vec3d low = {object.low[0], object.low[1], object.low[2]};
    const Vec3d high = {object.high[0], object.high[1], object.high[2]};
    const Vec3d to_middle = 0.5 * (low + high) - origin;
    if (length(to_middle - dot(to_middle, unit) * unit) > 0.5 * length(high - low) + 0.1) return;
    for (std::uint32_t t = 0; t < body.count; ++t) {
        auto end = meet(triangles_[body.first + t], origin, unit);
        if (!end || end->distance < -end->tolerance || end->distance > farthest + end->tolerance) continue;
        const double slack = border_slack * (1 + std::max(0.0, end->distance));
        const double depth = depth_in(body, origin + end->distance * unit);
        if (depth < -slack - end->tolerance) continue;
        if (depth < -1e-7 || end->distance < end->tolerance) end->is_sure = false;
        end->object = static_cast<accel::ObjectId>(id);
        end->triangle = t;
        ends.push_back(*end);
    }
}

std::optional<bool> ObjectOracle::stands_between(Vec3d p, Vec3d q, double touch, accel::ObjectId skipped) const {
    const double distance = length(q - p);
    if (!(distance > 2 * touch)) return false;
    std::vector<PossibleEnd> ends;
    for (std::uint32_t i = 0; i < bodies_.size(); ++i)
        if (static_cast<accel::ObjectId>(i) != skipped) meet_object(i, p, normalized(q - p), distance, ends);
    bool is_unclear = false;
    for (const PossibleEnd& end : ends) {
        const double slack = end.tolerance + band_;
        if (end.distance + slack < touch || end.distance - slack > distance - touch) continue;
        const bool is_inside = end.distance - slack > touch && end.distance + slack < distance - touch;
        if (end.is_sure && is_inside) return true;
        is_unclear = true;
    }
    return is_unclear ? std::optional<bool>() : false;
}

std::vector<PossibleEnd> ObjectOracle::ends_of(const RayQuery& ray) const {
    const Vec3d unit = normalized(ray.direction);
    const auto face = faces_.trace(ray.origin, ray.direction);
    const double wall = face ? face->distance : std::numeric_limits<double>::infinity();
    const double last = std::min(wall, ray.max_distance);
    std::vector<PossibleEnd> ends;
    for (std::uint32_t i = 0; i < bodies_.size(); ++i)
        meet_object(i, ray.origin, unit, last + border_slack * (1 + last), ends);
    const double sine = face && wall <= ray.max_distance
                            ? std::max(std::abs(dot(faces_.normal(face->source_face), unit)), least_sine)
                            : 1.0;
    ends.push_back({last, band_ / sine + border_slack * (1 + last), true});
    std::ranges::sort(ends, {}, &PossibleEnd::distance);
    // Everything up to the first sure one, and what lies within rounding behind it.
    double until = std::numeric_limits<double>::infinity();
    std::size_t kept = 0;
    for (; kept < ends.size() && ends[kept].distance <= until; ++kept)
        if (ends[kept].is_sure) until = std::min(until, ends[kept].distance + ends[kept].tolerance);
    ends.resize(kept);
    return ends;
}

bool ObjectOracle::allows(const RayQuery& ray, const RayHit& answer) const {
    const bool is_object = answer.status == WalkStatus::Object;
    double least_sure = std::numeric_limits<double>::infinity();  // of the objects
    for (const PossibleEnd& end : ends_of(ray)) {
        const bool is_of_object = end.object != none<accel::ObjectId>;
        const double tolerance = end.tolerance + 4e-6 * (1 + end.distance);
        if (is_of_object && end.is_sure) least_sure = std::min(least_sure, end.distance + tolerance);
        if (is_object != is_of_object || (is_object && answer.object != end.object)) continue;
        if (std::abs(answer.distance - end.distance) <= tolerance) return true;
    }
    // Beside the edges of walls, and for rays that start in a wall's plane, rounding decides which wall it is.
    if (answer.distance > least_sure) return false;
    return (answer.status == WalkStatus::Hit && faces_.plane_distance(ray.origin, answer.source_face) <= band_) ||
           faces_.edge_distance(ray.origin, ray.direction, answer.distance + band_) <= band_;
}

}  // namespace enfilade::render
