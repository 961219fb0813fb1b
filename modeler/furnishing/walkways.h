#pragma once
// The guarantee that every gate of a room is reached from every other wherever it was before.

#include <cstdint>
#include <memory>
#include <vector>

#include "modeler/furnishing/room_shape.h"
#include "modeler/furnishing/walk_lattice.h"

namespace enfilade::modeler {

inline constexpr double walker_radius = 0.3;  ///< metres
/// Pieces with their bottom this high, or less than `flat` thick on the floor, are in nobody's way.
inline constexpr double overhead = 1.0;
inline constexpr double flat = 0.03;

/// Grid units of the lattice on which ways are told for this floor: about 2 cm, more for floors beyond 400 square
/// metres, so that a million nodes suffice.
[[nodiscard]] std::int32_t fine_step(const Floor& floor, double unit);
/// Where one stands having come through a gate.
[[nodiscard]] plans::Point standing_place(const RoomOpening& gate, double unit);
/// How far from there a free node is looked for.
[[nodiscard]] double standing_reach(double unit);

/// What connects the gates, with obstacles as they come. Ways are told on the fine lattice before anything is placed;
/// then on a coarser one with a margin (what it connects, the fine one connects), unless that one has not all the ways
/// of the fine one.
class Walkways {
public:
    /// obstacles: what stands there already
    Walkways(const RoomShape& room, const std::vector<Ring>& obstacles);

    bool put(const Ring& obstacle, int by) { return lattice_->put(obstacle, by); }
    /// Whether all ways of before are there still. Cost: linear in the nodes
    [[nodiscard]] bool all_open();
    /// Whether some node of these is reached from a gate, since the last `all_open`; true in rooms without gates.
    [[nodiscard]] bool some_reached(const std::vector<std::uint32_t>& nodes) const;
    [[nodiscard]] std::vector<std::uint32_t> nodes_near(const Ring& ring, double reach) const {
        return lattice_->nodes_near(ring, reach);
    }
    [[nodiscard]] bool has_gates() const { return !groups_.empty(); }

private:
    using Groups = std::vector<std::vector<std::uint32_t>>;
    static Groups groups_of(WalkLattice& lattice, const std::vector<std::uint32_t>& nodes);

    std::unique_ptr<WalkLattice> lattice_;
    Groups groups_;  ///< nodes at gates, by the parts of the room that they reach
};

}  // namespace enfilade::modeler
