#pragma once
// Whether a device's pictures are those of the scalar tracer.

#include <vector>

#include "accel/parallel_for.h"
#include "render/cuda/device.h"
#include "tools/gpu/agreement.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// Every task that the scene has something for, by every way that has it. A picture is right without leaks if at most
/// `most_differing` of its pixels differ by more than its tolerance (lit ones: differ, and lie not at an edge); on the
/// host those of exact ways are the same bits.
[[nodiscard]] std::vector<Agreement> check_frames(render::cuda::Device& device, const TriedScene& scene,
                                                  const CheckOptions& options, const accel::Executor& executor);

}  // namespace enfilade::tools::gpu
