// T1-T7 of meshes: each fault gives its code, at its place, and nothing else.

#include <gtest/gtest.h>

#include "tests/modeler/meshes/polyhedra.h"

namespace enfilade::modeler::test {
namespace {

Polyhedron round_ball() {
    return ball(4, 7, [](std::size_t) { return 2.0; });
}

TEST(CheckMesh, FindsNothingInSoundPolyhedra) {
    for (const Polyhedron& p : {cube(), triangles(cube()), round_ball(), beside(cube(), cube({3, 0, 0}))}) {
        const CheckReport report = check_mesh(p.mesh());
        EXPECT_TRUE(report.findings.empty()) << report.findings.front().sentence;
        EXPECT_EQ(report.suppressed, 0u);
    }
}

TEST(CheckMesh, SaysWhatItApplied) {
    EXPECT_EQ(check_mesh(cube().mesh()).codes_checked,
              (Codes{"T1", "T2", "T3", "T4", "T5", "T6", "T7", "G1", "G2", "G3", "G4", "G5"}));
}

TEST(CheckMesh, CallsAHoleByItsEdgesAndPlace) {
    Polyhedron p = cube();
    p.faces.erase(p.faces.begin() + 1);
    MeshCount count;
    const CheckReport report = check_mesh(p.mesh(), {}, &count);
    ASSERT_EQ(codes(report), Codes{"T2"});
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0].sentence,
              "A hole of 4 edges, 4 round, along vertices 5, 4, 6 and 7: these edges have one face only.");
    EXPECT_EQ(report.findings[0].point, (std::optional<Point>({0.5, 0.5, 1})));
    EXPECT_EQ(count.boundary_edges, 4u);
    EXPECT_EQ(count.holes, 1u);
}

TEST(CheckMesh, CountsEveryHoleByItself) {
    Polyhedron p = round_ball();
    const auto far_apart = p.faces.size() - 1;
    p.faces.erase(p.faces.begin() + std::ptrdiff_t(far_apart));
    p.faces.erase(p.faces.begin());
    EXPECT_EQ(codes_of(p), Codes{"T2"});
    EXPECT_EQ(check_mesh(p.mesh()).findings.size(), 2u);
}

TEST(CheckMesh, CountsHolesThatMeetAtAVertexAsOne) {
    Polyhedron p =
        triangles(cube());  // two faces that share vertex 0 alone: (0, 2, 3) of the bottom, (0, 1, 5) in front
    std::erase(p.faces, Ring{0, 2, 3});
    std::erase(p.faces, Ring{0, 1, 5});
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"T2"});
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0].sentence.substr(0, 18), "A hole of 6 edges,");
}

TEST(CheckMesh, FindsSeamsOfSplitVertices) {
    Polyhedron p = cube();
    p.points.push_back(p.points[7]);
    std::replace(p.faces[1].begin(), p.faces[1].end(), 7u, 8u);
    const CheckReport report = check_mesh(p.mesh());
    ASSERT_EQ(codes(report), Codes{"T2"});
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_NE(report.findings[0].sentence.find("vertices are there twice"), std::string::npos);
    EXPECT_NE(report.findings[0].hint.find("--weld 0"), std::string::npos);
}

TEST(CheckMesh, TellsSeamsFromHoles) {
    Polyhedron apart{{}, {}};  // the cube as five separate faces: seams, and one hole
    const Polyhedron whole = cube();
    for (std::size_t f = 1; f < 6; ++f) {
        Ring face;
        for (const std::uint32_t v : whole.faces[f]) {
            face.push_back(std::uint32_t(apart.points.size()));
            apart.points.push_back(whole.points[v]);
        }
        apart.faces.push_back(face);
    }
    MeshCount count;
    const CheckReport report = check_mesh(apart.mesh(), {}, &count);
    EXPECT_EQ(codes(report), Codes{"T2"});
    EXPECT_EQ(report.findings.size(), 2u);
    EXPECT_EQ(count.holes, 1u);
    EXPECT_EQ(count.boundary_edges, 20u);
}

TEST(CheckMesh, NamesBothOfAFaceGivenTwice) {
    Polyhedron p = cube();
    p.faces.push_back({6, 4, 5, 7});  // the top, from another corner
    const CheckReport report = check_mesh(p.mesh());
    ASSERT_EQ(codes(report), Codes{"T4"});
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0].sentence, "Face 6 has the same vertices as face 1.");
    p.flip(6);
    EXPECT_EQ(codes_of(p), Codes{"T4"});
}

