// What baselines' trees hold: each triangle, in boxes that contain it, on paths of bounded length.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "render/cuda/bvh2.h"
#include "render/cuda/wide_bvh.h"
#include "render/cuda/wide_collapse.h"
#include "tests/support/bvh_scenes.h"

namespace enfilade::render::cuda {
namespace {

using test::TriedForest;

/// Boxes as doubles, so that decoding rounds nothing.
struct Box {
    std::array<double, 3> low, high;
};

Box box_of(const SahBox& box) {
    Box result;
    for (std::size_t k = 0; k < 3; ++k) {
        result.low[k] = box.low[k];
        result.high[k] = box.high[k];
    }
    return result;
}

/// How often each item was met, and whether its box lay in all boxes above. Parts of split triangles may lie outside.
struct Census {
    std::map<std::uint32_t, int> times;
    int outside = 0;
    int depth = 0;
};

class Checker {
public:
    Checker(const TriedForest& tried, bool is_split) : tried_(tried), is_split_(is_split) {}

    void meet(std::uint32_t item, const Box& in, Census& census) const {
        ++census.times[item];
        if (is_split_ && (item & instance_bit) == 0) return;
        const Box box = box_of((item & instance_bit) != 0 ? tried_.scene.instance_boxes[item & item_mask]
                                                          : tried_.scene.box_of(item));
        for (std::size_t k = 0; k < 3; ++k)
            if (!(in.low[k] <= box.low[k] && box.high[k] <= in.high[k])) ++census.outside;
    }

