// Inside of the walk through leaves: the boxes that rays leave by, the table that finds leaves, which leaves are
// entered, and that registers of triangles answer as single ones. (octree_extremes_test.cpp judges the answers.)

#include <algorithm>
#include <cstring>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "render/octree_kernels.h"
#include "render/octree_walk.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/object_scenes.h"
#include "tests/support/octree_rays.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::render {
namespace {

using accel::OctreeLeaf;
using accel::OctreeOptions;
using accel::OctreeView;
using test::TriedMesh;
using test::TriedOctree;

/// Compact, thin, scattered, and so small in a corner that leaves differ by many levels.
std::vector<accel::InputMesh> tried_meshes() {
    accel::InputMesh uneven = test::ball_mesh(12, 0.01f);
    for (auto& v : uneven.vertices) v[0] += 1;
    const accel::InputMesh box = test::box_mesh({-1, -1, -1}, {1, 1, 1});
    const auto offset = static_cast<std::uint32_t>(uneven.vertices.size());
    uneven.vertices.insert(uneven.vertices.end(), box.vertices.begin(), box.vertices.end());
    for (auto triangle : box.triangles) {
        for (auto& corner : triangle) corner += offset;
        uneven.triangles.push_back(triangle);
    }
    uneven.triangle_materials.assign(uneven.triangles.size(), uneven.triangle_materials.front());
    return {test::ball_mesh(20, 1), test::box_mesh({-1, -0.5f, -0.01f}, {1, 0.5f, 0.01f}),
            test::random_soup(500, 0.1f, 1), uneven};
}

const std::vector<OctreeOptions>& tried_options() {
    static const std::vector<OctreeOptions> options = {
        {}, {.depth = 0}, {.depth = 1, .leaf_size = 1}, {.depth = 6, .leaf_size = 2}, {.depth = 11, .leaf_size = 1}};
    return options;
}

template <class Check>
void with_every_octree(const Check& check) {
    for (const accel::InputMesh& input : tried_meshes()) {
        const TriedMesh mesh(input);
        for (const OctreeOptions& options : tried_options()) {
            const TriedOctree octree(mesh, options);
            check(mesh, octree);
        }
    }
}

struct LatticeRange {
    std::array<std::uint32_t, 3> low, high;
    [[nodiscard]] bool meets(const OctreeLeaf& leaf, std::uint32_t width) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (leaf.low[k] >= high[k] || leaf.low[k] + width <= low[k]) return false;
        return true;
    }
};

/// The box by which rays towards an octant leave a leaf.
LatticeRange exit_range(const TriedOctree& octree, std::size_t number, std::uint32_t octant) {
    const OctreeLeaf& leaf = octree.tree().leaves[number];
    const std::uint32_t width = octree.tree().width(leaf);
    const std::uint32_t unit = accel::exit_unit(octree.tree().frame.depth - leaf.level);
    LatticeRange range;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t extent = std::uint32_t{octree.view().leaves[number].exits[octant][k]} << unit;
        const bool is_up = (octant >> k & 1u) != 0;
        range.low[k] = is_up ? leaf.low[k] : leaf.low[k] + width - extent;
        range.high[k] = is_up ? leaf.low[k] + extent : leaf.low[k] + width;
    }
    return range;
}

