// The paper's tables: on a surface that is there on any machine, and on the paper's bunny where it is.

#include "accel/octree/rope_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace enfilade::accel {
namespace {

struct Surface {
    std::vector<Vertex> places;
    std::vector<MeshTriangle> triangles;
    std::vector<std::uint32_t> used;
    [[nodiscard]] MeshPart part() const { return {places.data(), triangles.data(), used}; }
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        used.push_back(static_cast<std::uint32_t>(triangles.size()));
        triangles.push_back({{a, b, c}, {}});
    }
};

/// A ball with dents, of 4 rings^2 triangles of about one size.
Surface ball(std::uint32_t rings) {
    Surface s;
    const std::uint32_t around = 2 * rings;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        for (std::uint32_t j = 0; j < around; ++j) {
            const float up = 3.14159265f * (static_cast<float>(i) + 0.01f) / (static_cast<float>(rings) + 0.02f);
            const float turn = 6.2831853f * static_cast<float>(j) / static_cast<float>(around);
            const float r = 1 + 0.2f * std::sin(5 * up) * std::sin(4 * turn);
            s.places.push_back(
                {r * std::sin(up) * std::cos(turn), r * std::sin(up) * std::sin(turn), r * std::cos(up)});
        }
    }
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < around; ++j) {
            const std::uint32_t next = (j + 1) % around, a = i * around;
            s.add(a + j, a + next, a + around + j);
            s.add(a + next, a + around + next, a + around + j);
        }
    }
    return s;
}

TEST(RopeFigures, AddUp) {
    const Surface s = ball(60);
    const RopeFigures figures = rope_figures(s.part(), paper_options(s.used.size()), SerialExecutor());
    EXPECT_EQ(figures.triangles, 14400u);
    for (const RopeTreeFigures& tree : {figures.free, figures.balanced}) {
        EXPECT_EQ(tree.stored.leaves, 16 * tree.leaves + 4 * tree.neighbours);
        EXPECT_EQ(tree.stored.triangles, 40 * tree.references);
        EXPECT_EQ(tree.stored.boxes, 16 * tree.leaves);
        EXPECT_EQ(tree.implicit.total() + tree.stored.boxes, tree.stored.total());
        EXPECT_EQ(tree.stored.nodes, 32 * ((tree.leaves - 1) / 7));
    }
    EXPECT_GE(figures.balanced.leaves, figures.free.leaves);
    EXPECT_LT(figures.free.neighbours_a_leaf(), 6);
    EXPECT_GT(figures.balanced.neighbours_a_leaf(), 6);
    EXPECT_GE(figures.balanced.references, figures.free.references);
}

TEST(RopeFigures, AreAsDeepAsThePaper) {
    EXPECT_EQ(paper_depth(69'451), 8u);
    EXPECT_EQ(paper_depth(346'000), 10u);
    EXPECT_EQ(paper_depth(871'414), 11u);
}

/// Corners and faces of an OBJ file whose faces are triangles.
Surface read_obj(const std::filesystem::path& file) {
    Surface s;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vertex v = {};
            words >> v.x >> v.y >> v.z;
            s.places.push_back(v);
        } else if (kind == "f") {
            std::array<std::uint32_t, 3> corners = {};
            for (std::uint32_t& corner : corners) {
                std::string word;
                words >> word;
                corner = static_cast<std::uint32_t>(std::strtoul(word.c_str(), nullptr, 10)) - 1;
            }
            s.add(corners[0], corners[1], corners[2]);
        }
    }
    return s;
}

/// Tables 1 and 3, with tolerance for what the paper does not tell: how it decides to split.
TEST(RopeFigures, OfTheBunnyAreThePapers) {
    const std::filesystem::path file =
        std::filesystem::path(ENFILADE_SOURCE_DIR) / "../shared/data/mesh/c3tm_stanford-bunny.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    const Surface s = read_obj(file);
    ASSERT_EQ(s.used.size(), 69451u);
    const RopeFigures figures = rope_figures(s.part(), paper_options(s.used.size()), SerialExecutor());
    EXPECT_NEAR(figures.leaf_ratio(), 1.20, 0.03);
    EXPECT_NEAR(figures.balanced.triangles_a_leaf(), 6, 0.5);
    EXPECT_NEAR(figures.balanced.neighbours_a_leaf(), 7, 0.5);
    EXPECT_NEAR(static_cast<double>(figures.balanced.stored.total()) / 69451, 268, 27);
    EXPECT_NEAR(static_cast<double>(figures.free.leaves), 69'000, 24'000);
}

}  // namespace
}  // namespace enfilade::accel
