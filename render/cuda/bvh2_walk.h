#pragma once
// One ray through a binary tree of boxes on a card, as Aila and Laine walk it (Understanding the Efficiency of Ray
// Traversal on GPUs, 2009; Kepler and Fermi Addendum, 2012): while-while, a leaf is kept until all lanes have one, rays
// are replaced in their lanes. Header-only, for host and device.

#include "render/bvh_walk.h"
#include "render/cuda/bvh_ray.h"

namespace enfilade::render::cuda {

/// The trees of all meshes behind that of the scene, in one array each. Plain pointers.
struct Bvh2View {
    const BvhNode* nodes;  ///< the scene's root first
    const TriangleRecord* records;
    const BvhInstance* instances;
    const BvhExtent* extents;  ///< of each instance's mesh, then of the scene; read by Watertight alone
    std::uint32_t instance_count;
    std::uint32_t is_empty;  ///< 1: nothing is ever hit
};

/// any: whether something is hit is all that is asked. instanced: whether there are objects.
template <bool any, bool instanced, TriangleTest test>
class Bvh2Walk {
public:
    /// Paths of two trees, what waits behind an instance, the mark there and one at the bottom.
    static constexpr int stack_size = static_cast<int>(instanced ? 2 * largest_bvh_depth + 3 : largest_bvh_depth + 1);
    /// Where what is left for later waits: a local of the kernel's, apart from the walk, whose numbers then stay in
    /// registers.
    using Stack = std::uint32_t[stack_size];
    ENFILADE_HD void begin(const Bvh2View& bvh, const BvhQuery& query, Stack& waiting) {
        near_ = query.near;
        hit_ = {query.far, no_record, no_object};
        instance_ = no_object;
        skipped_ = query.skipped;
        world_origin_ = query.origin;
        world_direction_ = query.direction;
        ray_.aim(query.origin, query.direction, bvh.extents + bvh.instance_count);
        waiting[0] = done;
        waiting_count_ = 1;
        at_ = bvh.is_empty != 0 || !(query.near <= query.far) ? done : 0u;
    }
    /// Follows the ray; false where fewer than `fetch_below` lanes were left with one: to be called again.
    template <class Events>
    ENFILADE_HD bool go(const Bvh2View& bvh, int fetch_below, Stack& waiting, Events& events) {
        while (at_ != done) {
            if constexpr (instanced)
                if (at_ == leave) leave_instance(bvh, waiting);
            std::uint32_t leaf = done;
            while (at_ < leaf_bit) {
                step(bvh.nodes + at_, waiting, events);
                if (leaf == done && is_leaf(at_)) {
                    leaf = at_;
                    at_ = pop(waiting);
                }
                if (!any_here(leaf == done)) break;
            }
            if (leaf == done && is_leaf(at_)) {
                leaf = at_;
                at_ = pop(waiting);
            }
            while (is_leaf(leaf)) {
                if (enters_instance(bvh, leaf & ~leaf_bit, waiting, events)) break;
                leaf = done;
                if (is_leaf(at_)) {
                    leaf = at_;
                    at_ = pop(waiting);
                }
            }
            if (lanes_here() < fetch_below) return at_ == done;
        }
        return true;
    }
    [[nodiscard]] ENFILADE_HD bool is_done() const { return at_ == done; }
    [[nodiscard]] ENFILADE_HD const BvhHit& hit() const { return hit_; }

private:
    static constexpr std::uint32_t done = 0xffffffffu;
    static constexpr std::uint32_t leave = 0xfffffffeu;  ///< on the stack: below it lies what the scene's ray meets
    static ENFILADE_HD bool is_leaf(std::uint32_t at) { return at >= leaf_bit && at < leave; }

    ENFILADE_HD std::uint32_t pop(const Stack& waiting) { return waiting[--waiting_count_]; }

