// The loops over rays. Included by one file for each instruction set, which names its namespace (isa.h); no include
// guard is needed, and no standard container may appear here.

#include "render/block_loops.h"
#include "render/block_streams.h"
#include "render/framebuffer.h"
#include "render/kernel.h"
#include "render/mirror.h"
#include "render/sampling.h"
#include "render/shade.h"
#include "render/walk.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

void store(const detail::TileJob& job, int x, int y, Vec3f colour) {
    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x;
    if (job.rgb == nullptr) {
        job.rgba[pixel] = encoded(colour);
        return;
    }
    float* p = job.rgb + 3 * pixel;
    p[0] = colour.x;
    p[1] = colour.y;
    p[2] = colour.z;
}

/// What a lamp at the eye shows of where a walk ended; throughput not yet counted.
template <class T>
Vec3f lambert_colour(const accel::SceneView& scene, const Look& look, const Ray<T>& ray, const WalkEnd<T>& end) {
    if (end.status != WalkStatus::Hit) return {1, 0, 1};  // a leak shows
    const accel::SourceFace& face = scene.source_faces[end.target.bits];
    return face.surface == accel::Surface::Sky ? sky_colour(look, vec_cast<float>(ray.direction))
                                               : headlight_cosine(scene, ray, end) * colour_of(scene, face);
}

/// What the mirror at which `ray` ended shows: the eye and its lamp have their images below it.
template <class T, class Events>
Vec3f lambert_in_mirror(const detail::TileJob& job, const accel::SceneView& scene, const Ray<T>& ray,
                        const WalkEnd<T>& end, Vec3f own, Events& events) {
    const Ray<T> image = mirrored(ray, T(scene.cells[end.cell].z_floor));
    Vec3f throughput = {1, 1, 1};
    const WalkEnd<T> seen = walk(scene, image, end.cell, NoLimit{}, throughput, events);
    return in_mirror(job.mirror_floor, own, throughput * lambert_colour(scene, *job.look, image, seen));
}

template <class T, class Events>
void lambert_rows(const detail::TileJob& job, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const Look& look = *job.look;
    const Vec<T> eye = vec_cast<T>(camera.origin);
    for (int y = job.y0; y < job.y1; ++y) {
        for (int x = job.x0; x < job.x1; ++x) {
            const Vec3f direction = camera.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const Ray<T> ray = make_ray_unchecked(eye, vec_cast<T>(direction));
            Vec3f throughput = {1, 1, 1};
            const WalkEnd<T> end = walk(scene, ray, job.start_cell, NoLimit{}, throughput, events);
            Vec3f colour = lambert_colour(scene, look, ray, end);
            if (job.mirror_floor > 0 && is_mirror_hit(scene, end))
                colour = lambert_in_mirror(job, scene, ray, end, colour, events);
            store(job, x, y, throughput * colour);
        }
    }
}

/// How much of the sky and of far walls a point sees: short rays over the hemisphere, each worth how far it gets.
template <class T, class Events>
float ambient_openness(const accel::SceneView& scene, const Look& look, Vec<T> point, Vec3f normal, std::uint32_t cell,
                       Sampler& sampler, Events& events) {
    float open = 0;
    for (int i = 0; i < look.ambient_samples; ++i) {
        const Ray<T> ray = make_ray_unchecked(point, vec_cast<T>(sampler.next_cosine_direction(normal)));
        Vec3f throughput = {1, 1, 1};
        const WalkEnd<T> end = walk(scene, ray, cell, Limit<T>{T(look.ambient_reach)}, throughput, events);
        const bool is_open =
            end.status != WalkStatus::Hit || scene.source_faces[end.target.bits].surface == accel::Surface::Sky;
        const float reached = is_open ? 1.0f : static_cast<float>(parameter(scene, ray, end) / T(look.ambient_reach));
        open += reached > 0 ? (reached < 1 ? reached * (2 - reached) : 1.0f) : 0.0f;
    }
    return look.ambient_samples > 0 ? open / static_cast<float>(look.ambient_samples) : 1.0f;
}

