// Plans and meshes of other programs, as a user gives them to the program.

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class Formats : public OfficeTest {
protected:
    static std::string example(const std::string& name) { return ENFILADE_SOURCE_DIR "/plans/examples/" + name; }
    static json json_of(const Outcome& outcome) { return json::parse(outcome.out); }
};

TEST_F(Formats, ADrawingBecomesASoundModelWithItsRooms) {
    const Outcome built = run({"build", example("drawings/office-10.dxf"), "-o", "drawing.enf", "--json"});
    ASSERT_EQ(built.exit_code, 0) << built.err;
    EXPECT_TRUE(json_of(built)["check"]["sound"]);
    const json info = json_of(run({"info", "drawing.enf", "--json"}));
    EXPECT_EQ(info["rooms"].size(), 10u);
}

TEST_F(Formats, TheLayersOfADrawingAreListed) {
    const Outcome listed = run({"import", example("drawings/office-10.dxf"), "--list-layers", "--json"});
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    std::vector<std::string> names;
    const json layers = json_of(listed)["layers"];
    for (const json& layer : layers) names.push_back(layer["name"]);
    for (const char* name : {"A-WALL", "A-DOOR", "A-GLAZ"})
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    EXPECT_EQ(run({"import", "office.json", "--list-layers"}).exit_code, 2) << "no drawing";
}

TEST_F(Formats, LayersAndBoxesOfADrawingCanBeChosen) {
    const Outcome none = run({"import", example("drawings/office-10.dxf"), "--layer", "B-*", "-o", "none.json"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_NE(none.err.find("A-WALL"), std::string::npos) << none.err;
    const Outcome far =
        run({"import", example("drawings/office-10.dxf"), "--crop", "1e6,1e6,2e6,2e6", "-o", "none.json"});
    EXPECT_EQ(far.exit_code, 2);
    EXPECT_EQ(line_count(far.err), 1u) << far.err;
    EXPECT_FALSE(std::filesystem::exists(folder() / "none.json"));
    const Outcome walls =
        run({"import", example("drawings/office-10.dxf"), "--layer", "A-WALL", "-o", "walls.json", "--json"});
    ASSERT_LE(walls.exit_code, 1) << walls.err;
    EXPECT_GT(json_of(walls)["plan"]["walls"].get<int>(), 10);
}

TEST_F(Formats, TheUnitOfTheUserOverrulesTheDrawing) {
    const auto extent = [](const std::string& unit) {
        run({"import", example("drawings/office-10.dxf"), "--units", unit, "-o", unit + ".json"});
        const json plan = json::parse(read_bytes(folder() / (unit + ".json")));
        double most = 0;
        for (const json& wall : plan["storeys"][0]["walls"]) most = std::max(most, wall["end"][0].get<double>());
        return most;
    };
    EXPECT_NEAR(extent("in") / extent("mm"), 25.4, 0.3);
}

TEST_F(Formats, AFloorPlanOfFloorspaceBecomesASoundModel) {
    const Outcome built = run({"build", example("floorspace/two-rooms.json"), "-o", "floorspace.enf", "--json"});
    ASSERT_EQ(built.exit_code, 0) << built.err;
    EXPECT_TRUE(json_of(built)["check"]["sound"]);
    const json info = json_of(run({"info", "floorspace.enf", "--json"}));
    EXPECT_EQ(info["rooms"].size(), 2u);
    EXPECT_EQ(info["openings"].size(), 2u);
}

TEST_F(Formats, AMeshIsCheckedAndItsHoleIsNamed) {
    write_bytes(folder() / "open.off",
                "OFF\n8 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                "4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    const Outcome checked = run({"check", "open.off", "--json"});
    EXPECT_EQ(checked.exit_code, 1) << checked.err;
    const json report = json_of(checked);
    EXPECT_FALSE(report["sound"]);
    ASSERT_EQ(report["code_counts"]["T2"], 1);
    EXPECT_EQ(report["findings"][0]["point"][2], 1);
}

TEST_F(Formats, SoupIsWeldedWhereAskedFor) {
    std::string soup = "OFF\n12 4 0\n";
    const char* corners[4] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    for (const auto& face : faces)
        for (const int k : face) soup += std::string(corners[k]) + '\n';
    for (int f = 0; f < 4; ++f)
        soup += "3 " + std::to_string(3 * f) + ' ' + std::to_string(3 * f + 1) + ' ' + std::to_string(3 * f + 2) + '\n';
    write_bytes(folder() / "soup.off", soup);
    EXPECT_EQ(run({"check", "soup.off"}).exit_code, 1);
    const Outcome welded = run({"check", "soup.off", "--weld", "0"});
    EXPECT_EQ(welded.exit_code, 0) << welded.out;
    EXPECT_NE(welded.out.find("weld"), std::string::npos) << welded.out;
}

TEST_F(Formats, TheReportIsAPageThatNeedsNothingElse) {
    ASSERT_EQ(run({"check", "office.json", "--report", "office.html"}).exit_code, 0);
    const std::string page = read_bytes(folder() / "office.html");
    EXPECT_TRUE(page.starts_with("<!doctype html>")) << page.substr(0, 40);
    EXPECT_NE(page.find("<svg"), std::string::npos);
    for (const char* outside : {"src=\"http", "href=\"http", "url(http", "@import"})
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    ASSERT_EQ(run({"check", "office.enf", "--report", "scene.html"}).exit_code, 0);
    EXPECT_NE(read_bytes(folder() / "scene.html").find("certified"), std::string::npos);
}

TEST_F(Formats, EveryFormatOfExportIsWritten) {
    for (const char* name : {"a.glb", "a.obj", "a.gml", "a.city.json", "a.hbjson", "a.graphml", "a.dot"}) {
        SCOPED_TRACE(name);
        const Outcome outcome = run({"export", "office.enf", "-o", name});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_GT(std::filesystem::file_size(folder() / name), 1000u);
    }
    EXPECT_EQ(run({"check", "a.city.json"}).exit_code, 0);
}

TEST_F(Formats, SemanticFormatsRefuseAStrippedScene) {
    ASSERT_EQ(run({"build", "office.json", "-o", "bare.enf", "--strip"}).exit_code, 0);
    for (const char* name : {"b.gml", "b.city.json", "b.hbjson"}) {
        const Outcome outcome = run({"export", "bare.enf", "-o", name});
        EXPECT_EQ(outcome.exit_code, 2) << name;
        EXPECT_NE(outcome.err.find("--strip"), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder() / name));
    }
    EXPECT_EQ(run({"export", "bare.enf", "-o", "b.glb"}).exit_code, 0);
}

}  // namespace
}  // namespace enfilade::test
