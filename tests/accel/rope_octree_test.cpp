// The paper's four arrays against their definitions.

#include "accel/octree/rope_octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "accel/octree/rope_links.h"
#include "tools/deep_octree.h"

namespace enfilade::accel {
namespace {

/// Triangles in a cube of side 1, and a tree about some of them.
struct Tried {
    std::vector<Vertex> places;
    std::vector<MeshTriangle> triangles;
    std::vector<std::uint32_t> used;
    Octree tree;
    [[nodiscard]] MeshPart part() const { return {places.data(), triangles.data(), used}; }
};

Tried tried(std::uint32_t depth, bool is_balanced, std::size_t points, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto next = [&] { return static_cast<double>(random() >> 40) * 0x1p-24; };
    Tried t;
    OctreeFrame frame;
    frame.depth = depth;
    frame.cells_a_unit = {frame.side(), frame.side(), frame.side()};
    std::vector<std::array<double, 3>> about;
    for (std::uint32_t i = 0; i < points; ++i) {
        const std::array<double, 3> p = {next(), next(), next()};
        about.push_back({p[0] * frame.side(), p[1] * frame.side(), p[2] * frame.side()});
        for (std::uint32_t c = 0; c < 3; ++c)
            t.places.push_back({static_cast<float>(p[0] + 0.01 * next()), static_cast<float>(p[1] + 0.01 * next()),
                                static_cast<float>(p[2] + 0.01 * next())});
        t.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, {}});
        t.used.push_back(i);
    }
    t.tree = tools::deep_octree(t.part(), {frame, about, is_balanced});
    return t;
}

/// Addresses of all leaves' records, in order.
std::vector<RopeAddress> addresses(const RopeView& view, std::size_t leaves) {
    std::vector<RopeAddress> all;
    RopeAddress at = 0;
    for (std::size_t i = 0; i < leaves; ++i) {
        all.push_back(at);
        at += view.header;
        for (std::uint32_t face = 0; face < rope_faces; ++face) at += view.words[all.back() + 3] >> 4 * face & 15u;
    }
    return all;
}

bool holds(const OctreeLeaf& leaf, std::uint32_t width, const std::array<std::uint32_t, 3>& cell) {
    for (std::size_t k = 0; k < 3; ++k)
        if (cell[k] < leaf.low[k] || cell[k] >= leaf.low[k] + width) return false;
    return true;
}

struct Variant {
    bool is_balanced, has_stored_boxes;
};

class RopeOctreeTest : public ::testing::TestWithParam<Variant> {
protected:
    static RopeOctree link(const Tried& t) {
        return {t.tree, t.part(), {GetParam().is_balanced, GetParam().has_stored_boxes}, SerialExecutor()};
    }
};

INSTANTIATE_TEST_SUITE_P(All, RopeOctreeTest,
                         ::testing::Values(Variant{true, true}, Variant{true, false}, Variant{false, true},
                                           Variant{false, false}),
                         [](const auto& variant) {
                             return std::string(variant.param.is_balanced ? "Balanced" : "Free") +
                                    (variant.param.has_stored_boxes ? "Stored" : "Implicit");
                         });

TEST_P(RopeOctreeTest, KeepsBoxesAndTriangles) {
    for (const std::uint32_t depth : {0u, 1u, 5u, 10u, 11u, 20u}) {
        const Tried t = tried(depth, GetParam().is_balanced, 6, depth);
        const RopeOctree ropes = link(t);
        const RopeView view = ropes.view();
        EXPECT_EQ(view.header, !GetParam().has_stored_boxes && depth > 10 ? 5u : 4u);
        const std::vector<RopeAddress> at = addresses(view, t.tree.leaves.size());
        std::size_t triangles = 0;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const OctreeLeaf& leaf = t.tree.leaves[i];
            const RopeCube cube = cube_of(view, at[i]);
            for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(cube.low[k], leaf.low[k]);
            ASSERT_EQ(cube.level, leaf.level);
            ASSERT_EQ(cube.width, t.tree.width(leaf));
            ASSERT_EQ(view.words[at[i]], leaf.count);
            for (std::uint32_t j = 0; j < leaf.count; ++j) {
                const RopeTriangle& triangle = view.triangles[view.words[at[i] + 1] + j];
                ASSERT_EQ(triangle.number, t.tree.references[leaf.first + j]);
                const Vertex& last = t.places[t.triangles[triangle.number].corners[2]];
                ASSERT_EQ(triangle.corners[2][1], last.y);
                ++triangles;
            }
        }
        EXPECT_EQ(triangles, t.tree.references.size());
        EXPECT_GT(triangles, 5u);
    }
}

