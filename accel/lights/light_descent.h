#pragma once
// The other way to ask a light tree, as Maria, Horna, Aveneau 2013 do (section 5.2): from the lamp down through the
// portals. What asking from the place's end (light_trees.h) is measured against.

#include <cstdint>
#include <vector>

#include "accel/lights/light_trees.h"

namespace enfilade::accel {

/// A beam in depth-first order; what goes on from it ends before `skip`.
struct DescentNode {
    std::uint32_t beam;
    std::uint32_t skip;
};

/// Plain data, for host and device.
struct LightDescentView {
    ArrayView<std::uint32_t> light_offsets;  ///< [light_count + 1] into `nodes`; empty for lamps without tree
    ArrayView<DescentNode> nodes;
};

class LightDescent {
public:
    /// \pre trees are of light_count lamps
    LightDescent(const LightTreesView& trees, std::size_t light_count);
    [[nodiscard]] LightDescentView view() const {
        return {{light_offsets_.data(), light_offsets_.size()}, {nodes_.data(), nodes_.size()}};
    }
    [[nodiscard]] std::size_t bytes() const {
        return light_offsets_.size() * sizeof light_offsets_[0] + nodes_.size() * sizeof nodes_[0];
    }

private:
    std::vector<std::uint32_t> light_offsets_;
    std::vector<DescentNode> nodes_;
};

/// The first beam of the lamp, in the order of its tree, that holds a place in `cell` at (x, y, z) from the lamp;
/// no_beam where none does. A branch is left where a plane of its beam has the place outside: planes hold for all that
/// goes on from their beam.
ENFILADE_HD std::uint32_t descend(const LightTreesView& trees, const LightDescentView& descent, std::uint32_t light,
                                  std::uint32_t cell, float x, float y, float z) {
    const std::uint32_t end = descent.light_offsets[light + 1];
    for (std::uint32_t k = descent.light_offsets[light]; k < end;) {
        const DescentNode node = descent.nodes[k];
        bool is_held = true;
        for (const BeamPlane& plane : trees.planes_of(node.beam))
            is_held = is_held && plane.x * x + plane.y * y + plane.z * z >= 0;
        if (is_held && static_cast<std::uint32_t>(trees.beams[node.beam].cell) == cell) return node.beam;
        k = is_held ? k + 1 : node.skip;
    }
    return no_beam;
}

}  // namespace enfilade::accel
