// Each test breaks a sound map in one way and expects that code and no other.
#include "gmap/validate.h"

#include <algorithm>
#include <map>
#include <utility>

#include "gmap/insert.h"
#include "gmap/sew.h"
#include "maps.h"

namespace enfilade::gmap {
namespace {

/// Exactly `count` defects, all with this code and about this kind of cell.
testing::AssertionResult is_exactly(const Map& map, const std::string& code, Blamed blamed, std::size_t count = 1) {
    const Validation found = validate(map);
    bool as_expected = found.defects.size() == count;
    for (const Defect& defect : found.defects)
        as_expected = as_expected && defect.code == code && defect.blamed == blamed && map.contains(defect.dart) &&
                      !defect.sentence.empty();
    if (as_expected) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "expected " << count << " " << code << ", got\n" << text_of(found);
}

/// Without the faces between volumes of the same name.
CellTuples renamed(const CellTuples& tuples, const std::function<std::uint32_t(std::uint32_t)>& volume) {
    CellTuples result;
    result.vertex_count = tuples.vertex_count;
    result.volume_count = tuples.volume_count;
    result.ring_first.push_back(0);
    for (std::size_t f = 0; f < tuples.face_count(); ++f) {
        const std::uint32_t a = volume(tuples.face_volumes[f][0]);
        const std::uint32_t b = volume(tuples.face_volumes[f][1]);
        if (a == b) continue;
        result.ring.insert(result.ring.end(), tuples.ring.begin() + tuples.ring_first[f],
                           tuples.ring.begin() + tuples.ring_first[f + 1]);
        result.ring_first.push_back(static_cast<std::uint32_t>(result.ring.size()));
        result.face_volumes.push_back({a, b});
    }
    return result;
}

/// Merges a chain of hexahedra of a grid into the first, which has to have the lowest id.
void merge_chain(Map& map, const std::vector<std::uint32_t>& chain) {
    for (std::size_t k = 1; k < chain.size(); ++k) {
        DartId face = none<DartId>;
        for (const DartId d : map.darts())
            if (map.volume(d) == VolumeId{chain[k]} && map.volume(map.alpha<3>(d)) == VolumeId{chain[0]}) face = d;
        ASSERT_NE(face, none<DartId>);
        ASSERT_TRUE(remove_face(map, face).has_value());
    }
}

TEST(Validate, FindsNothingInSoundMaps) {
    for (const Map& map : {cube(), grid(3, 2, 4), built(prism_tuples(9)), built(wrapped_grid_tuples(4, 3, 3)), Map()}) {
        const Validation found = validate(map);
        EXPECT_TRUE(found.is_sound()) << text_of(found);
        EXPECT_EQ(found.suppressed, 0u);
    }
}

TEST(ValidateT1, FindsALinkThatDoesNotLeadBack) {
    const Map map = grid(3, 3, 3);
    for (std::size_t i = 0; i < 4; ++i) {
        const Map broken = edited(map, [&](MapArrays& arrays) { arrays.alpha[i][100] = 901; });
        EXPECT_TRUE(is_exactly(broken, "T1", i % 2 == 0 ? Blamed::Edge : Blamed::Face)) << "alpha" << i;
    }
}

TEST(ValidateT1, FindsAlpha0Alpha2ThatIsNoInvolution) {
    // Two faces at one end of an edge change places with two faces of another volume, at that end alone.
    const Map map = grid(3, 3, 3);
    const Map broken = edited(map, [&](MapArrays& arrays) {
        const DartId d = dart_between(map, 13, 26 - 13 + 1);
        const DartId e = map.alpha<3>(d);
        const DartId d2 = map.alpha<2>(d);
        const DartId e2 = map.alpha<2>(e);
        const auto link = [&](DartId x, DartId y) {
            arrays.alpha[2][index(x)] = static_cast<std::uint32_t>(y);
            arrays.alpha[2][index(y)] = static_cast<std::uint32_t>(x);
        };
        link(d, e);
        link(d2, e2);
    });
    const Validation found = validate(broken);
    ASSERT_FALSE(found.is_sound());
    for (const std::string& code : codes_of(found)) EXPECT_EQ(code, "T1") << text_of(found);
}

TEST(ValidateT1, FindsAlpha3ThatDoesNotCommute) {
    // alpha3 turned by one edge on one pair of darts and its neighbours: involutions all, but the faces do not match.
    const Map map = cube();
    for (const int j : {0, 1}) {
        const Map broken = edited(map, [&](MapArrays& arrays) {
            const DartId d{0};
            const DartId e = map.alpha(j, d);
            const DartId d3 = map.alpha<3>(d);
            const DartId e3 = map.alpha<3>(e);
            arrays.alpha[3][index(d)] = static_cast<std::uint32_t>(e3);
            arrays.alpha[3][index(e3)] = static_cast<std::uint32_t>(d);
            arrays.alpha[3][index(e)] = static_cast<std::uint32_t>(d3);
            arrays.alpha[3][index(d3)] = static_cast<std::uint32_t>(e);
        });
        const Validation found = validate(broken);
        ASSERT_FALSE(found.is_sound());
        for (const std::string& code : codes_of(found)) EXPECT_EQ(code, "T1") << text_of(found);
    }
}

TEST(ValidateT1, FindsADartWithAWrongCell) {
    const Map map = grid(3, 3, 3);
    for (std::size_t i = 0; i < 4; ++i) {
        const Map broken = edited(map, [&](MapArrays& arrays) { arrays.cell_id[i][100] = arrays.cell_id[i][1001]; });
        EXPECT_TRUE(is_exactly(broken, "T1", static_cast<Blamed>(i))) << i << "-cell";
    }
}

TEST(ValidateT2, FindsAFaceWithNothingBeyond) {
    Map map = grid(3, 3, 3);
    ASSERT_TRUE(unsew<3>(map, dart_between(map, 13, 14)));
    EXPECT_TRUE(is_exactly(map, "T2", Blamed::Face, 2));
}

TEST(ValidateT2, FindsAMissingVolumeByItsSixFaces) {
    Map map = grid(3, 3, 3);
    ASSERT_TRUE(remove_volume(map, map.representatives<3>()[13]));
    EXPECT_TRUE(is_exactly(map, "T2", Blamed::Face, 6));
}

TEST(ValidateT2, FindsAnOpenShell) {
    Map map = grid(3, 3, 3);
    ASSERT_TRUE(unsew<2>(map, dart_between(map, 13, 14)));
    EXPECT_TRUE(is_exactly(map, "T2", Blamed::Volume));
}

TEST(ValidateT2, FindsAnOpenFaceAndAnOpenEdge) {
    Map map = grid(3, 3, 3);
    ASSERT_TRUE(unsew<1>(map, dart_between(map, 13, 14)));
    EXPECT_TRUE(is_exactly(map, "T2", Blamed::Face));
    map = grid(3, 3, 3);
    ASSERT_TRUE(unsew<0>(map, dart_between(map, 13, 14)));
    const Validation found = validate(map);
    ASSERT_FALSE(found.is_sound());
    for (const Defect& defect : found.defects) EXPECT_TRUE(defect.code == "T2" && defect.blamed == Blamed::Edge);
}

TEST(ValidateT3, FindsAMapGluedToItsMirrorImage) {
    EXPECT_TRUE(is_exactly(built(wrapped_grid_tuples(4, 4, 4, true)), "T3", Blamed::Component));
}

TEST(ValidateT3, BlamesOnlyThePieceThatIsTwisted) {
    Map map = built(wrapped_grid_tuples(3, 3, 3, true));
    map.append(cube());
    ASSERT_TRUE(unsew<3>(map, DartId(map.dart_bound() - 1)));
    EXPECT_EQ(codes_of(validate(map)), (std::vector<std::string>{"T2", "T2", "T3"})) << text_of(validate(map));
}

TEST(ValidateT3, FindsAShellWithoutInside) {
    // The projective plane by six vertices and ten triangles, as the face of two volumes.
    CellTuples tuples;
    tuples.vertex_count = 6;
    tuples.volume_count = 2;
    tuples.ring = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1, 1, 2, 4, 2, 3, 5, 3, 4, 1, 4, 5, 2, 5, 1, 3};
    for (std::uint32_t f = 0; f <= 10; ++f) tuples.ring_first.push_back(3 * f);
    tuples.face_volumes.assign(10, {0, 1});
    EXPECT_TRUE(is_exactly(built(tuples), "T3", Blamed::Volume, 2));
}

TEST(ValidateT4, FindsAFaceWithOneVolumeOnBothSides) {
    // Eight hexahedra in a ring become one volume that meets itself in the last face between them.
    Map map = grid(3, 3, 1);
    merge_chain(map, {0, 1, 2, 5, 8, 7, 6, 3});
    EXPECT_TRUE(is_exactly(map, "T4", Blamed::Face));
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(ValidateT4, FindsAnEdgeWithOneFaceOnBothSides) {
    // The side of a prism unrolled: three of its four upright edges are gone, the fourth is a seam.
    Map map = cube();
    const DartId bottom = map.representatives<2>()[0];
    std::vector<DartId> upright;
    for (const DartId d : face_path(map, bottom)) upright.push_back(map.alpha<2, 1>(d));
    ASSERT_TRUE(insert_edge(map, bottom, map.alpha<0, 1, 0>(bottom)));  // four faces are left
    for (std::size_t k = 0; k < 3; ++k) ASSERT_TRUE(remove_edge(map, upright[k])) << k;
    EXPECT_FALSE(remove_edge(map, upright[3]));
    EXPECT_TRUE(is_exactly(map, "T4", Blamed::Edge));
}

TEST(ValidateT4, FindsAVolumeThatTouchesItselfAlongAnEdge) {
    Map map = grid(2, 2, 2);
    merge_chain(map, {0, 4, 5, 7, 3});  // 0 and 3 are neighbours across an edge only
    EXPECT_TRUE(is_exactly(map, "T4", Blamed::Edge));
}

TEST(ValidateT4, FindsAFaceIdWithTwoOrbits) {
    const Map map = grid(3, 3, 3);
    const Map broken = edited(map, [](MapArrays& arrays) {
        for (std::uint32_t& face : arrays.cell_id[2])
            if (face == 100) face = 0;
    });
    EXPECT_TRUE(is_exactly(broken, "T4", Blamed::Face));
}

TEST(ValidateT4, FindsAnEdgeIdWithTwoOrbits) {
    const Map broken = edited(grid(3, 3, 3), [](MapArrays& arrays) {
        for (std::uint32_t& edge : arrays.cell_id[1])
            if (edge == 100) edge = 0;
    });
    EXPECT_TRUE(is_exactly(broken, "T4", Blamed::Edge));
}

TEST(ValidateT5, FindsAVertexIdWithTwoOrbits) {
    const Map broken = edited(grid(3, 3, 3), [](MapArrays& arrays) {
        for (std::uint32_t& vertex : arrays.cell_id[0])
            if (vertex == 63) vertex = 21;
    });
    EXPECT_TRUE(is_exactly(broken, "T5", Blamed::Vertex));
}

TEST(ValidateT5, FindsAVolumeInTwoPieces) {
    const Map broken = edited(grid(3, 3, 3), [](MapArrays& arrays) {
        for (std::uint32_t& volume : arrays.cell_id[3])
            if (volume == 26) volume = 13;
    });
    EXPECT_TRUE(is_exactly(broken, "T5", Blamed::Volume));  // though the two touch in a vertex
    for (const std::uint32_t neighbour : {14u, 17u}) {      // ... or in a face, or in an edge
        const Map touching = edited(grid(3, 3, 3), [&](MapArrays& arrays) {
            for (std::uint32_t& volume : arrays.cell_id[3])
                if (volume == neighbour) volume = 13;
        });
        EXPECT_TRUE(is_exactly(touching, "T5", Blamed::Volume)) << neighbour;
    }
}

TEST(ValidateT5, FindsAVolumeThatTouchesItselfInAVertex) {
    Map map = grid(4, 4, 4);
    const auto at = [](std::uint32_t i, std::uint32_t j, std::uint32_t k) { return (k * 4 + j) * 4 + i; };
    // From (1,1,1) around to (2,2,2), which touches it in one vertex; the lowest id comes first in the chain of merges.
    std::vector<std::uint32_t> names;
    for (std::uint32_t v = 0; v <= 64; ++v) names.push_back(v);
    for (const std::uint32_t v :
         {at(0, 1, 1), at(0, 1, 2), at(0, 1, 3), at(0, 2, 3), at(1, 2, 3), at(2, 2, 3), at(2, 2, 2)})
        names[v] = at(1, 1, 1);
    map = built(renamed(grid_tuples(4, 4, 4), [&](std::uint32_t v) { return names[v]; }));
    EXPECT_TRUE(is_exactly(map, "T5", Blamed::Vertex));
}

TEST(ValidateT6, FindsADanglingEdge) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 0, 1);
    const auto edge = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(edge);
    ASSERT_TRUE(insert_vertex(map, edge->dart));
    ASSERT_TRUE(remove_edge(map, edge->dart));
    EXPECT_TRUE(is_exactly(map, "T6", Blamed::Edge));
}

