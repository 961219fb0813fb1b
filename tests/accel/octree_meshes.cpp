#include "tests/accel/octree_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "accel/octree/triangle_box.h"

namespace enfilade::test {
namespace {

using accel::Octree;
using accel::OctreeLeaf;

std::string told(const char* what, std::size_t leaf) { return std::string(what) + " at leaf " + std::to_string(leaf); }

std::uint64_t morton(const std::array<std::uint32_t, 3>& cell) {
    std::uint64_t key = 0;
    for (std::uint32_t bit = 0; bit < accel::largest_octree_depth; ++bit)
        for (std::uint32_t k = 0; k < 3; ++k) key |= std::uint64_t{cell[k] >> bit & 1u} << (3 * bit + k);
    return key;
}

std::uint32_t leaf_number(const Octree& tree, const std::array<std::uint32_t, 3>& cell) {
    accel::OctreeEntry entry = tree.root;
    for (std::uint32_t bit = tree.frame.depth; !entry.is_leaf();) {
        --bit;
        const std::uint32_t octant = (cell[0] >> bit & 1u) | (cell[1] >> bit & 1u) << 1 | (cell[2] >> bit & 1u) << 2;
        entry = tree.children.at(std::size_t{8} * entry.number() + octant);
    }
    return entry.number();
}

/// Corners in the lattice, rounded nowhere but in double.
accel::Corners corners_of(const Octree& tree, const accel::MeshPart& mesh, std::uint32_t triangle) {
    accel::Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const accel::Vertex& v = mesh.places[mesh.triangles[triangle].corners[i]];
        const float p[3] = {v.x, v.y, v.z};
        for (std::size_t k = 0; k < 3; ++k)
            corners[i][k] = (double{p[k]} - double{tree.frame.low[k]}) * double{tree.frame.cells_a_unit[k]};
    }
    return corners;
}

/// How far a triangle may be taken to reach: its plane is known as well as float can tell it from its corners, the less
/// the thinner it is; of one without area not at all.
double doubt(const accel::Corners& c) {
    double longest = 0;
    accel::Corners edges;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) edges[i][k] = c[(i + 1) % 3][k] - c[i][k];
        longest = std::max(longest, std::hypot(edges[i][0], edges[i][1], edges[i][2]));
    }
    const double area = std::hypot(edges[0][1] * edges[1][2] - edges[0][2] * edges[1][1],
                                   edges[0][2] * edges[1][0] - edges[0][0] * edges[1][2],
                                   edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0]);
    return 0x1p-20 * longest * longest * longest / area;
}

}  // namespace

void OctreeMesh::add(const Point& a, const Point& b, const Point& c) {
    accel::MeshTriangle triangle = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = i == 0 ? a : i == 1 ? b : c;
        triangle.corners[i] = static_cast<std::uint32_t>(places_.size());
        places_.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
    used_.push_back(static_cast<std::uint32_t>(triangles_.size()));
    triangles_.push_back(triangle);
}

void OctreeMesh::move(double scale, const Point& offset) {
    for (accel::Vertex& v : places_)
        v = {static_cast<float>(scale * double{v.x} + offset[0]), static_cast<float>(scale * double{v.y} + offset[1]),
             static_cast<float>(scale * double{v.z} + offset[2])};
}

void OctreeMesh::use_every(std::uint32_t n) {
    std::erase_if(used_, [&](std::uint32_t t) { return t % n != 0; });
}

OctreeMesh OctreeMesh::sphere(int rings) {
    OctreeMesh mesh;
    const auto at = [&](int ring, int step) {
        const double polar = std::numbers::pi * ring / rings, turn = std::numbers::pi * step / rings;
        return Point{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < 2 * rings; ++step) {
            if (ring > 0) mesh.add(at(ring, step), at(ring + 1, step), at(ring, step + 1));
            if (ring + 1 < rings) mesh.add(at(ring, step + 1), at(ring + 1, step), at(ring + 1, step + 1));
        }
    }
    return mesh;
}

OctreeMesh OctreeMesh::soup(int count, double size) {
    OctreeMesh mesh;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> place(0, 1), away(-size, size);
    for (int i = 0; i < count; ++i) {
        const Point p = {place(random), place(random), place(random)};
        const auto near = [&] { return Point{p[0] + away(random), p[1] + away(random), p[2] + away(random)}; };
        const Point q = near(), r = near();
        mesh.add(p, q, r);
    }
    return mesh;
}

OctreeMesh OctreeMesh::needles(int count) {
    OctreeMesh mesh;
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> place(0, 1);
    for (int i = 0; i < count; ++i) {
        const Point p = {place(random), place(random), place(random)},
                    q = {place(random), place(random), place(random)};
        mesh.add(p, q, {q[0] + 1e-5, q[1], q[2] + 1e-6});
    }
    return mesh;
}

