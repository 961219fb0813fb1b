// Top down. Large nodes are split level by level, all cores at each; what is below smaller ones is built by one core
// each and put together in Morton order.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "accel/octree/lattice_triangles.h"
#include "accel/octree/octree.h"
#include "accel/octree/octree_balance.h"
#include "accel/octree/octree_split.h"
#include "accel/octree/subtree.h"

namespace enfilade::accel {
namespace detail {
namespace {

/// Triangles of a large node that one core asks for their octants at once.
constexpr std::size_t grain = 4096;

constexpr std::uint32_t none = 0xffffffffu;

/// A node near the root, where all cores share the work.
struct UpperNode {
    OctreeNode node;
    std::uint64_t budget;
    std::vector<std::uint32_t> listed;  ///< until it is split
    std::uint32_t octants = none;       ///< the first of its eight
    Subtree subtree;                    ///< where it has no octants here

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(listed.size()); }
};

/// A part of a large node's triangles.
struct Piece {
    std::uint32_t node;
    std::span<const std::uint32_t> listed;
    OctantTriangles found;
    std::array<std::size_t, 8> places;  ///< where in the lists of the octants it writes
};

class Builder {
public:
    Builder(const LatticeTriangles& triangles, const SplitRule& rule, const Executor& executor)
        : triangles_(triangles), rule_(rule), executor_(executor) {}

    /// References are places in MeshPart::used.
    Octree build() {
        UpperNode root = {{}, SplitRule::budget(triangles_.size())};
        root.listed.resize(triangles_.size());
        std::iota(root.listed.begin(), root.listed.end(), 0u);
        nodes_.push_back(std::move(root));
        for (std::size_t first = 0, last = 0; last < nodes_.size(); first = last) {
            last = nodes_.size();
            split_large(first, last);
        }
        build_subtrees();
        tree_.frame = triangles_.frame();
        tree_.root = put_together(0);
        fill();
        return std::move(tree_);
    }

private:
    /// Splits the large ones of the nodes [first, last), which are of one level.
    void split_large(std::size_t first, std::size_t last) {
        std::vector<Piece> pieces;
        for (std::size_t i = first; i < last; ++i) {
            const UpperNode& node = nodes_[i];
            if (!SplitRule::is_large(node.count()) || !rule_.may_split(node.count(), node.node.level)) continue;
            for (std::size_t at = 0; at < node.listed.size(); at += grain)
                pieces.push_back({static_cast<std::uint32_t>(i),
                                  std::span(node.listed).subspan(at, std::min(grain, node.listed.size() - at)),
                                  {},
                                  {}});
        }
        executor_.run(pieces.size(), [&](std::size_t p) {
            pieces[p].found.find(triangles_, nodes_[pieces[p].node].node, pieces[p].listed);
        });
        for (std::size_t p = 0; p < pieces.size();) {
            std::size_t end = p;
            while (end < pieces.size() && pieces[end].node == pieces[p].node) ++end;
            add_octants(pieces[p].node, std::span(pieces).subspan(p, end - p));
            p = end;
        }
        executor_.run(pieces.size(), [&](std::size_t p) {
            const std::uint32_t octants = nodes_[pieces[p].node].octants;
            if (octants == none) return;
            std::array<std::uint32_t*, 8> to;
            for (std::size_t i = 0; i < 8; ++i) to[i] = nodes_[octants + i].listed.data() + pieces[p].places[i];
            pieces[p].found.write(pieces[p].listed, to);
        });
        for (std::size_t i = first; i < last; ++i)
            if (nodes_[i].octants != none) std::vector<std::uint32_t>().swap(nodes_[i].listed);
    }

    void add_octants(std::uint32_t number, std::span<Piece> pieces) {
        OctantCounts counts = {};
        for (Piece& piece : pieces) {
            for (std::size_t i = 0; i < 8; ++i) {
                piece.places[i] = counts[i];
                counts[i] += piece.found.counts[i];
            }
        }
        const OctreeNode node = nodes_[number].node;
        const std::uint64_t budget = nodes_[number].budget;
        if (!rule_.tries(nodes_[number].count(), budget, counts)) return;
        nodes_[number].octants = static_cast<std::uint32_t>(nodes_.size());
        const std::array<std::uint64_t, 8> budgets = SplitRule::shares(budget, counts);
        for (std::uint32_t i = 0; i < 8; ++i) {
            nodes_.push_back({node.octant(i, triangles_.frame().depth), budgets[i]});
            nodes_.back().listed.resize(counts[i]);
        }
    }

