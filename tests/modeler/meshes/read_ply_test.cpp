#include "tests/modeler/meshes/mesh_texts.h"

namespace enfilade::modeler::test {
namespace {

const std::string text_header =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string binary_header(bool big, const std::string& vertex, const std::string& face) {
    return std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\nelement vertex 3\n" + vertex +
           "element face 2\n" + face + "end_header\n";
}

TEST(ReadPly, KeepsIndicesOfTextFiles) {
    const Mesh mesh = read_mesh(text_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply");
    EXPECT_EQ(mesh.format, MeshFormat::Ply);
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}}));
    EXPECT_EQ(mesh.points[1], (std::array<double, 3>{1, 0, 0}));
}

TEST(ReadPly, TakesWindowsLineEndsAndTheOtherName) {
    std::string text = text_header + "0 0 0\n1 0 0\n0 1 0\n3 2 1 0\n";
    text.replace(text.find("vertex_indices"), 14, "vertex_index");
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
    EXPECT_EQ(rings(read_mesh(text, "a.ply")), (std::vector<Ring>{{2, 1, 0}}));
}

TEST(ReadPly, PassesOverOtherPropertiesAndElements) {
    const Mesh mesh = read_mesh(
        "ply\nformat ascii 1.0\nobj_info none\nelement camera 1\nproperty float view\nproperty list uchar float near\n"
        "element vertex 3\nproperty uchar red\nproperty double z\nproperty double x\nproperty list uchar int tags\n"
        "property double y\nelement face 1\nproperty int group\nproperty list uchar uint vertex_indices\nproperty "
        "float "
        "q\nelement edge 1\nproperty int a\nend_header\n0.5 2 1 1\n255 3 1 2 7 7 2\n0 3 1 0 2\n0 3 1 1 9 2\n4 3 0 1 2 "
        "0.5\n7\n",
        "a.ply");
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}}));
    EXPECT_EQ(mesh.points[0], (std::array<double, 3>{1, 2, 3}));
    ASSERT_EQ(mesh.findings.size(), 2u);
    EXPECT_EQ(mesh.findings[1].code, "P812");
}

TEST(ReadPly, ReadsBinaryFilesOfBothByteOrders) {
    for (const bool big : {false, true}) {
        std::string bytes =
            binary_header(big, "property float x\nproperty double y\nproperty short z\nproperty list uchar ushort w\n",
                          "property list uchar int vertex_indices\nproperty uchar red\n");
        for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, -2}, {0, 0.1, 0}}) {
            put(bytes, float(x), big), put(bytes, y, big), put(bytes, std::int16_t(z), big);
            put(bytes, std::uint8_t(2)), put(bytes, std::uint16_t(5), big), put(bytes, std::uint16_t(6), big);
        }
        for (const Ring& ring : {Ring{0, 1, 2}, Ring{2, 1, 0, 1}}) {
            put(bytes, std::uint8_t(ring.size()));
            for (const std::uint32_t v : ring) put(bytes, std::int32_t(v), big);
            put(bytes, std::uint8_t(200));
        }
        const Mesh mesh = read_mesh(bytes, "a.ply");
        EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}, {2, 1, 0, 1}})) << big;
        EXPECT_EQ(mesh.points[1], (std::array<double, 3>{1, 0, -2})) << big;
        EXPECT_EQ(mesh.points[2], (std::array<double, 3>{0, 0.1, 0})) << big;
    }
}

TEST(ReadPly, TakesListsOfAnyWholeType) {
    const auto check = [](const char* count, const char* index, auto count_value, auto index_value) {
        std::string bytes = binary_header(false, "property uchar x\nproperty uchar y\nproperty uchar z\n",
                                          std::string("property list ") + count + " " + index + " vertex_indices\n");
        for (const int byte : {0, 0, 0, 1, 0, 0, 0, 1, 0}) bytes += static_cast<char>(byte);
        for (int face = 0; face < 2; ++face) {
            put(bytes, static_cast<decltype(count_value)>(3));
            for (const int v : {0, 1, 2}) put(bytes, static_cast<decltype(index_value)>(v));
        }
        EXPECT_EQ(rings(read_mesh(bytes, "a.ply")), (std::vector<Ring>{{0, 1, 2}, {0, 1, 2}})) << count << index;
    };
    check("char", "uint16", std::int8_t(), std::uint16_t());
    check("uint8", "int8", std::uint8_t(), std::int8_t());
    check("short", "uint", std::int16_t(), std::uint32_t());
    check("uint32", "ushort", std::uint32_t(), std::uint16_t());
    check("int", "uchar", std::int32_t(), std::uint8_t());
}

