#pragma once
// Edges of a stack on which boxes end.

#include <map>
#include <span>
#include <vector>

#include "modeler/stack.h"

namespace enfilade::modeler {

/// Edges that become chains: the first part keeps the edge's number, the others are appended to the stack's edges.
class StackChains {
public:
    /// A point of the edge, within half a unit per axis; its ends are no news.
    void add(const Stack& stack, std::uint32_t edge, plans::GridPoint point);
    void split(Stack& stack);

    /// The half-edges that a half-edge of the stack before has become, in its direction.
    void append(std::uint32_t half_edge, std::vector<std::uint32_t>& half_edges) const;
    /// Those between two points of it. \pre both were added, or are its ends; `to` comes after `from`
    void append(const Stack& stack, std::uint32_t half_edge, plans::GridPoint from, plans::GridPoint to,
                std::vector<std::uint32_t>& half_edges) const;

    /// The number of a new point: the same for the same place.
    std::uint32_t point(Stack& stack, plans::GridPoint at);

private:
    std::map<std::uint32_t, std::vector<plans::GridPoint>> points_;  ///< edge -> points on it
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts_;      ///< edge -> its parts, from a to b
    std::map<plans::GridPoint, std::uint32_t> new_points_;
};

}  // namespace enfilade::modeler
