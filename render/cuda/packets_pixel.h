#pragma once
// Pixels whose tile does not know where they end, each walked by itself from where the tile's rays parted.

#include "render/cuda/packets_view.h"

namespace enfilade::render::cuda {

/// As the scalar tracer has it, from the eye on.
template <class Rooms>
ENFILADE_HD_COLD Vec3f pixel_from_start(const PacketView& view, const Rooms& rooms, int x, int y) {
    const LambertPicture picture = {&view.scene, &view.camera, &view.look, view.start_cell, view.mirror_floor};
    NoEvents none;
    return lambert_pixel<float>(picture, rooms, x, y, none);
}

/// What a lamp at the eye shows of a floor, at whatever direction.
ENFILADE_HD float floor_cosine(const Ray<float>& ray) {
    return magnitude(ray.direction.z) / root(dot(ray.direction, ray.direction));
}

/// Linear light of a pixel of a bundle.
template <class Rooms, class Events>
ENFILADE_HD Vec3f pixel_from(const PacketView& view, const Rooms& rooms, Bundle at, int x, int y, Events& events) {
    Ray<float> ray = ray_of(view, at, x, y);
    Vec3f floor = at.is_mirrored() ? floor_cosine(ray) * at.floor : Vec3f{0, 0, 0};
    for (std::uint64_t steps = view.scene.cells.count + 16; steps > 0; --steps) {
        events.entered_cell(view.scene.cells[at.cell].section_count);
        Sight<float> sight = {};
        leave_cell(view.scene, ray, at.cell, at.entry, at.entry_next, true, NoLimit{}, events, sight.end);
        if (sight.end.target.is_portal()) {
            go_on(view, sight.end, at, events);
        } else if (ends_behind(ray, sight.end)) {
            break;
        } else if (meets_mirror(view, sight.end, at)) {
            reflect(view, sight.end, at);
            floor = floor_cosine(ray) * at.floor;
            ray = mirrored(ray, view.scene.cells[at.cell].z_floor);
        } else {
            return floor + at.tint * lambert_colour<Rooms>(view.scene, view.look, ray, sight);
        }
    }
    events.walked_from_start();
    return pixel_from_start(view, rooms, x, y);
}

}  // namespace enfilade::render::cuda
