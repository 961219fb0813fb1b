#pragma once
// A node of a compressed wide tree: 80 bytes for eight boxes (Ylitie, Karras, Laine: Efficient Incoherent Ray Traversal
// on GPUs Through Compressed Wide BVHs, 2017, section 3).

#include <cstdint>

#include "render/cuda/bvh_lane.h"
#include "render/cuda/triangle_record.h"

namespace enfilade::render::cuda {

/// Child i lies in slot i. Its box: origin + low 2^exponent .. origin + high 2^exponent on each axis. Children that are
/// nodes follow each other from `first_node` on by ascending slot, records of children that are leaves from
/// `first_record` on.
struct alignas(16) WideNode {
    float origin[3];
    std::uint8_t exponent[3];  ///< + 127
    std::uint8_t inner;        ///< bit i: child i is a node
    std::uint32_t first_node;
    std::uint32_t first_record;
    /// 0: none. A node: 1 in the upper three bits, 24 + slot in the lower five. A leaf: as many ones from bit 5 on as
    /// it has records (1 to 3), in the lower five bits where they begin (0 to 23).
    std::uint8_t meta[8];
    std::uint8_t low[3][8];   ///< [axis][slot]
    std::uint8_t high[3][8];  ///< [axis][slot]
};
static_assert(sizeof(WideNode) == 80);

inline constexpr std::uint32_t wide_leaf = 3;  ///< records of a leaf at most

/// No path from the root is longer: builders keep to it.
inline constexpr int largest_wide_depth = 24;

/// Some children of a node, or some records.
struct WideGroup {
    std::uint32_t first;  ///< node or record
    /// Nodes: bit 24 + (slot ^ order) for each child that waits, and the node's `inner` in the lowest byte. Records:
    /// bit i for record first + i, none from 24 on.
    std::uint32_t bits;
    ENFILADE_HD bool has_nodes() const { return bits > 0x00ffffffu; }
};

/// All trees in one array each, the scene's root first. Plain pointers.
struct WideBvhView {
    const WideNode* nodes;
    const TriangleRecord* records;
    const BvhInstance* instances;
    const struct BvhExtent* extents;  ///< as of Bvh2View
    std::uint32_t instance_count;
    std::uint32_t is_empty;
};

}  // namespace enfilade::render::cuda
