#include "gmap/insert.h"
#include "gmap/isomorphism.h"
#include "gmap/remove.h"
#include "gmap/sew.h"
#include "maps.h"

namespace enfilade::gmap {
namespace {

std::vector<std::size_t> sum(std::vector<std::size_t> counts, const std::vector<int>& by) {
    for (std::size_t i = 0; i < 4; ++i) counts[i] += static_cast<std::size_t>(by[i]);
    return counts;
}

void expect_unchanged(const Map& map, const MapArrays& before) {
    EXPECT_EQ(map.arrays().alpha, before.alpha);
    EXPECT_EQ(map.arrays().cell_id, before.cell_id);
}

TEST(InsertVertex, CutsAnEdgeInTwo) {
    Map map = grid(2, 2, 2);
    const auto before = cell_counts(map);
    const DartId d = dart_between(map, 0, 1);
    const EdgeId edge = map.edge(d);
    const VertexId far = map.vertex(map.alpha<0>(d));
    const auto changes = insert_vertex(map, d);
    ASSERT_TRUE(changes);
    EXPECT_EQ(cell_counts(map), sum(before, {1, 1, 0, 0}));
    EXPECT_EQ(changes->dart, map.alpha<0>(d));
    EXPECT_EQ(map.edge(d), edge);
    EXPECT_EQ(map.vertex(map.alpha<0, 1, 0>(d)), far);
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(InsertVertex, IsUndone) {
    for (const DartId d : {DartId{0}, DartId{77}}) {
        Map map = grid(2, 2, 2);
        const auto changes = insert_vertex(map, d);
        ASSERT_TRUE(changes && remove_vertex(map, changes->dart));
        EXPECT_TRUE(is_isomorphic(map, grid(2, 2, 2)));
        EXPECT_EQ(cell_counts(map), cell_counts(grid(2, 2, 2)));
        EXPECT_TRUE(all_ids_are_orbits(map));
    }
}

TEST(InsertVertex, WorksOnAnOpenEdge) {
    Map map;
    const DartId d = map.add_dart();
    ASSERT_TRUE(insert_vertex(map, d));
    EXPECT_EQ(map.dart_count(), 2u);
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{2, 1, 1, 1}));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(InsertEdge, SplitsAFaceOnBothSides) {
    Map map = grid(2, 2, 2);
    const auto before = cell_counts(map);
    const DartId d = dart_between(map, 0, 1);
    const FaceId face = map.face(d);
    const auto changes = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(changes);
    EXPECT_EQ(cell_counts(map), sum(before, {0, 1, 1, 0}));
    EXPECT_EQ(map.face(d), face);
    EXPECT_NE(map.face(map.alpha<1, 2>(d)), face);
    EXPECT_EQ(map.alpha<1>(d), changes->dart);
    EXPECT_EQ(map.volume(map.alpha<3>(changes->dart)), VolumeId{1});
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(InsertEdge, TakesEitherDartOfACorner) {
    Map by_one = grid(2, 2, 2);
    Map by_other = grid(2, 2, 2);
    const DartId d = dart_between(by_one, 0, 1);
    const DartId e = by_one.alpha<0, 1, 0>(d);
    ASSERT_TRUE(insert_edge(by_one, d, e));
    ASSERT_TRUE(insert_edge(by_other, d, by_other.alpha<1>(e)));
    EXPECT_EQ(by_one.arrays().alpha, by_other.arrays().alpha);
}

TEST(InsertEdge, IsUndone) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 0, 1);
    const auto changes = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(changes && remove_edge(map, changes->dart));
    EXPECT_TRUE(is_isomorphic(map, grid(2, 2, 2)));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(InsertEdge, WorksOnAFaceWithOneSide) {
    Map map = cube();
    ASSERT_TRUE(remove_volume(map, map.representatives<3>()[1]));
    const DartId d = map.representatives<3>()[0];
    ASSERT_TRUE(insert_edge(map, d, map.alpha<0, 1, 0>(d)));
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{8, 13, 7, 1}));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(InsertEdge, RefusesCornersThatDoNotBelongTogether) {
    Map map = grid(2, 2, 2);
    const MapArrays before = map.arrays();
    const DartId d = dart_between(map, 0, 1);
    EXPECT_FALSE(insert_edge(map, d, d));
    EXPECT_FALSE(insert_edge(map, d, map.alpha<1>(d)));
    EXPECT_FALSE(insert_edge(map, d, map.alpha<2>(d)));
    EXPECT_FALSE(insert_edge(map, d, map.alpha<0, 1, 0, 3>(d)));
    EXPECT_FALSE(insert_edge(map, d, DartId(map.dart_bound())));
    expect_unchanged(map, before);
}

TEST(InsertEdge, RefusesAnOpenFace) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 0, 1);
    const DartId e = map.alpha<0, 1, 0>(d);
    ASSERT_TRUE(unsew<1>(map, d));
    EXPECT_FALSE(insert_edge(map, d, e));
    EXPECT_FALSE(insert_edge(map, e, d));
}

