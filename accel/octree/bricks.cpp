#include "accel/octree/bricks.h"

#include <algorithm>
#include <bit>

#include "accel/octree/lattice_triangles.h"

namespace enfilade::accel {
namespace {

/// Which of a leaf's eighths its triangles meet, for leaves that are two cells wide. [leaf]
std::vector<std::uint8_t> full_octants(const Octree& tree, const MeshPart& mesh, const Executor& executor) {
    OctreeFrame finer = tree.frame;  // smallest cells have eighths, too
    ++finer.depth;
    for (float& cells : finer.cells_a_unit) cells *= 2;
    const detail::LatticeTriangles triangles(mesh, finer, executor);
    std::vector<std::uint32_t> place(mesh.used.empty() ? 0 : mesh.used.back() + std::size_t{1}, 0);  // among the used
    for (std::uint32_t i = 0; i < mesh.used.size(); ++i) place[mesh.used[i]] = i;
    std::vector<std::uint8_t> full(tree.leaves.size(), 0xff);
    parallel_for(executor, tree.leaves.size(), 1024, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> listed;
        std::vector<std::uint8_t> octants;
        for (std::size_t i = begin; i < end; ++i) {
            const OctreeLeaf& leaf = tree.leaves[i];
            if (leaf.level % 2 == 0 || leaf.count == 0) continue;
            listed.clear();
            for (std::uint32_t k = 0; k < leaf.count; ++k) listed.push_back(place[tree.references[leaf.first + k]]);
            octants.resize(listed.size());
            triangles.find_octants({{2 * leaf.low[0], 2 * leaf.low[1], 2 * leaf.low[2]}, leaf.level}, listed,
                                   octants.data());
            std::uint8_t met = 0;
            for (const std::uint8_t some : octants) met = static_cast<std::uint8_t>(met | some);
            full[i] = met;
        }
    });
    return full;
}

/// The bit of a brick's cell: octant `above` of the brick, octant `below` of that.
constexpr std::uint32_t cell_bit(std::uint32_t above, std::uint32_t below) {
    std::uint32_t bit = 0;
    for (std::uint32_t k = 0; k < 3; ++k) bit |= (2 * (above >> k & 1u) + (below >> k & 1u)) << 2 * k;
    return bit;
}

std::uint64_t mirrored(std::uint64_t mask, std::uint32_t axes) {
    std::uint64_t moved = 0;
    for (; mask != 0; mask &= mask - 1)
        moved |= std::uint64_t{1} << (static_cast<std::uint32_t>(std::countr_zero(mask)) ^ brick_mirror(axes));
    return moved;
}

class BrickLayer {
public:
    BrickLayer(const Octree& tree, const std::vector<std::uint8_t>& full, std::uint32_t floats_a_reference,
               Bricks& bricks)
        : tree_(tree), full_(full), floats_(floats_a_reference), bricks_(bricks) {}

    /// A brick for a node, and those below it.
    void lay(OctreeEntry node) {
        const std::size_t number = bricks_.masks.size();
        bricks_.masks.emplace_back();
        bricks_.first.push_back(static_cast<std::uint32_t>(bricks_.entries.size()));
        const std::array<OctreeEntry, 64> cells = cells_of(node);
        std::uint64_t mask = 0;
        std::array<OctreeEntry, 64> inner;  // that get bricks of their own
        std::size_t inner_count = 0;
        for (std::uint32_t bit = 0; bit < 64; ++bit) {
            if (is_empty_[bit]) continue;
            mask |= std::uint64_t{1} << bit;
            bricks_.entries.push_back(entry_of(cells[bit]));
            if (!cells[bit].is_leaf()) inner[inner_count++] = cells[bit];
        }
        for (std::uint32_t axes = 0; axes < 8; ++axes) bricks_.masks[number].mirrored[axes] = mirrored(mask, axes);
        std::size_t at = bricks_.first[number];
        for (std::size_t i = 0; i < inner_count; ++i, ++at) {
            while (bricks_.entries[at].is_leaf()) ++at;
            bricks_.entries[at] = BrickEntry::to_brick(static_cast<std::uint32_t>(bricks_.masks.size()));
            lay(inner[i]);
        }
    }

private:
    /// What is in each cell of a brick; is_empty_ tells where nothing is.
    std::array<OctreeEntry, 64> cells_of(OctreeEntry node) {
        std::array<OctreeEntry, 64> cells;
        for (std::uint32_t above = 0; above < 8; ++above) {
            const OctreeEntry half = node.is_leaf() ? node : tree_.children[std::size_t{8} * node.number() + above];
            for (std::uint32_t below = 0; below < 8; ++below) {
                const std::uint32_t bit = cell_bit(above, below);
                cells[bit] = half.is_leaf() ? half : tree_.children[std::size_t{8} * half.number() + below];
                is_empty_[bit] =
                    cells[bit].is_leaf() && (tree_.leaves[cells[bit].number()].count == 0 ||
                                             (half.is_leaf() && (full_[half.number()] >> below & 1u) == 0));
            }
        }
        return cells;
    }

    [[nodiscard]] BrickEntry entry_of(OctreeEntry cell) const {
        if (!cell.is_leaf()) return BrickEntry::to_brick(0);
        const OctreeLeaf& leaf = tree_.leaves[cell.number()];
        return BrickEntry::leaf(floats_ * leaf.first, leaf.count);
    }

    const Octree& tree_;
    const std::vector<std::uint8_t>& full_;
    std::uint32_t floats_;
    Bricks& bricks_;
    std::array<bool, 64> is_empty_ = {};
};

}  // namespace

Bricks build_bricks(const Octree& tree, const MeshPart& mesh, std::uint32_t floats_a_reference,
                    const Executor& executor) {
    Bricks bricks;
    BrickLayer(tree, full_octants(tree, mesh, executor), floats_a_reference, bricks).lay(tree.root);
    return bricks;
}

}  // namespace enfilade::accel
