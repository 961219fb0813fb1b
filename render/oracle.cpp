#include "render/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/shade.h"

namespace enfilade::render {
namespace {

Vec3d to_vec(const accel::Vertex& v) { return {v.x, v.y, v.z}; }

double part(Vec3d v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Least distance between the line o + t d (d of length 1) for t in [0, limit] and the segment a b (Lumelsky 1985).
double line_segment_distance(Vec3d o, Vec3d d, double limit, Vec3d a, Vec3d b) {
    const Vec3d e = b - a, w = o - a;
    const double ee = dot(e, e), de = dot(d, e), dw = dot(d, w), ew = dot(e, w);
    const double det = ee - de * de;
    double s = det > 1e-12 * ee ? (ew - de * dw) / det : 0;
    s = std::clamp(s, 0.0, 1.0);
    double t = std::clamp(de * s - dw, 0.0, limit);
    if (ee > 0) s = std::clamp((de * t + ew) / ee, 0.0, 1.0);
    t = std::clamp(de * s - dw, 0.0, limit);
    return length(w + t * d - s * e);
}

}  // namespace

Oracle::Oracle(const accel::SceneView& scene) {
    vertices_.reserve(scene.vertices.size());
    for (const accel::Vertex& v : scene.vertices) vertices_.push_back(to_vec(v));
    for (std::size_t f = 0; f < scene.source_face_count(); ++f) {
        const std::uint32_t first = scene.source_faces[f].first_vertex;
        const std::uint32_t count = scene.source_faces[f + 1].first_vertex - first;
        Vec3d normal = {0, 0, 0};  // Newell
        Vec3d centre = {0, 0, 0};
        for (std::uint32_t i = 0; i < count; ++i) {
            const Vec3d p = vertices_[first + i] - vertices_[first];
            const Vec3d q = vertices_[first + (i + 1) % count] - vertices_[first];
            normal = normal + cross(p, q);
            centre = centre + (1.0 / count) * vertices_[first + i];
        }
        const double size = length(normal);
        normal = size > 0 ? (1 / size) * normal : Vec3d{0, 0, 0};
        const Vec3d n = {std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
        const int axis = n.z >= n.x && n.z >= n.y ? 2 : n.x >= n.y ? 0 : 1;
        faces_.push_back({normal, dot(normal, centre), axis, first, count});
    }
}

std::optional<OracleHit> Oracle::trace(Vec3d origin, Vec3d direction) const {
    double best = std::numeric_limits<double>::infinity();
    std::size_t best_face = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const Face& face = faces_[f];
        const double den = dot(face.normal, direction);
        if (!(den < 0)) continue;
        const double t = (face.offset - dot(face.normal, origin)) / den;
        if (!(t >= 0) || !(t < best)) continue;
        const Vec3d p = origin + t * direction;
        const int u = face.axis == 0 ? 1 : 0;
        const int v = face.axis == 2 ? 1 : 2;
        bool inside = false;  // even-odd rule
        for (std::uint32_t i = 0, j = face.count - 1; i < face.count; j = i++) {
            const double iv = part(vertices_[face.first + i], v), jv = part(vertices_[face.first + j], v);
            if ((iv > part(p, v)) == (jv > part(p, v))) continue;
            const double iu = part(vertices_[face.first + i], u), ju = part(vertices_[face.first + j], u);
            if (part(p, u) < iu + (part(p, v) - iv) / (jv - iv) * (ju - iu)) inside = !inside;
        }
        if (!inside) continue;
        best = t;
        best_face = f;
    }
    if (!std::isfinite(best)) return std::nullopt;
    return OracleHit{static_cast<accel::SourceFaceId>(best_face), best * length(direction)};
}

double Oracle::edge_distance(Vec3d origin, Vec3d direction, double distance) const {
    const Vec3d unit = normalized(direction);
    double least = std::numeric_limits<double>::infinity();
    for (const Face& face : faces_)
        for (std::uint32_t i = 0; i < face.count; ++i)
            least = std::min(least, line_segment_distance(origin, unit, distance, vertices_[face.first + i],
                                                          vertices_[face.first + (i + 1) % face.count]));
    return least;
}

double Oracle::plane_distance(Vec3d point, accel::SourceFaceId face) const {
    const Face& f = faces_[index(face)];
    return std::abs(dot(f.normal, point) - f.offset);
}

namespace {

/// What is seen along one ray by a lamp at the eye. Where a floor mirrors, a second ray starts at the point that the
/// first one met, and the lamp seems to shine along both.
Vec3f lambert_by_oracle(const accel::SceneView& scene, const Oracle& oracle, Vec3d origin, Vec3d direction,
                        float mirror_floor) {
    const auto hit = oracle.trace(origin, direction);
    if (!hit) return {1, 0, 1};
    const accel::SourceFace& face = scene.source_faces[index(hit->source_face)];
    if (face.surface == accel::Surface::Sky) return sky_colour(Look(), vec_cast<float>(direction));
    const Vec3d normal = oracle.normal(hit->source_face);
    const double cosine = -dot(normal, normalized(direction));
    const Vec3f own = static_cast<float>(cosine) * colour_of(scene, face);
    if (!(mirror_floor > 0) || face.surface != accel::Surface::Floor || !(normal.z > 0)) return own;
    const Vec3d point = origin + hit->distance * normalized(direction);
    const Vec3d reflected = direction - (2 * dot(direction, normal)) * normal;
    return (1 - mirror_floor) * own + mirror_floor * lambert_by_oracle(scene, oracle, point, reflected, 0);
}

}  // namespace

Image trace_by_oracle(const accel::SceneView& scene, const Camera& camera, int samples_per_pixel, float mirror_floor) {
    const CameraFrame frame = make_frame(camera);
    (void)start_cell(scene, frame);
    const Oracle oracle(scene);
    const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(std::max(1, samples_per_pixel)))));
    Image image(camera.width, camera.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            Vec3f sum = {0, 0, 0};
            for (int k = 0; k < side * side; ++k) {
                const Vec3f direction = frame.direction(
                    static_cast<float>(x) + (static_cast<float>(k % side) + 0.5f) / static_cast<float>(side),
                    static_cast<float>(y) + (static_cast<float>(k / side) + 0.5f) / static_cast<float>(side));
                sum = sum + lambert_by_oracle(scene, oracle, vec_cast<double>(frame.origin),
                                              vec_cast<double>(direction), mirror_floor);
            }
            const Vec3f mean = (1.0f / static_cast<float>(side * side)) * sum;
            float* pixel =
                image.rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + x);
            pixel[0] = mean.x;
            pixel[1] = mean.y;
            pixel[2] = mean.z;
        }
    }
    return image;
}

