#pragma once
// Whether a device's answers to streams of rays are those of the scalar tracer.

#include <vector>

#include "accel/parallel_for.h"
#include "render/cuda/device.h"
#include "tools/gpu/agreement.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// An answer's distance is the scalar tracer's within this share of itself and these metres.
inline constexpr double distance_share = 1e-5, distance_slack_m = 1e-5;

/// Rays of the views, diffuse rays, shuffled ones, rays in the families where tracers go wrong, and shadow rays, bare
/// and furnished, by every way that has them. An answer is the same if it names the same face, or object and triangle,
/// at the same distance; on the host those of exact ways are the same bits. No ray may leak.
[[nodiscard]] std::vector<Agreement> check_streams(render::cuda::Device& device, const TriedScene& scene,
                                                   const CheckOptions& options, const accel::Executor& executor);

}  // namespace enfilade::tools::gpu