template <class T, class Events>
Vec3f sunlight(const accel::SceneView& scene, const Look& look, Vec<T> point, Vec3f normal, std::uint32_t cell,
               Events& events) {
    const float cosine = dot(normal, look.sun_direction);
    if (!(cosine > 0)) return {0, 0, 0};
    Vec3f throughput = {1, 1, 1};
    const Ray<T> ray = make_ray_unchecked(point, vec_cast<T>(look.sun_direction));
    const WalkEnd<T> end = walk(scene, ray, cell, NoLimit{}, throughput, events);
    if (end.status != WalkStatus::Hit || scene.source_faces[end.target.bits].surface != accel::Surface::Sky)
        return {0, 0, 0};
    return cosine * (throughput * look.sun);
}

/// Where the walk ended, on the face itself. Secondary rays need no epsilon: a walk starts in a cell and asks by which
/// face the line leaves it, so the face on which it starts is never hit again.
template <class T>
Vec<T> end_point(const accel::SceneView& scene, const Ray<T>& ray, const WalkEnd<T>& end) {
    const accel::Cell& cell = scene.cells[end.cell];
    Vec<T> point = ray.origin + parameter(scene, ray, end) * ray.direction;
    if (end.exit == Exit::Floor || point.z < T(cell.z_floor)) point.z = T(cell.z_floor);
    if (end.exit == Exit::Ceiling || point.z > T(cell.z_ceiling)) point.z = T(cell.z_ceiling);
    return point;
}

ENFILADE_HD float under_shoulder(float value, float shoulder) {
    const float over = value - shoulder, room = 1 - shoulder;
    return over > 0 && room > 0 ? shoulder + room * over / (over + room) : value;
}

ENFILADE_HD Vec3f under_shoulder(const Look& look, Vec3f c) {
    return {under_shoulder(c.x, look.shoulder), under_shoulder(c.y, look.shoulder), under_shoulder(c.z, look.shoulder)};
}

/// What the light shows of where a walk ended; throughput not yet counted.
template <class T, class Events>
Vec3f look_colour(const accel::SceneView& scene, const Look& look, const Ray<T>& ray, const WalkEnd<T>& end,
                  Sampler& sampler, Events& events) {
    if (end.status == WalkStatus::Reached) return sky_colour(look, vec_cast<float>(ray.direction));
    if (end.status != WalkStatus::Hit) return {1, 0, 1};
    const accel::SourceFace& face = scene.source_faces[end.target.bits];
    if (face.surface == accel::Surface::Sky) return sky_colour(look, vec_cast<float>(ray.direction));
    const Vec<T> point = end_point(scene, ray, end);
    const Vec3f normal = normal_of(scene, end);
    const float headlight = look.headlight * headlight_cosine(scene, ray, end);
    const Vec3f light = ambient_openness(scene, look, point, normal, end.cell, sampler, events) * look.ambient +
                        sunlight(scene, look, point, normal, end.cell, events) + Vec3f{headlight, headlight, headlight};
    return under_shoulder(look, light * colour_of(scene, face));
}

/// In a dollhouse a reflected ray that rises through the cut sees the sky.
template <class T, class Events>
Vec3f look_in_mirror(const detail::TileJob& job, const accel::SceneView& scene, const Ray<T>& ray,
                     const WalkEnd<T>& end, Vec3f own, Sampler& sampler, Events& events) {
    const Ray<T> image = mirrored(ray, T(scene.cells[end.cell].z_floor));
    const T limit = job.is_cut ? (T(job.cut_z) - image.origin.z) / image.direction.z : T(3e38f);
    Vec3f throughput = {1, 1, 1};
    const WalkEnd<T> seen = walk(scene, image, end.cell, Limit<T>{limit}, throughput, events);
    const Vec3f colour = look_colour(scene, *job.look, image, seen, sampler, events);
    return in_mirror(job.mirror_floor, own, throughput * colour);
}

template <class T, class Events>
Vec3f radiance(const detail::TileJob& job, const accel::SceneView& scene, Vec<T> origin, Vec3f direction,
               std::uint32_t cell, Sampler& sampler, Events& events) {
    const Ray<T> ray = make_ray_unchecked(origin, vec_cast<T>(direction));
    Vec3f throughput = {1, 1, 1};
    const WalkEnd<T> end = walk(scene, ray, cell, NoLimit{}, throughput, events);
    Vec3f colour = look_colour(scene, *job.look, ray, end, sampler, events);
    if (job.mirror_floor > 0 && is_mirror_hit(scene, end))
        colour = look_in_mirror(job, scene, ray, end, colour, sampler, events);
    return throughput * colour;
}