TEST(CheckMesh, FindsAnInnerWall) {
    Polyhedron p = sewn(beside(cube(), cube({1, 0, 0})));
    p.faces.erase(p.faces.begin() + 10);  // left side of the right cube: now one wall between two rooms
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), (Codes{"T4", "G1 note"}));
    EXPECT_EQ(report.findings[0].sentence.substr(0, 54), "4 edges in a chain have more than two faces each. The ");
}

TEST(CheckMesh, FindsCubesThatShareAFaceGivenTwice) {
    EXPECT_EQ(codes_of(sewn(beside(cube(), cube({1, 0, 0})))), (Codes{"T4", "G1 note"}));
}

TEST(CheckMesh, FindsCubesThatShareAnEdge) {
    const CheckReport report = check_mesh(sewn(beside(cube(), cube({1, 1, 0}))).mesh());
    ASSERT_EQ(codes(report), (Codes{"T4", "G1 note"}));
    EXPECT_EQ(report.findings.size(), 2u);
    EXPECT_EQ(report.findings[0].sentence, "The edge between vertices 3 and 7 has 4 faces: 3, 5, 8 and 10.");
    EXPECT_EQ(report.findings[0].point, (std::optional<Point>({1, 1, 0.5})));
}

TEST(CheckMesh, FindsCubesThatShareAVertex) {
    const CheckReport report = check_mesh(sewn(beside(cube(), cube({1, 1, 1}))).mesh());
    ASSERT_EQ(codes(report), (Codes{"T5", "G1 note"}));
    EXPECT_EQ(report.findings[0].sentence.substr(0, 42), "At vertex 7 the surface touches itself: 2 ");
    EXPECT_EQ(report.findings[0].point, (std::optional<Point>({1, 1, 1})));
}

TEST(CheckMesh, FindsAPinchedVertexBesideAHole) {
    Polyhedron p = sewn(beside(cube(), cube({1, 1, 1})));
    p.faces.erase(p.faces.begin() + 1);  // the top of the lower cube, which ends at the shared vertex
    EXPECT_EQ(codes_of(p), (Codes{"T2", "T5", "G1 note"}));
}

TEST(CheckMesh, WarnsOfATurnedFace) {
    Polyhedron p = cube();
    p.flip(3);
    const CheckReport report = check_mesh(p.mesh());
    ASSERT_EQ(codes(report), Codes{"T3 warning"});
    EXPECT_EQ(report.findings[0].sentence, "Face 3 is turned against the 5 others of its surface.");
    EXPECT_TRUE(report.sound());
}

TEST(CheckMesh, KnowsTheTurnedFacesEvenWhereTheyAreMost) {
    Polyhedron p = cube();
    for (std::size_t f = 0; f < 5; ++f) p.flip(f);
    EXPECT_EQ(check_mesh(p.mesh()).findings.at(0).sentence,
              "5 faces are turned against the 1 others of their surface: faces 0, 1, 2, 3 and 4.");
}

Polyhedron klein_bottle() {
    Polyhedron p = torus(8, 6);
    // Where the ring closes, run across it the other way round.
    for (Ring& face : p.faces) {
        const bool closes = std::any_of(face.begin(), face.end(), [](std::uint32_t v) { return v >= 42; }) &&
                            std::any_of(face.begin(), face.end(), [](std::uint32_t v) { return v < 6; });
        for (std::uint32_t& v : face)
            if (closes && v < 6) v = (6 - v) % 6;
    }
    return p;
}

TEST(CheckMesh, FindsSurfacesWithOneSide) {
    const CheckReport report = check_mesh(klein_bottle().mesh());
    EXPECT_EQ(codes(report), Codes{"T3"});
    EXPECT_EQ(report.findings.size(), 1u);
}

