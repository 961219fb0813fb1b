#pragma once
// Inside of the reference: pictures and streams as jobs for its loops, on the cores of an executor.

#include "accel/parallel_for.h"
#include "render/camera.h"
#include "render/embree_lamps.h"
#include "render/embree_loops.h"
#include "render/framebuffer.h"
#include "render/ray_stream.h"

namespace enfilade::render::detail {

/// Lambert's picture, tile by tile. \pre image has the camera's size, a multiple of 4 both ways
void embree_picture(const EmbreeScene& embree, const CameraFrame& frame, int lanes, const accel::Executor& executor,
                    Framebuffer& image);

/// The picture lit by lamps. \pre as above; lamps fit the picture
void embree_lit_picture(const EmbreeScene& embree, const CameraFrame& frame, const EmbreeLamps& lamps,
                        const EmbreeLitWay& way, const accel::Executor& executor, Framebuffer& image);

/// What each pixel's ray hits first. \pre sizes are multiples of 4
[[nodiscard]] SeenPlaces embree_places(const EmbreeScene& embree, const CameraFrame& frame, int width, int height,
                                       const accel::Executor& executor);

/// Columns that are empty are not written; cells never are.
void embree_nearest(const EmbreeScene& embree, const RayColumns& rays, const HitColumns& hits, int lanes,
                    const accel::Executor& executor, float skin);

void embree_visible(const EmbreeScene& embree, const SegmentColumns& segments, std::span<std::uint8_t> visible,
                    int lanes, const accel::Executor& executor, float skin);

}  // namespace enfilade::render::detail
