// The loops over blocks of rays of a stream (ray_stream.h); no include guard is needed, as in block_loops.h.

#include "render/block_walk.h"
#include "render/kernel.h"

#if ENFILADE_WIDE_SIDES

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// The rays of a block by their places in the stream's order.
struct BlockOfStream {
    const std::uint32_t* order;  ///< nullptr: 0, 1, 2...
    std::uint64_t begin;
    std::uint32_t count;

    [[nodiscard]] ENFILADE_HD std::uint64_t index(std::uint32_t r) const {
        return order != nullptr ? order[begin + r] : begin + r;
    }
    template <class From, class To>
    ENFILADE_HD void fetch(const From* column, To* to) const {
        if (order == nullptr) {
            for (std::uint32_t r = 0; r < count; ++r) to[r] = static_cast<To>(column[begin + r]);
        } else {
            for (std::uint32_t r = 0; r < count; ++r) to[r] = static_cast<To>(column[order[begin + r]]);
        }
    }
    template <class To, class ValueOf>
    ENFILADE_HD void give(To* column, const ValueOf& value_of) const {
        if (column == nullptr) return;
        if (order == nullptr) {
            for (std::uint32_t r = 0; r < count; ++r) column[begin + r] = value_of(r);
        } else {
            for (std::uint32_t r = 0; r < count; ++r) column[order[begin + r]] = value_of(r);
        }
    }
};

/// Scales the directions, refuses what is no ray, and puts the others on the list. metres: [count], of the directions
void begin_rays(RayBlock& block, const BlockOfStream& of, const float* max_distance, float* metres) {
    for (std::uint32_t r = 0; r < of.count; ++r) {
        const Vec3f direction = {block.dx[r], block.dy[r], block.dz[r]};
        const bool is_sound = is_ray({block.ox[r], block.oy[r], block.oz[r]}, direction);
        const Vec3f scaled = scaled_direction(direction);
        block.dx[r] = scaled.x;
        block.dy[r] = scaled.y;
        block.dz[r] = scaled.z;
        metres[r] = length(scaled);
        block.status[r] = static_cast<std::uint32_t>(is_sound ? WalkStatus::Hit : WalkStatus::Refused);
    }
    if (max_distance != nullptr) {
        for (std::uint32_t r = 0; r < of.count; ++r) {
            block.limit[r] = limit_of(max_distance[r], metres[r]);
            if (!(max_distance[r] == max_distance[r]))
                block.status[r] = static_cast<std::uint32_t>(WalkStatus::Refused);
        }
    }
    block.derive(of.count);
    std::uint32_t count = 0;
    for (std::uint32_t r = 0; r < of.count; ++r) {
        block.active[count] = r;
        count += block.status[r] == static_cast<std::uint32_t>(WalkStatus::Hit) ? 1 : 0;
    }
    block.active_count = count;
}

/// The rays that the block's walk left over.
template <class StopOf>
void walk_rest(const accel::SceneView& scene, RayBlock& block, const StopOf& stop_of) {
    NoEvents none;
    for (std::uint32_t k = 0; k < block.rest_count; ++k) {
        const std::uint32_t r = block.rest[k];
        const Ray<float> ray = block.ray(r);
        Vec3f tint = {1, 1, 1};
        const WalkEnd<float> end = walk(scene, ray, block.start[r], stop_of(r), tint, none);
        block.status[r] = static_cast<std::uint32_t>(end.status);
        block.cell[r] = end.cell;
        block.target[r] = end.target.bits;
        block.num[r] = parameter(scene, ray, end);
        block.den[r] = 1;
    }
}

void answer_rays(const detail::StreamJob& job, const BlockOfStream& of, RayBlock& block, const float* max_distance,
                 const float* metres) {
    constexpr auto hit = static_cast<std::uint32_t>(WalkStatus::Hit);
    constexpr auto reached = static_cast<std::uint32_t>(WalkStatus::Reached);
    constexpr auto refused = static_cast<std::uint32_t>(WalkStatus::Refused);
    for (std::uint32_t r = 0; r < of.count; ++r) {
        const float t = block.num[r] / block.den[r];
        const float distance = (t > 0.0f ? t : 0.0f) * metres[r];
        block.num[r] = block.status[r] == refused ? __builtin_nanf("") : distance;
        block.target[r] = block.status[r] == hit ? block.target[r] : ~0u;
    }
    if (max_distance != nullptr)
        for (std::uint32_t r = 0; r < of.count; ++r)
            block.num[r] = block.status[r] == reached ? max_distance[r] : block.num[r];
    of.give(job.distance, [&](std::uint32_t r) { return block.num[r]; });
    of.give(job.source_face, [&](std::uint32_t r) { return static_cast<accel::SourceFaceId>(block.target[r]); });
    of.give(job.cell, [&](std::uint32_t r) { return static_cast<accel::CellId>(block.cell[r]); });
    of.give(job.status, [&](std::uint32_t r) { return static_cast<WalkStatus>(block.status[r]); });
    of.give(job.object, [](std::uint32_t) { return static_cast<accel::ObjectId>(~0u); });  // blocks meet faces alone
    of.give(job.triangle, [](std::uint32_t) { return no_triangle; });
}

