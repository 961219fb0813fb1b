// What is no FloorspaceJS file, or a broken one: refused with line and column.
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "plans/floorspace/detect.h"
#include "tests/plans/floorspace/floor_text.h"

namespace enfilade::plans {
namespace {

using testing::floor_plan;
using testing::FloorText;

InputError refusal(const std::string& text) {
    try {
        (void)read_floorspace(text, "floor.json");
    } catch (const InputError& error) {
        return error;
    }
    return {"none", "", "nothing was refused"};
}

/// One office, with the first `what` replaced by `by`.
std::string broken(const std::string& what, const std::string& by) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    std::string plan = floor_plan({text.story()});
    const std::size_t at = plan.find(what);
    if (at == std::string::npos) ADD_FAILURE() << what << " is not in " << plan;
    else plan.replace(at, what.size(), by);
    return plan;
}

struct Complaint {
    const char* what;
    std::string text;
    const char* code;
    int line;
    const char* says;
};
void PrintTo(const Complaint& complaint, std::ostream* out) { *out << complaint.what; }

class FloorspaceRefused : public ::testing::TestWithParam<Complaint> {};

TEST_P(FloorspaceRefused, WithItsPlace) {
    const Complaint& expected = GetParam();
    const InputError error = refusal(expected.text);
    EXPECT_EQ(error.code, expected.code) << error.what();
    EXPECT_EQ(error.line, expected.line) << error.what();
    EXPECT_GT(error.column, 0);
    EXPECT_EQ(error.file, "floor.json");
    EXPECT_NE(std::string(error.what()).find(expected.says), std::string::npos) << error.what();
}

// Line 2: the story, 3: its geometry, whose vertices stand on 3..6, edges on 7..10, the face on 11.
INSTANTIATE_TEST_SUITE_P(
    Files, FloorspaceRefused,
    ::testing::Values(
        Complaint{"an empty file", "", "P101", 1, "end of the file"},
        Complaint{"a list", "[]", "P103", 1, "floor plan"},
        Complaint{"no stories", "{\"project\":{},\n\"application\":{}}", "P104", 1, "\"stories\""},
        Complaint{"an empty list of stories", "{\"project\":{},\n\"stories\":[]}", "P753", 2, "no story"},
        Complaint{"stories that are no list", "{\"project\":{},\n\"stories\":{}}", "P103", 2, "list"},
        Complaint{"a story that is a text", "{\"stories\":[\n\"a\"]}", "P103", 2, "story"},
        Complaint{"a story of our own format", "{\"stories\":[\n{\"walls\":[]}]}", "P104", 2, "storeys"},
        Complaint{"a text cut off", "{\"stories\":[\n{\"id\":\"g\",", "P101", 2, "end of the file"},
        Complaint{"an unknown unit", broken("\"si\"", "\"furlong\""), "P750", 1, "furlong"},
        Complaint{"a unit that is a number", broken("\"si\"", "3"), "P103", 1, "units"},
        Complaint{"no geometry", "{\"stories\":[\n{\"id\":\"g\"}]}", "P104", 2, "geometry"},
        Complaint{"a text for a coordinate", broken("\"x\":4.000000", "\"x\":\"4\""), "P103", 4, "\"x\""},
        Complaint{"a missing coordinate", broken(",\"y\":0.000000", ""), "P104", 3, "\"y\""},
        Complaint{"NaN", broken("\"x\":4.000000", "\"x\":NaN"), "P101", 4, "NaN"},
        Complaint{"a coordinate beyond all measure", broken("\"x\":4.000000", "\"x\":1e308"), "P105", 4, "at most"},
        Complaint{"a number that none can hold", broken("\"x\":4.000000", "\"x\":1e999"), "P101", 4, "too large"},
        Complaint{"a vertex without id", broken("\"id\":\"v1\",", ""), "P104", 4, "\"id\""},
        Complaint{"an edge without id", broken("\"id\":\"e1\",", ""), "P104", 8, "\"id\""},
        Complaint{"two vertices of one id", broken("\"id\":\"v2\"", "\"id\":\"v1\""), "P752", 5, "line 4"},
        Complaint{"two edges of one id", broken("\"id\":\"e2\"", "\"id\":\"e1\""), "P752", 9, "line 8"},
        Complaint{"an edge to no vertex", broken("[\"v1\",\"v2\"]", "[\"v1\",\"v9\"]"), "P751", 8, "\"v9\""},
        Complaint{"an edge of three vertices", broken("[\"v1\",\"v2\"]", "[\"v1\",\"v2\",\"v3\"]"), "P105", 8,
                  "names 3"},
        Complaint{"a face of no edge", broken("\"e2\",\"e3\"]", "\"e2\",\"e9\"]"), "P751", 11, "\"e9\""},
        Complaint{"an order of the wrong length", broken("[1,1,1,1]", "[1,1,1]"), "P105", 11, "4 edges"},
        Complaint{"an order of texts", broken("[1,1,1,1]", "[1,1,\"x\",1]"), "P103", 11, "edge_order"},
        Complaint{"an id that is a list", broken("\"face_id\":\"f0\"", "\"face_id\":[]"), "P103", 12, "face_id"},
        Complaint{"a negative height", broken("_height\":3", "_height\":-3"), "P105", 2, "height"},
        Complaint{"an infinite height", broken("_height\":3", "_height\":1e300"), "P105", 2, "height"},
        Complaint{"a name that is a number", broken("\"Office\"", "17"), "P103", 12, "name"},
        Complaint{"definitions of one id", broken("\"id\":\"row\"", "\"id\":\"single\""), "P752", 18, "line 17"},
        Complaint{"an aperture that is a number", broken("\"windows\":[]", "\"windows\":[1]"), "P103", 14, "window"},
        Complaint{"a share that is a text", broken("\"doors\":[]", R"("doors":[{"edge_id":"e0","alpha":"x"}])"), "P103",
                  15, "alpha"},
        Complaint{"nesting without end", "{\"stories\":" + std::string(100000, '['), "P101", 1, "deep"}),
    [](const ::testing::TestParamInfo<Complaint>& test) {
        std::string name = test.param.what;
        for (char& c : name)
            if (c == ' ') c = '_';
        return name;
    });

TEST(FloorspaceRefusals, PutStoriesNoHigherThanThePlanCan) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    const std::string tower = text.story("\"id\":\"t\",\"floor_to_ceiling_height\":9999");
    const InputError error = refusal(floor_plan(std::vector<std::string>(11, tower)));
    EXPECT_EQ(error.code, "P105");
    EXPECT_GT(error.line, 100);
}

