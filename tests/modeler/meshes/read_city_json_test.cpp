#include "tests/modeler/meshes/city_texts.h"
#include "tests/modeler/meshes/mesh_texts.h"

namespace enfilade::modeler::test {
namespace {

const std::string unit_box = box_vertices({0, 0, 0}, {1, 1, 1});

TEST(ReadCityJson, ReadsASolid) {
    const Mesh mesh =
        read_mesh(city(object("A", geometry("Solid", "[" + box_shell(0) + "]")), unit_box), "a.city.json");
    EXPECT_EQ(mesh.format, MeshFormat::CityJson);
    EXPECT_EQ(mesh.face_count(), 6u);
    EXPECT_EQ(rings(mesh)[0], (Ring{0, 2, 3, 1}));
    ASSERT_EQ(mesh.solids.size(), 1u);
    EXPECT_EQ(mesh.solids[0].object, "A");
    EXPECT_EQ(mesh.solids[0].name, "Building \"A\", LoD 2.2");
    EXPECT_TRUE(mesh.findings.empty());
}

TEST(ReadCityJson, AppliesTheTransformWhereverItStands) {
    const std::string text =
        R"({"vertices":[[0,0,0],[1000,0,0],[0,1000,0]],"CityObjects":{)" +
        object("A", geometry("Solid", "[[[[0,1,2]]]]")) +
        R"(},"version":"1.1","type":"CityJSON","transform":{"translate":[10,20,30],"scale":[0.001,0.002,1]}})";
    const Mesh mesh = read_mesh(text, "a.json");
    EXPECT_EQ(mesh.points[1], (std::array<double, 3>{11, 20, 30}));
    EXPECT_EQ(mesh.points[2], (std::array<double, 3>{10, 22, 30}));
}

TEST(ReadCityJson, ReadsVersionOneWithoutTransformAndWithNumbersAsLod) {
    std::string text = city(object("A", geometry("Solid", "[" + box_shell(0) + "]")), unit_box, "", "1.0");
    text.replace(text.find(R"("lod":"2.2")"), 11, R"("lod": 2.2)");
    text.replace(text.find(R"("transform")"), text.find("\"CityObjects\"") - text.find(R"("transform")"), "");
    EXPECT_EQ(read_mesh(text, "a.json").solids.at(0).name, "Building \"A\", LoD 2.2");
}

TEST(ReadCityJson, KeepsVoidsAndHoles) {
    const std::string with_hole = R"([[[[0,1,2,3],[4,5,6]]], [[[0,1,2]]]])";
    const Mesh mesh = read_mesh(city(object("A", geometry("Solid", with_hole)), unit_box), "a.json");
    ASSERT_EQ(mesh.solids.size(), 1u);
    EXPECT_EQ(mesh.solids[0].shell_count, 2u);
    EXPECT_EQ(mesh.shells[1].first_face, 1u);
    ASSERT_EQ(mesh.holes_of(0).size(), 1u);
    EXPECT_EQ((Ring{mesh.hole(mesh.holes[0]).begin(), mesh.hole(mesh.holes[0]).end()}), (Ring{4, 5, 6}));
    EXPECT_TRUE(mesh.holes_of(1).empty());
}

TEST(ReadCityJson, KeepsEverySolidOfMultiAndComposite) {
    const std::string solids = "[[" + box_shell(0) + "],[" + box_shell(0) + "]]";
    const Mesh mesh =
        read_mesh(city(object("A", geometry("MultiSolid", solids) + "," + geometry("CompositeSolid", solids)) + "," +
                           object("B", geometry("Solid", "[" + box_shell(0) + "]"), "Bridge"),
                       unit_box),
                  "a.json");
    ASSERT_EQ(mesh.solids.size(), 5u);
    EXPECT_NE(mesh.solids[0].composite, mesh.solids[1].composite);
    EXPECT_EQ(mesh.solids[2].composite, mesh.solids[3].composite);
    EXPECT_NE(mesh.solids[3].composite, mesh.solids[4].composite);
    EXPECT_EQ(mesh.solids[1].name, "Building \"A\", LoD 2.2, solid 1");
    EXPECT_EQ(mesh.solids[4].name, "Bridge \"B\", LoD 2.2");
}

TEST(ReadCityJson, NotesWhatIsNoSolid) {
    const Mesh mesh = read_mesh(city(object("A", geometry("MultiSurface", "[[[0,1,2]]]", "1")), unit_box), "a.json");
    EXPECT_EQ(mesh.face_count(), 0u);
    ASSERT_EQ(mesh.findings.size(), 1u);
    EXPECT_EQ(mesh.findings[0].code, "P813");
    EXPECT_EQ(mesh.findings[0].sentence, "Building \"A\", LoD 1 is a MultiSurface, not a solid.");
}

TEST(ReadCityJson, CountsTheRestOfManyThatAreNoSolids) {
    std::string geometries;
    for (int k = 0; k < 30; ++k) geometries += std::string(k == 0 ? "" : ",") + geometry("MultiSurface", "[]");
    const Mesh mesh = read_mesh(city(object("A", geometries), unit_box), "a.json");
    ASSERT_EQ(mesh.findings.size(), 21u);
    EXPECT_EQ(mesh.findings.back().sentence, "10 geometries more are no solids.");
}

const std::string templates = R"("geometry-templates":{"templates":[)" + geometry("Solid", "[" + box_shell(0) + "]") +
                              R"(],"vertices-templates":[)" + box_vertices({0, 0, 0}, {2, 2, 2}) + "]},";

std::string instance(int number, const std::string& matrix = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1") {
    return R"({"type":"GeometryInstance","template":)" + std::to_string(number) +
           R"(,"boundaries":[0],"transformationMatrix":[)" + matrix + "]}";
}

TEST(ReadCityJson, ReadsATemplateOnceAndSaysWhoPlacesIt) {
    const Mesh mesh = read_mesh(
        city(object("t1", instance(0), "Tree") + "," + object("t2", instance(0), "Tree"), "[0,0,0]", templates),
        "a.json");
    ASSERT_EQ(mesh.solids.size(), 1u);
    EXPECT_EQ(mesh.solids[0].name, "Template 0 (2 times, first in Tree \"t1\"), LoD 2.2");
    EXPECT_EQ(mesh.solids[0].first_vertex, 1u);
    EXPECT_EQ(mesh.points.back(), (std::array<double, 3>{2, 2, 2}));
}

TEST(ReadCityJson, WarnsOfMatricesThatFlatten) {
    const Mesh mesh =
        read_mesh(city(object("t", instance(0, "1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1")), "[0,0,0]", templates), "a.json");
    ASSERT_EQ(mesh.findings.size(), 1u);
    EXPECT_EQ(mesh.findings[0].code, "P814");
}

TEST(ReadCityJson, ReadsSequencesOfFeatures) {
    const std::string head =
        R"({"type":"CityJSON","version":"2.0","transform":{"scale":[2,2,2],"translate":[0,0,0]},"CityObjects":{},"vertices":[]})";
    const auto feature = [](const std::string& id) {
        return R"({"type":"CityJSONFeature","id":")" + id + R"(","CityObjects":{)" +
               object(id, geometry("Solid", "[" + box_shell(0) + "]")) + R"(},"vertices":[)" + unit_box + "]}";
    };
    const Mesh mesh = read_mesh(head + "\n" + feature("a") + "\n" + feature("b") + "\n", "a.jsonl");
    ASSERT_EQ(mesh.solids.size(), 2u);
    EXPECT_EQ(mesh.solids[1].first_vertex, 8u);
    EXPECT_EQ(mesh.points[15], (std::array<double, 3>{2, 2, 2}));
    EXPECT_EQ(rings(mesh)[6][0], 8u);
}

TEST(ReadCityJson, DecodesEscapesInNames) {
    EXPECT_EQ(read_mesh(city(object(R"(a\u00e9\n\ud83c\udfe0)", geometry("Solid", "[" + box_shell(0) + "]")), unit_box),
                        "a.json")
                  .solids.at(0)
                  .object,
              "a\u00e9\n\U0001F3E0");
}

TEST(ReadCityJson, RefusesVerticesThatDoNotExist) {
    expect_refused(city(object("A", geometry("Solid", "[[[[0,1,\n8]]]]")), unit_box), "a.json", "P804", 2,
                   "Vertex 8 of Building \"A\"");
    expect_refused(city(object("A", geometry("Solid", "[[[[0,1,-1]]]]")), unit_box), "a.json", "P804", 1, "Vertex -1");
    expect_refused(city(object("t", instance(7)), "[0,0,0]", templates), "a.json", "P804", 1, "template 7");
}

TEST(ReadCityJson, RefusesWhatIsNoCityJson) {
    expect_refused("{}", "a.json", "P809", 1, "not of type CityJSON");
    expect_refused(R"({"type":"FeatureCollection"})", "a.json", "P809", 1, "not of type CityJSON");
    expect_refused(R"({"type":"CityJSONFeature"})", "a.json", "P809", 1, "first object");
    expect_refused(R"({"type":"CityJSON","version":"0.9"})", "a.json", "P806", 1, "upgrade");
    expect_refused(R"({"type":"CityJSON","version":"2.0","CityObjects":{}})", "a.json", "P809", 1,
                   "no list of vertices");
    expect_refused(R"({"type":"CityJSON","version":"2.0","vertices":[]})", "a.json", "P809", 1, "no CityObjects");
    expect_refused(R"({"type":7})", "a.json", "P809", 1, "must be a text");
    expect_refused(city(object("A", geometry("Solid", "[[[0,1,2]]]")), unit_box), "a.json", "P809", 1,
                   "A ring must be a list");
    expect_refused(city(object("A", geometry("Solid", "[[[[0,1,2.5]]]]")), unit_box), "a.json", "P809", 1,
                   "whole number");
    expect_refused(city(object("A", geometry("Solid", "{}")), unit_box), "a.json", "P809", 1, "A solid must be a list");
    expect_refused(city(object("A", R"({"type":"Solid"})"), unit_box), "a.json", "P809", 1, "no boundaries");
    expect_refused(city(object("A", ""), "[0,0]"), "a.json", "P809", 1, "three numbers");
    expect_refused(city(object("A", ""), "[0,0,0,0]"), "a.json", "P809", 1, "three numbers");
    expect_refused(city(object("t", instance(0, "1,2,3")), "[0,0,0]", templates), "a.json", "P809", 1, "16 numbers");
    expect_refused(city("", "") + "[]", "a.json", "P809", 1, "must be an object");
}

TEST(ReadCityJson, RefusesCoordinatesThatAreNotFinite) {
    expect_refused(city(object("A", ""), "[0,0,1e308]"), "a.json", "P803", 1, "1e308");
    expect_refused(city(object("A", ""), "[0,0,1e999]"), "a.json", "P803", 1, "1e999");
    std::string far = city(object("A", ""), "[0,0,900000000000]");
    far.replace(far.find("[1,1,1]"), 7, "[1,1,9]");
    expect_refused(far, "a.json", "P803", 1, "farther than 1e12");
    expect_refused(city(object("A", ""), "[0,0,NaN]"), "a.json", "P809", 1, "must be a number");
}

TEST(ReadCityJson, RefusesJsonThatIsNotWellFormed) {
    const std::string sound = city(object("A", geometry("Solid", "[" + box_shell(0) + "]")), unit_box);
    for (std::size_t size = 1; size < sound.size(); ++size) {
        const InputError error = refusal(sound.substr(0, size), "a.json");
        EXPECT_TRUE(error.code == "P808" || error.code == "P809") << size << " " << error.code << " " << error.what();
        EXPECT_GT(error.line, 0) << size;
    }
    expect_refused(R"({"type":"CityJSON","version":"2.0","vertices":[],"CityObjects":{"a":{} "b":{}}})", "a.json",
                   "P808", 1, "',' or '}'");
    expect_refused("{\"type\":\"City\xFFJSON\"}", "a.json", "P808", 1, "UTF-8");
    expect_refused(R"({"a":"\q","type":"\q"})", "a.json", "P808", 1, "escape");
    expect_refused(R"({"type":"\ud800"})", "a.json", "P808", 1, "surrogate");
    expect_refused(R"({"a":[}})", "a.json", "P808", 1, "closes none");
}

TEST(ReadCityJson, RefusesAbsurdNesting) {
    expect_refused("{\"a\":" + std::string(100000, '['), "a.json", "P808", 1, "512 deep");
    EXPECT_EQ(
        read_mesh(city(object("A", geometry("MultiSurface", std::string(500, '[') + std::string(500, ']'))), unit_box),
                  "a.json")
            .face_count(),
        0u);
}

}  // namespace
}  // namespace enfilade::modeler::test