TEST(ValidateT6, FindsAChainOfDanglingEdges) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 0, 1);
    const auto edge = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(edge);
    ASSERT_TRUE(insert_vertex(map, edge->dart));
    ASSERT_TRUE(insert_vertex(map, edge->dart));
    ASSERT_TRUE(remove_edge(map, edge->dart));
    EXPECT_TRUE(is_exactly(map, "T6", Blamed::Edge, 2));
}

TEST(ValidateT6, FindsADanglingFace) {
    Map map = grid(3, 3, 3);
    const DartId d = dart_between(map, 13, 14);
    ASSERT_TRUE(insert_edge(map, d, map.alpha<0, 1, 0>(d)));
    ASSERT_TRUE(remove_face(map, d));
    EXPECT_TRUE(is_exactly(map, "T6", Blamed::Face));
}

TEST(ValidateT6, FindsAFaceOfTwoEdges) {
    Map map = grid(2, 2, 2);
    const DartId d = dart_between(map, 0, 1);
    ASSERT_TRUE(insert_edge(map, d, map.alpha<0>(d)));
    EXPECT_TRUE(is_exactly(map, "T6", Blamed::Face));
}

TEST(ValidateT6, FindsAVolumeOfTwoFaces) {
    Map map = grid(2, 2, 2);
    ASSERT_TRUE(insert_face(map, face_path(map, dart_between(map, 0, 1))));
    EXPECT_TRUE(is_exactly(map, "T6", Blamed::Volume));
}

