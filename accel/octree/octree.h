#pragma once
// The octree over the triangles of one mesh, as it is built: a tree of eighths whose leaves list triangles. Layouts
// that rays walk are made of it (linked_octree.h, README.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"

namespace enfilade::accel {

/// Where a mesh lies in its octree's lattice: the corner `low` is at 0, the smallest possible cell is 1 wide, the root
/// `side()`. Everything about an octree is counted in it, so its boxes are whole numbers, whatever the mesh's place and
/// size.
struct OctreeFrame {
    std::array<float, 3> low = {0, 0, 0};
    std::array<float, 3> cells_a_unit = {1, 1, 1};  ///< lattice = (p - low) * cells_a_unit
    std::uint32_t depth = 0;                        ///< of the smallest cells
    [[nodiscard]] ENFILADE_HD float side() const { return static_cast<float>(1u << depth); }
};

/// No octree is deeper: lattice coordinates stay exact in float, keys fit 64 bits.
inline constexpr std::uint32_t largest_octree_depth = 20;

/// A triangle belongs to a leaf whose box, wider by this share of the root's side on all sides, it meets: more than
/// what rounding moves a ray that is walked (near_ray.h).
inline constexpr double octree_slack = 0x1p-20;

/// What a walk is expected to spend, in any unit (README.md: nanoseconds of our walks).
struct OctreeCost {
    double full_leaf = 28;   ///< a step into a leaf with triangles and out of it
    double empty_leaf = 20;  ///< the same without any
    double block = 10;       ///< triangles that are tested at once, so many or less
    static constexpr std::uint32_t block_size = 16;
    std::uint32_t at_once = block_size;  ///< 16: a register of them; 1: one by one, as on a device

    [[nodiscard]] static constexpr std::uint32_t blocks(std::uint32_t triangles) {
        return triangles / block_size + (triangles % block_size != 0 ? 1 : 0);
    }
    [[nodiscard]] constexpr double of_leaf(std::uint32_t triangles) const {
        return triangles == 0 ? empty_leaf : full_leaf + block * ((triangles + at_once - 1) / at_once);
    }
};

/// What rays walk.
enum class OctreeLayout : std::uint8_t {
    Linked,  ///< ours (linked_octree.h)
    Ropes    ///< the paper's (rope_octree.h), balanced if the tree is
};

struct OctreeOptions {
    static constexpr std::uint32_t automatic = 0xffffffffu;
    std::uint32_t depth = automatic;      ///< of the smallest cells; automatic: no deeper than pays
    std::uint32_t leaf_size = automatic;  ///< leaves with no more triangles are not split; automatic: by `cost` alone
    bool is_balanced = false;             ///< neighbours differ by one level at most (2:1)
    OctreeCost cost = {};
    OctreeLayout layout = OctreeLayout::Linked;
    bool has_stored_boxes = false;  ///< with Ropes: boxes are stored, not computed
    bool walks_in_double = false;   ///< with Ropes: sides of edges are computed in double
};

/// Whatever the mesh and the options, leaves and references together are at most so many a triangle, and some more.
inline constexpr std::uint64_t octree_entries_a_triangle = 8, octree_entries_spare = 4096;

/// A child of a node: a leaf or an inner node, by number.
struct OctreeEntry {
    static constexpr std::uint32_t leaf_bit = 0x80000000u;
    std::uint32_t bits = leaf_bit;
    [[nodiscard]] ENFILADE_HD bool is_leaf() const { return (bits & leaf_bit) != 0; }
    [[nodiscard]] ENFILADE_HD std::uint32_t number() const { return bits & ~leaf_bit; }
    static constexpr OctreeEntry leaf(std::uint32_t number) { return {leaf_bit | number}; }
    static constexpr OctreeEntry inner(std::uint32_t number) { return {number}; }
    friend constexpr bool operator==(OctreeEntry, OctreeEntry) = default;
};

struct OctreeLeaf {
    std::array<std::uint32_t, 3> low;  ///< its corner in the lattice
    std::uint32_t level;               ///< 0: the root; it is 2^(depth - level) wide
    std::uint32_t first;               ///< into `references`
    std::uint32_t count;
};

/// Octant i of a node has bit 0 of i where x is in the upper half, bit 1 for y, bit 2 for z; so leaves stand in Morton
/// order.
struct Octree {
    OctreeFrame frame;
    OctreeEntry root;
    std::vector<OctreeEntry> children;  ///< [inner node][8]
    std::vector<OctreeLeaf> leaves;
    std::vector<std::uint32_t> references;  ///< triangles of the mesh, ascending in each leaf

    [[nodiscard]] bool is_empty() const { return references.empty(); }
    [[nodiscard]] std::uint32_t width(const OctreeLeaf& leaf) const { return 1u << (frame.depth - leaf.level); }
};

/// Triangles as builders see them. The memory is the scene's.
struct MeshPart {
    const Vertex* places = nullptr;           ///< of the mesh's vertices
    const MeshTriangle* triangles = nullptr;  ///< of the mesh
    std::span<const std::uint32_t> used;      ///< which of them, ascending; none of them without area
};

/// Builds it on the cores of `executor`; the result does not depend on them. However the triangles lie, depth and
/// memory are bounded: where splitting separates nothing it ends. Cost: about 1 us a triangle and core.
[[nodiscard]] Octree build_octree(const MeshPart& mesh, const OctreeOptions& options, const Executor& executor);

}  // namespace enfilade::accel
