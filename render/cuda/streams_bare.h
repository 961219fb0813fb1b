#pragma once
// Kernels of streams through bare rooms.

#include "render/cuda/launch.h"
#include "render/cuda/streams_run.h"

namespace enfilade::render::cuda {

/// A thread a ray; rare cases are put on a list.
template <class Scene, class Question>
struct DeferringKernel {
    static constexpr LaunchShape shape = {128, 8};
    Scene scene;
    Question question;
    RayWork work;
    RayList rare;

    ENFILADE_HD void operator()(std::uint64_t k) const {
        const std::uint32_t i = work[static_cast<std::uint32_t>(k)];
        typename Question::Traveller t;
        if (!question.begin(i, false, t)) return;
        NoThroughput none;
        WalkEnd<float> end;
        if (walk_plainly(scene, t.ray, t.cell, t.stop, none, end)) question.finish(scene, i, t, end);
        else rare.add(i);
    }
};

/// Warps that stay and fetch rays (Aila and Laine 2009): as soon as `refill` lanes are idle, they get the next rays.
template <class Scene, class Question>
struct FetchingKernel {
    static constexpr LaunchShape shape = {128, 7};
    Scene scene;
    Question question;
    RayWork work;
    RayList rare;
    std::uint32_t* next;  ///< the first ray that no warp has fetched
    std::uint32_t refill;

    struct Lane {
        typename Question::Traveller t;
        WalkEnd<float> end;
        std::uint32_t ray, steps;
    };

    ENFILADE_HD void operator()(Warp warp, std::uint64_t) const {
        PerLane<Lane> lanes;
        PerLane<bool> idle;
        for (int lane : warp.lanes()) idle[lane] = true;
        bool has_more = true;
        while (true) {
            const std::uint32_t free = warp.ballot(idle);
            if (free == ~0u && !has_more) return;
            if (has_more && (free == ~0u || count_bits(free) >= refill)) {
                has_more = fetch(warp, free, lanes, idle);
                continue;
            }
            for (int lane : warp.lanes())
                if (!idle[lane]) idle[lane] = !goes_on(lanes[lane]);
        }
    }

private:
    /// False: there are no more.
    ENFILADE_HD bool fetch(Warp warp, std::uint32_t free, PerLane<Lane>& lanes, PerLane<bool>& idle) const {
        const PerLane<std::uint32_t> numbers = take_numbers(warp, free, next);
        for (int lane : warp.lanes()) {
            if (!idle[lane] || numbers[lane] >= work.count) continue;
            Lane& l = lanes[lane];
            l.ray = work[numbers[lane]];
            if (!question.begin(l.ray, false, l.t)) continue;
            l.end.cell = l.t.cell;
            l.steps = most_steps(scene);
            idle[lane] = false;
        }
        return warp.of_lane(numbers, 0) + count_bits(free) < work.count;
    }
    /// One cell; false: the ray has ended.
    ENFILADE_HD bool goes_on(Lane& l) const {
        NoThroughput none;
        const Plainly step = step_plainly(scene, l.t.ray, l.t.stop, none, l.end);
        if (step == Plainly::GoesOn && --l.steps > 0) return true;
        if (step == Plainly::Ends) question.finish(scene, l.ray, l.t, l.end);
        else rare.add(l.ray);
        return false;
    }
};

}  // namespace enfilade::render::cuda
