#include "base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <random>

namespace enfilade {
namespace {

using Groups = std::vector<std::vector<std::uint32_t>>;

TEST(DisjointSets, EachNumberIsASetAtFirst) {
    DisjointSets sets(3);
    EXPECT_EQ(sets.size(), 3u);
    EXPECT_EQ(sets.lowest(), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(sets.groups(), (Groups{{0}, {1}, {2}}));
}

TEST(DisjointSets, NoNumbersAreNoSets) {
    DisjointSets sets;
    EXPECT_EQ(sets.size(), 0u);
    EXPECT_TRUE(sets.lowest().empty());
    EXPECT_TRUE(sets.groups().empty());
}

TEST(DisjointSets, JoinTellsWhetherTheyWereApart) {
    DisjointSets sets(4);
    EXPECT_TRUE(sets.join(3, 1));
    EXPECT_FALSE(sets.join(1, 3));
    EXPECT_FALSE(sets.join(2, 2));
    EXPECT_TRUE(sets.join(2, 3));
    EXPECT_FALSE(sets.join(1, 2));
}

TEST(DisjointSets, TheLowestMemberNamesTheSet) {
    DisjointSets sets(6);
    sets.join(5, 4);
    EXPECT_EQ(sets.find(5), 4u);
    sets.join(2, 5);
    EXPECT_EQ(sets.find(4), 2u);
    EXPECT_EQ(sets.find(5), 2u);
    EXPECT_EQ(sets.find(3), 3u);
}

TEST(DisjointSets, GroupsComeByTheirFirstMembers) {
    DisjointSets sets(6);
    sets.join(5, 3);
    sets.join(4, 1);
    sets.join(5, 0);
    EXPECT_EQ(sets.groups(), (Groups{{0, 3, 5}, {1, 4}, {2}}));
}

TEST(DisjointSets, ResetForgets) {
    DisjointSets sets(3);
    sets.join(0, 2);
    sets.reset(2);
    EXPECT_EQ(sets.groups(), (Groups{{0}, {1}}));
    sets.reset(4);
    EXPECT_EQ(sets.groups(), (Groups{{0}, {1}, {2}, {3}}));
}

TEST(DisjointSets, LongChainsAreFoundFromAnyEnd) {
    constexpr std::uint32_t count = 1'000'000;
    DisjointSets up(count), down(count);
    for (std::uint32_t k = 1; k < count; ++k) {
        up.join(k - 1, k);
        down.join(count - k, count - k - 1);
    }
    EXPECT_EQ(up.find(count - 1), 0u);
    EXPECT_EQ(down.find(count - 1), 0u);
    EXPECT_EQ(up.lowest(), down.lowest());
}

/// The same by walking from each number over all joined pairs.
std::vector<std::uint32_t> lowest_by_walking(std::uint32_t count,
                                             const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    std::vector<std::uint32_t> lowest(count, UINT32_MAX);
    for (std::uint32_t from = 0; from < count; ++from) {
        if (lowest[from] != UINT32_MAX) continue;
        lowest[from] = from;
        for (bool grows = true; grows;) {
            grows = false;
            for (const auto& [a, b] : pairs)
                if ((lowest[a] == from) != (lowest[b] == from)) lowest[a] = lowest[b] = from, grows = true;
        }
    }
    return lowest;
}

TEST(DisjointSets, AreTheSameInWhateverOrderTheyAreJoined) {
    std::mt19937 random(7);
    const auto below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(random() % bound); };
    for (int round = 0; round < 200; ++round) {
        const std::uint32_t count = 1 + below(40);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(below(2 * count));
        for (auto& [a, b] : pairs) a = below(count), b = below(count);
        const std::vector<std::uint32_t> expected = lowest_by_walking(count, pairs);
        for (int order = 0; order < 3; ++order) {
            std::shuffle(pairs.begin(), pairs.end(), random);
            DisjointSets sets(count);
            for (const auto& [a, b] : pairs) {
                sets.join(a, b);
                if (below(4) == 0) (void)sets.lowest();
            }
            for (std::uint32_t k = 0; k < count; ++k) ASSERT_EQ(sets.find(k), expected[k]);
            EXPECT_EQ(sets.lowest(), expected);
            for (const auto& group : sets.groups())
                for (const std::uint32_t k : group) EXPECT_EQ(expected[k], group.front());
        }
    }
}

}  // namespace
}  // namespace enfilade