double error_band(const accel::SceneView& scene) {
    double largest = 0;
    for (int k = 0; k < 3; ++k)
        largest = std::max({largest, std::abs(double{scene.locator_nodes[0].low[k]}),
                            std::abs(double{scene.locator_nodes[0].high[k]})});
    return 16 * largest * 0x1p-24 + 2 * scene.unit;
}

namespace {
constexpr double least_sine = 1e-5;  ///< of the angle between a ray and the face it grazes
}  // namespace

Agreement compare(const Oracle& oracle, std::span<const RayQuery> rays, std::span<const RayHit> hits, double band) {
    Agreement agreement;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ++agreement.rays;
        const auto expected = oracle.trace(rays[i].origin, rays[i].direction);
        const bool is_hit = hits[i].status == WalkStatus::Hit;
        if (expected && is_hit && expected->source_face == hits[i].source_face) {
            const double cosine = -dot(oracle.normal(expected->source_face), normalized(rays[i].direction));
            if (cosine > 0.0175)
                agreement.largest_distance_error =
                    std::max(agreement.largest_distance_error, std::abs(expected->distance - hits[i].distance));
            continue;
        }
        // Across a face by the band is along the ray by the band over the sine of the angle at which it grazes.
        const Vec3d along = normalized(rays[i].direction);
        const auto end_of = [&](double distance, accel::SourceFaceId face) {
            return distance + band / std::max(std::abs(dot(oracle.normal(face), along)), least_sine);
        };
        const double reach = std::max(expected ? end_of(expected->distance, expected->source_face) : band,
                                      is_hit ? end_of(hits[i].distance, hits[i].source_face) : band);
        const bool starts_on_it = (is_hit && oracle.plane_distance(rays[i].origin, hits[i].source_face) <= band) ||
                                  (expected && oracle.plane_distance(rays[i].origin, expected->source_face) <= band);
        if (starts_on_it || oracle.edge_distance(rays[i].origin, rays[i].direction, reach) <= band)
            ++agreement.differing_inside_band;
        else ++agreement.differing_outside_band;
    }
    return agreement;
}

}  // namespace enfilade::render
