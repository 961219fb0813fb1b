#pragma once
// What warps do while they walk octrees: turns, and how many of their lanes take part. The very code of the kernels,
// run on the host. For tests and tables.

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

    std::uint64_t leaf_sectors = 0;      ///< of 32 bytes, that the lanes read of leaves, turn by turn
    std::uint64_t triangle_sectors = 0;  ///< and of triangles

    void stepped(std::uint32_t lanes) {
        next_turn(leaf_sectors);
        ++steps;
        step_lanes += static_cast<std::uint64_t>(bit_count(lanes));
    }
    void tested(std::uint32_t lanes) {
        next_turn(triangle_sectors);
        ++tests;
        test_lanes += static_cast<std::uint64_t>(bit_count(lanes));
    }
    void entered_leaf(std::uint32_t /*leaf*/, std::uint32_t /*triangles*/) { ++leaves; }
    void descended(std::uint32_t levels) { looks += levels; }

    /// Of what one lane reads in this turn.
    void read(const void* from, std::size_t bytes) {
        const auto at = reinterpret_cast<std::uintptr_t>(from);
        for (std::uintptr_t sector = at / 32; sector <= (at + bytes - 1) / 32; ++sector) read_.push_back(sector);
    }
    void ended() { next_turn(of_none_); }

    /// Shares of lanes at work.
    [[nodiscard]] double step_share() const { return share(step_lanes, steps); }
    [[nodiscard]] double test_share() const { return share(test_lanes, tests); }

private:
    /// Counts the sectors of the turn before, and has those of the next added to `sum`.
    void next_turn(std::uint64_t& sum) {
        std::ranges::sort(read_);
        if (sum_ != nullptr) *sum_ += static_cast<std::uint64_t>(std::ranges::unique(read_).begin() - read_.begin());
        read_.clear();
        sum_ = &sum;
    }

    std::vector<std::uintptr_t> read_;
    std::uint64_t* sum_ = nullptr;
    std::uint64_t of_none_ = 0;

    [[nodiscard]] static double share(std::uint64_t lanes, std::uint64_t turns) {
        return turns == 0 ? 0 : static_cast<double>(lanes) / static_cast<double>(turns * warp_size);
    }
};

/// A tree that tells what is read of its leaves and triangles.
template <class Tree>
struct ReadTree : Tree {
    CountedWarps* counts;

    [[nodiscard]] LeafHead leaf(accel::JumpEntry entry, std::uint32_t octant) const {
        if constexpr (requires { this->leaves.by_octant; }) {
            if (this->leaves.by_octant != nullptr)
                counts->read(this->leaves.by_octant + std::size_t{octant} * this->leaves.count + entry.number(),
                             sizeof(OctantLeaf));
            else counts->read(this->leaves.as_linked + entry.number(), sizeof(accel::LinkedLeaf));
        } else {
            counts->read(this->view.leaves + entry.number(), sizeof(accel::LinkedLeaf));
        }
        return Tree::leaf(entry, octant);
    }
    [[nodiscard]] TriangleCorners triangle(const typename Tree::Place& place, std::uint32_t& number) const {
        if constexpr (requires { this->records; }) {
            counts->read(this->records + 3 * std::size_t{place.at}, 3 * sizeof(Quad));
        } else if constexpr (requires { this->references; }) {
            const auto& to = this->references[place.at];
            counts->read(&to, sizeof to);
            for (const std::uint32_t corner : {to.a, to.b, to.c}) counts->read(this->corners + corner, sizeof(Quad));
        } else {
            for (std::size_t i = 0; i < 9; ++i)
                counts->read(this->view.corners + place.at + i * place.stride, sizeof(float));
        }
        return Tree::triangle(place, number);
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
    const ReadTree<Tree> read = {tree, &events};
    using Rays = OctreeWarp<ReadTree<Tree>, CountedWarps>;
    std::uint32_t next = 0;
    if (schedule.kind == Kind::Persistent) {
        // One after the other: how they share the rays makes no difference to what a warp does with its own.
        Rays(read, job, schedule, count, events).run(Warp(), 0, &next);
    } else {
        for (std::uint32_t first = 0; first < count; first += warp_size)
            Rays(read, job, schedule, count, events).run(Warp(), first, nullptr);
    }
    events.ended();
    return events;
}

}  // namespace enfilade::render::cuda
