#pragma once
// The faces of a building's map, and what is flat, simple and apart, by the plainest way there is: all pairs, no trees,
// no shortcuts. For tests to put faults where they mean to, and to compare with.

#include <array>
#include <cstdint>
#include <vector>

#include "modeler/building.h"

namespace enfilade::testing {

struct OracleFace {
    std::vector<std::uint32_t> ring;  ///< vertex ids
    std::array<std::uint32_t, 2> volumes = {};
};

class FaceOracle {
public:
    /// \pre the topology is sound. The points are looked up in the building whenever they are asked for.
    explicit FaceOracle(const modeler::Building& building);

    [[nodiscard]] const std::vector<OracleFace>& faces() const { return faces_; }
    [[nodiscard]] const std::vector<std::uint32_t>& faces_at(std::uint32_t vertex) const { return at_[vertex]; }
    [[nodiscard]] bool is_flat(std::uint32_t face) const;
    [[nodiscard]] bool is_level(std::uint32_t face) const;
    [[nodiscard]] bool is_upright(std::uint32_t face) const;
    /// Seen along the axis that is steepest on the face. \pre is_flat(face)
    [[nodiscard]] bool is_simple(std::uint32_t face) const;
    /// Whether no other vertex lies where this one does.
    [[nodiscard]] bool is_alone(std::uint32_t vertex) const;
    /// World metres.
    [[nodiscard]] std::array<double, 3> world(std::uint32_t vertex) const;

private:
    const modeler::Building& building_;
    std::vector<OracleFace> faces_;
    std::vector<std::vector<std::uint32_t>> at_;  ///< [vertex]
};

/// Whether a closed ring of points is simple: every two edges, by exact orientation.
[[nodiscard]] bool is_simple_ring(const std::vector<plans::GridPoint>& ring);

}  // namespace enfilade::testing