TEST(OctreeExits, BoxesHoldTheLeafAndNoForeignTriangle) {
    std::size_t larger_boxes = 0;
    with_every_octree([&](const TriedMesh&, const TriedOctree& octree) {
        const accel::Octree& tree = octree.tree();
        const std::uint32_t side = 1u << tree.frame.depth;
        for (std::size_t i = 0; i < tree.leaves.size(); i += 1 + tree.leaves.size() / 200) {
            const OctreeLeaf& leaf = tree.leaves[i];
            const std::uint32_t width = tree.width(leaf);
            for (std::uint32_t octant = 0; octant < 8; ++octant) {
                const LatticeRange range = exit_range(octree, i, octant);
                bool is_larger = false;
                for (std::size_t k = 0; k < 3; ++k) {
                    ASSERT_LE(range.low[k], leaf.low[k]);
                    ASSERT_GE(range.high[k], leaf.low[k] + width);
                    ASSERT_LE(range.high[k], side);
                    is_larger |= range.high[k] - range.low[k] > width;
                }
                larger_boxes += is_larger ? 1 : 0;
                for (std::size_t j = 0; j < tree.leaves.size(); ++j) {
                    if (j == i || tree.leaves[j].count == 0) continue;
                    ASSERT_FALSE(range.meets(tree.leaves[j], tree.width(tree.leaves[j])))
                        << "leaf " << i << ", octant " << octant << ", foreign leaf " << j;
                }
            }
        }
    });
    EXPECT_GT(larger_boxes, 5000u);
}

TEST(OctreeJumps, FindTheLeafOfEachCellAlsoMirrored) {
    with_every_octree([&](const TriedMesh&, const TriedOctree& octree) {
        const accel::Octree& tree = octree.tree();
        const OctreeView view = octree.view();
        NoOctreeEvents events;
        for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
            const OctreeLeaf& leaf = tree.leaves[i];
            const std::uint32_t width = tree.width(leaf);
            for (std::uint32_t mirrored = 0; mirrored < 8; ++mirrored) {
                LatticeRay ray = {};
                ray.octant = 7 - mirrored;
                LatticeCell low, high;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t mirror = (mirrored >> k & 1u) != 0 ? (1u << tree.frame.depth) - 1 : 0;
                    low.at[k] = static_cast<std::int32_t>(leaf.low[k] ^ mirror);
                    high.at[k] = static_cast<std::int32_t>((leaf.low[k] + width - 1) ^ mirror);
                }
                for (const LatticeCell& cell : {low, high}) {
                    const accel::JumpEntry entry = leaf_at(view, ray, cell, events);
                    ASSERT_EQ(entry.number(), i);
                    ASSERT_EQ(1u << entry.width(), width);
                }
            }
        }
    });
}

/// The leaves that a walk enters, in their order.
struct LeafList {
    std::vector<std::uint32_t> leaves;
    void entered_leaf(std::uint32_t leaf, std::uint32_t) { leaves.push_back(leaf); }
    void descended(std::uint32_t) {}
};

