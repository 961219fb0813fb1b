#pragma once
// Which piece of its walk each lane of a warp does when. All schedules give the same answers, to the last bit. Included
// by kernels, and by those who count what warps do (octree_counts.h).

#include <bit>
#include <cstdint>

#include "render/cuda/octree_job.h"
#include "render/cuda/warp.h"

#if !defined(__CUDA_ARCH__)
#include <atomic>
#endif

namespace enfilade::render::cuda {

/// How the threads of a warp go together.
struct OctreeSchedule {
    enum class Kind : std::uint8_t {
        PerLeaf,     ///< a thread a ray; each turn a leaf and its triangles
        WhileWhile,  ///< a thread a ray; leaves without triangles in a loop of their own
        Postponed,   ///< a warp 32 rays; triangles are tested once `ready` lanes have some
        Persistent   ///< as many warps as the card holds; and once `idle` lanes have no ray left they fetch others
    };
    Kind kind = Kind::WhileWhile;
    int ready = 24;              ///< of 32 lanes
    int idle = 12;               ///< of 32 lanes
    int warps_a_processor = 24;  ///< with Persistent
};

[[nodiscard]] ENFILADE_HD int bit_count(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __popc(bits);
#else
    return std::popcount(bits);
#endif
}

/// What it was before `more` was added, at once for all who ask.
ENFILADE_HD std::uint32_t fetch_add(std::uint32_t* number, std::uint32_t more) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(number, more);
#else
    return std::atomic_ref<std::uint32_t>(*number).fetch_add(more, std::memory_order_relaxed);
#endif
}

/// What a warp may be asked to tell.
struct NoWarpEvents {
    static constexpr bool are_counted = false;
    ENFILADE_HD void stepped(std::uint32_t /*lanes*/) {}
    ENFILADE_HD void tested(const PerLane<std::uint32_t>& /*triangles*/) {}
};

enum class LaneState : std::uint8_t { Idle, Walking, Ready };

/// A warp's rays on their way.
template <class Tree, class Events>
class OctreeWarp {
public:
    ENFILADE_HD OctreeWarp(const Tree& tree, const OctreeJob& job, const OctreeSchedule& schedule, std::uint32_t count,
                           Events& events)
        : tree_(tree), job_(job), schedule_(schedule), count_(count), events_(events) {}

    /// next: the first ray that no warp has taken yet; nullptr: this warp's own 32 are from `first` on and no others.
    ENFILADE_HD void run(const Warp& warp, std::uint32_t first, std::uint32_t* next) {
        for (int lane : warp.lanes()) state_[lane] = LaneState::Idle;
        bool has_more = true;
        while (true) {
            const std::uint32_t idle = lanes_that_are(warp, LaneState::Idle);
            if (has_more && (idle == ~0u || (next != nullptr && bit_count(idle) >= schedule_.idle)))
                has_more = fetch(warp, idle, first, next);
            else if (idle == ~0u) return;
            if (walk(warp, has_more && next != nullptr)) test(warp);
        }
    }

private:
    [[nodiscard]] ENFILADE_HD std::uint32_t lanes_that_are(const Warp& warp, LaneState state) {
        PerLane<bool> are;
        for (int lane : warp.lanes()) are[lane] = state_[lane] == state;
        return warp.ballot(are);
    }

    /// Rays for lanes without. False: none are left for others.
    ENFILADE_HD bool fetch(const Warp& warp, std::uint32_t idle, std::uint32_t first, std::uint32_t* next) {
        if (next != nullptr) {
            PerLane<std::uint32_t> taken;
            for (int lane : warp.lanes())
                taken[lane] = lane == 0 ? fetch_add(next, static_cast<std::uint32_t>(bit_count(idle))) : 0;
            first = warp.of_lane(taken, 0);
        }
        for (int lane : warp.lanes()) {
            if (state_[lane] != LaneState::Idle) continue;
            const std::uint32_t before = static_cast<std::uint32_t>(bit_count(idle & ((1u << lane) - 1)));
            if (first >= count_ || before >= count_ - first) continue;
            number_[lane] = first + before;
            travel_[lane].found.triangle = no_triangle;
            if (begin_travel(tree_, job_.ray(number_[lane]), travel_[lane])) state_[lane] = LaneState::Walking;
            else finish(lane);
        }
        return next != nullptr && first < count_;
    }

    /// From leaf to leaf until enough of the lanes that have rays have triangles to test, or none goes on: true. False:
    /// so many have none that others are fetched first.
    ENFILADE_HD bool walk(const Warp& warp, bool may_fetch) {
        while (true) {
            const std::uint32_t walking = lanes_that_are(warp, LaneState::Walking);
            const int ready = bit_count(lanes_that_are(warp, LaneState::Ready)), busy = ready + bit_count(walking);
            if (may_fetch && warp_size - busy >= schedule_.idle) return false;
            if (walking == 0 || ready * warp_size >= schedule_.ready * busy) return true;
            events_.stepped(walking);
            for (int lane : warp.lanes()) {
                if (state_[lane] != LaneState::Walking) continue;
                enter_leaf(tree_, travel_[lane], events_);
                if (travel_[lane].leaf.count != 0) state_[lane] = LaneState::Ready;
                else leave(lane);
            }
        }
    }

    ENFILADE_HD void test(const Warp& warp) {
        if constexpr (Events::are_counted) {
            PerLane<std::uint32_t> triangles;
            for (int lane : warp.lanes())
                triangles[lane] = state_[lane] == LaneState::Ready ? travel_[lane].leaf.count : 0;
            events_.tested(triangles);
        }
        for (int lane : warp.lanes()) {
            if (state_[lane] != LaneState::Ready) continue;
            test_leaf<false>(tree_, travel_[lane]);
            leave(lane);
        }
    }

    ENFILADE_HD void leave(int lane) {
        if (leave_leaf(tree_, travel_[lane])) state_[lane] = LaneState::Walking;
        else finish(lane);
    }

    ENFILADE_HD void finish(int lane) {
        job_.put(number_[lane], tree_, travel_[lane].found);
        state_[lane] = LaneState::Idle;
    }

    const Tree& tree_;
    const OctreeJob& job_;
    const OctreeSchedule& schedule_;
    std::uint32_t count_;
    Events& events_;
    PerLane<OctreeTravel<Tree>> travel_;
    PerLane<std::uint32_t> number_;
    PerLane<LaneState> state_;
};

}  // namespace enfilade::render::cuda
