#pragma once
// Inside of streams: what all schedules are given, for a part of a stream.

#include <cstdint>

#include "render/cuda/buffer.h"
#include "render/cuda/compaction.h"
#include "render/cuda/device_objects.h"
#include "render/cuda/packed_sections.h"
#include "render/cuda/ray_order.h"
#include "render/cuda/streams.h"
#include "render/cuda/streams_atomics.h"
#include "render/cuda/streams_questions.h"

namespace enfilade::render::cuda {

/// A scene's copy in each layout that was made.
struct SceneCopies {
    SectionLayout layout = SectionLayout::Columns;
    accel::SceneView columns;
    PackedScene<false> points = {};  ///< where the layout is Points
    PackedScene<true> pairs = {};    ///< where it is Pairs
};

/// What a kernel works on: all rays below `count`, in an order if there is one.
struct RayWork {
    const std::uint32_t* order;  ///< nullptr: as they come
    std::uint32_t count;

    ENFILADE_HD std::uint32_t operator[](std::uint32_t k) const { return order != nullptr ? order[k] : k; }
};

/// Memory that schedules need besides the rays; grows with the largest part of a stream.
struct StreamRoom {
    static constexpr std::size_t counters = 4;

    Buffer<std::uint32_t> counts;  ///< [counters]: rare rays, the next ray to fetch, waiting rays
    Buffer<std::uint32_t> rare;
    Buffer<ObjectQuestion> questions[2];
    Buffer<WalkSoFar> walks[2];
    Buffer<ObjectAnswer> answers;

    [[nodiscard]] RayList rare_list() const { return {rare.data(), counts.data()}; }
    [[nodiscard]] std::uint32_t* next() const { return counts.data() + 1; }
    [[nodiscard]] std::uint32_t* waiting() const { return counts.data() + 2; }
    [[nodiscard]] std::size_t bytes() const {
        return counts.bytes() + rare.bytes() + questions[0].bytes() + questions[1].bytes() + walks[0].bytes() +
               walks[1].bytes() + answers.bytes();
    }
};

struct StreamRun {
    Device& device;
    const SceneCopies& scenes;
    const DeviceObjects* objects;  ///< nullptr: rooms are walked bare
    const DeviceStreamOptions& options;
    StreamRoom& room;
    KeySorter& sorter;
    RayWork work;
};

/// Warps for a kernel whose warps stay until there is nothing left.
[[nodiscard]] inline std::uint64_t staying_warps(const StreamRun& run) {
    constexpr std::uint64_t warps_a_multiprocessor = 64;  // as many as one can hold; those too many find nothing left
    const std::uint64_t most = (std::uint64_t{run.work.count} + warp_size - 1) / warp_size;
    const std::uint64_t held = static_cast<std::uint64_t>(run.device.multiprocessors()) * warps_a_multiprocessor;
    return held < most ? held : most;
}

// Each for both questions. Rare rays are left on the list, except by `ask_whole`.

/// In bare rooms: Deferred and Persistent.
void ask_bare(const StreamRun& run, const NearestQuestion& question);
void ask_bare(const StreamRun& run, const VisibleQuestion& question);
/// In furnished rooms, a thread asks its objects: Deferred and Persistent.
void ask_furnished(const StreamRun& run, const NearestQuestion& question);
void ask_furnished(const StreamRun& run, const VisibleQuestion& question);
/// In furnished rooms, cells and objects apart.
void ask_compacted(const StreamRun& run, const NearestQuestion& question);
void ask_compacted(const StreamRun& run, const VisibleQuestion& question);
/// All rays by the whole walk.
void ask_whole(const StreamRun& run, const NearestQuestion& question);
void ask_whole(const StreamRun& run, const VisibleQuestion& question);
/// The rare ones.
void ask_rare(const StreamRun& run, const NearestQuestion& question);
void ask_rare(const StreamRun& run, const VisibleQuestion& question);

}  // namespace enfilade::render::cuda
