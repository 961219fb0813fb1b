#include "tools/report/ring_chain.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace enfilade::tools {
namespace {

using Sides = std::vector<std::array<std::uint32_t, 2>>;

TEST(RingChain, FollowsSidesInAnyOrder) {
    const Sides sides = {{7, 3}, {1, 7}, {3, 1}, {20, 10}, {10, 20}};
    const auto rings = chain_rings(sides);
    ASSERT_EQ(rings.size(), 2u);
    EXPECT_EQ(rings[0], (std::vector<std::uint32_t>{1, 0, 2}));
    EXPECT_EQ(rings[1], (std::vector<std::uint32_t>{4, 3}));
}

TEST(RingChain, TakesEverySideOnceWhereRingsTouch) {
    const Sides sides = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
    std::vector<std::uint32_t> all;
    for (const auto& ring : chain_rings(sides)) {
        for (std::size_t k = 0; k < ring.size(); ++k)
            EXPECT_EQ(sides[ring[k]][1], sides[ring[(k + 1) % ring.size()]][0]);
        all.insert(all.end(), ring.begin(), ring.end());
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(RingChain, EndsAChainThatCannotGoOn) {
    const Sides sides = {{0, 1}, {1, 2}};
    EXPECT_EQ(chain_rings(sides), (std::vector<std::vector<std::uint32_t>>{{0, 1}}));
    EXPECT_TRUE(chain_rings({}).empty());
}

}  // namespace
}  // namespace enfilade::tools
