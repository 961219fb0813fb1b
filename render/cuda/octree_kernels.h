#pragma once
// The kernels of octree_rays.h. Included by .cu files alone.

#include <variant>

#include "render/cuda/launch.h"
#include "render/cuda/octree_arrays.h"
#include "render/cuda/octree_schedule.h"

namespace enfilade::render::cuda {

/// A thread's ray. Registers for eight warps a quarter of a multiprocessor.
template <class Tree, bool any>
struct OctreeThread {
    static constexpr LaunchShape shape = {128, 8};
    Tree tree;
    OctreeJob job;
    bool goes_through;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        NoEventsInOctree none;
        job.put(i, tree, find_nearest<any>(tree, job.ray(i), goes_through, none));
    }
};

/// The paper's walk: as many registers as it takes without spilling.
template <class T, bool any>
struct OctreeThread<RopeTree<T>, any> {
    static constexpr LaunchShape shape = {128, sizeof(T) == 4 ? 6 : 5};
    RopeTree<T> tree;
    OctreeJob job;
    bool goes_through;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        NoEventsInOctree none;
        job.put(i, tree, find_nearest<any>(tree, job.ray(i), goes_through, none));
    }
};

struct QuietWarp : NoEventsInOctree, NoWarpEvents {};

/// A warp's.
template <class Tree>
struct OctreeWarps {
    static constexpr LaunchShape shape = {128, 6};
    Tree tree;
    OctreeJob job;
    OctreeSchedule schedule;
    std::uint32_t count;
    std::uint32_t* next;  ///< nullptr: 32 rays a warp

    ENFILADE_HD void operator()(const Warp& warp, std::uint64_t w) const {
        QuietWarp none;
        OctreeWarp<Tree, QuietWarp> own(tree, job, schedule, count, none);
        own.run(warp, static_cast<std::uint32_t>(w) * warp_size, next);
    }
};

template <class Tree>
void start_octree_warps(Device& device, const Tree& tree, const OctreeJob& job, std::uint32_t count,
                        const OctreeSchedule& schedule, Buffer<std::uint32_t>& next) {
    const std::uint64_t warps = (std::uint64_t{count} + warp_size - 1) / warp_size;
    if (schedule.kind == OctreeSchedule::Kind::Postponed)
        return for_each_warp(device, warps, OctreeWarps<Tree>{tree, job, schedule, count, nullptr});
    next.clear();
    const auto held =
        static_cast<std::uint64_t>(device.multiprocessors()) * static_cast<std::uint64_t>(schedule.warps_a_processor);
    for_each_warp(device, held < warps ? held : warps, OctreeWarps<Tree>{tree, job, schedule, count, next.data()});
}

/// Trees whose walk comes in pieces.
template <class Tree>
inline constexpr bool has_pieces = true;
template <class T>
inline constexpr bool has_pieces<RopeTree<T>> = false;
/// Walks of a warp are compiled for the layouts that are likely the fastest.
template <>
inline constexpr bool has_pieces<IndexedTree> = false;

inline void start_octree(Device& device, const DeviceOctree& octree, const OctreeJob& job, std::uint32_t count,
                         const OctreeSchedule& schedule, Buffer<std::uint32_t>& next) {
    using Kind = OctreeSchedule::Kind;
    std::visit(
        [&]<class Tree>(const Tree& tree) {
            if constexpr (has_pieces<Tree>) {
                if (schedule.kind == Kind::Postponed || schedule.kind == Kind::Persistent)
                    return start_octree_warps(device, tree, job, count, schedule, next);
            }
            for_each(device, count, OctreeThread<Tree, false>{tree, job, schedule.kind != Kind::PerLeaf});
        },
        octree.tree());
}

inline void start_octree_any(Device& device, const DeviceOctree& octree, const OctreeJob& job, std::uint32_t count) {
    std::visit(
        [&]<class Tree>(const Tree& tree) {
            for_each(device, count, OctreeThread<Tree, true>{tree, job, true});
        },
        octree.tree());
}

}  // namespace enfilade::render::cuda
