#include "tests/modeler/meshes/mesh_texts.h"

namespace enfilade::modeler::test {
namespace {

const std::string four = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ReadObj, KeepsIndicesAsWritten) {
    const Mesh mesh = read_mesh(four + "f 1 3 2\nf 1 2 4\n", "a.obj");
    EXPECT_EQ(mesh.format, MeshFormat::Obj);
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 2, 1}, {0, 1, 3}}));
    EXPECT_EQ(mesh.points[3], (std::array<double, 3>{0, 0, 1}));
}

TEST(ReadObj, TakesCornersWithTextureAndNormal) {
    const Mesh mesh = read_mesh(
        four + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1/1/1 2/1/1 4/1/1\nf 1//1 3//1 4//1\nf 2// 3// 4//\n", "a.obj");
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}));
}

TEST(ReadObj, CountsNegativeNumbersBackFromTheirLine) {
    const Mesh mesh = read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -3 -1\n", "a.obj");
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}, {0, 1, 3}}));
}

TEST(ReadObj, PassesOverCommentsAndContinuesLines) {
    const Mesh mesh = read_mesh("# a\r\nv 0 0 0 # corner\r\nv 1 0 0\r\nv 0 1 \\\r\n 0\r\nf 1 2 \\\r\n3\r\n", "a.obj");
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}}));
}

TEST(ReadObj, TakesVerticesThatComeAfterTheirFace) {
    EXPECT_EQ(rings(read_mesh("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj")), (std::vector<Ring>{{0, 1, 2}}));
}

TEST(ReadObj, KeepsColoursAndWeightsOutOfCoordinates) {
    const Mesh mesh = read_mesh("v 0 0 0 1 0.5 0\nv 1 0 0 1\nv 0 +1 1e-400\nf 1 2 3\n", "a.obj");
    EXPECT_EQ(mesh.points[2], (std::array<double, 3>{0, 1, 0}));
    EXPECT_EQ(mesh.points.size(), 3u);
}

TEST(ReadObj, NamesObjectsAndTheirGroups) {
    const Mesh mesh = read_mesh(four + "o House one\nf 1 2 3\ng roof\nf 1 2 4\n", "a.obj");
    ASSERT_EQ(mesh.groups.size(), 2u);
    EXPECT_EQ(mesh.groups[0].name, "House one");
    EXPECT_EQ(mesh.groups[1].name, "House one, roof");
    EXPECT_EQ(mesh.groups[1].first_face, 1u);
}

TEST(ReadObj, NotesLinesAndPointsThatAreNoFaces) {
    const Mesh mesh = read_mesh(four + "l 1 2\np 3\nf 1 2 3\n", "a.obj");
    ASSERT_EQ(mesh.findings.size(), 1u);
    EXPECT_EQ(mesh.findings[0].code, "P812");
    EXPECT_EQ(mesh.findings[0].sentence.substr(0, 2), "2 ");
}

TEST(ReadObj, RefusesVerticesThatDoNotExist) {
    expect_refused(four + "f 1 2 9\nf 1 2 3\n", "a.obj", "P804", 5, "Vertex 9 does not exist");
    expect_refused(four + "f 1 2 0\n", "a.obj", "P804", 5, "counted from 1");
    expect_refused("v 0 0 0\nf -1 -2 -1\n", "a.obj", "P804", 2, "counted back");
    expect_refused(four + "f 1 2 99999999999999\n", "a.obj", "P804", 5, "does not exist");
    expect_refused(four + "f 1 2 99999999999999999999999\n", "a.obj", "P802", 5, "vertex number");
}

TEST(ReadObj, RefusesWhatIsNoNumber) {
    expect_refused("v 0 0 0\nv 1 zero 0\nf 1 1 1\n", "a.obj", "P802", 2, "\"zero\"");
    expect_refused("v 0 0\nf 1 1 1\n", "a.obj", "P802", 1, "end of this line");
    expect_refused(four + "f 1 2 x\n", "a.obj", "P802", 5, "\"x\"");
    expect_refused("v 0 0 1,5\n", "a.obj", "P802", 1, "1,5");
}

TEST(ReadObj, RefusesCoordinatesThatAreNotFinite) {
    for (const char* bad : {"nan", "inf", "-inf", "1e308", "1e999", "-2e12"})
        expect_refused(four + "v 0 0 " + bad + "\nf 1 2 3\n", "a.obj", "P803", 5, bad);
}

TEST(ReadObj, RefusesAFileWithoutFaces) {
    expect_refused(four, "a.obj", "P807", 0, "no face");
    expect_refused("", "a.obj", "P807", 0, "no face");
}

TEST(ReadObj, SaysThePlaceInALongLine) {
    const InputError error = refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", "folder/a.obj");
    EXPECT_EQ(error.located(), "folder/a.obj:4:9: Vertex 4 does not exist: the file has 3 vertices.");
}

}  // namespace
}  // namespace enfilade::modeler::test
