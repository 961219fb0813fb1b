#pragma once
// The walks of a block of rays, in turns: one cell of every ray, then the next cell of those that go on. It is the walk
// of walk.h, each ray by itself against all lines of its cell at once, and gives the same numbers bit for bit.
//
// What it wins is time that a processor loses by guessing. Where a walk ends is hard to foretell, and one ray after the
// other, every wrong guess throws away what was begun of the next ray. In turns, whether a ray goes on decides only
// whether its number stays in a list, for which no branch is needed, and while one ray waits for its cell, others work.

#include <cstddef>

#include "render/isa.h"
#include "render/left_bits.h"
#include "render/ray_block.h"
#include "render/walk.h"

#if ENFILADE_WIDE_SIDES

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// Where a block's walks end before a face stops them; a constant, so that what nobody asks for is not computed.
struct BlockStop {
    bool has_limit = false;  ///< at the parameter `limit`: Limit
    bool has_goal = false;   ///< and where they enter the cell `goal`: ToPoint
};

/// The arrays that every step reads.
struct SceneArrays {
    const accel::Cell* cells;
    const float* xs;
    const float* ys;
    const accel::SectionTail* tails;
    const accel::SideFace* faces;
};

static_assert(offsetof(accel::Cell, z_ceiling) == offsetof(accel::Cell, z_floor) + sizeof(float));
static_assert(offsetof(accel::Cell, ceiling) == offsetof(accel::Cell, floor) + sizeof(accel::Target));

/// Of a cell's floor, and of its ceiling that lies behind it in memory, the one that `up` (0 or 1) tells: no branch.
template <class Part>
ENFILADE_HD const Part* level_of(const Part* floor, std::uint32_t up) {
    return floor + up;
}

/// The section by which a ray leaves its cell's prism, and where; no_section where none accepts it, or more than one.
/// By value: an address would hold it in memory.
struct Crossed {
    std::uint32_t section, next_section;
    float num, facing;
};

/// `only_accepting` of up to 64 lines. May read 64 bytes behind the last.
ENFILADE_HD std::uint32_t only_accepting_of_64(const SceneArrays& arrays, const RayBlock& block, std::uint32_t r,
                                               std::uint32_t first, std::uint32_t count) {
    const WideFloat dx = wide_of(block.dx + r), minus_dy = wide_of(block.minus_dy + r);
    const WideFloat moment = wide_of(block.moment + r), flip = wide_of(block.zero_flip + r);
    std::uint64_t left = 0;
    for (std::uint32_t i = 0; i < count; i += wide_lines) {
        const WideFloat side = wide_fused(load_wide(arrays.ys + first + i), dx,
                                          wide_fused(load_wide(arrays.xs + first + i), minus_dy, moment));
        left |= std::uint64_t(wide_positive(side, flip)) << i;
    }
    left = _bzhi_u64(block.zero_mask[r] != 0 ? ~left : left, count);
    const std::uint64_t next = left >> 1 | (left & 1) << (count - 1);
    const std::uint64_t accepting = ~left & next;
    return accepting != 0 && _blsr_u64(accepting) == 0 ? static_cast<std::uint32_t>(_tzcnt_u64(accepting)) : no_section;
}

/// In a cell with more lines than one instruction takes.
__attribute__((noinline)) inline Crossed cross_many(const accel::SceneView& scene, const SceneArrays& arrays,
                                                    const RayBlock& block, std::uint32_t r, std::uint32_t first,
                                                    std::uint32_t count) {
    const Ray<float> ray = block.ray(r);
    const std::uint32_t p =
        count <= 64 ? only_accepting_of_64(arrays, block, r, first, count) : only_accepting(scene, ray, first, count);
    if (p == no_section) return {no_section, no_section, 0, 0};
    const std::uint32_t section = first + p, next = p + 1 == count ? first : section + 1;
    const Crossing<float> at = section_crossing(scene, ray, section, next);
    return {section, next, at.num, at.facing};
}