/// The leaves that share a piece of a face with leaf i, and where: by looking at all pairs.
std::set<std::size_t> touching(const Octree& tree, std::size_t i, std::uint32_t face) {
    const auto axis = static_cast<std::size_t>(axis_of(face));
    const OctreeLeaf& a = tree.leaves[i];
    std::set<std::size_t> found;
    for (std::size_t j = 0; j < tree.leaves.size(); ++j) {
        const OctreeLeaf& b = tree.leaves[j];
        bool touches =
            is_high(face) ? b.low[axis] == a.low[axis] + tree.width(a) : b.low[axis] + tree.width(b) == a.low[axis];
        for (std::size_t k = 0; k < 3; ++k)
            if (k != axis) touches &= b.low[k] < a.low[k] + tree.width(a) && a.low[k] < b.low[k] + tree.width(b);
        if (touches) found.insert(j);
    }
    return found;
}

/// All leaves at or below an address.
void collect(const RopeView& view, RopeAddress node, const std::map<RopeAddress, std::size_t>& numbers,
             std::set<std::size_t>& found) {
    if ((node & inner_bit) == 0) {
        found.insert(numbers.at(node));
        return;
    }
    for (std::uint32_t octant = 0; octant < 8; ++octant)
        collect(view, view.words[(node & ~inner_bit) + octant], numbers, found);
}

TEST_P(RopeOctreeTest, LinksTheLeavesThatTouch) {
    const Tried t = tried(6, GetParam().is_balanced, 4, 3);
    const RopeOctree ropes = link(t);
    const RopeView view = ropes.view();
    const std::vector<RopeAddress> at = addresses(view, t.tree.leaves.size());
    std::map<RopeAddress, std::size_t> numbers;
    for (std::size_t i = 0; i < at.size(); ++i) numbers[at[i]] = i;
    int fours = 0, inner = 0, borders = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const std::uint32_t* next = view.words + at[i] + view.header;
        for (std::uint32_t face = 0; face < rope_faces; ++face) {
            const std::uint32_t count = view.words[at[i] + 3] >> 4 * face & 15u;
            const std::set<std::size_t> expected = touching(t.tree, i, face);
            std::set<std::size_t> found;
            for (std::uint32_t j = 0; j < count; ++j) collect(view, next[j], numbers, found);
            borders += count == 0;
            ASSERT_EQ(count == 0, expected.empty());
            if (GetParam().is_balanced) {
                ASSERT_EQ(found, expected);
                ASSERT_TRUE(count == 0 || count == 1 || count == 4);
            } else {
                ASSERT_LE(count, 1u);
                inner += count == 1 && (*next & inner_bit) != 0;
                ASSERT_TRUE(std::ranges::includes(found, expected));
            }
            if (count == 4) {
                ++fours;
                const auto axis = static_cast<std::size_t>(axis_of(face));
                const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
                for (std::uint32_t j = 0; j < 4; ++j) {
                    const OctreeLeaf& b = t.tree.leaves[numbers.at(next[j])];
                    ASSERT_EQ(b.low[u] - t.tree.leaves[i].low[u], (j & 1u) * t.tree.width(b));
                    ASSERT_EQ(b.low[v] - t.tree.leaves[i].low[v], (j >> 1) * t.tree.width(b));
                }
            }
            next += count;
        }
    }
    EXPECT_GT(GetParam().is_balanced ? fours : inner, 40);
    EXPECT_GT(borders, 24);
}

