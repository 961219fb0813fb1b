#include "gmap/map.h"

#include <stdexcept>

#include "maps.h"

namespace enfilade::gmap {
namespace {

TEST(Map, NewDartIsFreeAndAloneInItsCells) {
    Map map;
    const DartId a = map.add_dart();
    const DartId b = map.add_dart();
    EXPECT_TRUE(map.is_free<0>(a) && map.is_free<1>(a) && map.is_free<2>(a) && map.is_free<3>(a));
    EXPECT_NE(map.vertex(a), map.vertex(b));
    EXPECT_NE(map.volume(a), map.volume(b));
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{2, 2, 2, 2}));
}

TEST(Map, RemovedDartLeavesAGapThatIsReused) {
    Map map;
    const DartId a = map.add_dart();
    map.add_dart();
    ASSERT_TRUE(map.remove_dart(a));
    EXPECT_FALSE(map.contains(a));
    EXPECT_TRUE(map.has_gaps());
    EXPECT_EQ(map.vertex_count(), 1u);
    EXPECT_EQ(map.add_dart(), a);
    EXPECT_FALSE(map.has_gaps());
}

TEST(Map, LinkedDartIsNotRemoved) {
    Map map = cube();
    EXPECT_FALSE(map.remove_dart(DartId{0}));
    EXPECT_EQ(map.dart_count(), 96u);
}

TEST(Map, CubeHasTheCellsOfACube) { EXPECT_EQ(cell_counts(cube()), (std::vector<std::size_t>{8, 12, 6, 2})); }

TEST(Map, ChainedAlphaAppliesTheFirstFirst) {
    const Map map = cube();
    for (const DartId d : map.darts()) EXPECT_EQ((map.alpha<0, 1>(d)), map.alpha<1>(map.alpha<0>(d)));
}

TEST(Map, TakesThirtyTwoBytesADart) {
    const Map map = grid(4, 4, 4);
    EXPECT_EQ(Map::bytes_per_dart(), 32u);
    EXPECT_EQ(map.memory_bytes(), 32 * map.dart_count());
}

TEST(Map, AppendedMapKeepsItsShape) {
    Map map = cube();
    map.append(cube());
    map.append(map);
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{32, 48, 24, 8}));
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Map, CompactClosesGapsAndKeepsTheOrder) {
    Map map;
    const DartId gone = map.add_dart();
    map.append(cube());
    ASSERT_TRUE(map.remove_dart(gone));
    const Renumbering renumbering = map.compact();
    EXPECT_EQ(map.arrays().alpha, cube().arrays().alpha);
    EXPECT_EQ(map.arrays().cell_id, cube().arrays().cell_id);
    EXPECT_EQ(map.cell_bound<0>(), 8u);
    EXPECT_EQ(renumbering.darts[0], none<DartId>);
    EXPECT_EQ(renumbering.darts[5], DartId{4});
}

TEST(Map, ArraysWithGapsAreTakenBack) {
    Map map;
    const DartId gone = map.add_dart();
    map.append(cube());
    ASSERT_TRUE(map.remove_dart(gone));
    map.compact();
    Map with_gap = map;
    ASSERT_TRUE(remove_volume(with_gap, DartId{0}));
    MapArrays arrays = with_gap.arrays();
    const Map again(std::move(arrays));
    EXPECT_EQ(again.dart_count(), 48u);
    EXPECT_EQ(cell_counts(again), (std::vector<std::size_t>{8, 12, 6, 1}));
}

TEST(Map, RefusesArraysOfDifferentLengths) {
    EXPECT_THROW(edited(cube(), [](MapArrays& arrays) { arrays.alpha[2].pop_back(); }), std::invalid_argument);
    EXPECT_THROW(edited(cube(), [](MapArrays& arrays) { arrays.cell_id[3].pop_back(); }), std::invalid_argument);
}

TEST(Map, RefusesIndicesOutOfRange) {
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_THROW(edited(cube(), [&](MapArrays& arrays) { arrays.alpha[i][7] = 96; }), std::invalid_argument);
        EXPECT_THROW(edited(cube(), [&](MapArrays& arrays) { arrays.cell_id[i][7] = arrays.cell_bound[i]; }),
                     std::invalid_argument);
    }
    EXPECT_THROW(edited(cube(), [](MapArrays& arrays) { arrays.cell_bound[0] = 97; }), std::invalid_argument);
}

TEST(Map, RefusesHalfAGap) {
    EXPECT_THROW(edited(cube(), [](MapArrays& arrays) { arrays.alpha[0][7] = detail::none_u32; }),
                 std::invalid_argument);
}

TEST(Map, RefusesLinksToAGap) {
    EXPECT_THROW(edited(cube(),
                        [](MapArrays& arrays) {
                            for (std::size_t i = 0; i < 4; ++i)
                                arrays.alpha[i][7] = arrays.cell_id[i][7] = detail::none_u32;
                        }),
                 std::invalid_argument);
}

}  // namespace
}  // namespace enfilade::gmap
