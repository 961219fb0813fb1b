#include "gmap/cell_tuples.h"

#include <stdexcept>

#include "maps.h"

namespace enfilade::gmap {
namespace {

TEST(BuildMap, PutsDartsWhereItSays) {
    const CellTuples tuples = grid_tuples(2, 3, 2);
    const Map map = built(tuples);
    for (std::uint32_t f = 0; f < tuples.face_count(); ++f) {
        const std::uint32_t first = tuples.ring_first[f];
        const std::uint32_t n = tuples.ring_first[f + 1] - first;
        for (std::uint32_t s = 0; s < 2; ++s)
            for (std::uint32_t k = 0; k < n; ++k) {
                const DartId d{4 * first + s * 2 * n + 2 * k};
                const DartId e{4 * first + s * 2 * n + 2 * k + 1};
                EXPECT_EQ(map.vertex(d), VertexId{tuples.ring[first + k]});
                EXPECT_EQ(map.vertex(e), VertexId{tuples.ring[first + (k + 1) % n]});
                EXPECT_EQ(map.edge(d), map.edge(e));
                EXPECT_EQ(map.face(d), FaceId{f});
                EXPECT_EQ(map.volume(d), VolumeId{tuples.face_volumes[f][s]});
            }
    }
}

TEST(BuildMap, ChangesTheIthIdByAlphaI) {
    const Map map = grid(3, 2, 2);
    for (const DartId d : map.darts()) {
        EXPECT_NE(map.vertex(map.alpha<0>(d)), map.vertex(d));
        EXPECT_NE(map.edge(map.alpha<1>(d)), map.edge(d));
        EXPECT_NE(map.face(map.alpha<2>(d)), map.face(d));
        EXPECT_NE(map.volume(map.alpha<3>(d)), map.volume(d));
    }
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(BuildMap, NumbersEdgesByFirstUse) {
    const Map map = built(grid_tuples(2, 2, 2));
    std::uint32_t known = 0;
    for (std::uint32_t d = 0; d < map.dart_bound(); d += 2) {
        const auto e = static_cast<std::uint32_t>(map.edge(DartId{d}));
        EXPECT_LE(e, known);
        if (e == known) ++known;
    }
    EXPECT_EQ(known, map.edge_count());
}

TEST(BuildMap, CountsOnlyCellsInUse) {
    CellTuples tuples = hexahedron_tuples();
    tuples.vertex_count = 11;
    tuples.volume_count = 5;
    const Map map = built(tuples);
    EXPECT_EQ(map.vertex_count(), 8u);
    EXPECT_EQ(map.cell_bound<0>(), 11u);
    EXPECT_EQ(map.volume_count(), 2u);
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
}

TEST(BuildMap, DoesNotDependOnTheNumberOfThreads) {
    const CellTuples tuples = grid_tuples(12, 11, 10);
    std::vector<Defect> defects;
    const Map one = build_map(tuples, defects, 1);
    const Map many = build_map(tuples, defects, 5);
    EXPECT_TRUE(defects.empty());
    EXPECT_EQ(one.arrays().alpha, many.arrays().alpha);
    EXPECT_EQ(one.arrays().cell_id, many.arrays().cell_id);
}

TEST(BuildMap, AcceptsRingsInEitherDirection) {
    CellTuples tuples = grid_tuples(2, 2, 2);
    for (std::size_t f = 0; f < tuples.face_count(); f += 3)
        std::reverse(tuples.ring.begin() + tuples.ring_first[f], tuples.ring.begin() + tuples.ring_first[f + 1]);
    const Map map = built(tuples);
    EXPECT_TRUE(validate(map).is_sound()) << text_of(validate(map));
}

TEST(BuildMap, ReportsALoneDartAndLeavesItFree) {
    CellTuples tuples = hexahedron_tuples();
    tuples.face_volumes.back() = {0, 0};  // the outside has no face there
    tuples.face_volumes.back()[1] = 2;
    tuples.volume_count = 3;
    std::vector<Defect> defects;
    const Map map = build_map(tuples, defects);
    ASSERT_EQ(defects.size(), 8u);  // four edges of the outside, four of volume 2
    for (const Defect& defect : defects) {
        EXPECT_EQ(defect.code, "T2");
        EXPECT_TRUE(map.is_free<2>(defect.dart));
    }
}

TEST(BuildMap, ReportsAThirdDartAndNeverOverwrites) {
    CellTuples tuples = hexahedron_tuples();
    // A second bottom, turned the same way: on each of its edges both volumes have three faces.
    tuples.ring.insert(tuples.ring.end(), {0, 1, 2, 3});
    tuples.ring_first.push_back(static_cast<std::uint32_t>(tuples.ring.size()));
    tuples.face_volumes.push_back({0, 1});
    std::vector<Defect> defects;
    const Map map = build_map(tuples, defects);
    ASSERT_EQ(defects.size(), 8u);
    for (const Defect& defect : defects) {
        EXPECT_EQ(defect.code, "T4");
        EXPECT_EQ(defect.face, FaceId{6});
        EXPECT_TRUE(map.is_free<2>(defect.dart));
    }
    const Map sound = cube();
    for (const DartId d : sound.darts()) EXPECT_EQ(map.alpha<2>(d), sound.alpha<2>(d));
}

TEST(BuildMap, ReportsAnEdgeFromAVertexToItself) {
    CellTuples tuples = hexahedron_tuples();
    tuples.ring[0] = tuples.ring[1];
    std::vector<Defect> defects;
    const Map map = build_map(tuples, defects);
    EXPECT_TRUE(std::any_of(defects.begin(), defects.end(), [](const Defect& d) { return d.code == "T6"; }));
    EXPECT_EQ(map.dart_count(), 96u);
}

TEST(BuildMap, ReportsAFaceWithoutEdges) {
    CellTuples tuples = hexahedron_tuples();
    tuples.ring_first.push_back(tuples.ring_first.back());
    tuples.face_volumes.push_back({0, 1});
    std::vector<Defect> defects;
    const Map map = build_map(tuples, defects);
    ASSERT_EQ(defects.size(), 1u);
    EXPECT_EQ(defects[0].code, "T6");
    EXPECT_EQ(map.face_count(), 6u);
}

TEST(BuildMap, RefusesIndicesOutOfRange) {
    std::vector<Defect> defects;
    CellTuples vertex = hexahedron_tuples();
    vertex.ring[3] = 8;
    EXPECT_THROW((void)build_map(vertex, defects), std::invalid_argument);
    CellTuples volume = hexahedron_tuples();
    volume.face_volumes[3][1] = 2;
    EXPECT_THROW((void)build_map(volume, defects), std::invalid_argument);
    CellTuples rings = hexahedron_tuples();
    rings.ring_first.pop_back();
    EXPECT_THROW((void)build_map(rings, defects), std::invalid_argument);
}

TEST(BuildMap, OfNothingIsEmpty) {
    std::vector<Defect> defects;
    EXPECT_EQ(build_map({}, defects).dart_count(), 0u);
    EXPECT_TRUE(defects.empty());
}

TEST(Primitives, AreSound) {
    for (std::uint32_t n : {3u, 4u, 7u, 100u}) EXPECT_TRUE(validate(built(prism_tuples(n))).is_sound()) << n;
    EXPECT_TRUE(validate(grid(1, 1, 1)).is_sound());
    EXPECT_TRUE(validate(grid(4, 3, 5)).is_sound());
    EXPECT_TRUE(validate(built(wrapped_grid_tuples(3, 4, 5))).is_sound());
    EXPECT_EQ(cell_counts(grid(4, 3, 5)), (std::vector<std::size_t>{5 * 4 * 6, 4 * 4 * 6 + 5 * 3 * 6 + 5 * 4 * 5,
                                                                    5 * 3 * 5 + 4 * 4 * 5 + 4 * 3 * 6, 61}));
}

TEST(Primitives, RefuseWhatTheyCannotBuild) {
    EXPECT_THROW((void)prism_tuples(2), std::invalid_argument);
    EXPECT_THROW((void)grid_tuples(1, 0, 1), std::invalid_argument);
    EXPECT_THROW((void)wrapped_grid_tuples(3, 2, 3), std::invalid_argument);
}

}  // namespace
}  // namespace enfilade::gmap
