#include "gmap/sew.h"

#include "gmap/isomorphism.h"
#include "maps.h"

namespace enfilade::gmap {
namespace {

/// A polygon of n edges by sewing darts one by one: alone, 2- and 3-free.
DartId add_polygon(Map& map, std::uint32_t n) {
    std::vector<DartId> darts;
    for (std::uint32_t k = 0; k < 2 * n; ++k) darts.push_back(map.add_dart());
    for (std::uint32_t k = 0; k < n; ++k) {
        EXPECT_TRUE(sew<0>(map, darts[2 * k], darts[2 * k + 1]));
        EXPECT_TRUE(sew<1>(map, darts[2 * k + 1], darts[(2 * k + 2) % (2 * n)]));
    }
    return darts[0];
}

/// Two triangles back to back, sewn along all edges: the smallest shell.
DartId add_pillow(Map& map) {
    const DartId a = add_polygon(map, 3);
    const DartId b = add_polygon(map, 3);
    DartId x = a;
    DartId y = b;
    for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE(sew<2>(map, x, y));
        x = map.alpha<0, 1>(x);
        y = map.alpha<0, 1>(y);
    }
    return a;
}

TEST(Sew, BuildsAPolygonFromDarts) {
    Map map;
    add_polygon(map, 5);
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{5, 5, 1, 1}));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Sew, BuildsAShellFromPolygons) {
    Map map;
    add_pillow(map);
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{3, 3, 2, 1}));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Sew, GluesWholeFaces) {
    Map map;
    const DartId a = add_pillow(map);
    const DartId b = add_pillow(map);
    const auto changes = sew<3>(map, a, b);
    ASSERT_TRUE(changes);
    EXPECT_EQ(map.alpha<3>(a), b);
    EXPECT_EQ(map.alpha<3>(map.alpha<1>(a)), map.alpha<1>(b));
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{3, 3, 3, 2}));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Sew, TellsWhichCellsBecameOne) {
    Map map;
    const DartId a = add_pillow(map);
    const DartId b = add_pillow(map);
    const std::vector<std::uint32_t> faces{static_cast<std::uint32_t>(map.face(a)),
                                           static_cast<std::uint32_t>(map.face(b))};
    const auto changes = sew<3>(map, a, b);
    ASSERT_TRUE(changes);
    std::vector<std::size_t> merged(4, 0);
    for (const CellChange& change : changes->cells) {
        EXPECT_EQ(change.kind, CellChange::Kind::Merged);
        ++merged[static_cast<std::size_t>(change.dimension)];
        if (change.dimension == 2) {
            EXPECT_EQ(change.cell, std::min(faces[0], faces[1]));
            EXPECT_EQ(change.other, std::max(faces[0], faces[1]));
        }
    }
    EXPECT_EQ(merged, (std::vector<std::size_t>{3, 3, 1, 0}));
}

TEST(Sew, RefusesFacesOfDifferentLengthAndChangesNothing) {
    Map map;
    const DartId a = add_polygon(map, 3);
    const DartId b = add_polygon(map, 4);
    const MapArrays before = map.arrays();
    EXPECT_FALSE(is_sewable<3>(map, a, b));
    EXPECT_FALSE(sew<3>(map, a, b));
    EXPECT_FALSE(sew<3>(map, b, a));
    EXPECT_EQ(map.arrays().alpha, before.alpha);
    EXPECT_EQ(map.arrays().cell_id, before.cell_id);
}

TEST(Sew, RefusesWhatIsSewnAlready) {
    Map map = cube();
    for (const DartId d : {DartId{0}, DartId{17}}) {
        EXPECT_FALSE(sew<3>(map, d, DartId{40}));
        EXPECT_FALSE(sew<0>(map, d, DartId{40}));
    }
}

TEST(Sew, RefusesAnOpenFaceOnAClosedOne) {
    Map map;
    const DartId a = add_polygon(map, 4);
    const DartId b = add_polygon(map, 4);
    ASSERT_TRUE(unsew<1>(map, b));
    EXPECT_FALSE(sew<3>(map, a, b));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Sew, RefusesADartToItself) {
    Map map;
    const DartId d = map.add_dart();
    EXPECT_FALSE(sew<0>(map, d, d));
    EXPECT_FALSE(sew<3>(map, d, DartId{5}));
    EXPECT_EQ(map.dart_count(), 1u);
}

TEST(Sew, RefusesToFoldAFaceOntoItself) {
    Map map;
    const DartId d = add_polygon(map, 4);
    for (const DartId e : cell<2>(map, d)) EXPECT_FALSE(is_sewable<3>(map, d, e));
    EXPECT_FALSE(is_sewable<2>(map, d, map.alpha<0>(d)));
}

template <int I>
void undo_each(const Map& sound) {
    for (const DartId d : {DartId{0}, DartId{33}, DartId{170}}) {
        Map map = sound;
        const DartId e = map.alpha<I>(d);
        ASSERT_TRUE(unsew<I>(map, d));
        EXPECT_TRUE(map.is_free<I>(d) && map.is_free<I>(e));
        EXPECT_TRUE(all_ids_are_orbits(map));
        EXPECT_FALSE(is_isomorphic(map, sound));
        EXPECT_FALSE(unsew<I>(map, d));
        ASSERT_TRUE(sew<I>(map, d, e));
        EXPECT_EQ(map.arrays().alpha, sound.arrays().alpha);
        EXPECT_TRUE(all_ids_are_orbits(map));
        EXPECT_EQ(cell_counts(map), cell_counts(sound));
        EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    }
}

TEST(Unsew, IsUndoneBySew) {
    const Map map = grid(2, 2, 2);
    undo_each<0>(map);
    undo_each<1>(map);
    undo_each<2>(map);
    undo_each<3>(map);
}

TEST(Unsew, SplitsTheFaceBetweenTwoVolumes) {
    Map map = cube();
    const auto changes = unsew<3>(map, DartId{0});
    ASSERT_TRUE(changes);
    ASSERT_EQ(changes->cells.size(), 1u);  // the edges and vertices still hang together by the other faces
    EXPECT_EQ(changes->cells[0].kind, CellChange::Kind::Split);
    EXPECT_EQ(changes->cells[0].dimension, 2);
    EXPECT_EQ(map.face_count(), 7u);
    EXPECT_EQ(map.face(DartId{0}), FaceId{0});  // the side of the dart keeps the id
}

}  // namespace
}  // namespace enfilade::gmap
