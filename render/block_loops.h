// The loops over blocks of rays: what kernel_loops.h does ray by ray, for instruction sets that test all lines of a
// cell at once; the same numbers bit for bit. Included by kernel_loops.h alone, once for each set: no include guard is
// needed.

#include "render/block_walk.h"
#include "render/framebuffer.h"
#include "render/kernel.h"
#include "render/mirror.h"
#include "render/shade.h"

#if ENFILADE_WIDE_SIDES

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// Rays of one picture in one block: rows of a tile, one below the other.
struct BlockPlace {
    int x, y;   ///< of the first pixel
    int width;  ///< pixels a row
    std::uint32_t count;
};

/// Rays through the pixels' middles.
ENFILADE_HD void aim(const CameraFrame& camera, std::uint32_t start_cell, const BlockPlace& place, RayBlock& block) {
    const std::uint32_t width = static_cast<std::uint32_t>(place.width);
    for (std::uint32_t row = 0; row * width < place.count; ++row) {
        const Vec3f down = (static_cast<float>(place.y + static_cast<int>(row)) + 0.5f) * camera.dv;
        float* dx = block.dx + row * width;
        float* dy = block.dy + row * width;
        float* dz = block.dz + row * width;
        for (std::uint32_t k = 0; k < width; ++k) {
            const float x = static_cast<float>(place.x + static_cast<int>(k)) + 0.5f;
            dx[k] = camera.corner.x + x * camera.du.x + down.x;
            dy[k] = camera.corner.y + x * camera.du.y + down.y;
            dz[k] = camera.corner.z + x * camera.du.z + down.z;
        }
    }
    for (std::uint32_t r = 0; r < place.count; ++r) {
        block.ox[r] = camera.origin.x;
        block.oy[r] = camera.origin.y;
        block.oz[r] = camera.origin.z;
        block.start[r] = start_cell;
    }
    block.begin_all(place.count);
}

/// The rays that the block's walk left over.
void walk_picture_rest(const accel::SceneView& scene, RayBlock& block) {
    NoEvents none;
    for (std::uint32_t k = 0; k < block.rest_count; ++k) {
        const std::uint32_t r = block.rest[k];
        const Ray<float> ray = block.ray(r);
        Vec3f tint = {1, 1, 1};
        const WalkEnd<float> end = walk(scene, ray, block.start[r], NoLimit{}, tint, none);
        block.tint[0][r] = tint.x;
        block.tint[1][r] = tint.y;
        block.tint[2][r] = tint.z;
        block.cell[r] = end.cell;
        block.target[r] = end.status == WalkStatus::Hit ? end.target.bits : leaked_target;
        block.level[r] = end.exit != Exit::Side ? ~0u : 0u;
        block.section[r] = end.section;
        block.next_section[r] = end.next_section;
        block.facing[r] = end.facing;
    }
}

/// What the shading of a block needs beside it.
struct alignas(64) BlockColours {
    float red[block_rays], green[block_rays], blue[block_rays];
    float length2[block_rays];                    ///< of the direction
    float facing[block_rays], edge2[block_rays];  ///< the lamp's cosine is facing / root(edge2 length2)
};

/// Colours of the faces met, to be dimmed by the lamp's cosine. What shines by itself (the sky, and a leak's magenta)
/// gets a cosine of exactly 1.
void fetch_colours(const accel::SceneView& scene, const Look& look, const RayBlock& block, std::uint32_t count,
                   BlockColours& colours) {
    std::uint32_t last = accel::Target::index_mask, last_section = no_section;  // none of either
    bool shines = false;
    Vec3f colour = {0, 0, 0};
    float edge2 = 0;
    for (std::uint32_t r = 0; r < count; ++r) {
        const std::uint32_t target = block.target[r], section = block.section[r];
        if (target != last) {
            last = target;
            shines = target == leaked_target || scene.source_faces[target].surface == accel::Surface::Sky;
            if (!shines) colour = colour_of(scene, scene.source_faces[target]);
        }
        if (section != last_section) {
            last_section = section;
            if (section != no_section) {
                const std::uint32_t next = block.next_section[r];
                const float ex = scene.section_x[next] - scene.section_x[section];
                const float ey = scene.section_y[next] - scene.section_y[section];
                edge2 = ex * ex + ey * ey;
            }
        }
        colours.edge2[r] = edge2;
        if (shines) [[unlikely]] {
            colour =
                target == leaked_target ? Vec3f{1, 0, 1} : sky_colour(look, {block.dx[r], block.dy[r], block.dz[r]});
        }
        colours.red[r] = colour.x;
        colours.green[r] = colour.y;
        colours.blue[r] = colour.z;
        colours.facing[r] = shines ? -1.0f : block.facing[r];
    }
    for (std::uint32_t r = 0; r < count; ++r) {
        const bool is_shining = colours.facing[r] < 0, is_level = block.level[r] != 0;
        colours.length2[r] = block.dx[r] * block.dx[r] + block.dy[r] * block.dy[r] + block.dz[r] * block.dz[r];
        colours.edge2[r] = is_shining | is_level ? 1.0f : colours.edge2[r];
        const float facing = is_level ? magnitude(block.dz[r]) : colours.facing[r];
        colours.facing[r] = is_shining ? root(colours.length2[r]) : facing;
    }
}