TEST(FloorspaceRefusals, HappenAtEveryPlaceWhereTheFileMayBeCutOff) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    text.window("w", "single", "e0", "0.5");
    const std::string plan = floor_plan({text.story()});
    for (std::size_t length = 0; length < plan.size(); ++length) {
        const InputError error = refusal(plan.substr(0, length));
        EXPECT_EQ(error.code, "P101") << length;
        EXPECT_GT(error.line, 0);
    }
}

TEST(FloorspaceDetection, KnowsItsOwn) {
    EXPECT_TRUE(is_floorspace(R"({"application":{},"project":{},"stories":[]})"));
    EXPECT_TRUE(is_floorspace(R"({"stories":[]})"));
    EXPECT_TRUE(is_floorspace("\xEF\xBB\xBF{\"version\":\"0.8.0\",\"stories\":[]}"));
    EXPECT_TRUE(is_floorspace(R"({"project":{"note":"}\"storeys\": [\\"},"application":{"storeys":1}})"));
    EXPECT_TRUE(is_floorspace(R"({"application":{"a":[1,{"b":)"));  // cut off
}

TEST(FloorspaceDetection, LeavesOursToOurReader) {
    EXPECT_FALSE(is_floorspace(R"({"storeys":[]})"));
    EXPECT_FALSE(is_floorspace(R"({"format_version":1,"name":"project","storeys":[{"stories":1}]})"));
    EXPECT_FALSE(is_floorspace("// \"stories\": a house\n{ /* \"stories\":[] */ \"storeys\":[]}"));
    EXPECT_FALSE(is_floorspace("// project\n{\"name\": \"x\" // y }\n, /* } */ \"storeys\":[],\"stories\":[]}"));
    EXPECT_FALSE(is_floorspace("{\"name\":\"\\\"stories\\\"\"}"));
    for (const char* text :
         {"", "{", "{\"", "{\"a", "{\"a\"", "{\"a\":", "{\"a\":[", "{\"\\", "[\"stories\"]", "/", "{/"})
        EXPECT_FALSE(is_floorspace(text)) << text;
}

TEST(FloorspaceDetection, ChoosesTheReaderOfAFile) {
    const auto write = [](const char* name, const std::string& text) {
        const std::string file = ::testing::TempDir() + "/" + name;
        std::ofstream(file) << text;
        return file;
    };
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    ReadOptions options;
    options.unit = Unit::Foot;
    const Plan plan = read(write("floor_detected.json", floor_plan({text.story()})), options);
    EXPECT_EQ(plan.name, "floor_detected");
    EXPECT_NEAR(plan.storeys.at(0).height, 3 * 0.3048, 1e-12);
    // A slip in our own format is still ours to explain.
    try {
        (void)read(write("ours_misspelt.json", "{\"storeys\": [\n{\"wals\": []}]}"));
        ADD_FAILURE() << "nothing was refused";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, "P102");
        EXPECT_EQ(error.line, 2);
        EXPECT_NE(std::string(error.what()).find("\"walls\""), std::string::npos);
    }
}

}  // namespace
}  // namespace enfilade::plans
