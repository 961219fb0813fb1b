#include "tools/deep_octree.h"

#include <algorithm>
#include <vector>

#include "accel/octree/triangle_box.h"

namespace enfilade::tools {
namespace {

using accel::OctreeEntry;
using Cell = std::array<std::uint32_t, 3>;

class Splitter {
public:
    Splitter(const accel::MeshPart& mesh, const DeepOctreeOptions& options, accel::Octree& tree)
        : mesh_(mesh), options_(options), tree_(tree), slack_(accel::octree_slack * double{tree.frame.side()}) {}

    OctreeEntry build(const Cell& low, std::uint32_t level, const std::vector<std::uint32_t>& triangles,
                      const std::vector<std::array<double, 3>>& points) {
        const std::uint32_t width = 1u << (tree_.frame.depth - level);
        if (points.empty() || level == tree_.frame.depth) {
            const auto first = static_cast<std::uint32_t>(tree_.references.size());
            tree_.leaves.push_back({low, level, first, static_cast<std::uint32_t>(triangles.size())});
            tree_.references.insert(tree_.references.end(), triangles.begin(), triangles.end());
            return OctreeEntry::leaf(static_cast<std::uint32_t>(tree_.leaves.size() - 1));
        }
        const auto number = static_cast<std::uint32_t>(tree_.children.size() / 8);
        tree_.children.resize(tree_.children.size() + 8);
        const std::uint32_t half = width / 2;
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            Cell corner = low;
            for (std::uint32_t k = 0; k < 3; ++k) corner[k] += (octant >> k & 1u) * half;
            std::vector<std::uint32_t> inside;
            for (const std::uint32_t t : triangles)
                if (meets(t, corner, half)) inside.push_back(t);
            std::vector<std::array<double, 3>> near;
            for (const auto& p : points)
                if (is_near(p, corner, half)) near.push_back(p);
            const OctreeEntry child = build(corner, level + 1, inside, near);
            tree_.children[std::size_t{8} * number + octant] = child;
        }
        return OctreeEntry::inner(number);
    }

private:
    [[nodiscard]] bool is_near(const std::array<double, 3>& p, const Cell& low, std::uint32_t width) const {
        const double reach = options_.is_balanced ? width : 0;
        for (std::size_t k = 0; k < 3; ++k)
            if (!(p[k] >= low[k] - reach && p[k] < (low[k] + width) + reach)) return false;
        return true;
    }

    [[nodiscard]] bool meets(std::uint32_t t, const Cell& low, std::uint32_t width) const {
        accel::Corners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const accel::Vertex& v = mesh_.places[mesh_.triangles[t].corners[i]];
            const std::array<float, 3> p = {v.x, v.y, v.z};
            for (std::size_t k = 0; k < 3; ++k)
                corners[i][k] = (double{p[k]} - tree_.frame.low[k]) * double{tree_.frame.cells_a_unit[k]};
        }
        const double half = 0.5 * width;
        return accel::triangle_meets_box(corners, {low[0] + half, low[1] + half, low[2] + half}, half + slack_);
    }

    const accel::MeshPart& mesh_;
    const DeepOctreeOptions& options_;
    accel::Octree& tree_;
    double slack_;
};

}  // namespace

accel::Octree deep_octree(const accel::MeshPart& mesh, const DeepOctreeOptions& options) {
    accel::Octree tree;
    tree.frame = options.frame;
    Splitter splitter(mesh, options, tree);
    tree.root = splitter.build({0, 0, 0}, 0, {mesh.used.begin(), mesh.used.end()},
                               {options.about.begin(), options.about.end()});
    return tree;
}

}  // namespace enfilade::tools
