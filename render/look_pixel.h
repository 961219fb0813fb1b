#pragma once
// A pixel with sun, sky, lamps and darkened corners, of a camera in the rooms or above a dollhouse. Included by loops,
// which are compiled once for each instruction set, and as device code.

#include "accel/cell_at_point.h"
#include "render/look_ways.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// Whether a point lies inside of an object: more surfaces below it are left than entered. triangle: one that shows
/// what the object is made of there.
template <class Inside>
ENFILADE_HD_FREE bool is_inside(const accel::SceneView& scene, const Inside& inside, const accel::PlacedObject& object,
                                Vec3f point, std::uint32_t& triangle) {
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
template <class T, class Tools>
ENFILADE_HD_FREE bool see_cut_object(const Tools& tools, Vec<T> point, Vec3f direction, std::uint32_t cell,
                                     Vec3f& colour) {
    const accel::SceneView& scene = tools.scene;
    const Look& look = tools.look;
    const Vec3f p = vec_cast<float>(point);
    for (std::uint32_t k = scene.cell_object_offsets[cell]; k < scene.cell_object_offsets[cell + 1]; ++k) {
        const auto id = static_cast<std::uint32_t>(scene.cell_objects[k]);
        const accel::PlacedObject& object = scene.objects[id];
        const auto* low = reinterpret_cast<const float*>(&object.low);
        const auto* high = reinterpret_cast<const float*>(&object.high);
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
template <class T, class Tools>
ENFILADE_HD_FREE Vec3f cut_radiance(const Tools& tools, Vec3f direction, float spread, std::uint32_t& near_cell,
                                    Sampler& sampler) {
    const LookPicture& picture = tools.picture;
    const accel::SceneView& scene = tools.scene;
    const Vec<T> eye = vec_cast<T>(picture.camera->origin), way = vec_cast<T>(direction);
    if (!(direction.z < 0)) return tools.look.paper;
    const T t = (T(picture.cut_z) - eye.z) / way.z;
    const Vec<T> point = {eye.x + t * way.x, eye.y + t * way.y, T(picture.cut_z)};
    const double where[3] = {point.x, point.y, point.z};
    if (near_cell == no_cell || !accel::cell_holds_point(scene, near_cell, where)) {
        const std::uint32_t cell = accel::cell_at_point(scene, where);
        if (cell == accel::no_cell_at_point) {
            const auto* low = reinterpret_cast<const float*>(&scene.locator_nodes[0].low);
            const auto* high = reinterpret_cast<const float*>(&scene.locator_nodes[0].high);
            const bool is_on_site =
                where[0] >= low[0] && where[0] <= high[0] && where[1] >= low[1] && where[1] <= high[1];
            return is_on_site ? tools.look.cut : tools.look.paper;
        }
        near_cell = cell;
    }
    if constexpr (Tools::Rooms::are_furnished) {
        Vec3f colour;
        if (see_cut_object(tools, point, direction, near_cell, colour)) return colour;
    }
    return radiance(tools, point, direction, near_cell, static_cast<float>(t) * spread, spread, sampler);
}

/// Linear light of the pixel x, y, counted from the upper left. near_cell: of a dollhouse, the cell that holds the
/// places of pixels nearby, or no_cell
template <class T, class Tools>
ENFILADE_HD_FREE Vec3f look_pixel(const Tools& tools, int x, int y, std::uint32_t& near_cell) {
    const LookPicture& picture = tools.picture;
    const CameraFrame& camera = *picture.camera;
    const int side = picture.samples_a_side;
    const float step = 1.0f / static_cast<float>(side);
    // A pixel's side on the plane at which directions end, of the pixel's samples one each.
    const float spread = step * length(camera.du);
    Sampler sampler(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    Vec3f sum = {0, 0, 0};
    for (int k = 0; k < side * side; ++k) {
        const Vec3f direction = camera.direction(static_cast<float>(x) + (static_cast<float>(k % side) + 0.5f) * step,
                                                 static_cast<float>(y) + (static_cast<float>(k / side) + 0.5f) * step);
        sum = sum + (picture.is_cut ? cut_radiance<T>(tools, direction, spread, near_cell, sampler)
                                    : radiance(tools, vec_cast<T>(camera.origin), direction, picture.start_cell, 0.0f,
                                               spread, sampler));
    }
    return (step * step) * sum;
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
