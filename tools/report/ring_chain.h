#pragma once
// Borders put together from the directed sides that they are made of.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace enfilade::tools {

/// Sides (from, to) in rings, as indices: each is followed by one that starts where it ends, by any where several do
/// (filled, all those rings look the same). A chain that cannot go on ends there. Every side is in one ring;
/// deterministic. Cost: n log n.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> chain_rings(std::span<const std::array<std::uint32_t, 2>> sides);

}  // namespace enfilade::tools
