#pragma once
// Pixels whose tile does not know where they end, each walked by itself from where the tile's rays parted.

#include "render/cuda/packets_objects.h"

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

/// A pixel's way through cells, from where its tile's rays parted.
template <class Rooms, class Events>
class PixelWay {
public:
    ENFILADE_HD PixelWay(const PacketView& view, const Rooms& rooms, const Bundle& at, int x, int y, Events& events)
        : view_(view), rooms_(rooms), events_(events), at_(at), ray_(ray_of(view, at, x, y)) {
        if (!at.is_mirrored()) return;
        floor_ = floor_cosine(ray_) * at.floor;
        // The same as seen from the eye: origin and direction have both been turned over.
        first_ = (view.scene.cells[at.floor_cell].z_floor - ray_.origin.z) / ray_.direction.z;
        near_ = first_;
    }

    /// To the end, as linear light. False in the rare cases that the lean walk leaves to others.
    ENFILADE_HD bool follow(Vec3f& light) {
        for (std::uint64_t steps = view_.scene.cells.count + 16; steps > 0; --steps) {
            events_.entered_cell(view_.scene.cells[at_.cell].section_count);
            Sight<float> sight = {};
            WalkEnd<float>& end = sight.end;
            if (!leave_plainly(view_.scene, ray_, at_.cell, NoLimit{}, end)) return false;
            if (meets_objects_here(sight)) {
                end.status = WalkStatus::Object;
            } else if (end.target.is_portal()) {
                if (end.target.is_glass()) pass_glass(view_, end, at_, events_);
                at_.cell = static_cast<std::uint32_t>(end.target.neighbour());
                continue;
            } else if (ends_behind(ray_, end)) {
                return false;
            } else if (meets_mirror(view_, end, at_.is_mirrored())) {
                turn_at(end);
                continue;
            }
            light = floor_ + at_.tint * lambert_colour<Rooms>(view_.scene, view_.look, ray_, sight);
            return true;
        }
        return false;
    }

private:
    /// Between where the ray came into the cell and where it leaves it.
    ENFILADE_HD bool meets_objects_here(Sight<float>& sight) {
        if constexpr (Rooms::are_furnished) {
            const std::uint32_t in_view = at_.objects;
            at_.objects = all_in_view;  // of the next cell
            const bool is_asked = in_view != 0 && object_count(view_.scene, at_.cell) != 0;
            const float leaves_at = parameter(view_.scene, ray_, sight.end);
            const float near = near_;
            near_ = stretch_start(leaves_at, first_);
            return is_asked && meets_in_view(view_.scene, rooms_.objects, ray_, at_.cell, in_view, near,
                                             stretch_end(leaves_at, 3e38f), sight.hit);
        }
        return false;
    }

    ENFILADE_HD void turn_at(const WalkEnd<float>& end) {
        first_ = near_ = parameter(view_.scene, ray_, end);
        reflect(view_, end, at_);
        floor_ = floor_cosine(ray_) * at_.floor;
        ray_ = mirrored(ray_, view_.scene.cells[at_.cell].z_floor);
    }

    const PacketView& view_;
    const Rooms& rooms_;
    Events& events_;
    Bundle at_;
    Ray<float> ray_;
    Vec3f floor_ = {0, 0, 0};
    float first_ = 0, near_ = 0;  ///< parameters: objects count from there; in this cell from there
};

}  // namespace enfilade::render::cuda
