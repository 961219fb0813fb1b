#pragma once
// How a baseline's kernels are given their rays.

namespace enfilade::render::cuda {

/// Persistent: as many threads as a card holds, which take one ray after the other (Aila and Laine 2012); a warp takes
/// new ones when fewer than `fetch_below` of its lanes have one left. Else a thread a ray.
struct BvhSchedule {
    bool is_persistent = false;
    int fetch_below = 20;  ///< 0 to 32
};

}  // namespace enfilade::render::cuda
