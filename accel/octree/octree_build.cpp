// Top down: a node with too many triangles hands to each of its eighths those that meet it.

#include <algorithm>
#include <bit>
#include <limits>

#include "accel/octree/octree.h"
#include "accel/octree/triangle_box.h"

namespace enfilade::accel {
namespace {

/// The cube about the used triangles, a little wider.
OctreeFrame frame_of(const MeshPart& mesh, const OctreeOptions& options) {
    constexpr float far = std::numeric_limits<float>::max();
    std::array<float, 3> low = {far, far, far}, high = {-far, -far, -far};
    for (const std::uint32_t t : mesh.used) {
        for (const std::uint32_t corner : mesh.triangles[t].corners) {
            const Vertex& v = mesh.places[corner];
            const std::array<float, 3> p = {v.x, v.y, v.z};
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], p[k]);
                high[k] = std::max(high[k], p[k]);
            }
        }
    }
    OctreeFrame frame;
    const double triangles_a_cell = 8;
    const double across = std::sqrt(static_cast<double>(mesh.used.size()) / (5 * triangles_a_cell));
    const auto by_size = static_cast<std::uint32_t>(std::max(1.0, std::ceil(std::log2(std::max(1.0, across)))));
    frame.depth = std::min(largest_octree_depth, options.depth == OctreeOptions::automatic ? by_size : options.depth);
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, double{high[k]} - low[k]);
    const double widened = size * (1 + 0x1p-20);
    for (std::size_t k = 0; k < 3; ++k) {
        frame.low[k] = low[k];
        frame.cells_a_unit[k] = widened > 0 ? static_cast<float>(double{frame.side()} / widened) : 1.0f;
    }
    return frame;
}

class Builder {
public:
    Builder(const MeshPart& mesh, const OctreeOptions& options, Octree& tree)
        : options_(options), tree_(tree), slack_(octree_slack * tree.frame.side()) {
        corners_.reserve(mesh.used.size());
        for (const std::uint32_t t : mesh.used) {
            Corners c;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vertex& v = mesh.places[mesh.triangles[t].corners[i]];
                const std::array<float, 3> p = {v.x, v.y, v.z};
                for (std::size_t k = 0; k < 3; ++k)
                    c[i][k] = (double{p[k]} - tree.frame.low[k]) * double{tree.frame.cells_a_unit[k]};
            }
            corners_.push_back(c);
        }
        names_ = mesh.used;
    }

    OctreeEntry build(const std::array<std::uint32_t, 3>& low, std::uint32_t level,
                      const std::vector<std::uint32_t>& here) {
        if (here.size() <= options_.leaf_size || level == tree_.frame.depth) return add_leaf(low, level, here);
        const std::uint32_t half = 1u << (tree_.frame.depth - level - 1);
        std::array<std::vector<std::uint32_t>, 8> parts;
        std::size_t sum = 0;
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            std::array<double, 3> centre;
            for (std::size_t k = 0; k < 3; ++k) centre[k] = corner_of(low, half, octant)[k] + 0.5 * half;
            for (const std::uint32_t i : here)
                if (triangle_meets_box(corners_[i], centre, 0.5 * half + slack_)) parts[octant].push_back(i);
            sum += parts[octant].size();
        }
        if (sum > 5 * here.size()) return add_leaf(low, level, here);
        const auto number = static_cast<std::uint32_t>(tree_.children.size() / 8);
        tree_.children.resize(tree_.children.size() + 8);
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            const OctreeEntry child = build(corner_of(low, half, octant), level + 1, parts[octant]);
            tree_.children[std::size_t{8} * number + octant] = child;
        }
        return OctreeEntry::inner(number);
    }

private:
    static std::array<std::uint32_t, 3> corner_of(std::array<std::uint32_t, 3> low, std::uint32_t half,
                                                  std::uint32_t octant) {
        for (std::uint32_t k = 0; k < 3; ++k) low[k] += (octant >> k & 1u) * half;
        return low;
    }

    OctreeEntry add_leaf(const std::array<std::uint32_t, 3>& low, std::uint32_t level,
                         const std::vector<std::uint32_t>& here) {
        tree_.leaves.push_back(
            {low, level, static_cast<std::uint32_t>(tree_.references.size()), static_cast<std::uint32_t>(here.size())});
        for (const std::uint32_t i : here) tree_.references.push_back(names_[i]);
        return OctreeEntry::leaf(static_cast<std::uint32_t>(tree_.leaves.size() - 1));
    }

    OctreeOptions options_;
    Octree& tree_;
    double slack_;
    std::vector<Corners> corners_;  ///< of used triangles, in the lattice
    std::span<const std::uint32_t> names_;
};

}  // namespace

Octree build_octree(const MeshPart& mesh, const OctreeOptions& options, const Executor&) {
    Octree tree;
    if (mesh.used.empty()) return tree;
    tree.frame = frame_of(mesh, options);
    Builder builder(mesh, options, tree);
    std::vector<std::uint32_t> all(mesh.used.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    tree.root = builder.build({0, 0, 0}, 0, all);
    return tree;
}

}  // namespace enfilade::accel