/// The four upright sides of a hexahedron, seen from its bottom: the path along their middle after each upright edge
/// was cut.
std::vector<DartId> waist(Map& map, DartId bottom) {
    std::vector<DartId> upright;
    for (const DartId d : face_path(map, bottom)) upright.push_back(map.alpha<2, 1>(d));
    for (const DartId d : upright) EXPECT_TRUE(insert_vertex(map, d));
    std::vector<DartId> path;
    for (std::size_t k = 0; k < upright.size(); ++k) {
        // From the new vertex of one upright edge to that of the next one around the bottom, within their face.
        const DartId corner = map.alpha<0>(upright[k]);
        const DartId next = map.alpha<2, 0>(upright[(k + 1) % upright.size()]);
        const auto changes = insert_edge(map, corner, next);
        EXPECT_TRUE(changes);
        if (changes) path.push_back(changes->dart);
    }
    return path;
}

TEST(InsertFace, SplitsAHexahedronInTwo) {
    Map map = grid(2, 2, 2);
    const DartId bottom = map.representatives<3>()[0];
    const std::vector<DartId> path = waist(map, bottom);
    const auto before = cell_counts(map);
    const auto changes = insert_face(map, path);
    ASSERT_TRUE(changes);
    EXPECT_EQ(cell_counts(map), sum(before, {0, 0, 1, 1}));
    EXPECT_EQ(map.volume(path[0]), VolumeId{0});
    EXPECT_EQ(map.alpha<2>(path[0]), changes->dart);
    EXPECT_NE(map.volume(map.alpha<3>(changes->dart)), VolumeId{0});
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(InsertFace, IsUndone) {
    Map map = grid(2, 2, 2);
    const std::vector<DartId> path = waist(map, map.representatives<3>()[0]);
    const Map before = map;
    const auto changes = insert_face(map, path);
    ASSERT_TRUE(changes && remove_face(map, changes->dart));
    EXPECT_TRUE(is_isomorphic(map, before));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(InsertFace, RefusesPathsThatAreNone) {
    Map map = grid(2, 2, 2);
    std::vector<DartId> path = waist(map, map.representatives<3>()[0]);
    const MapArrays before = map.arrays();
    EXPECT_FALSE(insert_face(map, {}));
    EXPECT_FALSE(insert_face(map, std::vector<DartId>{path[0], path[1], path[2]}));  // open
    std::vector<DartId> crossed = path;
    crossed[2] = map.alpha<2>(crossed[2]);  // on the other side
    EXPECT_FALSE(insert_face(map, crossed));
    std::vector<DartId> backward = path;
    backward[1] = map.alpha<0>(backward[1]);
    EXPECT_FALSE(insert_face(map, backward));
    std::vector<DartId> twice = path;
    twice.insert(twice.end(), path.begin(), path.end());
    EXPECT_FALSE(insert_face(map, twice));
    std::vector<DartId> outside = path;
    outside[0] = map.alpha<3>(outside[0]);
    EXPECT_FALSE(insert_face(map, outside));
    expect_unchanged(map, before);
    EXPECT_TRUE(insert_face(map, path));
}

/// The path on the shell of a volume from vertex to vertex, turning the same way at each.
std::vector<DartId> path_through(const Map& map, VolumeId volume, const std::vector<std::uint32_t>& vertices) {
    std::vector<DartId> path;
    for (const DartId d : map.darts())
        if (map.volume(d) == volume && map.vertex(d) == VertexId{vertices[0]} &&
            map.vertex(map.alpha<0>(d)) == VertexId{vertices[1]}) {
            path.push_back(d);
            break;
        }
    for (std::size_t k = 1; k < vertices.size(); ++k) {
        DartId x = map.alpha<0, 1>(path.back());
        while (map.vertex(map.alpha<0>(x)) != VertexId{vertices[(k + 1) % vertices.size()]}) x = map.alpha<2, 1>(x);
        path.push_back(x);
    }
    return path;
}

TEST(InsertFace, CutsARingOpenAndThenInTwo) {
    // A room around a pillar is no ball; one face across makes it one that meets itself there, a second one makes two
    // rooms.
    CellTuples tuples = grid_tuples(3, 3, 1);
    const auto name = [](std::uint32_t v) { return v == 4 || v == 9 ? v : 0; };
    CellTuples ring;
    ring.vertex_count = tuples.vertex_count;
    ring.volume_count = tuples.volume_count;
    ring.ring_first = {0};
    for (std::size_t f = 0; f < tuples.face_count(); ++f) {
        if (name(tuples.face_volumes[f][0]) == name(tuples.face_volumes[f][1])) continue;
        ring.ring.insert(ring.ring.end(), tuples.ring.begin() + tuples.ring_first[f],
                         tuples.ring.begin() + tuples.ring_first[f + 1]);
        ring.ring_first.push_back(static_cast<std::uint32_t>(ring.ring.size()));
        ring.face_volumes.push_back({name(tuples.face_volumes[f][0]), name(tuples.face_volumes[f][1])});
    }
    Map map = built(ring);
    EXPECT_EQ(codes_of(validate(map)), std::vector<std::string>{"T7"});
    ASSERT_TRUE(insert_face(map, path_through(map, VolumeId{0}, {1, 5, 21, 17})));
    EXPECT_EQ(codes_of(validate(map)), std::vector<std::string>{"T4"}) << text_of(validate(map));
    EXPECT_EQ(map.volume_count(), 3u);
    ASSERT_TRUE(insert_face(map, path_through(map, VolumeId{0}, {14, 10, 26, 30})));
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_EQ(map.volume_count(), 4u);
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(RemoveVertex, RefusesWhereMoreThanTwoEdgesMeet) {
    Map map = cube();
    const MapArrays before = map.arrays();
    EXPECT_FALSE(remove_vertex(map, DartId{0}));
    expect_unchanged(map, before);
}

TEST(RemoveVertex, RefusesTheTipOfADanglingEdge) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 0, 1);
    const auto edge = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(edge);
    const auto middle = insert_vertex(map, edge->dart);
    ASSERT_TRUE(middle);
    const DartId tip = map.alpha<1>(middle->dart);
    ASSERT_TRUE(remove_edge(map, edge->dart));
    const MapArrays before = map.arrays();
    EXPECT_FALSE(remove_vertex(map, tip));
    expect_unchanged(map, before);
}

TEST(RemoveEdge, RefusesWhereMoreThanTwoFacesMeet) {
    Map map = grid(2, 2, 2);
    const MapArrays before = map.arrays();
    EXPECT_FALSE(remove_edge(map, dart_between(map, 0, 1)));
    expect_unchanged(map, before);
}

TEST(RemoveEdge, MergesTwoFacesAndKeepsTheLowerId) {
    Map map = cube();
    const DartId d{0};
    const FaceId a = map.face(d);
    const FaceId b = map.face(map.alpha<2>(d));
    const DartId rest = map.alpha<1>(d);
    const auto changes = remove_edge(map, d);
    ASSERT_TRUE(changes);
    EXPECT_EQ(map.face(rest), std::min(a, b));
    EXPECT_EQ(cell_counts(map), (std::vector<std::size_t>{8, 11, 5, 2}));
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(RemoveEdge, TakesADanglingEdgeAway) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 0, 1);
    const auto edge = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(edge);
    const auto middle = insert_vertex(map, edge->dart);
    ASSERT_TRUE(middle);
    const DartId beyond = map.alpha<1>(middle->dart);
    ASSERT_TRUE(remove_edge(map, edge->dart));
    const auto changes = remove_edge(map, beyond);
    ASSERT_TRUE(changes);
    EXPECT_TRUE(is_isomorphic(map, grid(2, 2, 2)));
    EXPECT_TRUE(all_ids_are_orbits(map));
    EXPECT_EQ(changes->cells.size(), 2u);  // the edge and its tip
    for (const CellChange& change : changes->cells) EXPECT_EQ(change.kind, CellChange::Kind::Removed);
}