/// First half of a step: `find_section` and `crossing`.
ENFILADE_HD Crossed cross(const accel::SceneView& scene, const SceneArrays& arrays, const RayBlock& block,
                          std::uint32_t r, std::uint32_t first, std::uint32_t count) {
    if (count > wide_lines) [[unlikely]]
        return cross_many(scene, arrays, block, r, first, count);
    // The sides of all lines, and how far along the ray they lie.
    const WideFloat x = load_wide(arrays.xs + first), y = load_wide(arrays.ys + first);
    const WideFloat dx = wide_of(block.dx + r);
    const WideFloat side = wide_fused(y, dx, wide_fused(x, wide_of(block.minus_dy + r), wide_of(block.moment + r)));
    const WideFloat along = wide_fused(wide_minus(x, wide_of(block.ox + r)), dx,
                                       wide_times(wide_minus(y, wide_of(block.oy + r)), wide_of(block.dy + r)));
    const std::uint32_t left = _bzhi_u32(wide_positive(side, wide_of(block.zero_flip + r)) ^ block.zero_mask[r], count);
    const std::uint32_t twice = left | left << count;  // line i + count is line i
    const std::uint32_t accepting = _bzhi_u32(~twice & twice >> 1, count);
    if (accepting == 0 || _blsr_u32(accepting) != 0) [[unlikely]]
        return {no_section, no_section, 0, 0};
    const std::uint32_t p = lowest_bit(accepting), q = p + 1 == count ? 0 : p + 1;
    const float p_side = wide_at(side, p), q_side = wide_at(side, q);
    const float p_along = wide_at(along, p), q_along = wide_at(along, q);
    return {first + p, first + q, q_side * p_along - p_side * q_along, q_side - p_side};
}

ENFILADE_HD __m128 load_float(const float* p) { return _mm_load_ss(p); }
ENFILADE_HD __m128 load_mask(const std::uint32_t* p) { return _mm_castsi128_ps(_mm_loadu_si32(p)); }

/// `find_face`'s face of the stack [first, top]: the first whose top lies above the ray, else the last. Up to four at
/// once; may read 32 bytes behind the last one.
ENFILADE_HD std::uint32_t face_of_stack(const accel::SideFace* faces, std::uint32_t first, std::uint32_t top,
                                        __m128 scaled_dz, __m128 oz, __m128 den) {
    if (top - first < 4) [[likely]] {
        const __m256 tops = _mm256_loadu_ps(&faces[first].z_top);  // every other number is a target
        const __m256 above = _mm256_mul_ps(_mm256_sub_ps(tops, _mm256_broadcastss_ps(oz)), _mm256_broadcastss_ps(den));
        const __m256 is_it = _mm256_cmp_ps(_mm256_broadcastss_ps(scaled_dz), above, _CMP_LT_OQ);
        const std::uint32_t bits =
            (static_cast<std::uint32_t>(_mm256_movemask_ps(is_it)) & 0x55u) | 1u << 2 * (top - first);
        return first + lowest_bit(bits) / 2;
    }
    const float scaled = _mm_cvtss_f32(scaled_dz), from = _mm_cvtss_f32(oz), by = _mm_cvtss_f32(den);
    while (first < top && !(scaled < (faces[first].z_top - from) * by)) ++first;
    return first;
}

/// 1 where the limit lies before the face: Limit's and ToPoint's comparisons.
template <BlockStop stop>
ENFILADE_HD std::uint32_t is_limit_before(const RayBlock& block, std::uint32_t r, __m128 num, __m128 den, __m128 rise,
                                          __m128 is_level) {
    const __m128 limit = load_float(block.limit + r), upward = load_mask(block.upward + r);
    const __m128 side_limit = _mm_mul_ss(limit, den);
    const __m128 level_limit = _mm_mul_ss(limit, load_float(block.dz + r));
    __m128 side, floor, ceiling;
    if constexpr (stop.has_goal) {
        side = _mm_cmpge_ss(num, side_limit);
        floor = _mm_cmple_ss(rise, level_limit);
        ceiling = _mm_cmpge_ss(rise, level_limit);
    } else {
        side = _mm_cmpnle_ss(num, side_limit);
        floor = _mm_cmpnge_ss(rise, level_limit);
        ceiling = _mm_cmpnle_ss(rise, level_limit);
    }
    const __m128 is_before = _mm_blendv_ps(side, _mm_blendv_ps(floor, ceiling, upward), is_level);
    return static_cast<std::uint32_t>(_mm_movemask_ps(is_before)) & 1u;
}

