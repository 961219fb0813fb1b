#pragma once
// The functions of a pixel that pictures by devices are made of: those of the scalar tracer. Included by .cu files
// alone.

#include "render/cuda/apart_rooms.h"
#include "render/cuda/deferring.h"
#include "render/cuda/picture_job.h"
#include "render/lambert.h"
#include "render/lit_pixel.h"
#include "render/look_pixel.h"
#include "render/octree_trees.h"

namespace enfilade::render::cuda {

/// The rooms that walks meet at first, without their rare cases.
template <class Rooms>
ENFILADE_HD auto quick(const Rooms& rooms) {
    if constexpr (Rooms::are_furnished) return rooms;
    else return QuickRooms{};
}

/// Pixels whose walks leave rare cases to a second kernel, in float. Pixel: plain data with
/// `light<T>(rooms, x, y, events)`.
template <class T, class Rooms, class Pixel>
struct WalkedPixels {
    Pixel pixel;
    Rooms rooms;

    static constexpr bool defers = sizeof(T) == sizeof(float);
    ENFILADE_HD bool at(int x, int y, Vec3f& light) const {
        if constexpr (defers) {
            Deferring walked;
            light = pixel.template light<T>(quick(rooms), x, y, walked);
            return !walked.is_rare;
        } else {
            light = at_length(x, y);
            return true;
        }
    }
    ENFILADE_HD Vec3f at_length(int x, int y) const {
        NoEvents none;
        return pixel.template light<T>(rooms, x, y, none);
    }
};

/// A lamp at the eye.
struct LambertPixel {
    accel::SceneView scene;
    CameraFrame camera;
    Look look;
    std::uint32_t start_cell;
    float mirror_floor;

    template <class T, class Rooms, class Events>
    ENFILADE_HD Vec3f light(const Rooms& rooms, int x, int y, Events& events) const {
        return lambert_pixel<T>({&scene, &camera, &look, start_cell, mirror_floor}, rooms, x, y, events);
    }
};
template <class T, class Rooms>
WalkedPixels<T, Rooms, LambertPixel> lambert_pixels(const PictureJob& job, const Rooms& rooms) {
    return {{job.scene, job.camera, job.look, job.start_cell, job.mirror_floor}, rooms};
}

/// The scene's lamps, and colours.
struct LitPixel {
    accel::SceneView scene;
    CameraFrame camera;
    Look look;
    Lamps lamps;
    std::uint32_t start_cell;
    float mirror_floor;

    template <class T, class Rooms, class Events>
    ENFILADE_HD Vec3f light(const Rooms& rooms, int x, int y, Events& events) const {
        return lit_pixel<T>({&scene, &camera, &look, &lamps, start_cell, mirror_floor}, rooms, x, y, events);
    }
};
template <class T, class Rooms>
WalkedPixels<T, Rooms, LitPixel> lit_pixels(const PictureJob& job, const Rooms& rooms) {
    return {{job.scene, job.camera, job.look, job.lamps, job.start_cell, job.mirror_floor}, rooms};
}

/// Anything.
template <class T, class Rooms>
struct LookPixels {
    accel::SceneView scene;
    CameraFrame camera;
    Look look;
    Lamps lamps;
    Rooms rooms;
    bool has_lamps;
    std::uint32_t start_cell;
    int samples_a_side;
    bool is_cut;
    float cut_z;
    float mirror_floor;

    static constexpr bool defers = false;
    ENFILADE_HD bool at(int x, int y, Vec3f& light) const {
        const LookPicture picture = {&scene,      &camera,        &look,  has_lamps ? &lamps : nullptr,
                                     start_cell,  samples_a_side, is_cut, cut_z,
                                     mirror_floor};
        NoEvents none;
        const LookTools<Rooms, NoEvents> tools = {picture, scene, look, rooms, none};
        std::uint32_t near_cell = no_cell;
        light = look_pixel<T>(tools, x, y, near_cell);
        return true;
    }
};
template <class T, class Rooms>
LookPixels<T, Rooms> look_pixels(const PictureJob& job, const Rooms& rooms) {
    return {job.scene,      job.camera,         job.look,   job.lamps, rooms,           job.has_lamps,
            job.start_cell, job.samples_a_side, job.is_cut, job.cut_z, job.mirror_floor};
}

/// Trees of either kind, asked for when a ray comes there: for kernels of which one for each kind would not pay.
struct AnyTrees {
    OctreeTrees octrees;  ///< of_mesh is nullptr: the others are asked
    MeshTrees bvhs;
};
ENFILADE_HD void ask_nearest(const AnyTrees& trees, accel::MeshId mesh, ObjectRay& ray) {
    if (trees.octrees.of_mesh != nullptr) ask_nearest(trees.octrees, mesh, ray);
    else ask_nearest(trees.bvhs, mesh, ray);
}
ENFILADE_HD bool ask_blocked(const AnyTrees& trees, accel::MeshId mesh, const ObjectRay& ray) {
    if (trees.octrees.of_mesh != nullptr) return ask_blocked(trees.octrees, mesh, ray);
    return ask_blocked(trees.bvhs, mesh, ray);
}

/// body(rooms) with the rooms of the job: bare ones, or with trees of whichever kind, called.
template <class Body>
void among_any(const PictureJob& job, const Body& body) {
    if (job.objects == nullptr) return body(BareRooms{});
    const bool is_octree = job.objects->kind() == InsideKind::Octree;
    body(RoomsWith<CalledTrees<AnyTrees>>{{{is_octree ? job.objects->octrees() : OctreeTrees{nullptr},
                                            is_octree ? MeshTrees{nullptr} : job.objects->bvhs()}}});
}

/// The same for furnished rooms, with a type for each kind of trees.
template <class Body>
void among_furnished(const PictureJob& job, const Body& body) {
    if (job.objects->kind() == InsideKind::Octree) return body(ApartRooms<OctreeTrees>{{job.objects->octrees()}});
    body(ApartRooms<MeshTrees>{{job.objects->bvhs()}});
}

}  // namespace enfilade::render::cuda
