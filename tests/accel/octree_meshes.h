#pragma once
// Meshes for octrees, and what every octree over one has to be.

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::test {

/// Triangles by their corners, all used.
class OctreeMesh {
public:
    using Point = std::array<double, 3>;
    void add(const Point& a, const Point& b, const Point& c);
    /// p -> scale p + offset, in float.
    void move(double scale, const Point& offset);
    [[nodiscard]] accel::MeshPart part() const { return {places_.data(), triangles_.data(), used_}; }
    [[nodiscard]] std::size_t size() const { return used_.size(); }
    [[nodiscard]] std::size_t all() const { return triangles_.size(); }  ///< also those that are not used
    /// Uses every n-th alone.
    void use_every(std::uint32_t n);

    static OctreeMesh sphere(int rings);             ///< 2 rings^2 triangles about
    static OctreeMesh soup(int count, double size);  ///< anywhere in the unit cube
    static OctreeMesh needles(int count);
    static OctreeMesh on_one_vertex(int count);  ///< long thin triangles in all directions
    static OctreeMesh disc(int count);           ///< a flat fan
    static OctreeMesh identical(int count);

private:
    std::vector<accel::Vertex> places_;
    std::vector<accel::MeshTriangle> triangles_;
    std::vector<std::uint32_t> used_;
};

/// Empty: the tree is whole. Its leaves fill the root in Morton order without gaps, entries lead to the leaves that lie
/// there, references ascend and follow each other.
[[nodiscard]] std::string tree_fault(const accel::Octree& tree);

/// Empty: each leaf lists what meets it by the contract of octree_slack, and nothing that stays farther out than
/// twice that and what float knows of thin triangles. By testing everything against everything, in double.
[[nodiscard]] std::string reference_fault(const accel::Octree& tree, const accel::MeshPart& mesh);

/// Pairs of face neighbours whose levels differ by more than one.
[[nodiscard]] std::size_t unbalanced_pairs(const accel::Octree& tree);

/// Level of the leaf that holds a cell of the lattice.
[[nodiscard]] std::uint32_t level_at(const accel::Octree& tree, const std::array<std::uint32_t, 3>& cell);

[[nodiscard]] bool same_trees(const accel::Octree& a, const accel::Octree& b);

}  // namespace enfilade::test