TEST_P(RopeOctreeTest, FindsBorderLeavesByPlace) {
    const Tried t = tried(5, GetParam().is_balanced, 100, 11);
    const RopeOctree ropes = link(t);
    const RopeView view = ropes.view();
    const std::vector<RopeAddress> at = addresses(view, t.tree.leaves.size());
    std::map<RopeAddress, std::size_t> numbers;
    for (std::size_t i = 0; i < at.size(); ++i) numbers[at[i]] = i;
    const std::uint32_t across = 1u << view.cube_map_level, wide = 32u / across;
    ASSERT_EQ(ropes.bytes().cube_map, 6u * 4 * across * across);
    EXPECT_GE(across, 16u);
    for (std::uint32_t face = 0; face < rope_faces; ++face) {
        const auto axis = static_cast<std::size_t>(axis_of(face));
        for (std::uint32_t v = 0; v < across; ++v) {
            for (std::uint32_t u = 0; u < across; ++u) {
                const RopeAddress found = view.cube_map[(face * across + v) * across + u];
                ASSERT_EQ(found & inner_bit, 0u);
                std::array<std::uint32_t, 3> cell = {};
                cell[axis] = is_high(face) ? 31 : 0;
                cell[axis == 0 ? 1 : 0] = u * wide;
                cell[axis == 2 ? 1 : 2] = v * wide;
                const OctreeLeaf& leaf = t.tree.leaves[numbers.at(found)];
                ASSERT_TRUE(holds(leaf, t.tree.width(leaf), cell));
                ASSERT_GE(t.tree.width(leaf), wide);
            }
        }
    }
}

TEST(RopeOctree, RefusesToBalanceWhatIsNot) {
    const Tried t = tried(6, false, 4, 3);
    EXPECT_THROW(RopeOctree(t.tree, t.part(), {true, true}, SerialExecutor()), std::invalid_argument);
    EXPECT_NO_THROW(RopeOctree(t.tree, t.part(), {false, true}, SerialExecutor()));
}

TEST(RopeOctree, BoundsItsCubeMap) {
    const Tried t = tried(20, false, 1, 4);
    const RopeOctree ropes(t.tree, t.part(), {false, false}, SerialExecutor());
    EXPECT_LE(ropes.bytes().cube_map, 4 * (16 * ropes.leaf_count() + 6));
    EXPECT_LT(ropes.leaf_count(), 200u);
}

TEST(RopeOctree, CountsItsBytes) {
    const Tried t = tried(8, true, 20, 5);
    const RopeOctree stored(t.tree, t.part(), {true, true}, SerialExecutor());
    const RopeOctree implicit(t.tree, t.part(), {true, false}, SerialExecutor());
    EXPECT_EQ(stored.bytes().leaves, 4 * (4 * t.tree.leaves.size() + stored.neighbour_count()));
    EXPECT_EQ(stored.bytes().boxes, 16 * t.tree.leaves.size());
    EXPECT_EQ(stored.bytes().triangles, 40 * t.tree.references.size());
    EXPECT_EQ(stored.bytes().nodes, 4 * t.tree.children.size());
    EXPECT_EQ(implicit.bytes().total(), stored.bytes().total() - stored.bytes().boxes);
}

TEST(RopeOctree, IsTheSameOnAnyNumberOfThreads) {
    const Tried t = tried(20, true, 30, 8);
    const RopeOctree one(t.tree, t.part(), {true, false}, SerialExecutor());
    const RopeOctree four(t.tree, t.part(), {true, false}, ThreadExecutor(4));
    ASSERT_EQ(one.bytes().total(), four.bytes().total());
    const std::size_t words = (one.bytes().leaves + one.bytes().nodes) / 4;
    EXPECT_TRUE(std::equal(one.view().words, one.view().words + words, four.view().words));
    EXPECT_GT(t.tree.leaves.size(), 3 * std::size_t{4096});
}

TEST(RopeOctree, IsNothingWithoutTriangles) {
    const RopeOctree ropes(Octree{}, MeshPart{}, {}, SerialExecutor());
    EXPECT_EQ(ropes.view().words, nullptr);
    EXPECT_EQ(ropes.bytes().total(), 0u);
}

}  // namespace
}  // namespace enfilade::accel