OctreeMesh OctreeMesh::on_one_vertex(int count) {
    OctreeMesh mesh;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int i = 0; i < count; ++i) {
        const Point p = {normal(random), normal(random), normal(random)};
        mesh.add({0, 0, 0}, p, {p[0] + 1e-3, p[1], p[2] - 1e-3});
    }
    return mesh;
}

OctreeMesh OctreeMesh::disc(int count) {
    OctreeMesh mesh;
    const auto at = [&](int i) {
        const double turn = 2 * std::numbers::pi * i / count;
        return Point{std::cos(turn), std::sin(turn), 0};
    };
    for (int i = 0; i < count; ++i) mesh.add({0, 0, 0}, at(i), at(i + 1));
    return mesh;
}

OctreeMesh OctreeMesh::identical(int count) {
    OctreeMesh mesh;
    for (int i = 0; i < count; ++i) mesh.add({0, 0, 0}, {1, 0.9, 1}, {0.1, 1, 0.2});
    return mesh;
}

std::string tree_fault(const Octree& tree) {
    std::uint64_t filled = 0, references = 0;
    for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
        const OctreeLeaf& leaf = tree.leaves[i];
        if (leaf.level > tree.frame.depth) return told("too deep", i);
        for (const std::uint32_t low : leaf.low)
            if (low % tree.width(leaf) != 0) return told("off its place", i);
        if (morton(leaf.low) != filled) return told("a gap or a wrong order", i);
        filled += std::uint64_t{1} << 3 * (tree.frame.depth - leaf.level);
        if (leaf.first != references) return told("references out of order", i);
        references += leaf.count;
        if (references > tree.references.size()) return told("too few references", i);
        for (std::uint32_t j = 1; j < leaf.count; ++j)
            if (tree.references[leaf.first + j - 1] >= tree.references[leaf.first + j]) return told("not ascending", i);
        std::array<std::uint32_t, 3> last = leaf.low;
        for (std::uint32_t& cell : last) cell += tree.width(leaf) - 1;
        if (leaf_number(tree, leaf.low) != i || leaf_number(tree, last) != i) return told("entries lead elsewhere", i);
    }
    if (filled != std::uint64_t{1} << 3 * tree.frame.depth) return "the root is not filled";
    if (references != tree.references.size()) return "references of no leaf";
    if (tree.leaves.size() != tree.children.size() / 8 * 7 + 1) return "nodes out of the tree";
    return {};
}

std::string reference_fault(const Octree& tree, const accel::MeshPart& mesh) {
    std::vector<accel::Corners> corners;
    for (const std::uint32_t t : mesh.used) corners.push_back(corners_of(tree, mesh, t));
    const double slack = accel::octree_slack * tree.frame.side();
    for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
        const OctreeLeaf& leaf = tree.leaves[i];
        const double half = 0.5 * tree.width(leaf);
        const std::array<double, 3> centre = {leaf.low[0] + half, leaf.low[1] + half, leaf.low[2] + half};
        std::size_t listed = 0;
        for (std::size_t t = 0; t < corners.size(); ++t) {
            const bool is_listed =
                listed < leaf.count && tree.references[leaf.first + listed] == mesh.used[t] && ++listed > 0;
            if (!is_listed && accel::triangle_meets_box(corners[t], centre, half + slack))
                return told("a triangle is missing", i);
            const double reach = half + 2 * slack + doubt(corners[t]);
            if (is_listed && std::isfinite(reach) && !accel::triangle_meets_box(corners[t], centre, reach))
                return told("a triangle is listed in vain", i);
        }
        if (listed != leaf.count) return told("references to other triangles", i);
    }
    return {};
}

std::uint32_t level_at(const Octree& tree, const std::array<std::uint32_t, 3>& cell) {
    return tree.leaves.at(leaf_number(tree, cell)).level;
}

std::size_t unbalanced_pairs(const Octree& tree) {
    std::size_t pairs = 0;
    const std::uint32_t side = 1u << tree.frame.depth;
    for (const OctreeLeaf& leaf : tree.leaves) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (const bool is_up : {false, true}) {
                std::array<std::uint32_t, 3> cell = leaf.low;
                if (is_up ? cell[k] + tree.width(leaf) == side : cell[k] == 0) continue;
                cell[k] = is_up ? cell[k] + tree.width(leaf) : cell[k] - 1;
                if (level_at(tree, cell) + 1 < leaf.level) ++pairs;
            }
        }
    }
    return pairs;
}

bool same_trees(const Octree& a, const Octree& b) {
    const auto same_leaves = [](const OctreeLeaf& x, const OctreeLeaf& y) {
        return x.low == y.low && x.level == y.level && x.first == y.first && x.count == y.count;
    };
    return a.frame.low == b.frame.low && a.frame.cells_a_unit == b.frame.cells_a_unit &&
           a.frame.depth == b.frame.depth && a.root == b.root && a.children == b.children &&
           a.references == b.references && std::ranges::equal(a.leaves, b.leaves, same_leaves);
}

}  // namespace enfilade::test
