#pragma once
// A few hundred rays whose walks take turns (block_walk.h), as columns: what their set-up and their shading do to
// all of them is one loop each, which the compiler turns into vector instructions.

#include <cstdint>

#include "render/isa.h"
#include "render/ray.h"
#include "render/walk.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// As many as the first cache holds: with fewer, the rounds in which a few long walks are left would cost more.
inline constexpr std::uint32_t block_rays = 128;

/// As a target: the walk did not end within its bound.
inline constexpr std::uint32_t leaked_target = 0xffffffffu;

/// Rays, and where they end. Plain arrays: a block lives on the stack of one loop.
struct alignas(64) RayBlock {
    // The line; as in Ray.
    float ox[block_rays], oy[block_rays], oz[block_rays];
    float dx[block_rays], dy[block_rays], dz[block_rays];
    float minus_dy[block_rays];
    float moment[block_rays];
    std::uint32_t zero_mask[block_rays];
    float zero_flip[block_rays];  ///< -0.0 where a zero side counts as left, else 0: by its sign sides are exchanged
    float flat2[block_rays];      ///< dx dx + dy dy
    std::uint32_t upward[block_rays];   ///< all ones where dz > 0: the level that the ray may meet is the ceiling
    std::uint32_t sloping[block_rays];  ///< all ones but where dz = 0: it meets no level
    std::uint32_t start[block_rays];    ///< cell that holds the origin
    float limit[block_rays];            ///< of the parameter, for walks that have one
    std::uint32_t goal[block_rays];     ///< cell that ends the walk, for walks to a point

    // Where it is, and in the end where it ended.
    std::uint32_t next[block_rays];    ///< the cell to be walked through
    std::uint32_t cell[block_rays];    ///< the one before
    std::uint32_t target[block_rays];  ///< bits of the face by which it left that cell
    std::uint32_t status[block_rays];  ///< WalkStatus; a walk without a limit leaves it as it is
    std::uint32_t section[block_rays], next_section[block_rays];  ///< by which it left that cell's prism
    float facing[block_rays];                ///< direction . outward normal of that section, of its length
    float num[block_rays], den[block_rays];  ///< the parameter there is num / den
    std::uint32_t level[block_rays];         ///< all ones where it left that cell by its floor or ceiling
    float tint[3][block_rays];               ///< of the glass crossed

    std::uint32_t active[block_rays];  ///< rays that still walk
    std::uint32_t active_count;
    std::uint32_t rest[block_rays];  ///< rays that a rare case has stopped: the one-ray walk takes them from the start
    std::uint32_t rest_count = 0;

    [[nodiscard]] ENFILADE_HD Ray<float> ray(std::uint32_t r) const {
        return {
            {ox[r], oy[r], oz[r]}, {dx[r], dy[r], dz[r]}, moment[r], zero_mask[r] != 0 ? -1.0f : 1.0f, zero_mask[r]};
    }

    ENFILADE_HD void set(std::uint32_t r, Vec<float> origin, Vec<float> direction, std::uint32_t start_cell) {
        ox[r] = origin.x;
        oy[r] = origin.y;
        oz[r] = origin.z;
        dx[r] = direction.x;
        dy[r] = direction.y;
        dz[r] = direction.z;
        start[r] = start_cell;
    }

    /// Fills in what follows from the first rays' origins and directions: `make_ray_unchecked`.
    ENFILADE_HD void derive(std::uint32_t count) {
        for (std::uint32_t r = 0; r < count; ++r) {
            moment[r] = difference_of_products(ox[r], dy[r], oy[r], dx[r]);
            minus_dy[r] = -dy[r];
            zero_mask[r] = zero_side_is_positive(dx[r], dy[r]) ? ~0u : 0u;
            zero_flip[r] = zero_mask[r] != 0 ? -0.0f : 0.0f;
            flat2[r] = dx[r] * dx[r] + dy[r] * dy[r];
            upward[r] = dz[r] > 0 ? ~0u : 0u;
            sloping[r] = dz[r] != 0 ? ~0u : 0u;
            next[r] = cell[r] = start[r];
        }
    }

    /// `derive`; all of them walk, and no glass yet.
    ENFILADE_HD void begin_all(std::uint32_t count) {
        derive(count);
        for (std::uint32_t r = 0; r < count; ++r) {
            active[r] = r;
            tint[0][r] = tint[1][r] = tint[2][r] = 1;
        }
        active_count = count;
    }
};

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
