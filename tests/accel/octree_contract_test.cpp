// Whatever the triangles and the options, octrees keep their contract.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "accel/octree/octree_stats.h"
#include "tests/accel/octree_meshes.h"

namespace enfilade::accel {
namespace {

using test::OctreeMesh;

/// Corners on a coarse lattice of their own, so that triangles share planes with cells, degenerate and coincide.
OctreeMesh any_mesh() {
    OctreeMesh mesh;
    const int count = *rc::gen::inRange(1, 120);
    const int steps = *rc::gen::element(2, 8, 64, 100000);
    const auto corner = [&] {
        const auto at = rc::gen::inRange(0, steps + 1);
        return OctreeMesh::Point{static_cast<double>(*at), static_cast<double>(*at), static_cast<double>(*at)};
    };
    for (int i = 0; i < count; ++i) {
        const OctreeMesh::Point a = corner(), b = corner(), c = corner();
        mesh.add(a, b, c);
    }
    mesh.move(*rc::gen::element(1.0, 1e-12, 3e7), {0, 0, *rc::gen::element(0.0, 1e3)});
    return mesh;
}

OctreeOptions any_options() {
    OctreeOptions options;
    if (*rc::gen::arbitrary<bool>()) options.depth = *rc::gen::inRange(0u, 7u);
    if (*rc::gen::arbitrary<bool>()) options.leaf_size = *rc::gen::inRange(0u, 20u);
    options.is_balanced = *rc::gen::arbitrary<bool>();
    options.cost.full_leaf = *rc::gen::element(0.0, 1.0, 20.0);
    options.cost.empty_leaf = *rc::gen::element(0.0, 1.0, 20.0);
    return options;
}

RC_GTEST_PROP(Octrees, ListWhatMeetsTheirLeaves, ()) {
    const OctreeMesh mesh = any_mesh();
    const OctreeOptions options = any_options();
    const Octree tree = build_octree(mesh.part(), options, SerialExecutor());
    RC_ASSERT(test::tree_fault(tree).empty());
    RC_ASSERT(test::reference_fault(tree, mesh.part()).empty());
    RC_ASSERT(!options.is_balanced || test::unbalanced_pairs(tree) == 0);
    RC_ASSERT(tree.leaves.size() + tree.references.size() <=
              octree_entries_a_triangle * mesh.size() + octree_entries_spare);
    RC_ASSERT(test::same_trees(tree, build_octree(mesh.part(), options, ThreadExecutor(3))));
}

}  // namespace
}  // namespace enfilade::accel