    void build_subtrees() {
        std::vector<UpperNode*> tasks;
        for (UpperNode& node : nodes_)
            if (node.octants == none) tasks.push_back(&node);
        executor_.run(tasks.size(), [&](std::size_t t) {
            UpperNode& task = *tasks[t];
            task.subtree = build_subtree(triangles_, rule_, task.node, std::move(task.listed), task.budget);
        });
    }

    /// A subtree and where it stands in the tree.
    struct Part {
        const Subtree* subtree;
        std::size_t child, leaf, reference;
    };

    OctreeEntry put_together(std::uint32_t number) {
        const UpperNode& node = nodes_[number];
        const std::size_t child = tree_.children.size(), leaf = tree_.leaves.size();
        if (node.octants != none) {
            tree_.children.resize(child + 8);
            for (std::uint32_t i = 0; i < 8; ++i) {
                const OctreeEntry octant = put_together(node.octants + i);
                tree_.children[child + i] = octant;
            }
            return OctreeEntry::inner(static_cast<std::uint32_t>(child / 8));
        }
        const Subtree& subtree = node.subtree;
        parts_.push_back({&subtree, child, leaf, references_});
        tree_.children.resize(child + subtree.children.size());
        tree_.leaves.resize(leaf + subtree.leaves.size());
        references_ += subtree.references.size();
        return moved(subtree.root, child, leaf);
    }

    static OctreeEntry moved(OctreeEntry entry, std::size_t child, std::size_t leaf) {
        return entry.is_leaf() ? OctreeEntry::leaf(static_cast<std::uint32_t>(entry.number() + leaf))
                               : OctreeEntry::inner(static_cast<std::uint32_t>(entry.number() + child / 8));
    }

    void fill() {
        tree_.references.resize(references_);
        executor_.run(parts_.size(), [&](std::size_t p) {
            const Part& part = parts_[p];
            const Subtree& from = *part.subtree;
            std::ranges::copy(from.references, tree_.references.begin() + static_cast<std::ptrdiff_t>(part.reference));
            for (std::size_t i = 0; i < from.children.size(); ++i)
                tree_.children[part.child + i] = moved(from.children[i], part.child, part.leaf);
            for (std::size_t i = 0; i < from.leaves.size(); ++i) {
                OctreeLeaf leaf = from.leaves[i];
                leaf.first += static_cast<std::uint32_t>(part.reference);
                tree_.leaves[part.leaf + i] = leaf;
            }
        });
    }

    const LatticeTriangles& triangles_;
    SplitRule rule_;
    const Executor& executor_;
    std::vector<UpperNode> nodes_;
    std::vector<Part> parts_;
    std::size_t references_ = 0;
    Octree tree_;
};

std::uint32_t deepest_level(const Octree& tree) {
    std::uint32_t deepest = 0;
    for (const OctreeLeaf& leaf : tree.leaves) deepest = std::max(deepest, leaf.level);
    return deepest;
}

/// Balancing splits leaves of any size: where that is more than what a tree may have, the tree is built less deep.
Octree build_balanced(const LatticeTriangles& triangles, const OctreeOptions& options, const Executor& executor) {
    std::uint32_t deepest = triangles.frame().depth;
    while (true) {
        Octree tree = Builder(triangles, {options, deepest, triangles.size()}, executor).build();
        const std::uint32_t level = deepest_level(tree);
        if (balance_octree(tree, triangles, SplitRule::budget(triangles.size()))) return tree;
        deepest = level - 1;
    }
}

/// Makes the smallest cell as large as the smallest leaf: the same tree, in another unit.
void use_largest_cells(Octree& tree) {
    const std::uint32_t unused = tree.frame.depth - deepest_level(tree);
    for (float& cells : tree.frame.cells_a_unit) cells = std::ldexp(cells, -static_cast<int>(unused));
    for (OctreeLeaf& leaf : tree.leaves)
        for (std::uint32_t& low : leaf.low) low >>= unused;
    tree.frame.depth -= unused;
}

}  // namespace
}  // namespace detail

Octree build_octree(const MeshPart& mesh, const OctreeOptions& options, const Executor& executor) {
    if (mesh.used.empty()) return {};
    const detail::LatticeTriangles triangles(mesh, options, executor);
    Octree tree =
        options.is_balanced
            ? detail::build_balanced(triangles, options, executor)
            : detail::Builder(triangles, {options, triangles.frame().depth, triangles.size()}, executor).build();
    if (options.depth == OctreeOptions::automatic) detail::use_largest_cells(tree);
    parallel_for(executor, tree.references.size(), std::size_t{1} << 18, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) tree.references[i] = mesh.used[tree.references[i]];
    });
    return tree;
}

}  // namespace enfilade::accel
