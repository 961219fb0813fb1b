#pragma once
// What a ray meets on its way, counted.

#include <cstdint>
#include <span>

#include "accel/scene.h"
#include "render/trace_rays.h"

namespace enfilade::tools {

struct WalkCount {
    std::uint64_t visits = 0;    ///< cells
    std::uint64_t wholes = 0;    ///< volumes before they were cut
    std::uint64_t sections = 0;  ///< of the cells visited: each is tested
    std::uint64_t eights = 0;    ///< of the cells visited: sections in eights, rounded up, as wide registers test them
    std::uint64_t tested = 0;    ///< side faces whose top was asked for, in the sections by which cells are left
    std::uint64_t faces = 0;     ///< all side faces of the cells visited, tested or not

    friend WalkCount operator+(const WalkCount& a, const WalkCount& b) {
        return {a.visits + b.visits, a.wholes + b.wholes, a.sections + b.sections,
                a.eights + b.eights, a.tested + b.tested, a.faces + b.faces};
    }
};

/// The walk of one ray in float, as `trace_rays` does it. `parents`: [cell] the volume that it is cut from; empty: each
/// counts as one.
[[nodiscard]] WalkCount counted_walk(const accel::SceneView& scene, const render::RayQuery& ray,
                                     std::span<const std::uint32_t> parents = {});

/// The walks of `trace_rays` as processors without wide registers do them, one section at a time; for their time.
/// Returns how many rays end at a face.
std::size_t narrow_walks(const accel::SceneView& scene, std::span<const render::RayQuery> rays);

}  // namespace enfilade::tools
