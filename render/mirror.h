#pragma once
// Floors that mirror: the one reflection that keeps a ray's line on the plan, on host and device.

#include "accel/scene.h"
#include "render/isa.h"
#include "render/ray.h"
#include "render/walk.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// Whether a face that is met by this exit is a mirror: a floor of rooms, from above. The ground outdoors is none.
ENFILADE_HD bool is_mirror(const accel::SourceFace& face, Exit exit) {
    return exit == Exit::Floor && face.surface == accel::Surface::Floor;
}

/// Whether a walk ended at a mirror.
template <class T>
ENFILADE_HD bool is_mirror_hit(const accel::SceneView& scene, const WalkEnd<T>& end) {
    return end.status == WalkStatus::Hit && is_mirror(scene.source_faces[end.target.bits], end.exit);
}

/// The ray that the level mirror at height `z` makes of `ray`, to be walked on from the cell whose floor the mirror is.
///
/// It does not start at the mirror but at the mirror image of the origin below it, so that its parameter counts the
/// whole way from the eye and nothing of its line on the plan changes: origin and direction in x and y, moment and ties
/// are the same bits. Hence it needs no epsilon and no point of reflection; every line has the side that it had for
/// `ray`, it leaves the mirror's cell by the section by which `ray` leaves that cell's prism, and rays that share an
/// origin still do when they are mirrored: packets stay packets. One rounding: of the image's height.
///
/// It rises, and floors are left downwards only, so it never meets a second mirror.
template <class T>
ENFILADE_HD Ray<T> mirrored(const Ray<T>& ray, T z) {
    Ray<T> image = ray;
    image.origin.z = T(2) * z - ray.origin.z;
    image.direction.z = -ray.direction.z;
    return image;
}

/// What a mirror shows that reflects `share` of its light: its own colour, and what its ray sees.
ENFILADE_HD Vec3f in_mirror(float share, Vec3f own, Vec3f seen) { return (1 - share) * own + share * seen; }

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