void nearest_blocks(const detail::StreamJob& job) {
    RayBlock block;
    alignas(64) float metres[block_rays], distances[block_rays];
    const float* max_distance = job.max_distance != nullptr ? distances : nullptr;
    for (std::uint64_t begin = job.begin; begin < job.end; begin += block_rays) {
        const std::uint64_t left = job.end - begin;
        const BlockOfStream of = {job.order, begin, static_cast<std::uint32_t>(left < block_rays ? left : block_rays)};
        of.fetch(job.origin[0], block.ox);
        of.fetch(job.origin[1], block.oy);
        of.fetch(job.origin[2], block.oz);
        of.fetch(job.direction[0], block.dx);
        of.fetch(job.direction[1], block.dy);
        of.fetch(job.direction[2], block.dz);
        of.fetch(job.start, block.start);
        if (max_distance != nullptr) of.fetch(job.max_distance, distances);
        begin_rays(block, of, max_distance, metres);
        if (max_distance != nullptr) {
            walk_block<BlockStop{.has_limit = true}>(*job.scene, block);
            walk_rest(*job.scene, block, [&](std::uint32_t r) { return Limit<float>{block.limit[r]}; });
        } else {
            walk_block<BlockStop{}>(*job.scene, block);
            walk_rest(*job.scene, block, [](std::uint32_t) { return NoLimit{}; });
        }
        answer_rays(job, of, block, max_distance, metres);
    }
}

/// Segments that need a walk go on the list; the others are answered. answers: [count]
void begin_segments(RayBlock& block, const BlockOfStream& of, const float (&to)[3][block_rays],
                    std::uint32_t* answers) {
    std::uint32_t count = 0;
    for (std::uint32_t r = 0; r < of.count; ++r) {
        const Vec3f p = {block.ox[r], block.oy[r], block.oz[r]}, q = {to[0][r], to[1][r], to[2][r]};
        const Vec3f way = q - p, scaled = scaled_direction(way);
        block.dx[r] = scaled.x;
        block.dy[r] = scaled.y;
        block.dz[r] = scaled.z;
        block.limit[r] = largest_part(way) / largest_part(scaled);
        const bool are_places = is_place(p) & is_place(q);
        const bool are_near = (block.goal[r] == block.start[r]) | (largest_part(way) == 0.0f);
        answers[r] = are_places & are_near ? 1 : 0;
        block.status[r] = are_places & !are_near ? 1 : 0;
    }
    for (std::uint32_t r = 0; r < of.count; ++r) {
        block.active[count] = r;
        count += block.status[r];
    }
    block.active_count = count;
    block.derive(of.count);
}

void visible_blocks(const detail::SegmentJob& job) {
    RayBlock block;
    alignas(64) float to[3][block_rays];
    alignas(64) std::uint32_t answers[block_rays];
    for (std::uint64_t begin = job.begin; begin < job.end; begin += block_rays) {
        const std::uint64_t left = job.end - begin;
        const BlockOfStream of = {job.order, begin, static_cast<std::uint32_t>(left < block_rays ? left : block_rays)};
        of.fetch(job.from[0], block.ox);
        of.fetch(job.from[1], block.oy);
        of.fetch(job.from[2], block.oz);
        for (int k = 0; k < 3; ++k) of.fetch(job.to[k], to[k]);
        of.fetch(job.from_cell, block.start);
        if (job.to_cell != nullptr) {
            of.fetch(job.to_cell, block.goal);
        } else {
            for (std::uint32_t r = 0; r < of.count; ++r) block.goal[r] = no_cell;
        }
        begin_segments(block, of, to, answers);
        std::uint32_t walked[block_rays];
        const std::uint32_t count = block.active_count;
        for (std::uint32_t k = 0; k < count; ++k) walked[k] = block.active[k];
        walk_block<BlockStop{.has_limit = true, .has_goal = true}>(*job.scene, block);
        walk_rest(*job.scene, block, [&](std::uint32_t r) { return ToPoint<float>{block.limit[r], block.goal[r]}; });
        for (std::uint32_t k = 0; k < count; ++k) answers[walked[k]] = block.status[walked[k]] == 1 ? 1 : 0;
        of.give(job.visible, [&](std::uint32_t r) { return static_cast<std::uint8_t>(answers[r]); });
    }
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render

#endif
