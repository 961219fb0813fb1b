#pragma once
// Pixels whose tile does not know where they end, each walked by itself from where the tile's rays parted.

#include "render/cuda/packets_view.h"

namespace enfilade::render::cuda {

/// What a lamp at the eye shows of a floor, at whatever direction.
ENFILADE_HD float floor_cosine(const Ray<float>& ray) {
    return magnitude(ray.direction.z) / root(dot(ray.direction, ray.direction));
}

/// Linear light of a pixel whose ray floats led astray: walked from the eye, in double.
template <class Rooms>
ENFILADE_HD_COLD Vec3f pixel_in_double(const PacketView& view, int x, int y) {
    Bundle at = bundle_at_eye(view, x, y);
    Ray<float> ray = ray_of(view, at, x, y);
    NoEvents none;
    const WalkEnd<float> seen = walk_in_double(view.scene, ray, at.cell, NoLimit{}, at.tint, none);
    if (!meets_mirror(view, seen, false))
        return at.tint * lambert_colour<Rooms>(view.scene, view.look, ray, Sight<float>{seen, {}});
    reflect(view, seen, at);
    const Vec3f floor = floor_cosine(ray) * at.floor;
    ray = mirrored(ray, view.scene.cells[seen.cell].z_floor);
    const WalkEnd<float> in_mirror = walk_in_double(view.scene, ray, seen.cell, NoLimit{}, at.tint, none);
    return floor + at.tint * lambert_colour<Rooms>(view.scene, view.look, ray, Sight<float>{in_mirror, {}});
}

/// Linear light of a pixel of a bundle. False where rounding leads its ray astray: then it is to be walked from the
/// eye.
template <class Rooms, class Events>
ENFILADE_HD bool pixel_from(const PacketView& view, Bundle at, int x, int y, Events& events, Vec3f& light) {
    Ray<float> ray = ray_of(view, at, x, y);
    Vec3f floor = at.is_mirrored() ? floor_cosine(ray) * at.floor : Vec3f{0, 0, 0};
    for (std::uint64_t steps = view.scene.cells.count + 16; steps > 0; --steps) {
        events.entered_cell(view.scene.cells[at.cell].section_count);
        Sight<float> sight = {};
        leave_cell(view.scene, ray, at.cell, at.entry, at.entry_next, true, NoLimit{}, events, sight.end);
        if (sight.end.target.is_portal()) {
            if (sight.end.target.is_glass()) pass_glass(view, sight.end, at, events);
            at.entry = sight.end.exit == Exit::Side ? sight.end.section : no_section;
            at.entry_next = sight.end.next_section;
            at.cell = static_cast<std::uint32_t>(sight.end.target.neighbour());
        } else if (ends_behind(ray, sight.end)) {
            return false;
        } else if (meets_mirror(view, sight.end, at.is_mirrored())) {
            reflect(view, sight.end, at);
            floor = floor_cosine(ray) * at.floor;
            ray = mirrored(ray, view.scene.cells[at.cell].z_floor);
            at.entry = at.entry_next = no_section;
        } else {
            light = floor + at.tint * lambert_colour<Rooms>(view.scene, view.look, ray, sight);
            return true;
        }
    }
    return false;
}

}  // namespace enfilade::render::cuda