/// How far a ray goes through what of a leaf is in the triangles' box, made smaller by a thousandth of a cell, before
/// `far`; in the ray's parameter.
double way_through(const TriedOctree& octree, const OctreeLeaf& leaf, const ObjectRay& ray, double far) {
    const accel::Octree& tree = octree.tree();
    const accel::LatticeBox box = octree.view().box;
    const double o[3] = {ray.origin_x, ray.origin_y, ray.origin_z};
    const double d[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
    double enter = ray.near, leave = far;
    for (std::size_t k = 0; k < 3; ++k) {
        const double scale = tree.frame.cells_a_unit[k];
        const double low = std::max<double>(leaf.low[k], box.from[k]) + 1e-3;
        const double high = std::min<double>(leaf.low[k] + tree.width(leaf), box.to[k]) - 1e-3;
        const double from = (o[k] - tree.frame.low[k]) * scale, along = d[k] * scale;
        if (along == 0) {
            if (from < low || from > high) return 0;
            continue;
        }
        const double a = (low - from) / along, b = (high - from) / along;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return std::max(0.0, leave - enter);
}

TEST(OctreeWalk, EntersEveryLeafWithTrianglesThatARayPassesAndNoneTwice) {
    std::size_t passed = 0, entered = 0;
    with_every_octree([&](const TriedMesh& mesh, const TriedOctree& octree) {
        const accel::Octree& tree = octree.tree();
        if (tree.frame.depth > 8) return;  // a thousandth of a cell is more than what rounding does
        for (const auto family : {test::OctreeRayFamily::Outside, test::OctreeRayFamily::Inside,
                                  test::OctreeRayFamily::FromTriangles, test::OctreeRayFamily::AlongAxes}) {
            test::OctreeRays rays(mesh, tree.frame, 3);
            for (int i = 0; i < 100; ++i) {
                const ObjectRay asked = rays.take(family);
                ObjectRay answered = asked;
                LeafList list;
                octree_walk<false>(octree.view(), answered, list);
                const std::set<std::uint32_t> once(list.leaves.begin(), list.leaves.end());
                ASSERT_EQ(once.size(), list.leaves.size());
                entered += list.leaves.size();
                for (std::uint32_t n = 0; n < tree.leaves.size(); ++n) {
                    if (tree.leaves[n].count == 0 || way_through(octree, tree.leaves[n], asked, answered.far) <= 0)
                        continue;
                    ++passed;
                    ASSERT_TRUE(once.contains(n)) << "leaf " << n;
                }
            }
        }
    });
    EXPECT_GT(passed, 2000u);
    EXPECT_LT(entered, 8 * passed);
}

TEST(OctreeWalk, StepsGoOnAlongAnAxisAndBackAlongNone) {
    with_every_octree([&](const TriedMesh& mesh, const TriedOctree& octree) {
        const OctreeView view = octree.view();
        for (const test::NamedOctreeRays& each : test::octree_ray_families) {
            test::OctreeRays rays(mesh, octree.tree().frame, 5);
            for (int i = 0; i < 20; ++i) {
                ObjectRay ray = rays.take(each.family);
                bring_near(view.low, view.high, ray);
                const LatticeRay r = lattice_ray(view, ray);
                float enter = ray.near, leave = ray.far;
                if (r.exponent != 0 || !part_in_box(view, r, enter, leave)) continue;
                NoOctreeEvents events;
                LatticeCell cell = first_cell(view, r, enter);
                while (true) {
                    const accel::JumpEntry entry = leaf_at(view, r, cell, events);
                    const BoxExit exit = exit_of(view, view.leaves[entry.number()], entry.width(), r, cell);
                    if (!(exit.least < leave)) break;
                    const LatticeCell before = cell;
                    step(r, exit, cell);
                    std::int32_t gone = 0;
                    for (int k = 0; k < 3; ++k) {
                        ASSERT_GE(cell.at[k], before.at[k]) << each.name;
                        ASSERT_LT(cell.at[k], 1 << view.frame.depth) << each.name;
                        gone += cell.at[k] - before.at[k];
                    }
                    ASSERT_GT(gone, 0) << each.name;
                }
            }
        }
    });
}

TEST(OctreeWalk, EveryInstructionSetAnswersAsOneTriangleAtATime) {
    int sets = 0, hits = 0;
    for (const test::InstructionSet& set : test::instruction_sets()) {
        const test::UsingInstructionSet here(set);
        const detail::OctreeKernels* lanes = detail::octree_lane_kernels();
        if (lanes == nullptr) continue;
        ++sets;
        with_every_octree([&](const TriedMesh& mesh, const TriedOctree& octree) {
            const OctreeView view = octree.view();
            for (const test::NamedOctreeRays& each : test::octree_ray_families) {
                test::OctreeRays rays(mesh, octree.tree().frame, 7);
                for (int i = 0; i < 40; ++i) {
                    ObjectRay asked = rays.take(each.family), scalar = asked, lane = asked;
                    const bool is_hit = detail::octree_kernels().nearest(view, scalar);
                    ASSERT_EQ(lanes->nearest(view, lane), is_hit) << set.name << ", " << each.name;
                    ASSERT_EQ(std::memcmp(&scalar, &lane, sizeof scalar), 0) << set.name << ", " << each.name;
                    ASSERT_EQ(lanes->blocked(view, asked), is_hit) << set.name << ", " << each.name;
                    hits += is_hit ? 1 : 0;
                }
            }
        });
    }
    if (sets == 0) GTEST_SKIP() << "no lanes in this build or on this machine";
    EXPECT_GT(hits, 1000 * sets);
}

}  // namespace
}  // namespace enfilade::render
