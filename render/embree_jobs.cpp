#include "render/embree_jobs.h"

#include <algorithm>

#include "render/embree_device.h"
#include "render/embree_lit_loops.h"

namespace enfilade::render::detail {
namespace {

constexpr int tile_side = 64;
constexpr std::size_t chunk_rays = 1 << 13;

/// Calls `draw` with a job for every tile of an image.
template <class Draw>
void for_tiles(const EmbreeScene& embree, const CameraFrame& frame, std::uint32_t* rgba, int width, int height,
               const accel::Executor& executor, const Draw& draw) {
    const Look look;
    const int columns = (width + tile_side - 1) / tile_side;
    const int rows = (height + tile_side - 1) / tile_side;
    executor.run(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), [&](std::size_t tile) {
        const ZeroDenormals zero_denormals;
        const int x = static_cast<int>(tile) % columns * tile_side, y = static_cast<int>(tile) / columns * tile_side;
        const EmbreeTile job = {
            embree, &frame, &look, rgba, width, x, y, std::min(x + tile_side, width), std::min(y + tile_side, height)};
        draw(job);
    });
}

}  // namespace

void embree_picture(const EmbreeScene& embree, const CameraFrame& frame, int lanes, const accel::Executor& executor,
                    Framebuffer& image) {
    for_tiles(embree, frame, image.rgba.data(), image.width, image.height, executor,
              [&](const EmbreeTile& job) { embree_tile(job, lanes); });
}

void embree_lit_picture(const EmbreeScene& embree, const CameraFrame& frame, const EmbreeLamps& lamps,
                        const EmbreeLitWay& way, const accel::Executor& executor, Framebuffer& image) {
    EmbreeLitTile lit = {};
    lit.lights = lamps.lights.data();
    lit.offsets = lamps.lists->offsets.data();
    lit.lamps = lamps.lists->lamps.data();
    lit.exposure = lamps.exposure;
    lit.cells = lamps.cells;
    for (std::size_t k = 0; lamps.seen != nullptr && k < 3; ++k) {
        lit.point[k] = lamps.seen->point[k].data();
        lit.normal[k] = lamps.seen->normal[k].data();
        lit.colour[k] = lamps.seen->colour[k].data();
    }
    lit.is_lit = lamps.seen != nullptr ? lamps.seen->is_lit.data() : nullptr;
    lit.coherent_shadows = way.coherent_shadows;
    lit.from_lamps = way.from_lamps;
    for_tiles(embree, frame, image.rgba.data(), image.width, image.height, executor, [&](const EmbreeTile& tile) {
        EmbreeLitTile job = lit;
        job.tile = tile;
        embree_lit_tile(job, way.primary.lanes);
    });
}

SeenPlaces embree_places(const EmbreeScene& embree, const CameraFrame& frame, int width, int height,
                         const accel::Executor& executor) {
    SeenPlaces seen;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    EmbreePlacesTile places = {};
    for (std::size_t k = 0; k < 3; ++k) {
        for (auto* columns : {&seen.point, &seen.normal, &seen.colour}) (*columns)[k].resize(pixels);
        places.point[k] = seen.point[k].data();
        places.normal[k] = seen.normal[k].data();
        places.colour[k] = seen.colour[k].data();
    }
    seen.is_lit.resize(pixels);
    places.is_lit = seen.is_lit.data();
    for_tiles(embree, frame, nullptr, width, height, executor, [&](const EmbreeTile& tile) {
        EmbreePlacesTile job = places;
        job.tile = tile;
        embree_places_tile(job);
    });
    seen.lit_count = pixels - static_cast<std::size_t>(std::ranges::count(seen.is_lit, std::uint8_t{0}));
    return seen;
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