    /// Each item of a tree's entries as often as it has entries.
    void expect_right(const Census& census, std::uint32_t begin, std::uint32_t end, bool is_top) const {
        EXPECT_EQ(census.outside, 0);
        std::map<std::uint32_t, int> expected;
        for (std::uint32_t t = begin; t < end; ++t)
            if (tried_.scene.can_be_hit[t]) expected[t] = 1;
        if (is_top)
            for (std::uint32_t k = 0; k < tried_.scene.instances.size(); ++k)
                if (!tried_.forest.meshes[tried_.scene.mesh_of[k]].nodes.empty()) expected[instance_bit | k] = 1;
        if (!is_split_) {
            EXPECT_EQ(census.times, expected);
            return;
        }
        ASSERT_EQ(census.times.size(), expected.size());
        for (const auto& [item, times] : census.times) EXPECT_TRUE(expected.contains(item));
    }

private:
    const TriedForest& tried_;
    bool is_split_;
};

Census census_of(const Bvh2Arrays& arrays, std::uint32_t root, const Checker& checker) {
    Census census;
    const std::function<void(std::uint32_t, int)> visit = [&](std::uint32_t at, int depth) {
        census.depth = std::max(census.depth, depth);
        const BvhNode& node = arrays.nodes[at];
        for (std::size_t c = 0; c < 2; ++c) {
            if (c == 1 && node.child[0] == node.child[1]) continue;
            if ((node.child[c] & leaf_bit) == 0) {
                visit(node.child[c], depth + 1);
                continue;
            }
            Box box;
            for (std::size_t k = 0; k < 3; ++k) {
                box.low[k] = node.low[k][c];
                box.high[k] = node.high[k][c];
            }
            for (std::uint32_t r = node.child[c] & ~leaf_bit;; ++r) {
                checker.meet(arrays.records[r].item & ~end_bit, box, census);
                if ((arrays.records[r].item & end_bit) != 0) break;
            }
        }
    };
    visit(root, 1);
    return census;
}

Box decoded(const WideNode& node, std::size_t slot) {
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
        const double step = std::ldexp(1.0, node.exponent[k] - 127);
        box.low[k] = double{node.origin[k]} + node.low[k][slot] * step;
        box.high[k] = double{node.origin[k]} + node.high[k][slot] * step;
    }
    return box;
}

Census census_of(const WideBvhArrays& arrays, std::uint32_t root, const Checker& checker) {
    Census census;
    const std::function<void(std::uint32_t, const Box&, int)> visit = [&](std::uint32_t at, const Box& above,
                                                                          int depth) {
        census.depth = std::max(census.depth, depth);
        const WideNode& node = arrays.nodes[at];
        std::uint32_t next = node.first_node;
        for (std::size_t slot = 0; slot < 8; ++slot) {
            const std::uint32_t meta = node.meta[slot];
            Box box = decoded(node, slot);
            for (std::size_t k = 0; k < 3; ++k) {  // whatever is visited was met in all boxes above
                box.low[k] = std::max(box.low[k], above.low[k]);
                box.high[k] = std::min(box.high[k], above.high[k]);
            }
            if ((node.inner >> slot & 1) != 0) {
                EXPECT_EQ(meta, 1u << 5 | (24 + slot));
                visit(next++, box, depth + 1);
                continue;
            }
            for (std::uint32_t i = 0; i < 3; ++i)
                if ((meta >> (5 + i) & 1) != 0)
                    checker.meet(arrays.records[node.first_record + (meta & 31) + i].item, box, census);
        }
    };
    constexpr double far = std::numeric_limits<double>::max();
    visit(root, {{-far, -far, -far}, {far, far, far}}, 1);
    return census;
}

/// Both trees of a scene and its meshes.
void expect_right_trees(const accel::SceneView& view, float split_share = 0) {
    const TriedForest binary(view, 8, split_share), single(view, 1, split_share);
    const Checker of_binary(binary, split_share > 0), of_single(single, split_share > 0);
    const Bvh2Arrays bvh2 = lay_out_bvh2(binary.scene, binary.forest, TriangleTest::Fast);
    const WideBvhArrays wide = lay_out_wide_bvh(single.scene, single.forest, TriangleTest::Fast);
    if (!bvh2.is_empty) {
        of_binary.expect_right(census_of(bvh2, 0, of_binary), 0, binary.scene.face_triangles, true);
        of_single.expect_right(census_of(wide, 0, of_single), 0, single.scene.face_triangles, true);
    }
    for (std::size_t k = 0; k < bvh2.instances.size(); ++k) {
        const std::uint32_t mesh = binary.scene.mesh_of[k];
        if (binary.forest.meshes[mesh].nodes.empty()) continue;
        const std::uint32_t begin = binary.scene.mesh_first[mesh], end = binary.scene.mesh_first[mesh + 1];
        const Census narrow = census_of(bvh2, bvh2.instances[k].root, of_binary);
        of_binary.expect_right(narrow, begin, end, false);
        EXPECT_LE(narrow.depth, static_cast<int>(largest_bvh_depth));
        const Census eight = census_of(wide, wide.instances[k].root, of_single);
        of_single.expect_right(eight, begin, end, false);
        EXPECT_LE(eight.depth, largest_wide_depth);
    }
    EXPECT_LE(wide.depth, largest_wide_depth);
}

TEST(BvhTrees, HoldEachTriangleAndObjectOnceInBoxesThatContainIt) {
    expect_right_trees(test::furnished_office({.objects = 40, .turn = 0.3}).view());
}

TEST(BvhTrees, HoldEachTriangleAtLeastOnceWhereTheyAreSplit) {
    expect_right_trees(test::furnished_office({.objects = 40, .turn = 0.3}).view(), 0.5f);
}

TEST(BvhTrees, SplitNoMoreThanAskedFor) {
    const accel::Scene scene = test::furnished_office({.objects = 1, .turn = 0.3});
    const TriangleScene triangles(scene.view());
    const auto whole = triangle_entries(triangles, 0, triangles.face_triangles, 0);
    const auto split = triangle_entries(triangles, 0, triangles.face_triangles, 0.3f);
    EXPECT_GT(split.size(), whole.size());
    EXPECT_LE(static_cast<double>(split.size()), 1.3 * static_cast<double>(whole.size()) + 1);
    double before = 0, after = 0;
    for (const SahEntry& e : whole) before += e.box.half_area();
    for (const SahEntry& e : split) after += e.box.half_area();
    EXPECT_LT(after, before);
}

TEST(BvhTrees, AreNoDeeperThanStacksWhateverTheTriangles) {
    std::vector<std::array<std::array<float, 3>, 3>> equal(20'000, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    std::vector<std::array<std::array<float, 3>, 3>> shrinking, growing;
    for (int i = 0; i < 100; ++i) {  // each in the corner of the one before
        const float s = std::ldexp(1.0f, -i);
        shrinking.push_back({{{0, 0, 0}, {s, 0, 0}, {0, s, s}}});
        growing.push_back({{{0, 0, 0}, {1 / s * 1e-20f, 0, 0}, {0, 1 / s * 1e-20f, 1e-20f}}});
    }
    expect_right_trees(test::room_of_meshes({test::soup(equal), test::soup(shrinking), test::soup(growing),
                                             test::random_soup(3000, 0.001f, 7), test::random_soup(1000, 1, 8)})
                           .view());
}

/// What is left to do where costs would make too deep a tree.
TEST(BvhTrees, CollapsedByHeightTakeThreeLevelsAtLeastInOne) {
    std::vector<std::array<std::array<float, 3>, 3>> shrinking;
    for (int i = 0; i < 100; ++i) {
        const float s = std::ldexp(1.0f, -i);
        shrinking.push_back({{{0, 0, 0}, {s, 0, 0}, {0, s, s}}});
    }
    const accel::Scene scene = test::room_of_meshes({test::soup(shrinking), test::random_soup(3000, 0.01f, 7)});
    const TriedForest tried(scene.view(), 1);
    for (const SahTree& tree : tried.forest.meshes) {
        std::function<int(std::uint32_t)> height_of = [&](std::uint32_t code) {
            if ((code & leaf_bit) != 0) return 0;
            return 1 + std::max(height_of(tree.nodes[code].child[0]), height_of(tree.nodes[code].child[1]));
        };
        WideCollapse collapse(tree, instance_bit);
        collapse.choose_by_height();
        EXPECT_LE(collapse.depth(), (height_of(0) + 2) / 3);
        std::map<std::uint32_t, int> times;
        std::function<void(std::uint32_t)> visit = [&](std::uint32_t node) {
            const WideChildren children = collapse.children_of(node);
            for (int c = 0; c < children.count; ++c) {
                const WideChild& child = children.of[static_cast<std::size_t>(c)];
                if (child.item_count == 0) visit(child.node);
                for (std::uint32_t i = 0; i < child.item_count; ++i) ++times[child.items[i]];
            }
        };
        visit(0);
        EXPECT_EQ(times.size(), tree.order.size());
        for (const auto& [item, count] : times) EXPECT_EQ(count, 1);
    }
}

TEST(BvhTrees, MayBeEmptyFlatOrOfOneTriangle) {
    accel::InputMesh nothing;
    nothing.vertices = {{0, 0, 0}};
    const accel::InputMesh no_area = test::soup({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}});
    const accel::InputMesh one = test::soup({{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}});
    const accel::InputMesh far = test::soup({{{{1e11f, 1e11f, 1}, {1e11f, -1e11f, 1}, {-1e11f, 1, 1}}},
                                             {{{1e11f, 1e11f, 2}, {1.1e11f, 1e11f, 2}, {1e11f, 1.1e11f, 2}}}});
    accel::InputMesh flat = test::random_soup(500, 0.1f, 9);
    for (auto& v : flat.vertices) v[1] = 0.5f;
    expect_right_trees(test::room_of_meshes({nothing, no_area, one, far, flat}).view());
}

TEST(BvhTrees, OfTriangleScenesWithoutObjectsHaveNone) {
    const accel::Scene scene = test::furnished_office({.objects = 5});
    const TriangleScene bare(scene.view(), true);
    EXPECT_TRUE(bare.instances.empty());
    EXPECT_EQ(bare.triangles.size(), bare.face_triangles);
}

}  // namespace
}  // namespace enfilade::render::cuda
