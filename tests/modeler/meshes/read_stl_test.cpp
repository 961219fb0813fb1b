#include <algorithm>
#include <cctype>
#include <limits>

#include "tests/modeler/meshes/mesh_texts.h"

namespace enfilade::modeler::test {
namespace {

using Triangle = std::array<std::array<float, 3>, 3>;

const std::vector<Triangle> two = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, -0.0f, 0}, {0, 1, 0}, {0, 0, 1}}}};

std::string binary(const std::vector<Triangle>& triangles, std::string header = "made by hand") {
    header.resize(80, '\0');
    put(header, std::uint32_t(triangles.size()));
    for (const Triangle& triangle : triangles) {
        for (int k = 0; k < 3; ++k) put(header, 0.0f);
        for (const auto& corner : triangle)
            for (const float x : corner) put(header, x);
        put(header, std::uint16_t(0));
    }
    return header;
}

const std::string text =
    "solid house\n facet normal nan 0 0\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n "
    "endfacet\nendsolid house\n";

TEST(ReadStl, WeldsEqualPointsAndSaysSo) {
    const Mesh mesh = read_mesh(binary(two), "a.stl");
    EXPECT_EQ(mesh.format, MeshFormat::Stl);
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(mesh.findings.size(), 1u);
    EXPECT_EQ(mesh.findings[0].code, "P810");
    EXPECT_NE(mesh.findings[0].sentence.find("6 corners"), std::string::npos);
    EXPECT_NE(mesh.findings[0].sentence.find("4 vertices"), std::string::npos);
}

TEST(ReadStl, ReadsTextWithNormalsThatAreNoNumbers) {
    const Mesh mesh = read_mesh(text, "a.stl");
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}}));
    ASSERT_EQ(mesh.groups.size(), 1u);
    EXPECT_EQ(mesh.groups[0].name, "house");
}

TEST(ReadStl, ReadsTextInCapitalsAndSeveralSolids) {
    std::string capitals = text + text;
    std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                   [](unsigned char c) { return char(std::toupper(c)); });
    EXPECT_EQ(rings(read_mesh(capitals, "a.stl")), (std::vector<Ring>{{0, 1, 2}, {0, 1, 2}}));
}

TEST(ReadStl, KnowsBinaryFilesWhoseHeaderSaysSolid) {
    EXPECT_EQ(read_mesh(binary(two, "solid of another program"), "a.stl").face_count(), 2u);
    EXPECT_EQ(read_mesh(binary(two, "solid"), "model").face_count(), 2u);
    expect_refused(binary(two, "solid").substr(0, 150), "a.stl", "P805", 0,
                   "promises 2 triangles, but the file holds 1");
}

TEST(ReadStl, WarnsOfBytesBehindTheLastTriangle) {
    const Mesh mesh = read_mesh(binary(two) + "more", "a.stl");
    EXPECT_EQ(mesh.face_count(), 2u);
    EXPECT_EQ(mesh.findings.front().code, "P815");
    EXPECT_NE(mesh.findings.front().sentence.find("4 bytes"), std::string::npos);
}

TEST(ReadStl, WarnsOfTextWithoutAnEnd) {
    const Mesh mesh = read_mesh(text.substr(0, text.find("endsolid")), "a.stl");
    EXPECT_EQ(mesh.face_count(), 1u);
    EXPECT_EQ(mesh.findings.front().code, "P815");
}

TEST(ReadStl, RefusesTruncatedFiles) {
    expect_refused(std::string(40, 'x'), "a.stl", "P805", 0, "header of 84 bytes");
    std::string many = binary(two);
    many[83] = '\x7F';
    expect_refused(many, "a.stl", "P805", 0, "but the file holds 2");
    for (const std::size_t size : {20u, 40u, 60u, 80u, 120u})
        EXPECT_EQ(refusal(text.substr(0, size), "a.stl").code, "P805") << size;
}

TEST(ReadStl, RefusesWhatDoesNotBelong) {
    std::string wrong = text;
    wrong.replace(wrong.find("outer"), 5, "inner");
    expect_refused(wrong, "a.stl", "P802", 3, "\"outer\" is expected");
    expect_refused("solid\nvertex 0 0 0\n", "a.stl", "P802", 2, "\"facet\"");
    wrong = text;
    wrong.replace(wrong.find("1 0 0"), 5, "1 0");
    expect_refused(wrong, "a.stl", "P802", 5, "end of this line");
}

TEST(ReadStl, RefusesCoordinatesThatAreNotFinite) {
    std::vector<Triangle> bad = two;
    bad[1][2][0] = std::numeric_limits<float>::quiet_NaN();
    expect_refused(binary(bad), "a.stl", "P803", 0, "Triangle 1 (byte 170)");
    bad[1][2][0] = 3e38f;
    expect_refused(binary(bad), "a.stl", "P803", 0, "Triangle 1");
}

}  // namespace
}  // namespace enfilade::modeler::test
