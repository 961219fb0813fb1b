#include "tests/modeler/meshes/mesh_texts.h"

namespace enfilade::modeler::test {
namespace {

TEST(ReadOff, KeepsIndicesAsWritten) {
    const Mesh mesh = read_mesh(tetrahedron_off, "a.off");
    EXPECT_EQ(mesh.format, MeshFormat::Off);
    EXPECT_EQ(rings(mesh), tetrahedron_rings);
    EXPECT_EQ(mesh.points[1], (std::array<double, 3>{1, 0, 0}));
}

TEST(ReadOff, TakesCommentsBeforeTheHeaderAndAnywhere) {
    const Mesh mesh = read_mesh(
        "# one\n\n# two\nOFF # header\n# three\n3 1 0 # counts\n0 0 0 # v\n\n1 0 0\n0 1 0\n# f\n3 0 1 2 # end\n",
        "a.off");
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}}));
}

TEST(ReadOff, PassesOverColoursNormalsAndTextures) {
    for (const char* header : {"COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF", "OFF"}) {
        const Mesh mesh = read_mesh(
            std::string(header) + "\n3 1 0\n0 0 0 9 9 9 9\n1 0 0 9 9 9\n0 1 0 9\n3 0 1 2 0.5 0 0 1\n", "a.off");
        EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}})) << header;
        EXPECT_EQ(mesh.points[2], (std::array<double, 3>{0, 1, 0})) << header;
    }
}

TEST(ReadOff, TakesCountsOnTheLineOfTheHeaderOrWithoutOne) {
    EXPECT_EQ(rings(read_mesh("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a")), (std::vector<Ring>{{0, 1, 2}}));
    EXPECT_EQ(rings(read_mesh("3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", "a.off")), (std::vector<Ring>{{0, 1, 2}}));
}

TEST(ReadOff, TakesWindowsLineEndsAndAByteOrderMark) {
    EXPECT_EQ(rings(read_mesh("\xEF\xBB\xBFOFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n", "a.off")),
              (std::vector<Ring>{{0, 1, 2}}));
}

TEST(ReadOff, KeepsFacesOfAnyNumberOfCorners) {
    EXPECT_EQ(rings(read_mesh("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n0\n2 0 1\n5 0 1 2\n0 1\n", "a.off")),
              (std::vector<Ring>{{}, {0, 1}, {0, 1, 2, 0, 1}}));
}

TEST(ReadOff, RefusesVerticesThatDoNotExist) {
    expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off", "P804", 6, "Vertex 3 does not exist");
    expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off", "P804", 6, "Vertex -1");
}

TEST(ReadOff, RefusesMoreThanTheFileHolds) {
    expect_refused("OFF\n4000000000 1 0\n0 0 0\n", "a.off", "P805", 2, "promises 4000000000 vertices");
    expect_refused("OFF\n1 4000000000 0\n0 0 0\n", "a.off", "P805", 2, "promises 4000000000 faces");
    expect_refused("OFF\n1 1 0\n0 0 0\n900000000000 0\n", "a.off", "P805", 4, "promises 900000000000 corners");
    expect_refused("OFF\n4 1 0\n0.000 0.000 0.000\n0 0 1\n", "a.off", "P805", 5, "before vertex 2 of 4");
    expect_refused("OFF\n1 2 0\n0 0 0\n1 0\n", "a.off", "P805", 5, "before face 1 of 2");
    expect_refused("OFF\n1 1 0\n0 0 0\n3 0 0\n", "a.off", "P805", 5, "before face 0 of 1");
    expect_refused("OFF\n", "a.off", "P805", 2, "number of vertices is missing");
    expect_refused("# only this\n", "a.off", "P805", 1, "holds nothing");
}

TEST(ReadOff, RefusesWhatIsNoNumber) {
    expect_refused("OFF\nx 1 0\n", "a.off", "P802", 2, "\"x\"");
    expect_refused("OFF\n-1 1 0\n", "a.off", "P802", 2, "negative");
    expect_refused("OFF\n1 1 0\n0 0\n1 0\n", "a.off", "P802", 3, "end of this line");
    expect_refused("OFF\n1 1 0\n0 0 0\n-3 0\n", "a.off", "P802", 4, "not negative");
    expect_refused("OFF\n1 1 0\n0 1e308 0\n1 0\n", "a.off", "P803", 3, "1e308");
}

TEST(ReadOff, RefusesOtherDimensionsAndBinary) {
    expect_refused("4OFF\n1 0 0\n", "a.off", "P806", 1, "dimension");
    expect_refused("nOFF\n3\n1 0 0\n", "a.off", "P806", 1, "dimension");
    expect_refused("OFF BINARY\n", "a.off", "P806", 1, "as text");
}

}  // namespace
}  // namespace enfilade::modeler::test
