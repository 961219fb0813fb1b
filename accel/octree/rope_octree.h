#pragma once
// The octree as Portalez and Duguet lay it out (Lancer de rayons dans un octree, 2016, section 3): four arrays, each
// leaf a record of words that names its triangles, its box and its neighbours by direction. What they left for later
// is beside it: neighbours of any size, boxes that are not stored, rays that start inside (README.md).

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::accel {

/// Faces of boxes have the paper's numbers (figure 4): 0 lower y, 1 lower x, 2 upper y, 3 upper x, 4 lower z, 5 upper
/// z.
inline constexpr std::uint32_t rope_faces = 6;

/// 0, 1, 2: x, y, z.
[[nodiscard]] ENFILADE_HD constexpr int axis_of(std::uint32_t face) { return face >= 4 ? 2 : (face & 1u) != 0 ? 0 : 1; }
[[nodiscard]] ENFILADE_HD constexpr bool is_high(std::uint32_t face) { return face == 5 || face == 2 || face == 3; }
[[nodiscard]] constexpr std::uint32_t face_at(int axis, bool high) {
    return axis == 2 ? (high ? 5u : 4u) : axis == 0 ? (high ? 3u : 1u) : high ? 2u : 0u;
}

/// A stored box, in the lattice.
struct RopeBox {
    float low[3];
    float width;
};

/// A triangle of one leaf, in the mesh's own space: a leaf's stand side by side.
struct RopeTriangle {
    float corners[3][3];
    std::uint32_t number;  ///< of the mesh
};

/// Where a record stands in the array of words; with `inner_bit`, eight addresses stand there instead, by octant.
using RopeAddress = std::uint32_t;
inline constexpr RopeAddress inner_bit = 0x80000000u;

/// Plain pointers, safe to copy to a device.
///
/// A leaf's record (the paper's formula 3) is tCount | tOffset | i | nCount | neighbours..., where nCount has four bits
/// a face: 0, 1 or 4 neighbours stand for it; of four, number u + 2 v lies in the upper half along the face's first
/// axis if u, its second if v (axes in the order x, y, z). With implicit boxes i is not an index but the box itself
/// (packed_box); where that takes more than 32 bits the rest is a fifth word, after nCount.
struct RopeView {
    OctreeFrame frame;
    const std::uint32_t* words;  ///< the paper's octree; nullptr: nothing is ever hit
    const RopeTriangle* triangles;
    const RopeBox* boxes;          ///< by i; nullptr: boxes are implicit
    const RopeAddress* cube_map;   ///< [face][v][u]: the leaf at that place of the root's surface (or a node about it)
    std::uint32_t cube_map_level;  ///< 2^level places along an edge
    std::uint32_t header;          ///< words of a record before its neighbours
    RopeAddress root;
    bool is_balanced;       ///< false: one neighbour a face, of the leaf's size or larger, leaf or not
    float low[3], high[3];  ///< of the triangles in it
};

/// Packs a leaf's box into 3 depth + 1 bits: x with a one before its `level` bits, y, z, each in widths of the leaf.
[[nodiscard]] std::uint64_t packed_box(const OctreeFrame& frame, const OctreeLeaf& leaf);

/// A leaf's box and level, however the view keeps them.
struct RopeCube {
    std::uint32_t low[3];
    std::uint32_t width;
    std::uint32_t level;
};

/// The bits of the highest one below it, and it: 32 - leading zeros.
ENFILADE_HD std::uint32_t bit_length(std::uint32_t word) {
#if defined(__CUDA_ARCH__)
    return 32u - static_cast<std::uint32_t>(__clz(static_cast<int>(word)));
#else
    return word == 0 ? 0u : 32u - static_cast<std::uint32_t>(__builtin_clz(word));
#endif
}

ENFILADE_HD RopeCube cube_of(const RopeView& tree, RopeAddress leaf) {
    const std::uint32_t word = tree.words[leaf + 2], depth = tree.frame.depth;
    if (tree.boxes != nullptr) {
        const RopeBox& box = tree.boxes[word];
        const auto width = static_cast<std::uint32_t>(box.width);
        return {{static_cast<std::uint32_t>(box.low[0]), static_cast<std::uint32_t>(box.low[1]),
                 static_cast<std::uint32_t>(box.low[2])},
                width,
                depth + 1 - bit_length(width)};
    }
    std::uint64_t bits = word;
    if (tree.header == 5) bits |= std::uint64_t{tree.words[leaf + 4]} << 32;
    const auto x = static_cast<std::uint32_t>(bits >> (2 * depth));
    const std::uint32_t mask = (1u << depth) - 1, level = bit_length(x) - 1, up = depth - level;
    return {{(x ^ 1u << level) << up, (static_cast<std::uint32_t>(bits >> depth) & mask) << up,
             (static_cast<std::uint32_t>(bits) & mask) << up},
            1u << up,
            level};
}

/// What each array takes (the paper's table 3).
struct RopeBytes {
    std::size_t cube_map = 0;
    std::size_t leaves = 0;  ///< the paper's octree
    std::size_t nodes = 0;   ///< addresses by octant: for rays that start inside, and for neighbours of any size
    std::size_t triangles = 0;
    std::size_t boxes = 0;
    [[nodiscard]] std::size_t total() const { return cube_map + leaves + nodes + triangles + boxes; }
};

struct RopeOptions {
    bool is_balanced = true;
    bool has_stored_boxes = true;
};

/// Owns the arrays of a RopeView; leaves in Morton order. Moving it keeps its views.
class RopeOctree {
public:
    RopeOctree() = default;
    /// Links the leaves on the cores of `executor`; the bytes do not depend on them. \throws std::invalid_argument if
    /// `options` asks for a balanced one and neighbours of `tree` differ by more than one level; std::length_error if
    /// the records take more than 8 GiB
    RopeOctree(const Octree& tree, const MeshPart& mesh, const RopeOptions& options, const Executor& executor);

    [[nodiscard]] RopeView view() const;
    /// A view of copies of the arrays, for another memory: first the words, the cube map last. copy: T const* copy(T
    /// const* values, count)
    template <class Copy>
    [[nodiscard]] RopeView copied(const Copy& copy) const {
        RopeView copied = view();
        if (words_.empty()) return copied;
        copied.words = copy(words_.data(), words_.size());
        copied.triangles = copy(triangles_.data(), triangles_.size());
        copied.boxes = boxes_.empty() ? nullptr : copy(boxes_.data(), boxes_.size());
        copied.cube_map = copy(cube_map_.data(), cube_map_.size());
        return copied;
    }
    [[nodiscard]] RopeBytes bytes() const;
    [[nodiscard]] std::size_t leaf_count() const { return leaf_count_; }
    [[nodiscard]] std::size_t neighbour_count() const { return neighbour_count_; }  ///< over all leaves

private:
    RopeView view_ = {};  ///< without its pointers
    std::size_t leaf_count_ = 0, leaf_words_ = 0, neighbour_count_ = 0;
    std::vector<std::uint32_t> words_;
    std::vector<RopeTriangle> triangles_;
    std::vector<RopeBox> boxes_;
    std::vector<RopeAddress> cube_map_;
};

}  // namespace enfilade::accel
