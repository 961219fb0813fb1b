#include "render/cuda/streams_rays.h"

#include "render/cuda/launch.h"
#include "render/rooms.h"
#include "render/sampling.h"
#include "render/shade.h"

namespace enfilade::render::cuda {
namespace {

struct Pixel {
    std::uint32_t x, y;
};

/// Pixel k of a picture.
ENFILADE_HD Pixel pixel_of(const RayPicture& picture, std::uint32_t k) {
    const auto width = static_cast<std::uint32_t>(picture.width);
    if (picture.width % 8 != 0 || picture.height % 4 != 0) return {k % width, k / width};
    const std::uint32_t tile = k / 32, tiles_a_row = width / 8;
    return {tile % tiles_a_row * 8 + k % 8, tile / tiles_a_row * 4 + k % 32 / 8};
}

ENFILADE_HD Vec3f direction_of(const RayPicture& picture, Pixel pixel) {
    return picture.frame.direction(static_cast<float>(pixel.x) + 0.5f, static_cast<float>(pixel.y) + 0.5f);
}

std::uint64_t pixels_of(const RayPicture& picture) {
    return static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height);
}

/// Where kernels write rays.
struct RayWriter {
    float* origin[3];
    float* direction[3];
    accel::CellId* cell;

    explicit RayWriter(const RayBuffers& rays) : cell(rays.cell()) {
        for (int k = 0; k < 3; ++k) {
            origin[k] = rays.origin(k);
            direction[k] = rays.direction(k);
        }
    }
    ENFILADE_HD void write(std::uint64_t i, Vec3f from, Vec3f along, accel::CellId start) const {
        origin[0][i] = from.x;
        origin[1][i] = from.y;
        origin[2][i] = from.z;
        direction[0][i] = along.x;
        direction[1][i] = along.y;
        direction[2][i] = along.z;
        cell[i] = start;
    }
};

struct PrimaryKernel {
    RayPicture picture;
    RayWriter to;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const Pixel pixel = pixel_of(picture, static_cast<std::uint32_t>(i));
        to.write(i, picture.frame.origin, direction_of(picture, pixel), picture.start);
    }
};

/// What a pixel sees.
struct SeenPlace {
    Vec3f place, normal;
    accel::CellId cell;
};

ENFILADE_HD SeenPlace seen_place(const accel::SceneView& scene, const RayPicture& picture, Pixel pixel) {
    const Ray<float> ray = make_ray_unchecked(picture.frame.origin, direction_of(picture, pixel));
    NoThroughput none;
    NoEvents events;
    const WalkEnd<float> end = walk(scene, ray, static_cast<std::uint32_t>(picture.start), NoLimit{}, none, events);
    Vec3f place = ray.origin + parameter(scene, ray, end) * ray.direction;
    const accel::Cell& cell = scene.cells[end.cell];
    if (place.z < cell.z_floor || end.exit == Exit::Floor) place.z = cell.z_floor;
    if (place.z > cell.z_ceiling || end.exit == Exit::Ceiling) place.z = cell.z_ceiling;
    return {place, normal_of(scene, end), static_cast<accel::CellId>(end.cell)};
}

struct BounceKernel {
    accel::SceneView scene;
    RayPicture picture;
    std::uint32_t pixels;
    RayWriter to;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const auto sample = static_cast<std::uint32_t>(i / pixels);
        const Pixel pixel = pixel_of(picture, static_cast<std::uint32_t>(i % pixels));
        const SeenPlace seen = seen_place(scene, picture, pixel);
        Sampler sampler(pixel.x ^ sample * 0x9e3779b1u, pixel.y);
        to.write(i, seen.place, sampler.next_cosine_direction(seen.normal), seen.cell);
    }
};

