#pragma once
// Many rays at once, as columns: what simulations of sound, radio and heat ask for, and how secondary rays are traced.

#include <cstdint>
#include <span>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/object_tracer.h"
#include "render/tracer.h"
#include "render/walk_events.h"

namespace enfilade::render {

/// Rays as columns of n numbers each: metres, scene frame. Directions of any finite length but zero.
struct RayColumns {
    std::span<const float> origin_x, origin_y, origin_z;
    std::span<const float> direction_x, direction_y, direction_z;
    std::span<const accel::CellId> cell;  ///< that holds the origin
    std::span<const float> max_distance;  ///< metres; empty: none
};

/// Where they end; a column left empty is not written.
struct HitColumns {
    std::span<float> distance;                   ///< metres; the limit where it was reached, NaN for refused rays
    std::span<accel::SourceFaceId> source_face;  ///< none<SourceFaceId> where no face was hit
    std::span<accel::CellId> cell;               ///< the last one
    std::span<WalkStatus> status;
    std::span<accel::ObjectId> object;  ///< none<ObjectId> where no object was hit
    std::span<std::uint32_t> triangle;  ///< of the object's mesh; no_triangle where no object was hit
};

/// Segments from p to q as columns: metres, scene frame.
struct SegmentColumns {
    std::span<const float> from_x, from_y, from_z;
    std::span<const float> to_x, to_y, to_z;
    std::span<const accel::CellId> from_cell;  ///< that holds p
    std::span<const accel::CellId> to_cell;    ///< that holds q; empty: not known, which costs time
};

enum class StreamOrder {
    Coherent,  ///< neighbours in the stream are neighbours in space
    Any        ///< neighbours are strangers: more rays a task, so that those of one cell meet
};

struct StreamOptions {
    Tracer tracer = Tracer::Packet;  ///< Packet: whichever is fastest
    StreamOrder order = StreamOrder::Coherent;
    const accel::Executor* executor = nullptr;  ///< nullptr: the calling thread. Results do not depend on it.
    const ObjectTracer* objects = nullptr;      ///< nullptr: rooms are walked without what stands in them
    RayStats* stats = nullptr;
};

/// The first face that each ray meets; glass lets it pass. Rays that are none (NaN, no direction) are answered with
/// status Refused. \pre columns are of one length; cells are the scene's
void nearest(const accel::SceneView& scene, const RayColumns& rays, const HitColumns& hits,
             const StreamOptions& options = {});

/// 1 where nothing but glass lies between p and q, else 0: shadow rays. Equal points see each other. visible: [n]
void visible(const accel::SceneView& scene, const SegmentColumns& segments, std::span<std::uint8_t> visible,
             const StreamOptions& options = {});

}  // namespace enfilade::render
