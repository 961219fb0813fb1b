#pragma once
// Pixels whose tile does not know where they end, each walked by itself from where the tile's rays parted.

#include "render/cuda/packets_view.h"

namespace enfilade::render::cuda {

/// What a lamp at the eye shows of a floor, at whatever direction.
ENFILADE_HD float floor_cosine(const Ray<float>& ray) {
    return magnitude(ray.direction.z) / root(dot(ray.direction, ray.direction));
}

/// As the scalar tracer has it, from the eye on.
template <class Rooms>
ENFILADE_HD_COLD Vec3f pixel_from_eye(const PacketView& view, const Rooms& rooms, int x, int y) {
    const LambertPicture picture = {&view.scene, &view.camera, &view.look, view.start_cell, view.mirror_floor};
    NoEvents none;
    return lambert_pixel<float>(picture, rooms, x, y, none);
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
        if (!leave_plainly(view.scene, ray, at.cell, NoLimit{}, sight.end)) return false;
        if (sight.end.target.is_portal()) {
            if (sight.end.target.is_glass()) pass_glass(view, sight.end, at, events);
            at.cell = static_cast<std::uint32_t>(sight.end.target.neighbour());
        } else if (ends_behind(ray, sight.end)) {
            return false;
        } else if (meets_mirror(view, sight.end, at.is_mirrored())) {
            reflect(view, sight.end, at);
            floor = floor_cosine(ray) * at.floor;
            ray = mirrored(ray, view.scene.cells[at.cell].z_floor);
        } else {
            light = floor + at.tint * lambert_colour<Rooms>(view.scene, view.look, ray, sight);
            return true;
        }
    }
    return false;
}

}  // namespace enfilade::render::cuda
