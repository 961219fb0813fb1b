#include <algorithm>
#include <stdexcept>

#include "accel/octree/exit_boxes.h"
#include "accel/octree/linked_octree.h"
#include "render/cuda/launch.h"
#include "render/cuda/octree_build.h"
#include "render/cuda/scan.h"

namespace enfilade::render::cuda {
namespace {

constexpr std::uint32_t columns = 10;  ///< floats a reference
constexpr std::size_t padding = 16;    ///< floats behind the last

/// Inner nodes below which nodes of the jump table begin: 1 for those, else 0.
struct MarkJumpNodes {
    const std::uint32_t* inner_levels;
    std::uint32_t top;
    std::uint32_t* marks;
    ENFILADE_HD void operator()(std::uint64_t i) const {
        marks[i] = inner_levels[i] >= top && (inner_levels[i] - top) % 2 == 0 ? 1 : 0;
    }
};

/// A tree in jumps.
struct JumpWriter {
    const accel::OctreeEntry* children;
    const accel::OctreeLeaf* leaves;
    const std::uint32_t* ranks;  ///< [inner node]: sums before of MarkJumpNodes
    std::uint32_t depth, top;
    accel::JumpEntry* jumps;

    /// What stands for a cell of `levels` levels below an entry. cell: its octants, the first highest
    [[nodiscard]] ENFILADE_HD accel::JumpEntry entry(accel::OctreeEntry from, std::uint32_t cell,
                                                     std::uint32_t levels) const {
        for (; !from.is_leaf() && levels > 0; --levels)
            from = children[std::size_t{8} * from.number() + (cell >> 3 * (levels - 1) & 7u)];
        if (!from.is_leaf()) return {(1u << 3 * top) + 64 * ranks[from.number()]};
        const std::uint32_t width = depth - leaves[from.number()].level;
        return {accel::JumpEntry::leaf_bit | width << accel::JumpEntry::number_bits | from.number()};
    }
};

struct WriteTop {
    JumpWriter writer;
    accel::OctreeEntry root;
    ENFILADE_HD void operator()(std::uint64_t cell) const {
        writer.jumps[cell] = writer.entry(root, static_cast<std::uint32_t>(cell), writer.top);
    }
};

struct WriteJumpNodes {
    JumpWriter writer;
    const std::uint32_t* marks;
    ENFILADE_HD void operator()(std::uint64_t i) const {
        const auto node = static_cast<std::uint32_t>(i / 64), cell = static_cast<std::uint32_t>(i % 64);
        if (marks[node] == 0) return;
        const std::size_t at = (std::size_t{1} << 3 * writer.top) + 64 * std::size_t{writer.ranks[node]} + cell;
        writer.jumps[at] = writer.entry(accel::OctreeEntry{node}, cell, 2);
    }
};

/// 1 for cells of the grid that leaves with triangles fill, one row and slice on.
struct MarkFullCells {
    const accel::OctreeLeaf* leaves;
    std::uint32_t depth, side, shift;
    std::uint32_t* sums;

    ENFILADE_HD void operator()(const Warp& warp, std::uint64_t i) const {
        const accel::OctreeLeaf& leaf = leaves[i];
        if (leaf.count == 0) return;
        const std::uint32_t wide = (1u << (depth - leaf.level)) >> shift, width = wide > 0 ? wide : 1;
        const std::size_t row = side + 1;
        for (int lane : warp.lanes()) {
            for (std::uint32_t cell = static_cast<std::uint32_t>(lane); cell < width * width * width;
                 cell += warp_size) {
                const std::size_t x = (leaf.low[0] >> shift) + cell % width + 1,
                                  y = (leaf.low[1] >> shift) + cell / width % width + 1,
                                  z = (leaf.low[2] >> shift) + cell / width / width + 1;
                sums[(z * row + y) * row + x] = 1;
            }
        }
    }
};

/// Sums along one axis of the grid.
struct SumAlong {
    std::uint32_t row;
    std::size_t stride;              ///< along the axis
    std::size_t stride_u, stride_v;  ///< along the others
    std::uint32_t* sums;
    ENFILADE_HD void operator()(std::uint64_t line) const {
        std::uint32_t* at = sums + line % row * stride_u + line / row * stride_v;
        std::uint32_t sum = 0;
        for (std::uint32_t k = 0; k < row; ++k, at += stride) *at = sum += *at;
    }
};

struct WriteExits {
    const accel::OctreeLeaf* from;
    std::uint32_t depth;
    accel::FullCellSums cells;
    accel::LinkedLeaf* leaves;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const accel::OctreeLeaf& leaf = from[i / 8];
        const auto octant = static_cast<std::uint32_t>(i % 8);
        const std::uint32_t width = depth - leaf.level, unit = accel::exit_unit(width);
        const std::array<std::uint32_t, 3> extent = accel::exit_extent(leaf.low, 1u << width, cells, octant);
        accel::LinkedLeaf& to = leaves[i / 8];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t units = extent[k] >> unit;
            to.exits[octant][k] = static_cast<std::uint8_t>(units < 255 ? units : 255);
        }
        if (octant != 0) return;
        to.first = columns * leaf.first;
        to.count = leaf.count;
    }
};

