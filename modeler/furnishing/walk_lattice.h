#pragma once
// Where a person, a disc, can stand and walk in a room: its configuration space on a lattice.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "modeler/furnishing/floor_geometry.h"

namespace enfilade::modeler {

/// Nodes at whole multiples of `step` grid units. A node is free where its distance from all sides of the floor and all
/// obstacles is at least radius + step / 2 + margin. Between two free neighbours no point is further than step / 2 from
/// one of them, so the disc goes from one to the other: what the lattice connects is connected indeed.
class WalkLattice {
public:
    /// Lengths in grid units.
    WalkLattice(const Floor& floor, std::int32_t step, double radius, double margin);

    [[nodiscard]] std::size_t size() const { return blocked_.size(); }
    [[nodiscard]] std::int32_t step() const { return step_; }
    [[nodiscard]] plans::Point at(std::uint32_t node) const;
    [[nodiscard]] bool is_free(std::uint32_t node) const { return blocked_[node] == 0; }
    /// The free node nearest to p, within `reach`.
    [[nodiscard]] std::optional<std::uint32_t> free_node(plans::Point p, double reach) const;
    /// Free nodes whose distance from the convex ring is at most `reach`.
    [[nodiscard]] std::vector<std::uint32_t> nodes_near(const Ring& ring, double reach) const;

    /// Puts an obstacle there (by = 1), or takes it away again (by = -1). Returns whether a free node was blocked.
    bool put(const Ring& obstacle, int by);

    /// The nodes that are connected with `from`, which is free, count as reached until the next call; before it,
    /// `start_reaching` forgets what was reached.
    void start_reaching();
    void reach(std::uint32_t from);
    [[nodiscard]] bool has_reached(std::uint32_t node) const { return reached_[node] == round_; }

private:
    template <class Visit>
    void near(const Ring& ring, double distance, Visit visit) const;

    std::int32_t step_ = 1, x_low_ = 0, y_low_ = 0;  ///< of the lattice, in steps
    std::int32_t columns_ = 0, rows_ = 0;
    double clear_ = 0;
    std::vector<std::uint16_t> blocked_;  ///< [node] how many obstacles are too near
    std::vector<std::uint32_t> reached_;  ///< [node] the round in which it was reached
    std::uint32_t round_ = 0;
    std::vector<std::uint32_t> queue_;
};

}  // namespace enfilade::modeler
