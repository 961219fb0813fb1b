#include "render/embree_jobs.h"

#include <algorithm>

#include "render/embree_device.h"

namespace enfilade::render::detail {
namespace {

constexpr int tile_side = 64;
constexpr std::size_t chunk_rays = 1 << 13;

}  // namespace

void embree_picture(const EmbreeScene& embree, const CameraFrame& frame, int lanes, const accel::Executor& executor,
                    Framebuffer& image) {
    const Look look;
    const int columns = (image.width + tile_side - 1) / tile_side;
    const int rows = (image.height + tile_side - 1) / tile_side;
    executor.run(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), [&](std::size_t tile) {
        const ZeroDenormals zero_denormals;
        const int x = static_cast<int>(tile) % columns * tile_side, y = static_cast<int>(tile) / columns * tile_side;
        const EmbreeTile job = {embree,
                                &frame,
                                &look,
                                image.rgba.data(),
                                image.width,
                                x,
                                y,
                                std::min(x + tile_side, image.width),
                                std::min(y + tile_side, image.height)};
        embree_tile(job, lanes);
    });
}

void embree_nearest(const EmbreeScene& embree, const RayColumns& rays, const HitColumns& hits, int lanes,
                    const accel::Executor& executor, float skin) {
    const auto column_of = [](auto span) { return span.empty() ? nullptr : span.data(); };
    accel::parallel_for(executor, rays.origin_x.size(), chunk_rays, [&](std::size_t begin, std::size_t end) {
        const ZeroDenormals zero_denormals;
        const EmbreeRays job = {embree,
                                {rays.origin_x.data(), rays.origin_y.data(), rays.origin_z.data()},
                                {rays.direction_x.data(), rays.direction_y.data(), rays.direction_z.data()},
                                column_of(rays.max_distance),
                                skin,
                                column_of(hits.distance),
                                column_of(hits.source_face),
                                column_of(hits.status),
                                column_of(hits.object),
                                column_of(hits.triangle),
                                begin,
                                end};
        embree_rays(job, lanes);
    });
}

void embree_visible(const EmbreeScene& embree, const SegmentColumns& segments, std::span<std::uint8_t> visible,
                    int lanes, const accel::Executor& executor, float skin) {
    accel::parallel_for(executor, segments.from_x.size(), chunk_rays, [&](std::size_t begin, std::size_t end) {
        const ZeroDenormals zero_denormals;
        const EmbreeSegments job = {embree,
                                    {segments.from_x.data(), segments.from_y.data(), segments.from_z.data()},
                                    {segments.to_x.data(), segments.to_y.data(), segments.to_z.data()},
                                    skin,
                                    visible.data(),
                                    begin,
                                    end};
        embree_segments(job, lanes);
    });
}

}  // namespace enfilade::render::detail