/// First half of a step of all active rays. Takes those off the list that are rare cases.
ENFILADE_HD void cross_cells(const accel::SceneView& scene, const SceneArrays& arrays, RayBlock& block) {
    std::uint32_t kept = 0;
    const std::uint32_t count = block.active_count;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t r = block.active[k], c = block.next[r];
        const Crossed at = cross(scene, arrays, block, r, arrays.cells[c].first_section, arrays.cells[c].section_count);
        if (at.section == no_section) [[unlikely]] {
            block.rest[block.rest_count++] = r;
            continue;
        }
        block.cell[r] = c;
        block.section[r] = at.section;
        block.num[r] = at.num;
        block.facing[r] = at.facing;
        block.active[kept++] = r;
    }
    block.active_count = kept;
}

/// Second half: the face in those sections' stacks, or the level that the ray meets before (`find_face`), what lies
/// behind it, and which rays go on. A ceiling lies no lower than the tops of the faces below it, so it may be asked for
/// before them.
template <BlockStop stop>
ENFILADE_HD void pass_faces(const SceneArrays& arrays, RayBlock& block) {
    std::uint32_t kept = 0;
    const std::uint32_t count = block.active_count;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t r = block.active[k], c = block.cell[r], p = block.section[r];
        const accel::Cell& cell = arrays.cells[c];
        const __m128 num = load_float(block.num + r), dz = load_float(block.dz + r);
        const __m128 scaled_dz = _mm_mul_ss(num, dz),
                     den = _mm_mul_ss(load_float(block.facing + r), load_float(block.flat2 + r));
        const __m128 oz = load_float(block.oz + r), upward = load_mask(block.upward + r);
        const std::uint32_t up = block.upward[r] & 1u;
        const __m128 rise = _mm_sub_ss(load_float(level_of(&cell.z_floor, up)), oz);
        const __m128 is_level = _mm_and_ps(_mm_xor_ps(_mm_cmplt_ss(scaled_dz, _mm_mul_ss(rise, den)), upward),
                                           load_mask(block.sloping + r));
        const std::uint32_t face = face_of_stack(arrays.faces, arrays.tails[p].first_face,
                                                 arrays.tails[p + 1].first_face - 1, scaled_dz, oz, den);
        const __m128 target = _mm_blendv_ps(load_mask(&arrays.faces[face].target.bits),
                                            load_mask(&level_of(&cell.floor, up)->bits), is_level);
        const std::uint32_t bits = static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_castps_si128(target)));
        const std::uint32_t next = bits & accel::Target::index_mask;
        std::uint32_t goes_on = bits > accel::Target::index_mask ? 1 : 0;
        if constexpr (stop.has_limit) {
            const std::uint32_t is_before = is_limit_before<stop>(block, r, num, den, rise, is_level);
            std::uint32_t is_reached = is_before;
            goes_on &= ~is_before;
            if constexpr (stop.has_goal) {
                const std::uint32_t arrives = goes_on & static_cast<std::uint32_t>(next == block.goal[r]);
                is_reached |= arrives;
                goes_on &= ~arrives;
            }
            block.status[r] = is_reached;
        }
        block.target[r] = bits;
        block.next[r] = next;
        _mm_store_ss(block.num + r, _mm_blendv_ps(num, rise, is_level));
        _mm_store_ss(block.den + r, _mm_blendv_ps(den, dz, is_level));
        block.active[kept] = r;
        kept += goes_on;
        // What ends behind its origin is a rare case (`ends_behind`).
        const auto is_behind = static_cast<std::uint32_t>(_mm_movemask_ps(_mm_andnot_ps(is_level, num))) & 1u;
        if ((is_behind & ~goes_on) != 0) [[unlikely]]
            block.rest[block.rest_count++] = r;
    }
    block.active_count = kept;
}

