#pragma once
// Inside of accel: the light tree of one lamp, before all of them are put together.

#include <cstdint>
#include <vector>

#include "accel/lights/beam_objects.h"
#include "accel/lights/lamp_walk.h"
#include "accel/lights/light_trees.h"

namespace enfilade::accel::detail {

/// One lamp's beams; parents, planes and tints counted from its own first ones.
struct LampTree {
    std::vector<LightBeam> beams;
    std::vector<BeamPlane> planes;
    std::vector<Vertex> tints;
    std::vector<BeamObjects> object_lists;  ///< [beams.size()], or empty
    std::vector<ObjectId> objects;
    std::vector<CellId> cells;  ///< of a lamp without tree: where it may be seen, ascending
};

/// Builds trees, one after the other. The scene and the options must outlive it.
class LampTreeBuilder {
public:
    LampTreeBuilder(const SceneView& view, const LightTreeOptions& options);
    [[nodiscard]] LampTree build(const Light& light);

private:
    bool add_beams(const Light& light, LampTree& tree);
    void find_planes();
    void find_tints(LampTree& tree);
    void find_covered();
    [[nodiscard]] Vertex tint_behind(const Vertex& tint, PortalId portal) const;
    [[nodiscard]] std::vector<CellId> cells_of_steps() const;

    const SceneView& view_;
    const LightTreeOptions& options_;
    std::int64_t margin_;  ///< grid units
    LampWalk walk_;
    BeamObjectLister objects_;
    // Of the lamp at hand:
    std::vector<std::uint32_t> plane_offsets_;  ///< [step_count + 1] into `planes_`
    std::vector<ConeVector> planes_;
    std::vector<ConeVector> planes_of_step_;
    std::vector<std::uint32_t> tint_of_step_;
    std::vector<char> is_covered_;  ///< [step_count]: another step has all of its cell
};

}  // namespace enfilade::accel::detail