TEST(ReadPly, RefusesVerticesThatDoNotExist) {
    expect_refused(text_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.ply", "P804", 14, "Face 0 names vertex 3");
    std::string bytes = binary_header(false, "property uchar x\nproperty uchar y\nproperty uchar z\n",
                                      "property list uchar int vertex_indices\n");
    for (int k = 0; k < 9; ++k) bytes += '\0';
    const std::size_t at = bytes.size() + 1;
    put(bytes, std::uint8_t(3));
    for (const int v : {-1, 1, 2, 0}) put(bytes, v);
    expect_refused(bytes, "a.ply", "P804", 0, "Byte " + std::to_string(at));
}

TEST(ReadPly, RefusesMoreThanTheFileHolds) {
    std::string many = text_header;
    many.replace(many.find("vertex 3"), 8, "vertex 99999999");
    expect_refused(many + "0 0 0\n", "a.ply", "P805", 10, "promises 99999999 of \"vertex\"");
    expect_refused(text_header + "0.000 0.000 0.000\n1 0 0\n0.000 1 0\n3 0 1", "a.ply", "P805", 14,
                   "ends before its last value");
    expect_refused(text_header + "0 0 0\n1 0 0\n0 1 0\n30000 0 1 2\n", "a.ply", "P805", 14, "promises 30000 items");
    expect_refused(text_header + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "a.ply", "P805", 14, "promises -3 items");
    std::string bytes = binary_header(true, "property uchar x\nproperty uchar y\nproperty uchar z\n",
                                      "property list uint int vertex_indices\n");
    for (int k = 0; k < 9; ++k) bytes += '\0';
    std::string list = bytes;
    put(list, 0xFFFFFFFFu), put(list, 0xFFFFFFFFu);
    expect_refused(list, "a.ply", "P805", 0, "promises 4294967295 items");
    put(bytes, 1u, true), put(bytes, 1u, true), put(bytes, 1u, true), bytes += "ab";
    expect_refused(bytes, "a.ply", "P805", 0, "within a value");
}

TEST(ReadPly, RefusesHeadersThatAreNone) {
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = text_header;
        return text.replace(text.find(from), from.size(), to) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    };
    expect_refused(changed("ascii", "morse"), "a.ply", "P806", 2, "\"morse\"");
    expect_refused(changed("float z", "float w"), "a.ply", "P806", 1, "no property z");
    expect_refused(changed("float z", "quad z"), "a.ply", "P806", 7, "\"quad\"");
    expect_refused(changed("list uchar", "list float"), "a.ply", "P806", 9, "whole number");
    expect_refused(changed("comment", "komment"), "a.ply", "P806", 3, "\"komment\"");
    expect_refused(changed("vertex 3", "vertex -3"), "a.ply", "P802", 4, "negative");
    expect_refused(changed("element vertex 3\n", ""), "a.ply", "P806", 4, "before the first element");
    expect_refused(changed("element vertex", "element points"), "a.ply", "P804", 14, "has 0");
    expect_refused(changed("format ascii 1.0\n", ""), "a.ply", "P806", 9, "does not say its format");
    expect_refused("ply\nformat ascii 1.0\n", "a.ply", "P805", 2, "end_header");
}

TEST(ReadPly, RefusesCoordinatesThatAreNotFinite) {
    expect_refused(text_header + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "a.ply", "P803", 12, "nan");
    std::string bytes = binary_header(false, "property double x\nproperty double y\nproperty double z\n",
                                      "property list uchar int vertex_indices\n");
    for (int k = 0; k < 9; ++k) put(bytes, k == 4 ? 1e308 : 0.0);
    bytes += std::string(10, '\0');
    expect_refused(bytes, "a.ply", "P803", 0, "Byte");
}

TEST(ReadPly, RefusesPointCloudsAndStrips) {
    const std::string cloud =
        text_header.substr(0, text_header.find("element face")) + "end_header\n0 0 0\n1 0 0\n0 1 0\n";
    expect_refused(cloud, "a.ply", "P807", 0, "no face");
    const std::string strips =
        text_header.substr(0, text_header.find("element face")) +
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    expect_refused(strips, "a.ply", "P806", 1, "strips");
}

}  // namespace
}  // namespace enfilade::modeler::test