/// The dollhouse: the ray begins where it falls through the cut.
template <class T, class Events>
Vec3f cut_radiance(const detail::TileJob& job, const accel::SceneView& scene, Vec3f direction, std::uint32_t& near_cell,
                   Sampler& sampler, Events& events) {
    const Look& look = *job.look;
    const Vec<T> eye = vec_cast<T>(job.camera->origin), way = vec_cast<T>(direction);
    if (!(direction.z < 0)) return look.paper;
    const T t = (T(job.cut_z) - eye.z) / way.z;
    const Vec<T> point = {eye.x + t * way.x, eye.y + t * way.y, T(job.cut_z)};
    const double where[3] = {point.x, point.y, point.z};
    if (near_cell == no_cell || !detail::cell_holds(scene, near_cell, where)) {
        const std::uint32_t cell = detail::cell_at(scene, where);
        if (cell == no_cell) {
            const accel::LocatorNode& site = scene.locator_nodes[0];
            const bool is_on_site = where[0] >= site.low[0] && where[0] <= site.high[0] && where[1] >= site.low[1] &&
                                    where[1] <= site.high[1];
            return is_on_site ? look.cut : look.paper;
        }
        near_cell = cell;
    }
    return radiance(job, scene, point, direction, near_cell, sampler, events);
}

template <class T, class Events>
void look_rows(const detail::TileJob& job, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const Vec<T> eye = vec_cast<T>(camera.origin);
    const int side = job.samples_a_side;
    const float step = 1.0f / static_cast<float>(side);
    std::uint32_t near_cell = no_cell;
    for (int y = job.y0; y < job.y1; ++y) {
        for (int x = job.x0; x < job.x1; ++x) {
            Sampler sampler(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            Vec3f sum = {0, 0, 0};
            for (int k = 0; k < side * side; ++k) {
                const Vec3f direction =
                    camera.direction(static_cast<float>(x) + (static_cast<float>(k % side) + 0.5f) * step,
                                     static_cast<float>(y) + (static_cast<float>(k / side) + 0.5f) * step);
                sum = sum + (job.is_cut ? cut_radiance<T>(job, scene, direction, near_cell, sampler, events)
                                        : radiance(job, scene, eye, direction, job.start_cell, sampler, events));
            }
            store(job, x, y, (step * step) * sum);
        }
    }
}

template <class T, class Events>
void trace_each(const detail::RayJob& job, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t i = 0; i < job.count; ++i) {
        const RayQuery& query = job.rays[i];
        RayHit& hit = job.hits[i];
        hit.throughput = {1, 1, 1};
        hit.cell = query.cell;
        hit.status = WalkStatus::Refused;
        Ray<T> ray;
        if (!make_ray(vec_cast<T>(query.origin), vec_cast<T>(query.direction), ray) ||
            !(query.max_distance == query.max_distance))
            continue;
        const T metres = length(ray.direction);
        const T limit = static_cast<T>(query.max_distance) / metres;
        const bool is_limited = query.max_distance < 1e30;
        const auto cell = static_cast<std::uint32_t>(query.cell);
        const WalkEnd<T> end = is_limited ? walk(scene, ray, cell, Limit<T>{limit}, hit.throughput, events)
                                          : walk(scene, ray, cell, NoLimit{}, hit.throughput, events);
        hit.status = end.status;
        hit.source_face = static_cast<accel::SourceFaceId>(end.target.bits);
        hit.cell = static_cast<accel::CellId>(end.cell);
        hit.exit = end.exit;
        hit.section = end.section;
        hit.face = end.face;
        hit.distance = end.status == WalkStatus::Reached ? query.max_distance
                                                         : static_cast<double>(parameter(scene, ray, end) * metres);
    }
}

