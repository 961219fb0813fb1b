#pragma once
// One ray through a compressed wide tree (wide_node.h), as Ylitie, Karras and Laine walk it (2017, sections 4 and 5):
// groups of children on a short stack, the nearest octant first, records tested when enough lanes have some.
// Header-only, for host and device.

#include "render/cuda/bvh_ray.h"
#include "render/cuda/wide_node.h"

namespace enfilade::render::cuda {

/// What waits: the deepest entries in the multiprocessor's own memory, all others in the thread's. A local of the
/// kernel's, apart from the walk, whose numbers then stay in registers.
template <int size>
class WideStack {
public:
    ENFILADE_HD void put(int k, WideGroup group) {
#if defined(__CUDA_ARCH__)
        if (k < near_count) near_entry(k) = group;
        else own_[k - near_count] = group;
#else
        own_[k] = group;
#endif
    }
    ENFILADE_HD WideGroup get(int k) const {
#if defined(__CUDA_ARCH__)
        return k < near_count ? near_entry(k) : own_[k - near_count];
#else
        return own_[k];
#endif
    }

private:
#if defined(__CUDA_ARCH__)
    static constexpr int near_count = 8;
    static __device__ __forceinline__ WideGroup& near_entry(int k) {
        __shared__ WideGroup entries[near_count * bvh_block];
        return entries[k * bvh_block + static_cast<int>(threadIdx.x)];
    }
    WideGroup own_[size - near_count];
#else
    WideGroup own_[size];
#endif
};

/// any, instanced: as of Bvh2Walk.
template <bool any, bool instanced, TriangleTest test>
class WideBvhWalk {
public:
    /// Nodes and records of each level of two trees, and the mark between them.
    static constexpr int stack_size = (instanced ? 2 : 1) * 2 * (largest_wide_depth + 1) + 1;
    using Stack = WideStack<stack_size>;

    ENFILADE_HD void begin(const WideBvhView& bvh, const BvhQuery& query, Stack&) {
        near_ = query.near;
        hit_ = {query.far, no_record, no_object};
        instance_ = no_object;
        skipped_ = query.skipped;
        world_origin_ = query.origin;
        world_direction_ = query.direction;
        aim(query.origin, query.direction, bvh.extents + bvh.instance_count);
        waiting_count_ = 0;
        is_done_ = bvh.is_empty != 0 || !(query.near <= query.far);
        nodes_ = root_group(0);
    }
    /// As Bvh2Walk::go.
    template <class Events>
    ENFILADE_HD bool go(const WideBvhView& bvh, int fetch_below, Stack& waiting, Events& events) {
        while (!is_done_) {
            WideGroup records = {0, 0};
            if (nodes_.has_nodes()) {
                visit_next(bvh, records, waiting, events);
            } else {
                records = nodes_;
                nodes_ = {0, 0};
            }
            test_records(bvh, records, waiting, events);
            if (!is_done_ && !nodes_.has_nodes()) pop(bvh, waiting);
            if (lanes_here() < fetch_below) return is_done_;
        }
        return true;
    }
    [[nodiscard]] ENFILADE_HD bool is_done() const { return is_done_; }
    [[nodiscard]] ENFILADE_HD const BvhHit& hit() const { return hit_; }

private:
    /// Its one child is the root: node `root` + 0.
    static ENFILADE_HD WideGroup root_group(std::uint32_t root) { return {root, 0x80000000u}; }

    ENFILADE_HD void aim(Vec3f origin, Vec3f direction, const BvhExtent* extent) {
        ray_.aim(origin, direction, extent);
        const std::uint32_t positive =
            (direction.x < 0 ? 0u : 1u) | (direction.y < 0 ? 0u : 2u) | (direction.z < 0 ? 0u : 4u);
        order_ = positive * 0x01010101u;
    }