struct WriteColumns {
    const accel::OctreeLeaf* leaves;
    const std::uint32_t* references;
    const accel::Vertex* places;
    const accel::MeshTriangle* triangles;
    float* corners;

    ENFILADE_HD void operator()(const Warp& warp, std::uint64_t i) const {
        const accel::OctreeLeaf& leaf = leaves[i];
        const std::size_t n = leaf.count;
        for (int lane : warp.lanes()) {
            for (std::uint32_t j = static_cast<std::uint32_t>(lane); j < leaf.count; j += warp_size) {
                const std::uint32_t number = references[leaf.first + j];
                float* to = corners + columns * std::size_t{leaf.first} + j;
                for (std::size_t c = 0; c < 3; ++c) {
                    const accel::Vertex& v = places[triangles[number].corners[c]];
                    to[3 * c * n] = v.x;
                    to[(3 * c + 1) * n] = v.y;
                    to[(3 * c + 2) * n] = v.z;
                }
                to[9 * n] = float_of(number);
            }
        }
    }
};

void link_jumps(Device& device, const OctreeOnDevice& tree, std::uint32_t most_levels, OctreeArrays& arrays) {
    const std::size_t inner = tree.inner_levels.size();
    const std::uint32_t top = accel::jump_levels_for(tree.frame.depth, tree.leaves.size(), most_levels);
    Buffer<std::uint32_t> marks(device, inner + 1), ranks(device, inner + 1);
    marks.clear();
    for_each(device, inner, MarkJumpNodes{tree.inner_levels.data(), top, marks.data()});
    Scanner(device).sums_before(marks.data(), ranks.data(), inner + 1);
    std::uint32_t nodes = 0;
    device.download(&nodes, ranks.data() + inner, sizeof nodes);
    const std::size_t cells = std::size_t{1} << 3 * top;
    arrays.jumps = Buffer<accel::JumpEntry>(device, cells + 64 * std::size_t{nodes});
    const JumpWriter writer = {tree.children.data(), tree.leaves.data(), ranks.data(), tree.frame.depth, top,
                               arrays.jumps.data()};
    for_each(device, cells, WriteTop{writer, tree.root});
    for_each(device, 64 * inner, WriteJumpNodes{writer, marks.data()});
    arrays.view.jumps = arrays.jumps.data();
    arrays.view.jump_levels = top;
    device.wait();
}

void link_leaves(Device& device, const OctreeOnDevice& tree, OctreeArrays& arrays) {
    const std::uint32_t depth = tree.frame.depth, levels = accel::exit_grid_levels(depth, tree.leaves.size());
    const std::uint32_t side = 1u << levels, row = side + 1;
    const std::size_t slice = std::size_t{row} * row;
    Buffer<std::uint32_t> sums(device, slice * row);
    sums.clear();
    for_each_warp(device, tree.leaves.size(),
                  MarkFullCells{tree.leaves.data(), depth, side, depth - levels, sums.data()});
    for_each(device, slice, SumAlong{row, 1, row, slice, sums.data()});
    for_each(device, slice, SumAlong{row, row, 1, slice, sums.data()});
    for_each(device, slice, SumAlong{row, slice, 1, row, sums.data()});
    arrays.leaves = Buffer<accel::LinkedLeaf>(device, tree.leaves.size());
    for_each(device, 8 * tree.leaves.size(),
             WriteExits{tree.leaves.data(), depth, {side, depth - levels, sums.data()}, arrays.leaves.data()});
    arrays.view.leaves = arrays.leaves.data();
    device.wait();
}

}  // namespace

OctreeArrays link_octree_on(Device& device, const OctreeOnDevice& tree, const MeshOnDevice& mesh,
                            std::uint32_t most_jump_levels) {
    OctreeArrays arrays;
    if (tree.references.size() == 0) return arrays;
    if (tree.leaves.size() > accel::JumpEntry::most_leaves)
        throw std::length_error("an octree of more than 2^26 leaves");
    arrays.references = tree.references.size();
    arrays.view.frame = tree.frame;
    arrays.view.root = tree.root;
    std::ranges::copy(tree.low, arrays.view.low);
    std::ranges::copy(tree.high, arrays.view.high);
    arrays.view.box = accel::lattice_box(tree.frame, arrays.view.low, arrays.view.high);
    link_jumps(device, tree, most_jump_levels, arrays);
    link_leaves(device, tree, arrays);
    arrays.corners = Buffer<float>(device, columns * tree.references.size() + padding);
    arrays.corners.clear();
    for_each_warp(device, tree.leaves.size(),
                  WriteColumns{tree.leaves.data(), tree.references.data(), mesh.places.data(), mesh.triangles.data(),
                               arrays.corners.data()});
    arrays.view.corners = arrays.corners.data();
    device.wait();
    return arrays;
}

}  // namespace enfilade::render::cuda