TEST(CheckMesh, FindsBothFaultsOfAMoebiusBand) {
    Polyhedron p;
    for (std::uint32_t k = 0; k < 12; ++k) {
        const double a = 2 * std::numbers::pi * k / 12;
        for (const double side : {-0.3, 0.3}) {
            const double r = 2 + side * std::cos(a / 2);
            p.points.push_back({r * std::cos(a), r * std::sin(a), side * std::sin(a / 2)});
        }
    }
    for (std::uint32_t k = 0; k < 12; ++k) {
        const bool closes = k == 11;
        const std::uint32_t a = 2 * k, b = 2 * k + 1, c = closes ? 0 : 2 * k + 3, d = closes ? 1 : 2 * k + 2;
        p.faces.push_back({a, b, c});
        p.faces.push_back({a, c, d});
    }
    EXPECT_EQ(codes_of(p), (Codes{"T2", "T3"}));
}

TEST(CheckMesh, FindsFacesOfFewerThanThreeCorners) {
    Polyhedron p = cube();
    p.faces.push_back({0, 7});
    p.faces.push_back({});
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"T6"});
    EXPECT_EQ(report.findings.size(), 2u);
    EXPECT_EQ(report.findings[0].sentence, "Face 6 has 2 corners, fewer than three.");
}

TEST(CheckMesh, FindsSurfacesOfFewerThanFourFaces) {
    const Polyhedron pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
    const CheckReport report = check_mesh(beside(cube(), pillow).mesh());
    ASSERT_EQ(codes(report), Codes{"T6"});
    EXPECT_EQ(report.findings[0].sentence, "The surface of face 6 has 2 faces, fewer than the four of a tetrahedron.");
}

TEST(CheckMesh, NotesHandles) {
    const CheckReport report = check_mesh(torus(12, 8).mesh());
    EXPECT_EQ(codes(report), Codes{"T7 note"});
    EXPECT_NE(report.findings[0].sentence.find("has 1 handle"), std::string::npos);
    EXPECT_TRUE(report.sound());
}

TEST(CheckMesh, TakesManySurfacesWithHandlesAndManyPillowsInLinearTime) {
    Polyhedron p;
    const Polyhedron ring = torus(5, 4);
    Polyhedron pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
    for (int k = 0; k < 2000; ++k) {
        Polyhedron moved = ring;
        for (Point& point : moved.points) point[0] += 10.0 * k;
        const auto shift = std::uint32_t(p.points.size());
        p.points.insert(p.points.end(), moved.points.begin(), moved.points.end());
        for (Ring face : moved.faces) {
            for (std::uint32_t& v : face) v += shift;
            p.faces.push_back(face);
        }
        const auto next = std::uint32_t(p.points.size());
        for (Point point : pillow.points) p.points.push_back({point[0] + 10.0 * k, point[1] + 9, point[2]});
        p.faces.push_back({next, next + 1, next + 2});
        p.faces.push_back({next + 2, next + 1, next});
    }
    MeshCount count;
    const CheckReport report = check_mesh(p.mesh(), {}, &count);  // a pass for each of them would take minutes
    EXPECT_EQ(count.pieces, 4000u);
    EXPECT_EQ(report.count("T7"), 21u);
    EXPECT_EQ(report.count("T6"), 21u);
}

TEST(CheckMesh, CountsTheRestOfALongList) {
    Polyhedron p = torus(24, 8);
    std::vector<Ring> left;  // without the first half of every second square of every second row
    for (std::size_t f = 0; f < p.faces.size(); ++f)
        if (f % 4 != 0 || f / 16 % 2 != 0) left.push_back(p.faces[f]);
    p.faces = left;
    const CheckReport report = check_mesh(p.mesh(), {.listed = 5});
    EXPECT_EQ(report.count("T2"), 6u);
    EXPECT_EQ(report.findings.back().sentence, "43 more holes were found, 48 in all.");
}

TEST(CheckMesh, CountsFromOneInObjFiles) {
    Mesh mesh = cube().mesh();
    mesh.format = MeshFormat::Obj;
    mesh.groups = {{0, "House"}};
    mesh.ring_first.pop_back();
    mesh.ring.resize(20);
    const CheckReport report = check_mesh(mesh);
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_NE(report.findings[0].sentence.find("vertices 4, 2, 6 and 8"), std::string::npos)
        << report.findings[0].sentence;
    EXPECT_EQ(report.findings[0].elements.at(0).name, "House");
    EXPECT_EQ(report.findings[0].elements.at(1).kind, "face");
}

}  // namespace
}  // namespace enfilade::modeler::test