TEST(ValidateT7, FindsAVolumeThatIsARing) {
    const auto ring = [](std::uint32_t v) { return v == 4 || v == 9 ? v : 0; };
    const Map map = built(renamed(grid_tuples(3, 3, 1), ring));
    EXPECT_TRUE(is_exactly(map, "T7", Blamed::Volume));
}

TEST(ValidateT7, FindsVerticesWhoseSurroundingsAreNoBall) {
    // The suspension of the seven-vertex torus: tetrahedra all, but around the two apices lies a torus.
    CellTuples tuples;
    tuples.vertex_count = 9;
    tuples.volume_count = 28;
    tuples.ring_first.push_back(0);
    const auto add = [&](std::vector<std::uint32_t> ring, std::uint32_t a, std::uint32_t b) {
        tuples.ring.insert(tuples.ring.end(), ring.begin(), ring.end());
        tuples.ring_first.push_back(static_cast<std::uint32_t>(tuples.ring.size()));
        tuples.face_volumes.push_back({a, b});
    };
    std::vector<std::vector<std::uint32_t>> triangles;
    for (std::uint32_t i = 0; i < 7; ++i) {
        triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
        triangles.push_back({i, (i + 2) % 7, (i + 3) % 7});
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> at_edge;
    for (std::uint32_t t = 0; t < 14; ++t) {
        add(triangles[t], t, 14 + t);
        for (std::size_t k = 0; k < 3; ++k)
            at_edge[std::minmax(triangles[t][k], triangles[t][(k + 1) % 3])].push_back(t);
    }
    for (const auto& [edge, sides] : at_edge) {
        ASSERT_EQ(sides.size(), 2u);
        add({edge.first, edge.second, 7}, sides[0], sides[1]);
        add({edge.first, edge.second, 8}, 14 + sides[0], 14 + sides[1]);
    }
    const Validation found = validate(built(tuples));
    EXPECT_TRUE(is_exactly(built(tuples), "T7", Blamed::Vertex, 2));
    EXPECT_EQ(found.defects.at(0).vertex, VertexId{7});
    EXPECT_EQ(found.defects.at(1).vertex, VertexId{8});
}

TEST(Validate, ReportsTwoFaultsFarApart) {
    Map map = grid(5, 5, 5);
    ASSERT_TRUE(unsew<3>(map, dart_between(map, 0, 1)));
    const DartId d = dart_between(map, 123, 124);
    ASSERT_TRUE(insert_edge(map, d, map.alpha<0>(d)));
    EXPECT_EQ(codes_of(validate(map)), (std::vector<std::string>{"T2", "T2", "T6"})) << text_of(validate(map));
}

TEST(Validate, CountsWhatItSuppresses) {
    Map map = grid(3, 3, 3);
    ASSERT_TRUE(unsew<2>(map, dart_between(map, 13, 14)));
    EXPECT_GT(validate(map).suppressed, 0u);
}

TEST(Validate, ReportsACodeOncePerCell) {
    Map map = grid(2, 2, 2);
    ASSERT_TRUE(remove_volume(map, map.representatives<3>()[8]));
    const Validation found = validate(map);
    EXPECT_EQ(found.defects.size(), 24u) << text_of(found);
    std::set<FaceId> faces;
    for (const Defect& defect : found.defects) EXPECT_TRUE(faces.insert(defect.face).second);
}

TEST(Validate, SurvivesArbitraryLinks) {
    // Whatever stands in the arrays, it ends and says T1.
    std::uint32_t state = 7;
    const auto next = [&] { return state = state * 1664525u + 1013904223u; };
    for (int round = 0; round < 200; ++round) {
        const Map broken = edited(grid(2, 2, 2), [&](MapArrays& arrays) {
            for (int k = 0; k <= round; ++k) {
                arrays.alpha[(next() >> 8) % 4][(next() >> 8) % arrays.alpha[0].size()] =
                    static_cast<std::uint32_t>((next() >> 8) % arrays.alpha[0].size());
                const std::size_t i = (next() >> 8) % 4;
                arrays.cell_id[i][(next() >> 8) % arrays.alpha[0].size()] = (next() >> 8) % arrays.cell_bound[i];
            }
        });
        const Validation found = validate(broken);
        ASSERT_FALSE(found.is_sound());
        EXPECT_EQ(found.defects[0].code, "T1");
    }
}

}  // namespace
}  // namespace enfilade::gmap
