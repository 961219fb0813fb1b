#include "gmap/close.h"

#include "gmap/isomorphism.h"
#include "gmap/sew.h"
#include "maps.h"

namespace enfilade::gmap {
namespace {

TEST(Close, PutsBackTheOutside) {
    const Map sound = grid(3, 2, 2);
    Map map = sound;
    ASSERT_TRUE(remove_volume(map, map.representatives<3>()[12]));
    const auto [closed, added] = closed_copy(map);
    EXPECT_EQ(added.size(), 1u);
    EXPECT_EQ(closed.volume(closed.alpha<3>(dart_between(sound, 0, 12))), added[0]);
    EXPECT_TRUE(is_isomorphic(closed, sound));
    EXPECT_TRUE(validate(closed).is_sound()) << text_of(validate(closed));
    EXPECT_TRUE(all_ids_are_orbits(closed));
}

TEST(Close, FillsEachHoleWithAVolumeOfItsOwn) {
    const Map sound = grid(5, 3, 3);
    Map map = sound;
    const std::vector<DartId> at = map.representatives<3>();
    ASSERT_TRUE(remove_volume(map, at[16]));
    ASSERT_TRUE(remove_volume(map, at[18]));
    ASSERT_TRUE(remove_volume(map, at[44]));
    const Changes changes = close(map);
    EXPECT_EQ(changes.cells.size(), 3u);
    for (const CellChange& change : changes.cells) EXPECT_EQ(change.kind, CellChange::Kind::Created);
    EXPECT_TRUE(is_isomorphic(map, sound));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Close, ClosesASingleFaceToAPillow) {
    Map map = cube();
    ASSERT_TRUE(remove_volume(map, DartId{0}));
    ASSERT_TRUE(remove_volume(map, map.representatives<3>()[1]));
    EXPECT_EQ(map.dart_count(), 0u);
    std::vector<DartId> darts;
    for (int k = 0; k < 6; ++k) darts.push_back(map.add_dart());
    for (std::size_t k = 0; k < 6; k += 2) {
        ASSERT_TRUE(sew<0>(map, darts[k], darts[k + 1]));
        ASSERT_TRUE(sew<1>(map, darts[k + 1], darts[(k + 2) % 6]));
    }
    close(map);
    EXPECT_EQ(map.dart_count(), 12u);
    for (const DartId d : map.darts()) EXPECT_TRUE(map.is_free<2>(d) && !map.is_free<3>(d));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Close, LeavesAClosedMapAlone) {
    Map map = grid(2, 2, 2);
    const MapArrays before = map.arrays();
    const Changes changes = close(map);
    EXPECT_TRUE(changes.cells.empty());
    EXPECT_EQ(changes.dart, none<DartId>);
    EXPECT_EQ(map.arrays().alpha, before.alpha);
    EXPECT_TRUE(closed_copy(map).second.empty());
}

}  // namespace
}  // namespace enfilade::gmap
