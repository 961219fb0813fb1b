#pragma once
// Inside of the reference: its loops, compiled by Highway for every instruction set and chosen where they run.

#include <embree3/rtcore.h>

#include <cstdint>

#include "render/camera.h"
#include "render/face_mesh.h"
#include "render/look.h"
#include "render/walk_events.h"

namespace enfilade::render::detail {

/// An object as its hits are shaded: 64 bytes, so that lanes gather from it.
struct EmbreePlace {
    float normal[9];           ///< rows: the mesh's normals to the scene's (of any length)
    std::uint32_t first_look;  ///< into the looks: of its first triangle, or of the whole object
    std::uint32_t look_mask;   ///< all ones, or 0 where the whole object has one look
    std::uint32_t reserved[5];
};
static_assert(sizeof(EmbreePlace) == 64);

/// What all jobs ask of Embree.
struct EmbreeScene {
    RTCScene scene;
    const PrimitiveLook* looks;
    const EmbreePlace* places;  ///< [place_count + 1]: of objects, the last one of faces; nullptr: there are faces only
    std::uint32_t place_count;
    bool flat;  ///< objects are geometries of the scene, else instances
    bool coherent;
};

/// A rectangle of a framebuffer; its size is a multiple of 4 both ways.
struct EmbreeTile {
    EmbreeScene embree;
    const CameraFrame* camera;
    const Look* look;
    std::uint32_t* rgba;  ///< of the whole image
    int width;            ///< of the whole image
    int x0, y0, x1, y1;
};

/// Rays [begin, end) of columns; those that are not wanted are nullptr.
struct EmbreeRays {
    EmbreeScene embree;
    const float* origin[3];
    const float* direction[3];
    const float* max_distance;
    float skin;  ///< metres
    float* distance;
    accel::SourceFaceId* source_face;
    WalkStatus* status;
    accel::ObjectId* object;  ///< not written where there are faces only
    std::uint32_t* triangle;
    std::uint64_t begin, end;
};

struct EmbreeSegments {
    EmbreeScene embree;
    const float* from[3];
    const float* to[3];
    float skin;  ///< metres
    std::uint8_t* visible;
    std::uint64_t begin, end;
};

/// `lanes` rays a call: 1, 8 or 16.
void embree_tile(const EmbreeTile& job, int lanes);
void embree_rays(const EmbreeRays& job, int lanes);
void embree_segments(const EmbreeSegments& job, int lanes);

}  // namespace enfilade::render::detail