template <class Events>
void trace_stream(const detail::StreamJob& job, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t k = job.begin; k < job.end; ++k) {
        const std::uint64_t i = job.order != nullptr ? job.order[k] : k;
        const float max_distance = job.max_distance != nullptr ? job.max_distance[i] : 3e38f;
        WalkEnd<float> end = {};
        end.status = WalkStatus::Refused;
        end.cell = static_cast<std::uint32_t>(job.start[i]);
        float distance = __builtin_nanf("");
        Ray<float> ray;
        if (make_ray(Vec3f{job.origin[0][i], job.origin[1][i], job.origin[2][i]},
                     Vec3f{job.direction[0][i], job.direction[1][i], job.direction[2][i]}, ray) &&
            max_distance == max_distance) {
            const float metres = length(ray.direction);
            Vec3f throughput = {1, 1, 1};
            end = job.max_distance != nullptr
                      ? walk(scene, ray, end.cell, Limit<float>{limit_of(max_distance, metres)}, throughput, events)
                      : walk(scene, ray, end.cell, NoLimit{}, throughput, events);
            distance = end.status == WalkStatus::Reached ? max_distance : parameter(scene, ray, end) * metres;
        }
        if (job.distance != nullptr) job.distance[i] = distance;
        if (job.source_face != nullptr)
            job.source_face[i] =
                static_cast<accel::SourceFaceId>(end.status == WalkStatus::Hit ? end.target.bits : ~0u);
        if (job.cell != nullptr) job.cell[i] = static_cast<accel::CellId>(end.cell);
        if (job.status != nullptr) job.status[i] = end.status;
    }
}

/// Whether nothing but glass lies between p (in `cell`) and q (in `to_cell`; no_cell: not known): the walk from p
/// reaches q's cell, or q.
///
/// The ray's direction is q - p rounded once and scaled by a power of two, so that power is exactly the parameter of q,
/// and a floor or ceiling at q's height has exactly q's parameter: what lies on a level is seen from its cell, in
/// either direction. Where q lies on a wall and its cell is not known, rounding decides, as everywhere within
/// `error_band`. Outside that band the answer is the same for q and p exchanged. Points that are none (NaN, infinite)
/// see nothing, not even themselves.
template <class Events>
bool sees(const accel::SceneView& scene, Vec3f p, Vec3f q, std::uint32_t cell, std::uint32_t to_cell, Events& events) {
    if (!is_place(p) || !is_place(q)) return false;
    if (cell == to_cell) return true;
    Ray<float> ray;
    const Vec3f way = q - p;
    if (!make_ray(p, way, ray)) return true;  // equal points
    const float t = largest_part(way) / largest_part(ray.direction);
    Vec3f throughput = {1, 1, 1};
    return walk(scene, ray, cell, ToPoint<float>{t, to_cell}, throughput, events).status == WalkStatus::Reached;
}

template <class Events>
void trace_segments(const detail::SegmentJob& job, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t k = job.begin; k < job.end; ++k) {
        const std::uint64_t i = job.order != nullptr ? job.order[k] : k;
        const std::uint32_t to_cell = job.to_cell != nullptr ? static_cast<std::uint32_t>(job.to_cell[i]) : no_cell;
        job.visible[i] = static_cast<std::uint8_t>(sees(scene, {job.from[0][i], job.from[1][i], job.from[2][i]},
                                                        {job.to[0][i], job.to[1][i], job.to[2][i]},
                                                        static_cast<std::uint32_t>(job.from_cell[i]), to_cell, events));
    }
}

template <class Job, class Body>
void counted(const Job& job, const Body& body) {
    NoEvents none;
    if (job.stats != nullptr) body(*job.stats);
    else body(none);
}

void lambert_tile(const detail::TileJob& job) {
#if ENFILADE_WIDE_SIDES
    if (job.stats == nullptr && !job.is_double) return lambert_blocks(job);
#endif
    counted(job, [&](auto& events) {
        if (job.is_double) lambert_rows<double>(job, events);
        else lambert_rows<float>(job, events);
    });
}

void look_tile(const detail::TileJob& job) {
    counted(job, [&](auto& events) {
        if (job.is_double) look_rows<double>(job, events);
        else look_rows<float>(job, events);
    });
}

void rays_float(const detail::RayJob& job) {
    counted(job, [&](auto& events) { trace_each<float>(job, events); });
}

void rays_double(const detail::RayJob& job) {
    counted(job, [&](auto& events) { trace_each<double>(job, events); });
}

void nearest(const detail::StreamJob& job) {
#if ENFILADE_WIDE_SIDES
    if (job.stats == nullptr) return nearest_blocks(job);
#endif
    counted(job, [&](auto& events) { trace_stream(job, events); });
}

void visible(const detail::SegmentJob& job) {
#if ENFILADE_WIDE_SIDES
    if (job.stats == nullptr) return visible_blocks(job);
#endif
    counted(job, [&](auto& events) { trace_segments(job, events); });
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
