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

/// Nodes with no more triangles are built by one core. Trees do not depend on it.
constexpr std::uint32_t small_node = 4096;
/// Triangles of a large node that one core asks for their octants at once.
constexpr std::size_t grain = 4096;

constexpr std::uint32_t none = 0xffffffffu;

/// A node of the levels that all cores share.
struct UpperNode {
    OctreeNode node;
    std::size_t begin, end;  ///< of its triangles, in its level's lists
    std::uint64_t budget;
    std::uint32_t octants = none;  ///< the first of its eight in the next level
    std::uint32_t subtree = none;
    double cost = 0;

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(end - begin); }
};

struct UpperLevel {
    std::vector<UpperNode> nodes;
    std::vector<std::uint32_t> lists;
};

/// A part of a large node's triangles.
struct Piece {
    std::uint32_t node;
    std::size_t begin, end;
    OctantTriangles found;
};

class Builder {
public:
    Builder(const LatticeTriangles& triangles, const SplitRule& rule, const Executor& executor)
        : triangles_(triangles), rule_(rule), executor_(executor) {}

    /// References are places in MeshPart::used.
    Octree build() {
        UpperLevel first;
        first.lists.resize(triangles_.size());
        std::iota(first.lists.begin(), first.lists.end(), 0u);
        first.nodes.push_back({{}, 0, triangles_.size(), SplitRule::budget(triangles_.size())});
        for (levels_.push_back(std::move(first)); !levels_.back().nodes.empty();) levels_.push_back(next_level());
        build_subtrees();
        choose();
        tree_.frame = triangles_.frame();
        tree_.root = put_together(0, 0);
        fill();
        return std::move(tree_);
    }

private:
    [[nodiscard]] static bool is_large(const UpperNode& node) { return node.count() > small_node; }

    /// Splits the large nodes of the last level.
    UpperLevel next_level() {
        UpperLevel& here = levels_.back();
        std::vector<Piece> pieces;
        for (std::uint32_t i = 0; i < here.nodes.size(); ++i) {
            const UpperNode& node = here.nodes[i];
            if (!is_large(node) || !rule_.may_split(node.count(), node.node.level)) continue;
            for (std::size_t at = node.begin; at < node.end; at += grain)
                pieces.push_back({i, at, std::min(node.end, at + grain), {}});
        }
        executor_.run(pieces.size(), [&](std::size_t p) {
            Piece& piece = pieces[p];
            piece.found.find(triangles_, here.nodes[piece.node].node, listed(here, piece.begin, piece.end));
        });
        UpperLevel next;
        std::vector<std::array<std::size_t, 8>> ends(pieces.size());  // where each piece writes
        for (std::size_t p = 0; p < pieces.size();) {
            std::size_t last = p;
            while (last < pieces.size() && pieces[last].node == pieces[p].node) ++last;
            add_octants(here.nodes[pieces[p].node], {pieces.data() + p, last - p}, ends.data() + p, next);
            p = last;
        }
        executor_.run(pieces.size(), [&](std::size_t p) {
            const Piece& piece = pieces[p];
            if (here.nodes[piece.node].octants != none)
                piece.found.write(listed(here, piece.begin, piece.end), next.lists.data(), ends[p]);
        });
        return next;
    }

    static std::span<const std::uint32_t> listed(const UpperLevel& level, std::size_t begin, std::size_t end) {
        return {level.lists.data() + begin, end - begin};
    }

    void add_octants(UpperNode& node, std::span<const Piece> pieces, std::array<std::size_t, 8>* places,
                     UpperLevel& next) const {
        OctantCounts counts = {};
        for (const Piece& piece : pieces)
            for (std::size_t i = 0; i < 8; ++i) counts[i] += piece.found.counts[i];
        if (!rule_.tries(node.count(), node.budget, counts)) return;
        node.octants = static_cast<std::uint32_t>(next.nodes.size());
        const std::array<std::uint64_t, 8> budgets = SplitRule::shares(node.budget, counts);
        for (std::uint32_t i = 0; i < 8; ++i) {
            const std::size_t begin = next.lists.size();
            std::size_t at = begin;
            for (std::size_t p = 0; p < pieces.size(); ++p) {
                places[p][i] = at;
                at += pieces[p].found.counts[i];
            }
            next.nodes.push_back({node.node.octant(i, triangles_.frame().depth), begin, at, budgets[i]});
            next.lists.resize(at);
        }
    }

