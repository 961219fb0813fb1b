#pragma once
// Whether a device's pictures are those of the scalar tracer.

#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "render/cuda/device.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// A row of the report.
struct Agreement {
    std::string scene, what, way;
    std::uint64_t asked = 0;  ///< pixels or rays
    std::uint64_t same = 0;
    std::uint64_t explained = 0;  ///< of the others: at edges
    std::uint64_t leaks = 0;
    std::string bound;  ///< in words: what counts as the same
    bool is_right = true;
    std::string fault;  ///< the first one, with its pixel or ray; empty where there is none
};

/// Pictures of more than this share of differing pixels are wrong: one in a hundred thousand.
inline constexpr double most_differing = 1e-5;

struct CheckOptions {
    int side = 1024;        ///< of pictures, pixels
    std::size_t views = 2;  ///< of each scene, at most
};

/// Every task that the scene has something for, by every way that has it. A picture is right without leaks if at most
/// `most_differing` of its pixels differ by more than its tolerance (lit ones: differ, and lie not at an edge); on the
/// host those of exact ways are the same bits.
[[nodiscard]] std::vector<Agreement> check_frames(render::cuda::Device& device, const TriedScene& scene,
                                                  const CheckOptions& options, const accel::Executor& executor);

}  // namespace enfilade::tools::gpu