struct LampKernel {
    accel::SceneView scene;
    RayPicture picture;
    std::uint32_t pixels;
    float* from[3];
    float* to[3];
    accel::CellId* from_cell;
    accel::CellId* to_cell;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const auto sample = static_cast<std::uint32_t>(i / pixels);
        const Pixel pixel = pixel_of(picture, static_cast<std::uint32_t>(i % pixels));
        const SeenPlace seen = seen_place(scene, picture, pixel);
        std::uint32_t hash = (pixel.x * 0x8da6b343u ^ pixel.y * 0xd8163841u) + sample * 0x9e3779b1u;
        hash = (hash ^ hash >> 16) * 0x7feb352du;
        hash ^= hash >> 15;
        const accel::Light& light = scene.lights[hash % static_cast<std::uint32_t>(scene.lights.count)];
        const float* at = reinterpret_cast<const float*>(&light.position);
        const Vec3f p = seen.place;
        const float place[3] = {p.x, p.y, p.z};
        for (int k = 0; k < 3; ++k) {
            from[k][i] = place[k];
            to[k][i] = at[k];
        }
        from_cell[i] = seen.cell;
        to_cell[i] = light.cell;
    }
};

struct ShuffleKernel {
    DeviceRays rays;
    RayWriter to;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const std::uint32_t k = shuffled_place(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(rays.count));
        to.write(i, {rays.origin[0][k], rays.origin[1][k], rays.origin[2][k]},
                 {rays.direction[0][k], rays.direction[1][k], rays.direction[2][k]}, rays.cell[k]);
    }
};

}  // namespace

RayBuffers::RayBuffers(Device& device, std::uint64_t count) : cell_(device, count) {
    for (int k = 0; k < 3; ++k) {
        origin_[k] = Buffer<float>(device, count);
        direction_[k] = Buffer<float>(device, count);
    }
}

DeviceRays RayBuffers::view() const {
    return {{origin(0), origin(1), origin(2)}, {direction(0), direction(1), direction(2)}, cell(), nullptr, size()};
}

SegmentBuffers::SegmentBuffers(Device& device, std::uint64_t count)
    : from_cell_(device, count), to_cell_(device, count) {
    for (int k = 0; k < 3; ++k) {
        from_[k] = Buffer<float>(device, count);
        to_[k] = Buffer<float>(device, count);
    }
}

DeviceSegments SegmentBuffers::view() const {
    return {{from(0), from(1), from(2)}, {to(0), to(1), to(2)}, from_cell(), to_cell(), size()};
}

RayBuffers primary_rays(Device& device, const RayPicture& picture) {
    RayBuffers rays(device, pixels_of(picture));
    for_each(device, rays.size(), PrimaryKernel{picture, RayWriter(rays)});
    return rays;
}

RayBuffers bounce_rays(Device& device, const accel::SceneView& scene, const RayPicture& picture,
                       std::uint32_t rays_a_pixel) {
    const std::uint64_t pixels = pixels_of(picture);
    RayBuffers rays(device, pixels * rays_a_pixel);
    for_each(device, rays.size(), BounceKernel{scene, picture, static_cast<std::uint32_t>(pixels), RayWriter(rays)});
    return rays;
}

SegmentBuffers lamp_segments(Device& device, const accel::SceneView& scene, const RayPicture& picture,
                             std::uint32_t segments_a_pixel) {
    const std::uint64_t pixels = pixels_of(picture);
    SegmentBuffers s(device, pixels * segments_a_pixel);
    for_each(device, s.size(),
             LampKernel{scene,
                        picture,
                        static_cast<std::uint32_t>(pixels),
                        {s.from(0), s.from(1), s.from(2)},
                        {s.to(0), s.to(1), s.to(2)},
                        s.from_cell(),
                        s.to_cell()});
    return s;
}

RayBuffers shuffled(Device& device, const RayBuffers& rays) {
    RayBuffers mixed(device, rays.size());
    for_each(device, rays.size(), ShuffleKernel{rays.view(), RayWriter(mixed)});
    return mixed;
}

}  // namespace enfilade::render::cuda