/// Steps of rays that are neighbours, in one go: what one does the next does too, so a processor guesses well, and
/// needs not wait for the answer.
ENFILADE_HD void step_neighbours(const accel::SceneView& scene, const SceneArrays& arrays, RayBlock& block) {
    std::uint32_t kept = 0;
    const std::uint32_t count = block.active_count;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t r = block.active[k], c = block.next[r];
        const accel::Cell& cell = arrays.cells[c];
        const Crossed at = cross(scene, arrays, block, r, cell.first_section, cell.section_count);
        if (at.section == no_section) [[unlikely]] {
            block.rest[block.rest_count++] = r;
            continue;
        }
        const float den = at.facing * block.flat2[r], dz = block.dz[r], oz = block.oz[r], scaled_dz = at.num * dz;
        accel::Target target;
        Exit exit = Exit::Side;
        std::uint32_t face = 0;
        if (dz < 0 && scaled_dz < (cell.z_floor - oz) * den) {
            target = cell.floor;
            exit = Exit::Floor;
        } else if (dz > 0 && !(scaled_dz < (cell.z_ceiling - oz) * den)) {
            target = cell.ceiling;
            exit = Exit::Ceiling;
        } else {
            face = arrays.tails[at.section].first_face;
            const std::uint32_t top = arrays.tails[at.section + 1].first_face - 1;
            while (face < top && !(scaled_dz < (arrays.faces[face].z_top - oz) * den)) ++face;
            target = arrays.faces[face].target;
        }
        block.cell[r] = c;
        block.target[r] = target.bits;
        block.section[r] = at.section;
        block.next_section[r] = at.next_section;
        block.facing[r] = at.facing;
        block.level[r] = exit != Exit::Side ? ~0u : 0u;
        if (!target.is_portal()) {
            // What ends behind its origin is a rare case (`ends_behind`).
            if (at.num < 0 && exit == Exit::Side) [[unlikely]]
                block.rest[block.rest_count++] = r;
            continue;
        }
        if (target.is_glass()) {
            const Vec3f tint = tint_of(scene, c, exit, face);
            block.tint[0][r] = block.tint[0][r] * tint.x;
            block.tint[1][r] = block.tint[1][r] * tint.y;
            block.tint[2][r] = block.tint[2][r] * tint.z;
        }
        block.next[r] = static_cast<std::uint32_t>(target.neighbour());
        block.active[kept++] = r;
    }
    block.active_count = kept;
}

ENFILADE_HD SceneArrays arrays_of(const accel::SceneView& scene) {
    return {scene.cells.first, scene.section_x.first, scene.section_y.first, scene.section_tails.first,
            scene.side_faces.first};
}

/// So many steps until every walk ended, or walks turn in a circle (`walk`).
template <class Step>
ENFILADE_HD void walk_in_turns(const accel::SceneView& scene, RayBlock& block, const Step& step) {
    block.rest_count = 0;
    const std::uint64_t turns = scene.cells.count + 16;
    for (std::uint64_t turn = 0; block.active_count > 0 && turn < turns; ++turn) step();
    for (std::uint32_t k = 0; k < block.active_count; ++k) block.rest[block.rest_count++] = block.active[k];
    block.active_count = 0;
}

/// Walks the block's active rays, of any order: what is wanted is num, den, cell, target and status. Those in `rest`
/// afterwards are to be walked again, by `walk` and from the start: the rare cases (README.md, "Ties and noise").
template <BlockStop stop>
void walk_block(const accel::SceneView& scene, RayBlock& block) {
    const SceneArrays arrays = arrays_of(scene);
    walk_in_turns(scene, block, [&] {
        cross_cells(scene, arrays, block);
        pass_faces<stop>(arrays, block);
    });
}

/// The same for rays of a picture, without a limit: what is wanted is target, section, facing, level and tint.
inline void walk_picture_block(const accel::SceneView& scene, RayBlock& block) {
    const SceneArrays arrays = arrays_of(scene);
    walk_in_turns(scene, block, [&] { step_neighbours(scene, arrays, block); });
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render

#endif
