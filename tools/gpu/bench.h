#pragma once
// How fast a card is: one function a table.

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "render/cuda/device.h"
#include "tools/gpu/report.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

struct BenchOptions {
    int rounds = 9;                ///< of each contest
    int side = 1024;               ///< of frames, pixels
    int large_side = 8192;         ///< of the pictures that are batches: 67 million rays
    std::size_t rays = 64u << 20;  ///< of a batch
    std::chrono::steady_clock::time_point end = std::chrono::steady_clock::time_point::max();

    /// Whether there is no time left: what follows is left out, and the report says so.
    [[nodiscard]] bool is_late(Report& report, const std::string& what) const {
        if (std::chrono::steady_clock::now() < end) return false;
        report.leave_out(what);
        return true;
    }
};

/// What the others are measured against, in the same run.
struct Limits {
    std::optional<double> empty_kernel;  ///< seconds, one after the other without a pause
    std::optional<double> empty_waited;  ///< seconds, waited for each time
    std::optional<double> copy;          ///< bytes a second, read and written
    std::optional<double> image;         ///< seconds to write a frame of one colour
    std::optional<double> large_image;   ///< seconds to write a large picture of one colour
};
[[nodiscard]] Limits bench_limits(render::cuda::Device& device, const BenchOptions& options, Report& report);

/// Frames a second of each task and way: the paper's tables 2 and 3.
void bench_frames(render::cuda::Device& device, const std::vector<TriedScene>& scenes, const Limits& limits,
                  const BenchOptions& options, const accel::Executor& executor, Report& report);

/// Rays a second in batches: pictures of many pixels, and streams.
void bench_batches(render::cuda::Device& device, const std::vector<TriedScene>& scenes, const Limits& limits,
                   const BenchOptions& options, const accel::Executor& executor, Report& report);

/// Single meshes: the second paper's table 2.
void bench_meshes(render::cuda::Device& device, const std::vector<TriedScene>& scenes, const BenchOptions& options,
                  const accel::Executor& executor, Report& report);

}  // namespace enfilade::tools::gpu
