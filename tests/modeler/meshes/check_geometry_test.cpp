// G1-G5 of meshes: each fault gives its code, at its place, and nothing else.

#include <gtest/gtest.h>

#include "tests/modeler/meshes/polyhedra.h"

namespace enfilade::modeler::test {
namespace {

TEST(CheckMesh, FindsTwoVerticesAtOnePlace) {
    Polyhedron p = triangles(cube());
    p.points[7] = p.points[6];  // squeezed to a wedge: two faces have no area now, and that is why
    const CheckReport report = check_mesh(p.mesh());
    ASSERT_EQ(codes(report), Codes{"G1"});
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0].sentence, "Vertices 6 and 7 lie at one place, in one connected surface.");
    EXPECT_EQ(report.findings[0].point, std::optional<Point>(p.points[6]));
}

TEST(CheckMesh, FindsVerticesWithinADistance) {
    Polyhedron p = triangles(cube());
    p.points[7] = {0.001, 1, 1};
    EXPECT_EQ(codes(check_mesh(p.mesh(), {.coincident = 0.0005})), Codes{});
    EXPECT_EQ(codes(check_mesh(p.mesh(), {.coincident = 0.002})), Codes{"G1"});
}

TEST(CheckMesh, LetsSeparateSolidsTouch) {
    for (const Point& at : {Point{1, 0, 0}, Point{1, 1, 0}, Point{1, 1, 1}, Point{1, 0.25, 0.5}})
        EXPECT_EQ(codes_of(beside(cube(), cube(at))), Codes{}) << at[0] << at[1] << at[2];
}

TEST(CheckMesh, NotesUnusedVertices) {
    Polyhedron p = cube();
    p.points.push_back({9, 9, 9});
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"G1 note"});
    EXPECT_EQ(report.findings[0].sentence, "Vertex 8 belongs to no face.");
    EXPECT_TRUE(report.sound());
}

TEST(CheckMesh, FindsAVertexNamedTwiceInARow) {
    Polyhedron p = cube();
    p.faces[2] = {0, 1, 1, 5, 4};
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"G2"});
    EXPECT_EQ(report.findings.at(0).sentence, "Face 2 names vertex 1 twice in a row.");
}

TEST(CheckMesh, FindsATriangleOfTwoVertices) {
    Polyhedron p = triangles(cube());
    p.faces.push_back({0, 0, 1});
    EXPECT_EQ(codes_of(p), Codes{"G2"});
}

TEST(CheckMesh, FindsASpike) {
    Polyhedron p = cube();
    p.faces[2] = {0, 1, 7, 1, 5, 4};
    EXPECT_EQ(codes_of(p), Codes{"G2"});
}

TEST(CheckMesh, FindsAFaceWithoutArea) {
    Polyhedron p = triangles(cube());  // a point on the edge 0-1, used by the bottom alone: a sliver fills the gap
    p.points.push_back({0.5, 0, 0});
    std::erase(p.faces, Ring{0, 3, 1});
    p.faces.insert(p.faces.end(), {{0, 3, 8}, {8, 3, 1}, {0, 8, 1}});
    const CheckReport report = check_mesh(p.mesh());
    ASSERT_EQ(codes(report), Codes{"G2"});
    EXPECT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0].sentence, "Face 13 has no area: its corners 0, 8 and 1 lie on one line.");
}

TEST(CheckMesh, FindsSidesThatCross) {
    Polyhedron p = cube();
    for (const Ring& bow : {Ring{4, 5, 6, 7}, Ring{4, 7, 5, 6}}) {
        p.faces[1] = bow;
        const CheckReport report = check_mesh(p.mesh());
        EXPECT_EQ(report.count("G2"), 1u) << report.findings.at(0).sentence;
    }
}

TEST(CheckMesh, FindsAVertexOutOfThePlane) {
    Polyhedron p = cube();
    p.points[7] = {1.1, 1.1, 1.1};
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"G3"});
    EXPECT_EQ(report.count("G3"), 3u);
    EXPECT_EQ(codes(check_mesh(p.mesh(), {.planar_distance = 0.2})), Codes{});
}

