// The loops of pictures with sun, sky and darkened corners. Included by kernel_loops.h alone, once for each instruction
// set: no include guard is needed.

#include "render/framebuffer.h"
#include "render/kernel.h"
#include "render/lamp_light.h"
#include "render/mirror.h"
#include "render/rooms.h"
#include "render/sampling.h"
#include "render/shade.h"

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

/// What all rays of a picture share.
template <class Rooms, class Events>
struct LookTools {
    const detail::TileJob& job;
    const accel::SceneView& scene;
    const Look& look;
    const Rooms& rooms;
    Events& events;
};

/// Whether a ray that ended so sees the sky, or at least nothing within its reach.
template <class T>
bool is_open(const accel::SceneView& scene, const WalkEnd<T>& end) {
    if (end.status == WalkStatus::Object) return false;
    return end.status != WalkStatus::Hit || scene.source_faces[end.target.bits].surface == accel::Surface::Sky;
}

/// How much of the sky and of far walls a point sees: short rays over the hemisphere, each worth how far it gets.
template <class T, class Rooms, class Events>
float ambient_openness(const LookTools<Rooms, Events>& tools, const LitPlace<T>& at, Sampler& sampler) {
    const Look& look = tools.look;
    float open = 0;
    for (int i = 0; i < look.ambient_samples; ++i) {
        const Ray<T> ray = make_ray_unchecked(at.point, vec_cast<T>(sampler.next_cosine_direction(at.normal)));
        Vec3f throughput = {1, 1, 1};
        const Sight<T> sight = tools.rooms.look_along(tools.scene, ray, at.cell, Limit<T>{T(look.ambient_reach)},
                                                      throughput, tools.events);
        const float reached = is_open(tools.scene, sight.end)
                                  ? 1.0f
                                  : static_cast<float>(parameter(tools.scene, ray, sight) / T(look.ambient_reach));
        open += reached > 0 ? (reached < 1 ? reached * (2 - reached) : 1.0f) : 0.0f;
    }
    return look.ambient_samples > 0 ? open / static_cast<float>(look.ambient_samples) : 1.0f;
}

