#include "gmap/isomorphism.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "gmap/insert.h"
#include "maps.h"

namespace enfilade::gmap {
namespace {

/// The same map with its darts in another order.
Map shuffled(const Map& map, unsigned seed) {
    std::vector<std::uint32_t> to(map.dart_bound());
    std::iota(to.begin(), to.end(), 0u);
    std::shuffle(to.begin(), to.end(), std::mt19937(seed));
    MapArrays arrays = map.arrays();
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t d = 0; d < to.size(); ++d) {
            arrays.alpha[i][to[d]] = to[map.arrays().alpha[i][d]];
            arrays.cell_id[i][to[d]] = map.arrays().cell_id[i][d];
        }
    return Map(std::move(arrays));
}

TEST(Isomorphism, FindsTheSameMapInAnotherOrder) {
    const Map map = grid(3, 4, 2);
    const Map other = shuffled(map, 5);
    const auto found = find_isomorphism(map, other);
    ASSERT_TRUE(found);
    std::vector<DartId> images = *found;
    std::sort(images.begin(), images.end());
    EXPECT_TRUE(std::adjacent_find(images.begin(), images.end()) == images.end());
    for (const DartId d : map.darts())
        for (int i = 0; i < 4; ++i) EXPECT_EQ((*found)[index(map.alpha(i, d))], other.alpha(i, (*found)[index(d)]));
}

TEST(Isomorphism, TellsDifferentMapsOfOneSizeApart) {
    EXPECT_FALSE(is_isomorphic(grid(2, 3, 1), grid(3, 3, 1)));
    EXPECT_FALSE(is_isomorphic(grid(8, 1, 1), grid(2, 2, 2)));
    // As many cells and darts: two edges of a cube are cut, neighbours or opposites.
    Map a = cube();
    Map b = cube();
    ASSERT_TRUE(insert_vertex(a, DartId{0}) && insert_vertex(a, a.alpha<1>(DartId{0})));
    ASSERT_TRUE(insert_vertex(b, DartId{0}) && insert_vertex(b, cube().alpha<0, 1, 0, 1>(DartId{0})));
    EXPECT_EQ(a.dart_count(), b.dart_count());
    EXPECT_FALSE(is_isomorphic(a, b));
}

TEST(Isomorphism, TellsATorusFromItsTwistedCousin) {
    EXPECT_FALSE(is_isomorphic(built(wrapped_grid_tuples(4, 4, 4)), built(wrapped_grid_tuples(4, 4, 4, true))));
    EXPECT_TRUE(is_isomorphic(built(wrapped_grid_tuples(3, 4, 5)), built(wrapped_grid_tuples(5, 3, 4))));
}

TEST(Isomorphism, MatchesPiecesInAnyOrder) {
    Map a = cube();
    a.append(built(prism_tuples(5)));
    a.append(cube());
    Map b = built(prism_tuples(5));
    b.append(cube());
    b.append(cube());
    EXPECT_TRUE(is_isomorphic(a, b));
    Map c = built(prism_tuples(5));
    c.append(built(prism_tuples(3)));
    c.append(built(prism_tuples(5)));
    EXPECT_EQ(c.dart_count(), a.dart_count());
    EXPECT_FALSE(is_isomorphic(a, c));
}

TEST(Isomorphism, RespectsLabels) {
    const Map map = grid(3, 1, 1);
    const auto label = [&](std::uint32_t volume) {
        return [&map, volume](DartId d) -> std::uint64_t { return map.volume(d) == VolumeId{volume} ? 1 : 0; };
    };
    EXPECT_TRUE(is_isomorphic(map, map, label(0), label(2)));
    EXPECT_FALSE(is_isomorphic(map, map, label(0), label(1)));
    EXPECT_FALSE(is_isomorphic(map, map, label(0), {}));
}

TEST(Isomorphism, IgnoresGapsAndCellIds) {
    Map map = grid(2, 2, 2);
    const auto changes = insert_vertex(map, DartId{0});
    ASSERT_TRUE(changes && remove_vertex(map, changes->dart));
    EXPECT_TRUE(map.has_gaps());
    EXPECT_TRUE(is_isomorphic(map, grid(2, 2, 2)));
    EXPECT_TRUE(is_isomorphic(grid(2, 2, 2), map));
    EXPECT_TRUE(is_isomorphic(Map(), Map()));
    EXPECT_FALSE(is_isomorphic(Map(), map));
}

TEST(Isomorphism, ExtendsFromOnePair) {
    const Map map = grid(3, 1, 1);
    EXPECT_TRUE(extend_isomorphism(map, DartId{0}, map, DartId{0}));
    EXPECT_FALSE(extend_isomorphism(map, dart_between(map, 0, 1), map, dart_between(map, 1, 0)));
    EXPECT_TRUE(extend_isomorphism(map, dart_between(map, 0, 1), map, dart_between(map, 2, 1)));
}

}  // namespace
}  // namespace enfilade::gmap