    template <class Events>
    ENFILADE_HD void push(WideGroup group, Stack& waiting, Events& events) {
        waiting.put(waiting_count_++, group);
        events.stack_holds(waiting_count_);
    }

    ENFILADE_HD void pop(const WideBvhView& bvh, const Stack& waiting) {
        while (waiting_count_ > 0) {
            nodes_ = waiting.get(--waiting_count_);
            if (!instanced || nodes_.bits != 0) return;
            aim(world_origin_, world_direction_, bvh.extents + bvh.instance_count);
            instance_ = no_object;
        }
        is_done_ = true;
    }

    /// Goes to the nearest child that waits: its children and records that the ray meets.
    template <class Events>
    ENFILADE_HD void visit_next(const WideBvhView& bvh, WideGroup& records, Stack& waiting, Events& events) {
        const std::uint32_t bit = highest_bit(nodes_.bits);
        nodes_.bits &= ~(1u << bit);
        if (nodes_.has_nodes()) push(nodes_, waiting, events);
        const std::uint32_t slot = (bit - 24) ^ (order_ & 7u);
        const std::uint32_t before = bits_in(nodes_.bits & 0xffu & ~(0xffffffffu << slot));
        events.visited_node();
        const auto* from = reinterpret_cast<const unsigned char*>(bvh.nodes + (nodes_.first + before));
        const Float4 head = load_float4(from), links = load_float4(from + 16);
        const Float4 q[3] = {load_float4(from + 32), load_float4(from + 48), load_float4(from + 64)};
        const std::uint32_t met = children_met(head, links, q);
        nodes_ = {bits_of(links.x), (met & 0xff000000u) | bits_of(head.w) >> 24};
        records = {bits_of(links.y), met & 0x00ffffffu};
    }

    /// Parameters of planes along an axis of a node, a + (2^15 + byte) scale: of those by which a ray enters, and of
    /// those by which it leaves.
    struct Slabs {
        float scale, enter, leave;
    };
    ENFILADE_HD Slabs slabs(float origin, std::uint32_t exponent, float ray_low, float ray_high, float inverse,
                            bool is_forward) const {
        const float scale = float_of(exponent << 23) * inverse;
        const float offset = -0x1p15f * scale;
        const float low = fused(origin - ray_low, inverse, offset), high = fused(origin - ray_high, inverse, offset);
        return {scale, is_forward ? low : high, is_forward ? high : low};
    }

    ENFILADE_HD std::uint32_t children_met(const Float4& head, const Float4& links, const Float4* q) const {
        const std::uint32_t exponents = bits_of(head.w);
        const Vec3f low = ray_.origin_low(), high = ray_.origin_high();
        const bool fx = (order_ & 1u) != 0, fy = (order_ & 2u) != 0, fz = (order_ & 4u) != 0;
        const Slabs x = slabs(head.x, exponents & 0xffu, low.x, high.x, ray_.inverse.x, fx);
        const Slabs y = slabs(head.y, exponents >> 8 & 0xffu, low.y, high.y, ray_.inverse.y, fy);
        const Slabs z = slabs(head.z, exponents >> 16 & 0xffu, low.z, high.z, ray_.inverse.z, fz);
        // Low x, y, z, then high x, y, z, two words each.
        const EnterAndLeave px[2] = {by_direction(fx, q[0].x, q[1].z), by_direction(fx, q[0].y, q[1].w)};
        const EnterAndLeave py[2] = {by_direction(fy, q[0].z, q[2].x), by_direction(fy, q[0].w, q[2].y)};
        const EnterAndLeave pz[2] = {by_direction(fz, q[1].x, q[2].z), by_direction(fz, q[1].y, q[2].w)};
        const std::uint32_t meta[2] = {bits_of(links.z), bits_of(links.w)};
        std::uint32_t met = 0;
        ENFILADE_UNROLL
        for (int half = 0; half < 2; ++half) {
            // Bits 3 and 4 are both set in a node's number, 24 + slot; in the place of a leaf, below 24, they are not.
            const std::uint32_t is_inner = (meta[half] & (meta[half] << 1)) & 0x10101010u;
            const std::uint32_t place = (meta[half] ^ (order_ & bytes_of_bit_4(is_inner))) & 0x1f1f1f1fu;
            const std::uint32_t marks = meta[half] >> 5 & 0x07070707u;
            ENFILADE_UNROLL
            for (int i = 0; i < 4; ++i) {
                const float enter = most(most(fused(byte_above_2_15(px[half].enter, i), x.scale, x.enter),
                                              fused(byte_above_2_15(py[half].enter, i), y.scale, y.enter)),
                                         most(fused(byte_above_2_15(pz[half].enter, i), z.scale, z.enter), near_));
                const float leave = least(least(fused(byte_above_2_15(px[half].leave, i), x.scale, x.leave),
                                                fused(byte_above_2_15(py[half].leave, i), y.scale, y.leave)),
                                          least(fused(byte_above_2_15(pz[half].leave, i), z.scale, z.leave), hit_.t));
                if (enter <= leave) met |= (marks >> (8 * i) & 0xffu) << (place >> (8 * i) & 0xffu);
            }
        }
        return met;
    }

