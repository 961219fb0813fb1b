#pragma once
// What warps do while they walk octrees: turns, and how many of their lanes take part. The very code of the kernels,
// run on the host. For tests and tables.

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "render/cuda/octree_schedule.h"

namespace enfilade::render::cuda {

/// Events of OctreeWarp on the host.
struct CountedWarps {
    std::uint64_t steps = 0;       ///< turns in which lanes go to a leaf
    std::uint64_t step_lanes = 0;  ///< lanes that do, over all turns
    std::uint64_t tests = 0;       ///< turns in which lanes test a triangle
    std::uint64_t test_lanes = 0;  ///< lanes that do: triangles
    std::uint64_t leaves = 0;      ///< with triangles and without, over all rays
    std::uint64_t looks = 0;       ///< loads from the table of leaves

    void stepped(std::uint32_t lanes) {
        ++steps;
        step_lanes += static_cast<std::uint64_t>(bit_count(lanes));
    }
    void tested(std::uint32_t lanes) {
        ++tests;
        test_lanes += static_cast<std::uint64_t>(bit_count(lanes));
    }
    void entered_leaf(std::uint32_t /*leaf*/, std::uint32_t /*triangles*/) { ++leaves; }
    void descended(std::uint32_t levels) { looks += levels; }

    /// Shares of lanes at work.
    [[nodiscard]] double step_share() const { return share(step_lanes, steps); }
    [[nodiscard]] double test_share() const { return share(test_lanes, tests); }

private:
    [[nodiscard]] static double share(std::uint64_t lanes, std::uint64_t turns) {
        return turns == 0 ? 0 : static_cast<double>(lanes) / static_cast<double>(turns * warp_size);
    }
};

/// Runs a job as kernels do and counts. schedule: Postponed and Persistent as they are, with as many warps as one
/// processor holds; PerLeaf and WhileWhile as compilers make warps meet again: after each leaf, once all have one.
/// \pre pointers are of this machine's memory
template <class Tree>
[[nodiscard]] CountedWarps count_octree_warps(const Tree& tree, const OctreeJob& job, std::uint32_t count,
                                              OctreeSchedule schedule) {
    using Kind = OctreeSchedule::Kind;
    if (schedule.kind == Kind::PerLeaf) schedule.ready = 1, schedule.testing = 0;
    if (schedule.kind == Kind::WhileWhile) schedule.ready = warp_size, schedule.testing = 0;
    CountedWarps events;
    std::uint32_t next = 0;
    if (schedule.kind == Kind::Persistent) {
        // One after the other: how they share the rays makes no difference to what a warp does with its own.
        OctreeWarp<Tree, CountedWarps>(tree, job, schedule, count, events).run(Warp(), 0, &next);
        return events;
    }
    for (std::uint32_t first = 0; first < count; first += warp_size)
        OctreeWarp<Tree, CountedWarps>(tree, job, schedule, count, events).run(Warp(), first, nullptr);
    return events;
}

}  // namespace enfilade::render::cuda