TEST(CheckMesh, FindsAFoldThatIsNearThePlane) {
    Polyhedron p = cube();  // 5 mm out of the plane, 6 mm from its neighbour: flat by distance, not by direction
    p.points.push_back({0.5, 0, 1});
    p.points.push_back({0.506, 0, 1.005});
    p.points.push_back({0.512, 0, 1});
    p.faces[1] = {4, 8, 9, 10, 5, 7, 6};
    p.faces[2] = {0, 1, 5, 10, 9, 8, 4};
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"G3"});
    EXPECT_NE(report.findings.at(0).sentence.find("fold of"), std::string::npos) << report.findings[0].sentence;
    EXPECT_EQ(codes(check_mesh(p.mesh(), {.planar_angle_deg = 89})), Codes{});
}

TEST(CheckMesh, FindsASurfaceThatGoesThroughItself) {
    Polyhedron p = ball(5, 8, [](std::size_t) { return 1.0; });
    p.points[0] = {0, 0, 1.5};  // the lower pole through the upper one
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"G4"});
    EXPECT_EQ(report.findings.size(), 1u) << "one place";
    EXPECT_GT((*report.findings[0].point)[2], 0.5);
}

TEST(CheckMesh, FindsASurfaceThatTouchesItself) {
    Polyhedron p = ball(5, 8, [](std::size_t) { return 1.0; });
    const Point &a = p.points[33], &c = p.points.back();                      // of a side at the upper pole
    p.points[0] = {(a[0] + c[0]) / 2, (a[1] + c[1]) / 2, (a[2] + c[2]) / 2};  // the lower pole comes to its side
    EXPECT_EQ(codes_of(p), Codes{"G4"});
}

TEST(CheckMesh, FindsFacesThatFoldBack) {
    // A box whose lid is folded over itself: two of its triangles share a side and lie on each other.
    Polyhedron p = triangles(cube());
    p.points.push_back({0.5, 0.5, 1});
    std::erase(p.faces, Ring{4, 5, 7});
    std::erase(p.faces, Ring{4, 7, 6});
    p.points.push_back({0.9, 0.5, 1});
    for (const Ring& face : {Ring{4, 5, 8}, Ring{5, 7, 9}, Ring{5, 9, 8}, Ring{7, 6, 8}, Ring{6, 4, 8}, Ring{7, 8, 9}})
        p.faces.push_back(face);
    EXPECT_EQ(codes_of(p), Codes{}) << "the lid itself is sound";
    p.points[9] = {0.2, 0.5, 1};
    EXPECT_EQ(codes_of(p), Codes{"G4"});
}

TEST(CheckMesh, FindsSolidsThatGoThroughEachOther) {
    const CheckReport report = check_mesh(beside(cube(), cube({0.5, 0.5, 0.5})).mesh());
    ASSERT_EQ(codes(report), Codes{"G5"});
    EXPECT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0].sentence, "The surface of face 0 and the surface of face 6 go through each other.");
}

TEST(CheckMesh, FindsASolidWithinAnother) {
    Polyhedron p = beside(cube(), cube({0.25, 0.25, 0.25}, 0.5));
    EXPECT_EQ(codes_of(p), Codes{"G5"});
    EXPECT_NE(check_mesh(p.mesh()).findings[0].sentence.find("lies within"), std::string::npos);
    for (std::size_t f = 6; f < 12; ++f) p.flip(f);
    EXPECT_EQ(codes_of(p), Codes{}) << "turned inside out it is a void";
}

TEST(CheckMesh, FindsTheSameSolidTwice) {
    const CheckReport report = check_mesh(beside(cube(), cube()).mesh());
    ASSERT_EQ(codes(report), Codes{"G5"});
    EXPECT_EQ(report.findings[0].sentence, "The surface of face 0 and the surface of face 6 are the same.");
}

TEST(CheckMesh, WarnsOfASolidTurnedInsideOut) {
    Polyhedron p = cube();
    p.flip_all();
    const CheckReport report = check_mesh(p.mesh());
    EXPECT_EQ(codes(report), Codes{"G5 warning"});
    EXPECT_TRUE(report.sound());
}

TEST(CheckMesh, WorksFarFromTheOrigin) {
    Polyhedron p = ball(6, 9, [](std::size_t) { return 1.0; });
    for (Point& point : p.points)
        for (double& x : point) x += 5e6;
    EXPECT_EQ(codes_of(p), Codes{});
    p.flip_all();
    EXPECT_EQ(codes_of(p), Codes{"G5 warning"});
}

}  // namespace
}  // namespace enfilade::modeler::test