    /// Words of four planes.
    struct EnterAndLeave {
        std::uint32_t enter, leave;
    };
    static ENFILADE_HD EnterAndLeave by_direction(bool is_forward, float low, float high) {
        return {bits_of(is_forward ? low : high), bits_of(is_forward ? high : low)};
    }

    template <class Events>
    ENFILADE_HD void test_records(const WideBvhView& bvh, WideGroup records, Stack& waiting, Events& events) {
        const int lanes = lanes_here();
        while (records.bits != 0) {
            // Where few lanes have records left, they wait for others.
            if (5 * lanes_here() < lanes) {
                push_nodes(waiting, events);
                push(records, waiting, events);
                return;
            }
            const std::uint32_t k = highest_bit(records.bits);
            records.bits &= ~(1u << k);
            const std::uint32_t number = records.first + k;
            const RecordAt record = load_record(bvh.records, number);
            if constexpr (instanced) {
                if ((record.item & instance_bit) != 0) {
                    if ((record.item & item_mask) == skipped_) continue;
                    push_nodes(waiting, events);
                    if (records.bits != 0) push(records, waiting, events);
                    enter_instance(bvh, record.item & item_mask, waiting, events);
                    return;
                }
            }
            events.tested_triangle();
            float t;
            if (ray_.meets(record, near_, hit_.t, t) &&
                (!ray_.breaks_ties() || t < hit_.t || comes_first(bvh.records, record, instance_, hit_))) {
                hit_ = {t, number, instance_};
                if constexpr (any) {
                    is_done_ = true;
                    return;
                }
            }
        }
    }

    template <class Events>
    ENFILADE_HD void push_nodes(Stack& waiting, Events& events) {
        if (nodes_.has_nodes()) push(nodes_, waiting, events);
        nodes_ = {0, 0};
    }

    template <class Events>
    ENFILADE_HD void enter_instance(const WideBvhView& bvh, std::uint32_t number, Stack& waiting, Events& events) {
        events.entered_instance();
        const InstanceAt instance = load_instance(bvh.instances, number);
        aim(instance.turned(world_origin_ - instance.origin), instance.turned(world_direction_), bvh.extents + number);
        push({0, 0}, waiting, events);
        instance_ = number;
        nodes_ = root_group(instance.root);
    }

    SpaceRay<test> ray_;
    Vec3f world_origin_, world_direction_;
    float near_;
    BvhHit hit_;
    std::uint32_t instance_, skipped_;
    std::uint32_t order_;  ///< slot ^ order is larger the nearer the octant: in each byte
    WideGroup nodes_;
    bool is_done_;
    int waiting_count_;
};

}  // namespace enfilade::render::cuda