    void build_subtrees() {
        struct Task {
            const UpperLevel* level;
            const UpperNode* node;
        };
        std::vector<Task> tasks;
        for (UpperLevel& level : levels_) {
            for (UpperNode& node : level.nodes) {
                if (is_large(node)) continue;
                node.subtree = static_cast<std::uint32_t>(tasks.size());
                tasks.push_back({&level, &node});
            }
        }
        subtrees_.resize(tasks.size());
        executor_.run(tasks.size(), [&](std::size_t t) {
            const UpperNode& node = *tasks[t].node;
            subtrees_[t] =
                build_subtree(triangles_, rule_, node.node, listed(*tasks[t].level, node.begin, node.end), node.budget);
        });
    }

    /// Bottom up: which of the large nodes stay split.
    void choose() {
        for (std::size_t l = levels_.size(); l-- > 0;) {
            for (UpperNode& node : levels_[l].nodes) {
                node.cost = node.subtree != none ? subtrees_[node.subtree].cost : rule_.cost_of_leaf(node.count());
                if (node.octants == none) continue;
                double cost = 0;
                for (std::uint32_t i = 0; i < 8; ++i)
                    cost += SplitRule::crossed * levels_[l + 1].nodes[node.octants + i].cost;
                if (rule_.keeps_split(node.count(), cost)) {
                    node.cost = cost;
                } else {
                    node.octants = none;
                }
            }
        }
    }

    /// Leaves and references that stand together in the tree, and where.
    struct Part {
        const Subtree* subtree;  ///< nullptr: a large node that is a leaf, with these references
        std::span<const std::uint32_t> references;
        std::size_t child, leaf, reference;
    };

    OctreeEntry put_together(std::size_t l, std::uint32_t number) {
        const UpperNode& node = levels_[l].nodes[number];
        const std::size_t child = tree_.children.size(), leaf = tree_.leaves.size();
        if (node.octants != none) {
            tree_.children.resize(child + 8);
            for (std::uint32_t i = 0; i < 8; ++i) {
                const OctreeEntry octant = put_together(l + 1, node.octants + i);
                tree_.children[child + i] = octant;
            }
            return OctreeEntry::inner(static_cast<std::uint32_t>(child / 8));
        }
        if (node.subtree == none) {
            const auto first = static_cast<std::uint32_t>(references_);
            tree_.leaves.push_back({node.node.low, node.node.level, first, node.count()});
            parts_.push_back({nullptr, listed(levels_[l], node.begin, node.end), child, leaf, references_});
            references_ += node.count();
            return OctreeEntry::leaf(static_cast<std::uint32_t>(leaf));
        }
        const Subtree& subtree = subtrees_[node.subtree];
        parts_.push_back({&subtree, subtree.references, child, leaf, references_});
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
            std::ranges::copy(part.references, tree_.references.begin() + static_cast<std::ptrdiff_t>(part.reference));
            if (part.subtree == nullptr) return;
            for (std::size_t i = 0; i < part.subtree->children.size(); ++i)
                tree_.children[part.child + i] = moved(part.subtree->children[i], part.child, part.leaf);
            for (std::size_t i = 0; i < part.subtree->leaves.size(); ++i) {
                OctreeLeaf leaf = part.subtree->leaves[i];
                leaf.first += static_cast<std::uint32_t>(part.reference);
                tree_.leaves[part.leaf + i] = leaf;
            }
        });
    }

    const LatticeTriangles& triangles_;
    SplitRule rule_;
    const Executor& executor_;
    std::vector<UpperLevel> levels_;
    std::vector<Subtree> subtrees_;
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
        Octree tree = Builder(triangles, {options, deepest}, executor).build();
        balance_octree(tree, triangles);
        if (tree.leaves.size() + tree.references.size() <= SplitRule::budget(triangles.size())) return tree;
        deepest = deepest_level(tree) - 1;
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
    Octree tree = options.is_balanced
                      ? detail::build_balanced(triangles, options, executor)
                      : detail::Builder(triangles, {options, triangles.frame().depth}, executor).build();
    if (options.depth == OctreeOptions::automatic) detail::use_largest_cells(tree);
    parallel_for(executor, tree.references.size(), std::size_t{1} << 18, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) tree.references[i] = mesh.used[tree.references[i]];
    });
    return tree;
}

}  // namespace enfilade::accel
