#pragma once
// General ray tracers over the same triangles, as competitors: each kind of tree, thread by thread and persistent, with
// and without triangles split into several boxes.

#include <string>
#include <vector>

#include "render/cuda/bvh_baseline.h"

namespace enfilade::tools::gpu {

struct BaselineWay {
    std::string name;
    render::cuda::BvhBaselineOptions options;
};

[[nodiscard]] inline std::vector<BaselineWay> baseline_ways() {
    using render::cuda::BvhKind;
    return {{"BVH2: a thread a ray", {.kind = BvhKind::Binary, .split_share = 0}},
            {"BVH2: split boxes", {.kind = BvhKind::Binary}},
            {"BVH2: split boxes, persistent", {.kind = BvhKind::Binary, .schedule = {.is_persistent = true}}},
            {"BVH8: a thread a ray", {.kind = BvhKind::Wide, .split_share = 0}},
            {"BVH8: split boxes", {.kind = BvhKind::Wide}},
            {"BVH8: split boxes, persistent", {.kind = BvhKind::Wide, .schedule = {.is_persistent = true}}}};
}

/// Metres that their secondary rays are kept off the surfaces that they leave; ours need nothing of the kind.
inline constexpr float baseline_skin = 1e-3f;

}  // namespace enfilade::tools::gpu
