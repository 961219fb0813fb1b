#pragma once
// Which piece of its walk each lane of a warp does when. All schedules give the same answers, to the last bit. Included
// by kernels, and by those who count what warps do (octree_counts.h).

#include <cstdint>

#include "render/cuda/octree_job.h"
#include "render/cuda/streams_atomics.h"
#include "render/cuda/warp.h"

namespace enfilade::render::cuda {

/// How the threads of a warp go together.
struct OctreeSchedule {
    enum class Kind : std::uint8_t {
        PerLeaf,     ///< a thread a ray; each turn a leaf and its triangles
        WhileWhile,  ///< a thread a ray; leaves without triangles in a loop of their own
        Postponed,   ///< a warp 32 rays; triangles are tested once `ready` lanes have some, while `testing` have
        Persistent   ///< as many warps as the card holds; and once `idle` lanes have no ray left they fetch others
    };
    Kind kind = Kind::Persistent;
    int ready = 16;              ///< of 32 lanes that have rays
    int testing = 16;            ///< of 32 lanes that have rays: fewer stop testing, and go on where they were
    int idle = 4;                ///< of 32 lanes
    int warps_a_processor = 24;  ///< with Persistent
};

[[nodiscard]] ENFILADE_HD int bit_count(std::uint32_t bits) { return static_cast<int>(count_bits(bits)); }

/// What a warp may be asked to tell.
struct NoWarpEvents {
    ENFILADE_HD void stepped(std::uint32_t /*lanes*/) {}
    ENFILADE_HD void tested(std::uint32_t /*lanes*/) {}
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
                taken[lane] = lane == 0 ? atomic_add(next, static_cast<std::uint32_t>(bit_count(idle))) : 0;
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
                triangle_[lane] = 0;
                if (travel_[lane].leaf.count != 0) state_[lane] = LaneState::Ready;
                else leave(lane);
            }
        }
    }

    /// A triangle each turn, until too few lanes have one left.
    ENFILADE_HD void test(const Warp& warp) {
        std::uint32_t ready = lanes_that_are(warp, LaneState::Ready);
        while (ready != 0) {
            events_.tested(ready);
            for (int lane : warp.lanes()) {
                if (state_[lane] != LaneState::Ready) continue;
                test_triangle<false>(tree_, triangle_[lane], travel_[lane]);
                if (++triangle_[lane] == travel_[lane].leaf.count) leave(lane);
            }
            ready = lanes_that_are(warp, LaneState::Ready);
            const int busy = warp_size - bit_count(lanes_that_are(warp, LaneState::Idle));
            if (bit_count(ready) * warp_size < schedule_.testing * busy) return;
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
    PerLane<std::uint32_t> triangle_;  ///< of its leaf, the next to test
};

}  // namespace enfilade::render::cuda