TEST(RemoveFace, MergesTwoVolumesAndKeepsTheLowerId) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 3, 2);
    const DartId rest = map.alpha<2>(d);
    ASSERT_TRUE(remove_face(map, d));
    EXPECT_EQ(map.volume(rest), VolumeId{2});
    EXPECT_EQ(map.volume_count(), 8u);
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(RemoveFace, RefusesToTurnARoomIntoARing) {
    Map map = grid(2, 2, 1);
    for (const std::uint32_t v : {1u, 3u, 2u}) {
        DartId face = none<DartId>;
        for (const DartId d : map.darts())
            if (map.volume(d) == VolumeId{v} && map.volume(map.alpha<3>(d)) == VolumeId{0}) face = d;
        ASSERT_TRUE(remove_face(map, face)) << v;
    }
    // The last of the four faces around the middle edge has the one room on both sides; it is a fin, and may go.
    DartId last = none<DartId>;
    for (const DartId d : map.darts())
        if (map.volume(d) == map.volume(map.alpha<3>(d))) last = d;
    ASSERT_NE(last, none<DartId>);
    ASSERT_TRUE(remove_face(map, last));
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
    EXPECT_TRUE(all_ids_are_orbits(map));
    EXPECT_EQ(map.volume_count(), 2u);

    Map ring = grid(3, 3, 1);
    for (const std::uint32_t v : {1u, 2u, 5u, 8u, 7u, 6u, 3u}) {
        DartId face = none<DartId>;
        for (const DartId d : ring.darts())
            if (ring.volume(d) == VolumeId{v} && ring.volume(ring.alpha<3>(d)) == VolumeId{0}) face = d;
        ASSERT_TRUE(remove_face(ring, face)) << v;
    }
    for (const DartId d : ring.darts())
        if (ring.volume(d) == ring.volume(ring.alpha<3>(d))) last = d;
    const MapArrays before = ring.arrays();
    EXPECT_FALSE(remove_face(ring, last));
    expect_unchanged(ring, before);
}

TEST(RemoveFace, RefusesTheHullOfAnOpenMap) {
    Map map = grid(2, 1, 1);
    ASSERT_TRUE(remove_volume(map, map.representatives<3>()[2]));
    for (const DartId d : map.darts()) {
        if (!map.is_free<3>(d)) continue;
        EXPECT_FALSE(remove_face(map, d));
        break;
    }
}

TEST(RemoveVolume, OpensItsNeighbours) {
    Map map = grid(2, 1, 1);
    const auto changes = remove_volume(map, map.representatives<3>()[1]);
    ASSERT_TRUE(changes);
    EXPECT_EQ(map.volume_count(), 2u);
    EXPECT_EQ(map.face_count(), 11u);  // each face keeps its other side
    std::size_t open = 0;
    for (const DartId d : map.darts()) open += map.is_free<3>(d) ? 1 : 0;
    EXPECT_EQ(open, 48u);
    EXPECT_TRUE(all_ids_are_orbits(map));
}

}  // namespace
}  // namespace enfilade::gmap