    /// From a node to the nearer of those children that the ray meets; the other one waits.
    template <class Events>
    ENFILADE_HD void step(const BvhNode* node, Stack& waiting, Events& events) {
        events.visited_node();
        const auto* from = reinterpret_cast<const unsigned char*>(node);
        const Float4 xy = load_float4(from), z = load_float4(from + 16), high = load_float4(from + 32);
        const Float4 child = load_float4(from + 48);
        float enter0, enter1;
        const bool meets0 = meets({xy.x, xy.z, z.x}, {z.z, high.x, high.z}, enter0);
        const bool meets1 = meets({xy.y, xy.w, z.y}, {z.w, high.y, high.w}, enter1);
        std::uint32_t first = bits_of(child.x), second = bits_of(child.y);
        if (!meets0 && !meets1) {
            at_ = pop(waiting);
            return;
        }
        if (meets0 && meets1) {
            if (enter1 < enter0) {
                const std::uint32_t nearer = second;
                second = first;
                first = nearer;
            }
            waiting[waiting_count_++] = second;
            events.stack_holds(waiting_count_);
        } else {
            first = meets0 ? first : second;
        }
        at_ = first;
    }

    ENFILADE_HD bool meets(Vec3f low, Vec3f high, float& enter) const {
        Vec3f a, b;
        if constexpr (test == TriangleTest::Fast) {
            const Vec3f shift = ray_.origin * ray_.inverse;
            a = {fused(low.x, ray_.inverse.x, -shift.x), fused(low.y, ray_.inverse.y, -shift.y),
                 fused(low.z, ray_.inverse.z, -shift.z)};
            b = {fused(high.x, ray_.inverse.x, -shift.x), fused(high.y, ray_.inverse.y, -shift.y),
                 fused(high.z, ray_.inverse.z, -shift.z)};
        } else {
            a = (low - ray_.origin_low()) * ray_.inverse;
            b = (high - ray_.origin_high()) * ray_.inverse;
        }
        enter = most(most(least(a.x, b.x), least(a.y, b.y)), most(least(a.z, b.z), near_));
        const float exit = least(least(most(a.x, b.x), most(a.y, b.y)), least(most(a.z, b.z), hit_.t));
        return enter <= exit;
    }

    /// Tests what a leaf holds; true where it holds an instance, whose root is next.
    template <class Events>
    ENFILADE_HD bool enters_instance(const Bvh2View& bvh, std::uint32_t k, Stack& waiting, Events& events) {
        RecordAt record;
        do {
            record = load_record(bvh.records, k);
            if constexpr (instanced) {
                if ((record.item & instance_bit) != 0) {
                    enter_instance(bvh, record.item & item_mask, waiting, events);
                    return instance_ != no_object;
                }
            }
            events.tested_triangle();
            float t;
            if (ray_.meets(record, near_, hit_.t, t) &&
                (!ray_.breaks_ties() || t < hit_.t || comes_first(bvh.records, record, instance_, hit_))) {
                hit_ = {t, k, instance_};
                if constexpr (any) {
                    at_ = done;
                    return true;
                }
            }
            ++k;
        } while ((record.item & end_bit) == 0);
        return false;
    }

    template <class Events>
    ENFILADE_HD void enter_instance(const Bvh2View& bvh, std::uint32_t number, Stack& waiting, Events& events) {
        if (number == skipped_) return;
        events.entered_instance();
        const InstanceAt instance = load_instance(bvh.instances, number);
        ray_.aim(instance.turned(world_origin_ - instance.origin), instance.turned(world_direction_),
                 bvh.extents + number);
        waiting[waiting_count_++] = at_;
        waiting[waiting_count_++] = leave;
        events.stack_holds(waiting_count_);
        instance_ = number;
        at_ = instance.root;
    }
    ENFILADE_HD void leave_instance(const Bvh2View& bvh, const Stack& waiting) {
        ray_.aim(world_origin_, world_direction_, bvh.extents + bvh.instance_count);
        instance_ = no_object;
        at_ = pop(waiting);
    }

    SpaceRay<test> ray_;
    Vec3f world_origin_, world_direction_;
    float near_;
    BvhHit hit_;
    std::uint32_t instance_, skipped_;
    std::uint32_t at_;
    int waiting_count_;
};

}  // namespace enfilade::render::cuda
