#pragma once
// The rings around a flat region, from its border in any order.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace enfilade::modeler {

/// A directed segment between two nodes; the region lies on its left.
struct BorderSegment {
    std::uint32_t from = 0;  ///< into the nodes
    std::uint32_t to = 0;
    friend auto operator<=>(const BorderSegment&, const BorderSegment&) = default;
};

/// One connected region: its outer ring runs counter-clockwise, its holes clockwise. A ring visits a node once.
struct RegionRings {
    std::vector<std::uint32_t> outer;
    std::vector<std::vector<std::uint32_t>> holes;
};

/// The rings of a region that hangs together over its inside. Segments that are there in both directions are inside
/// of it and cancel out. `nodes`: integer coordinates within +-2^30. Throws InputError (F22) where the border does not
/// close. Each ring begins at its lowest node, holes are sorted by it. Cost: n log n.
[[nodiscard]] RegionRings trace_rings(std::vector<BorderSegment> border,
                                      std::span<const std::array<std::int64_t, 2>> nodes);

}  // namespace enfilade::modeler