/// The colours under the lamp at the eye; glass not counted yet.
void light_block(const detail::TileJob& job, const RayBlock& block, std::uint32_t count, BlockColours& colours) {
    fetch_colours(*job.scene, *job.look, block, count, colours);
    for (std::uint32_t r = 0; r < count; ++r) {
        const float cosine = colours.facing[r] / root(colours.edge2[r] * colours.length2[r]);
        colours.red[r] = cosine * colours.red[r];
        colours.green[r] = cosine * colours.green[r];
        colours.blue[r] = cosine * colours.blue[r];
    }
}

ENFILADE_HD void tint_colours(const RayBlock& block, std::uint32_t count, BlockColours& colours) {
    for (std::uint32_t r = 0; r < count; ++r) {
        colours.red[r] = block.tint[0][r] * colours.red[r];
        colours.green[r] = block.tint[1][r] * colours.green[r];
        colours.blue[r] = block.tint[2][r] * colours.blue[r];
    }
}

/// Rays that have ended at floors go on from there (mirror.h), in a block of their own.
void mirror_block(const detail::TileJob& job, const RayBlock& block, std::uint32_t count, BlockColours& colours) {
    const accel::SceneView& scene = *job.scene;
    RayBlock images;
    std::uint32_t of[block_rays], mirrors = 0;
    for (std::uint32_t r = 0; r < count; ++r) {
        if (block.level[r] == 0 || block.upward[r] != 0 || block.target[r] == leaked_target) continue;
        if (scene.source_faces[block.target[r]].surface != accel::Surface::Floor) continue;
        const Ray<float> image = mirrored(block.ray(r), scene.cells[block.cell[r]].z_floor);
        images.set(mirrors, image.origin, image.direction, block.cell[r]);
        of[mirrors++] = r;
    }
    if (mirrors == 0) return;
    images.begin_all(mirrors);
    walk_picture_block(scene, images);
    walk_picture_rest(scene, images);
    BlockColours seen;
    light_block(job, images, mirrors, seen);
    tint_colours(images, mirrors, seen);
    for (std::uint32_t k = 0; k < mirrors; ++k) {
        const std::uint32_t r = of[k];
        const Vec3f own = {colours.red[r], colours.green[r], colours.blue[r]};
        const Vec3f both = in_mirror(job.mirror_floor, own, {seen.red[k], seen.green[k], seen.blue[k]});
        colours.red[r] = both.x;
        colours.green[r] = both.y;
        colours.blue[r] = both.z;
    }
}

void store_block(const detail::TileJob& job, const BlockPlace& place, const BlockColours& colours) {
    const std::uint32_t width = static_cast<std::uint32_t>(place.width);
    for (std::uint32_t row = 0; row * width < place.count; ++row) {
        const float *red = colours.red + row * width, *green = colours.green + row * width;
        const float* blue = colours.blue + row * width;
        const std::size_t pixel =
            (static_cast<std::size_t>(place.y) + row) * static_cast<std::size_t>(job.width) + place.x;
        if (job.rgb == nullptr) {
            std::uint32_t* out = job.rgba + pixel;
            for (std::uint32_t k = 0; k < width; ++k) out[k] = encoded({red[k], green[k], blue[k]});
        } else {
            float* out = job.rgb + 3 * pixel;
            for (std::uint32_t k = 0; k < width; ++k) {
                out[3 * k] = red[k];
                out[3 * k + 1] = green[k];
                out[3 * k + 2] = blue[k];
            }
        }
    }
}

void lambert_blocks(const detail::TileJob& job) {
    RayBlock block;
    BlockColours colours;
    const CameraFrame camera = *job.camera;
    const int most = static_cast<int>(block_rays);
    for (int x = job.x0; x < job.x1; x += most) {
        const int width = job.x1 - x < most ? job.x1 - x : most;
        const int rows = most / width;
        for (int y = job.y0; y < job.y1; y += rows) {
            const int height = job.y1 - y < rows ? job.y1 - y : rows;
            const BlockPlace place = {x, y, width, static_cast<std::uint32_t>(width * height)};
            aim(camera, job.start_cell, place, block);
            walk_picture_block(*job.scene, block);
            walk_picture_rest(*job.scene, block);
            light_block(job, block, place.count, colours);
            if (job.mirror_floor > 0) mirror_block(job, block, place.count, colours);
            tint_colours(block, place.count, colours);
            store_block(job, place, colours);
        }
    }
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render

#endif
