// The loops of pictures with sun, sky and darkened corners. Included by kernel_loops.h alone, once for each instruction
// set: no include guard is needed.

#include "render/framebuffer.h"
#include "render/kernel.h"
#include "render/lamp_light.h"
#include "render/mirror.h"
#include "render/rooms.h"
#include "render/sampling.h"
#include "render/shade.h"
#include "render/surface.h"

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
bool is_open(const accel::SceneView& scene, const Sight<T>& sight) {
    const WalkEnd<T>& end = sight.end;
    if (end.status == WalkStatus::Object)
        return scene.has_looks() && is_glass(scene, sight.hit.object, sight.hit.triangle);
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
        const float reached = is_open(tools.scene, sight)
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

/// A place that a ray found, and what light does there.
template <class T>
struct Found {
    LitPlace<T> place;
    float headlight;  ///< Lambert's cosine for a lamp at the eye
    Surfacing surfacing;
};

/// Of where a walk ended, other than in the sky. width: of the ray's beam there, metres
template <class T, class Rooms, class Events>
Found<T> what_is_found(const LookTools<Rooms, Events>& tools, const Ray<T>& ray, const Sight<T>& sight, float width) {
    const accel::SceneView& scene = tools.scene;
    if constexpr (Rooms::are_furnished) {
        if (sight.end.status == WalkStatus::Object) {
            const Vec3f normal = facing_normal(ray, sight.hit);
            return {{off_object(ray, sight.hit, normal), normal, sight.end.cell},
                    headlight_cosine(ray, sight.hit),
                    surfacing_of_object(scene, ray, sight.hit, normal, width)};
        }
    }
    const WalkEnd<T>& end = sight.end;
    const LitPlace<T> place = {end_point(scene, ray, end), normal_of(scene, end), end.cell};
    return {place, headlight_cosine(scene, ray, end),
            surfacing_of_face(scene, ray, end, vec_cast<float>(place.point), place.normal, width)};
}

/// A part of a pixel's light that is still to be followed.
template <class T>
struct Way {
    Ray<T> ray;
    std::uint32_t cell;
    T first;           ///< the parameter from which objects count
    float width;       ///< of its beam where it starts to count, metres
    float spread;      ///< by which that grows, a unit of its parameter
    T counted;         ///< the parameter where it starts to count
    Vec3f share;       ///< of the pixel's light
    bool is_mirrored;  ///< somewhere before
};

/// The ways that one ray splits into at mirrors and glass. The weakest are left out where they cannot be seen, and none
/// is split any more where there are too many: there a surface shows its colour alone.
template <class T>
class Ways {
public:
    static constexpr int most_open = 8;
    static constexpr int most_walked = 48;
    static constexpr float least_share = 1.0f / 512;

    [[nodiscard]] bool may_split() const { return open_ + 2 <= most_open && walked_ + open_ + 2 <= most_walked; }
    void add(const Way<T>& way) {
        if (largest_part(way.share) >= least_share) ways_[open_++] = way;
    }
    bool take(Way<T>& way) {
        if (open_ == 0) return false;
        way = ways_[--open_];
        ++walked_;
        return true;
    }

private:
    Way<T> ways_[most_open];
    int open_ = 0, walked_ = 0;
};

/// In a dollhouse a ray that rises through the cut sees the sky.
template <class T>
Limit<T> until_the_cut(const detail::TileJob& job, const Ray<T>& ray) {
    const bool rises = job.is_cut && ray.direction.z > 0;
    return Limit<T>{rises ? (T(job.cut_z) - ray.origin.z) / ray.direction.z : T(3e38f)};
}

/// The way from a mirror: a level floor keeps the ray's line on the plan (mirror.h).
template <class T>
Way<T> reflected(const accel::SceneView& scene, const Way<T>& way, const Sight<T>& sight, const LitPlace<T>& place,
                 float width, Vec3f share) {
    Way<T> next = way;
    next.cell = sight.end.cell;
    next.share = share;
    next.width = width;
    next.is_mirrored = true;
    if (is_mirror_hit(scene, sight.end)) {
        next.ray = mirrored(way.ray, T(scene.cells[sight.end.cell].z_floor));
        next.first = next.counted = parameter(scene, way.ray, sight.end);
        return next;
    }
    const Vec<T> n = vec_cast<T>(place.normal);
    next.ray = make_ray_unchecked(place.point, way.ray.direction - T(2) * dot(n, way.ray.direction) * n);
    next.spread = way.spread * static_cast<float>(length(next.ray.direction) / length(way.ray.direction));
    next.first = next.counted = 0;
    return next;
}

/// Straight on, behind the triangle that was met.
template <class T>
Way<T> straight_on(const Way<T>& way, const Sight<T>& sight, float width, Vec3f share) {
    Way<T> next = way;
    const Vec<T> met = sight.hit.t * way.ray.direction;
    const T step = T(0x1p-18f) * (largest_part(way.ray.origin) + largest_part(met)) + T(0x1p-16f);
    next.cell = sight.end.cell;
    next.first = next.counted = sight.hit.t + step / length(way.ray.direction);
    next.width = width;
    next.share = share;
    return next;
}

/// What one way shows: adds the ways that go on from there.
template <class T, class Rooms, class Events>
Vec3f along_way(const LookTools<Rooms, Events>& tools, const Way<T>& way, Ways<T>& ways, Sampler& sampler) {
    const accel::SceneView& scene = tools.scene;
    const Look& look = tools.look;
    Vec3f tint = {1, 1, 1};
    const Sight<T> sight =
        way.is_mirrored ? tools.rooms.look_along(scene, way.ray, way.cell, until_the_cut(tools.job, way.ray), tint,
                                                 tools.events, way.first)
                        : tools.rooms.look_along(scene, way.ray, way.cell, NoLimit{}, tint, tools.events, way.first);
    const WalkEnd<T>& end = sight.end;
    const Vec3f share = tint * way.share;
    const bool is_sky =
        end.status == WalkStatus::Reached ||
        (end.status == WalkStatus::Hit && scene.source_faces[end.target.bits].surface == accel::Surface::Sky);
    if (is_sky) return share * sky_colour(look, vec_cast<float>(way.ray.direction));
    if (end.status != WalkStatus::Hit && end.status != WalkStatus::Object) return share * Vec3f{1, 0, 1};
    const float width = way.width + way.spread * static_cast<float>(parameter(scene, way.ray, sight) - way.counted);
    const Found<T> found = what_is_found(tools, way.ray, sight, width);
    Surfacing surfacing = found.surfacing;
    if (tools.job.mirror_floor > 0 && !way.is_mirrored && is_mirror_hit(scene, end)) {
        surfacing.mirror = tools.job.mirror_floor;
        surfacing.diffuse = 1 - surfacing.mirror;
    }
    const bool splits = surfacing.mirror > 0 || largest_part(surfacing.through) > 0;
    if (splits && ways.may_split()) {
        if (largest_part(surfacing.through) > 0) ways.add(straight_on(way, sight, width, surfacing.through * share));
        if (surfacing.mirror > 0) ways.add(reflected(scene, way, sight, found.place, width, surfacing.mirror * share));
    } else {
        surfacing.diffuse = 1;
    }
    const Vec3f own = surfacing.diffuse * share;
    if (splits && largest_part(own) < Ways<T>::least_share) return {0, 0, 0};
    return own * lit_colour(tools, found.place, look.headlight * found.headlight, surfacing.colour, sampler);
}

/// spread: how much wider the pixel's beam becomes along `direction`, metres.
template <class T, class Rooms, class Events>
Vec3f radiance(const LookTools<Rooms, Events>& tools, Vec<T> origin, Vec3f direction, std::uint32_t cell, float width,
               float spread, Sampler& sampler) {
    Ways<T> ways;
    const Ray<T> ray = make_ray_unchecked(origin, vec_cast<T>(direction));
    const float scale = static_cast<float>(length(ray.direction)) / length(direction);
    Way<T> way = {ray, cell, T(0), width, scale * spread, T(0), {1, 1, 1}, false};
    Vec3f sum = along_way(tools, way, ways, sampler);
    while (ways.take(way)) sum = sum + along_way(tools, way, ways, sampler);
    return sum;
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
Vec3f cut_radiance(const LookTools<Rooms, Events>& tools, Vec3f direction, float spread, std::uint32_t& near_cell,
                   Sampler& sampler) {
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
    return radiance(tools, point, direction, near_cell, static_cast<float>(t) * spread, spread, sampler);
}

template <class T, class Rooms, class Events>
void look_rows(const detail::TileJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const LookTools<Rooms, Events> tools = {job, scene, *job.look, rooms, events};
    const Vec<T> eye = vec_cast<T>(camera.origin);
    const int side = job.samples_a_side;
    const float step = 1.0f / static_cast<float>(side);
    // A pixel's side on the plane at which directions end, of the pixel's samples one each.
    const float spread = step * length(camera.du);
    std::uint32_t near_cell = no_cell;
    for (int y = job.y0; y < job.y1; ++y) {
        for (int x = job.x0; x < job.x1; ++x) {
            Sampler sampler(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            Vec3f sum = {0, 0, 0};
            for (int k = 0; k < side * side; ++k) {
                const Vec3f direction =
                    camera.direction(static_cast<float>(x) + (static_cast<float>(k % side) + 0.5f) * step,
                                     static_cast<float>(y) + (static_cast<float>(k / side) + 0.5f) * step);
                sum = sum + (job.is_cut ? cut_radiance<T>(tools, direction, spread, near_cell, sampler)
                                        : radiance(tools, eye, direction, job.start_cell, 0.0f, spread, sampler));
            }
            store(job, x, y, (step * step) * sum);
        }
    }
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