template <class T, class Rooms, class Events>
Vec3f sunlight(const LookTools<Rooms, Events>& tools, const LitPlace<T>& at) {
    const float cosine = dot(at.normal, tools.look.sun_direction);
    if (!(cosine > 0) || largest_part(tools.look.sun) == 0) return {0, 0, 0};
    Vec3f throughput = {1, 1, 1};
    const Ray<T> ray = make_ray_unchecked(at.point, vec_cast<T>(tools.look.sun_direction));
    const WalkEnd<T> end =
        tools.rooms.look_for_any(tools.scene, ray, at.cell, NoLimit{}, ObjectPart{}, throughput, tools.events);
    if (end.status != WalkStatus::Hit || tools.scene.source_faces[end.target.bits].surface != accel::Surface::Sky)
        return {0, 0, 0};
    return cosine * (throughput * tools.look.sun);
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

/// What lamps add to a white surface in the picture.
template <class T, class Rooms, class Events>
Vec3f lamp_light(const LookTools<Rooms, Events>& tools, const LitPlace<T>& at) {
    constexpr float inverse_pi = 0.318309886f;
    LampLight<Rooms, Events> light(tools.scene, *tools.job.lamps, tools.rooms, tools.events);
    return inverse_pi * tools.job.lamps->exposure * light.at(at);
}

/// The light of a surface of that colour. headlight: what the lamp at the camera adds where there are no others.
template <class T, class Rooms, class Events>
Vec3f lit_colour(const LookTools<Rooms, Events>& tools, const LitPlace<T>& at, float headlight, Vec3f colour,
                 Sampler& sampler) {
    const Vec3f near = tools.job.lamps != nullptr ? lamp_light(tools, at) : Vec3f{headlight, headlight, headlight};
    const Vec3f light = ambient_openness(tools, at, sampler) * tools.look.ambient + sunlight(tools, at) + near;
    return under_shoulder(tools.look, light * colour);
}

/// What the light shows of where a walk ended; throughput not yet counted.
template <class T, class Rooms, class Events>
Vec3f look_colour(const LookTools<Rooms, Events>& tools, const Ray<T>& ray, const Sight<T>& sight, Sampler& sampler) {
    const accel::SceneView& scene = tools.scene;
    const Look& look = tools.look;
    const WalkEnd<T>& end = sight.end;
    if (end.status == WalkStatus::Reached) return sky_colour(look, vec_cast<float>(ray.direction));
    if constexpr (Rooms::are_furnished) {
        if (end.status == WalkStatus::Object) {
            const Vec3f normal = facing_normal(ray, sight.hit);
            return lit_colour(tools, LitPlace<T>{off_object(ray, sight.hit, normal), normal, end.cell},
                              look.headlight * headlight_cosine(ray, sight.hit),
                              object_colour(scene, sight.hit.object, sight.hit.triangle), sampler);
        }
    }
    if (end.status != WalkStatus::Hit) return {1, 0, 1};
    const accel::SourceFace& face = scene.source_faces[end.target.bits];
    if (face.surface == accel::Surface::Sky) return sky_colour(look, vec_cast<float>(ray.direction));
    return lit_colour(tools, LitPlace<T>{end_point(scene, ray, end), normal_of(scene, end), end.cell},
                      look.headlight * headlight_cosine(scene, ray, end), colour_of(scene, face), sampler);
}

/// In a dollhouse a reflected ray that rises through the cut sees the sky.
template <class T, class Rooms, class Events>
Vec3f look_in_mirror(const LookTools<Rooms, Events>& tools, const Ray<T>& ray, const WalkEnd<T>& end, Vec3f own,
                     Sampler& sampler) {
    const detail::TileJob& job = tools.job;
    const Ray<T> image = mirrored(ray, T(tools.scene.cells[end.cell].z_floor));
    const T limit = job.is_cut ? (T(job.cut_z) - image.origin.z) / image.direction.z : T(3e38f);
    Vec3f throughput = {1, 1, 1};
    const Sight<T> seen = tools.rooms.look_along(tools.scene, image, end.cell, Limit<T>{limit}, throughput,
                                                 tools.events, parameter(tools.scene, ray, end));
    return in_mirror(job.mirror_floor, own, throughput * look_colour(tools, image, seen, sampler));
}

template <class T, class Rooms, class Events>
Vec3f radiance(const LookTools<Rooms, Events>& tools, Vec<T> origin, Vec3f direction, std::uint32_t cell,
               Sampler& sampler) {
    const Ray<T> ray = make_ray_unchecked(origin, vec_cast<T>(direction));
    Vec3f throughput = {1, 1, 1};
    const Sight<T> sight = tools.rooms.look_along(tools.scene, ray, cell, NoLimit{}, throughput, tools.events);
    Vec3f colour = look_colour(tools, ray, sight, sampler);
    if (tools.job.mirror_floor > 0 && is_mirror_hit(tools.scene, sight.end))
        colour = look_in_mirror(tools, ray, sight.end, colour, sampler);
    return throughput * colour;
}

/// Whether a point lies inside of an object: more surfaces below it are left than entered. triangle: one that shows
/// what the object is made of there.
template <class Inside>
bool is_inside(const accel::SceneView& scene, const Inside& inside, const accel::PlacedObject& object, Vec3f point,
               std::uint32_t& triangle) {
    constexpr int most_surfaces = 64;
    constexpr float step = 1e-4f;  // metres: surfaces nearer to each other count as one
    const accel::ObjectMesh& mesh = scene.meshes[static_cast<std::uint32_t>(object.mesh)];
    const Ray<float> down = make_ray_unchecked(point, Vec3f{0, 0, -1});
    int depth = 0;
    float near = 0;
    for (int i = 0; i < most_surfaces; ++i) {
        ObjectRay asked = to_object(object, down, near, 3e38f);
        if (!may_meet(mesh, asked)) break;
        ask_nearest(inside, object.mesh, asked);
        if (asked.triangle == no_triangle) break;
        const bool is_left = scene_normal(object, asked).z < 0;
        if (is_left && depth <= 0) triangle = asked.triangle;
        depth += is_left ? 1 : -1;
        near = asked.far + step;
    }
    return depth > 0;
}

/// What is seen of the object that the dollhouse's cut goes through at a point: its colour, as on a level surface.
/// False where the point lies in none.
template <class T, class Events>
bool see_cut_object(const LookTools<FurnishedRooms, Events>& tools, Vec<T> point, Vec3f direction, std::uint32_t cell,
                    Vec3f& colour) {
    const accel::SceneView& scene = tools.scene;
    const Look& look = tools.look;
    const Vec3f p = vec_cast<float>(point);
    for (std::uint32_t k = scene.cell_object_offsets[cell]; k < scene.cell_object_offsets[cell + 1]; ++k) {
        const auto id = static_cast<std::uint32_t>(scene.cell_objects[k]);
        const accel::PlacedObject& object = scene.objects[id];
        const auto &low = object.low, &high = object.high;
        if (p.x < low[0] || p.x > high[0] || p.y < low[1] || p.y > high[1] || p.z < low[2] || p.z > high[2]) continue;
        std::uint32_t triangle = 0;
        if (!is_inside(scene, tools.rooms.objects, object, p, triangle)) continue;
        const float headlight = look.headlight * magnitude(direction.z) / length(direction);
        const Vec3f light = look.ambient + Vec3f{headlight, headlight, headlight};
        colour = under_shoulder(look, light * object_colour(scene, id, triangle));
        return true;
    }
    return false;
}

/// The dollhouse: the ray begins where it falls through the cut.
template <class T, class Rooms, class Events>
Vec3f cut_radiance(const LookTools<Rooms, Events>& tools, Vec3f direction, std::uint32_t& near_cell, Sampler& sampler) {
    const detail::TileJob& job = tools.job;
    const accel::SceneView& scene = tools.scene;
    const Vec<T> eye = vec_cast<T>(job.camera->origin), way = vec_cast<T>(direction);
    if (!(direction.z < 0)) return tools.look.paper;
    const T t = (T(job.cut_z) - eye.z) / way.z;
    const Vec<T> point = {eye.x + t * way.x, eye.y + t * way.y, T(job.cut_z)};
    const double where[3] = {point.x, point.y, point.z};
    if (near_cell == no_cell || !detail::cell_holds(scene, near_cell, where)) {
        const std::uint32_t cell = detail::cell_at(scene, where);
        if (cell == no_cell) {
            const accel::LocatorNode& site = scene.locator_nodes[0];
            const bool is_on_site = where[0] >= site.low[0] && where[0] <= site.high[0] && where[1] >= site.low[1] &&
                                    where[1] <= site.high[1];
            return is_on_site ? tools.look.cut : tools.look.paper;
        }
        near_cell = cell;
    }
    if constexpr (Rooms::are_furnished) {
        Vec3f colour;
        if (see_cut_object(tools, point, direction, near_cell, colour)) return colour;
    }
    return radiance(tools, point, direction, near_cell, sampler);
}

template <class T, class Rooms, class Events>
void look_rows(const detail::TileJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const LookTools<Rooms, Events> tools = {job, scene, *job.look, rooms, events};
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
                sum = sum + (job.is_cut ? cut_radiance<T>(tools, direction, near_cell, sampler)
                                        : radiance(tools, eye, direction, job.start_cell, sampler));
            }
            store(job, x, y, (step * step) * sum);
        }
    }
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
