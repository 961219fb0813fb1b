// `enfilade info --svg`: what the drawing says is what `info --json` says.

#include <cmath>
#include <fstream>
#include <pugixml.hpp>
#include <set>

#include "tests/cli/program.h"
#include "tests/report/path_rings.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class InfoDrawing : public OfficeTest {
protected:
    /// The drawing that `info` makes with these flags, as XML.
    static pugi::xml_document draw(std::vector<std::string> flags = {}, const std::string& scene = "office.enf") {
        std::vector<std::string> words = {"info", scene, "--svg", "cuts.svg"};
        words.insert(words.end(), flags.begin(), flags.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        pugi::xml_document svg;
        EXPECT_TRUE(svg.load_file((folder() / "cuts.svg").c_str()));
        return svg;
    }
    static json info(const std::string& scene = "office.enf") {
        return json::parse(run({"info", scene, "--json"}).out);
    }
    static pugi::xpath_node_set panels(const pugi::xml_document& svg) {
        return svg.select_nodes("//g[@class='panel']");
    }
};

std::set<std::string> rooms_of(const pugi::xml_node& node) {
    std::set<std::string> ids;
    for (const pugi::xpath_node& path : node.select_nodes(".//path[starts-with(@class,'room ')]"))
        ids.insert(path.node().attribute("data-space").value());
    return ids;
}

double length_mm(const std::string& path) {
    double sum = 0;
    for (const auto& line : testing::PathReader(path).rings())
        for (std::size_t k = 1; k < line.size(); ++k)
            sum += std::hypot(double(line[k].x - line[k - 1].x), double(line[k].y - line[k - 1].y));
    return sum;
}

TEST_F(InfoDrawing, HasAPanelForEachStoreyWithItsRooms) {
    const pugi::xml_document svg = draw();
    const json about = info();
    ASSERT_EQ(panels(svg).size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        const pugi::xml_node panel = panels(svg)[k].node();
        std::set<std::string> expected;
        std::size_t cells = 0;
        std::string storey;
        for (const json& room : about["rooms"]) {
            if (storey.empty() &&
                panel.select_node("text").node().text().get() == "Storey " + room["storey"].get<std::string>())
                storey = room["storey"];
            if (room["storey"] != storey) continue;
            expected.insert(room["id"].get<std::string>());
            cells += room["cells"].get<std::size_t>();
        }
        EXPECT_FALSE(expected.empty());
        EXPECT_EQ(rooms_of(panel), expected);
        const std::string line = panel.select_node("text[@class='line']").node().text().get();
        EXPECT_TRUE(line.starts_with(std::to_string(expected.size()) + " rooms of " + std::to_string(cells) + " cells"))
            << line;
    }
}

TEST_F(InfoDrawing, TakesAStoreyByNameOrNumber) {
    const std::string name = info()["rooms"].back()["storey"];
    const pugi::xml_document by_number = draw({"--storey", "1"});
    EXPECT_EQ(panels(by_number).size(), 1u);
    const std::string drawn = read_bytes(folder() / "cuts.svg");
    const pugi::xml_document by_name = draw({"--storey", name});
    EXPECT_EQ(read_bytes(folder() / "cuts.svg"), drawn);
    for (const json& room : info()["rooms"])
        EXPECT_EQ(rooms_of(by_name).count(room["id"].get<std::string>()), room["storey"] == name ? 1u : 0u);
}

/// The height is the plan's, lengths are measured on the drawing.
TEST_F(InfoDrawing, CutsAreAsLongAsTheirAreaSays) {
    const std::string file = ENFILADE_SOURCE_DIR "/plans/examples/curved-room.json";
    const json plan = json::parse(read_bytes(file));
    ASSERT_EQ(run({"build", file, "-o", "curved.enf", "-q"}).exit_code, 0);
    const pugi::xml_document svg = draw({}, "curved.enf");
    double drawn = 0, area = 0;
    for (const pugi::xpath_node& cut : svg.select_nodes("//g[@class='inside']/path[starts-with(@class,'cut ')]"))
        drawn += length_mm(cut.node().attribute("d").value()) / 1000;
    const json about = info("curved.enf");
    for (const json& room : about["rooms"]) area += room["cut_area_m2"].get<double>();
    ASSERT_GT(area, 1);
    EXPECT_NEAR(drawn * plan["storeys"][0]["height"].get<double>(), area, 0.005 * area);
    EXPECT_GE(about["virtual_portal_area_m2"].get<double>(), area);
}

TEST_F(InfoDrawing, NeedsNoModelGroup) {
    draw();
    const std::string whole = read_bytes(folder() / "cuts.svg");
    std::filesystem::create_directory(folder() / "thin");
    ASSERT_EQ(run({"build", "office.json", "-o", "thin/office.enf", "--strip", "-q"}).exit_code, 0);
    draw({}, "thin/office.enf");
    EXPECT_EQ(read_bytes(folder() / "cuts.svg"), whole) << "drawn from the flat scene alone, the same bytes each time";
}

TEST_F(InfoDrawing, RefusesWhatItCannotDraw) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> faults = {
        {{"info", "office.enf", "--svg", "cuts.png"}, "end its name so"},
        {{"info", "office.enf", "--svg", "none.svg", "--storey", "7"}, "no storey \"7\""},
        {{"info", "office.enf", "--storey", "0"}, "--svg"}};
    for (const auto& [words, expected] : faults) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(std::filesystem::exists(folder() / "cuts.png"));
    EXPECT_FALSE(std::filesystem::exists(folder() / "none.svg"));
    const Outcome nowhere = run({"info", "office.enf", "--svg", "nowhere/cuts.svg"});
    EXPECT_EQ(nowhere.exit_code, 3);
    EXPECT_NE(nowhere.err.find("nowhere"), std::string::npos) << nowhere.err;
}

TEST_F(InfoDrawing, ShowsNamesOfStrangersAsText) {
    json plan = json::parse(read_bytes(folder() / "office.json"));
    const std::string name = "A&B <script>\"'";
    plan["storeys"][0]["rooms"][0]["name"] = name;
    std::ofstream(folder() / "odd.json") << plan.dump();
    ASSERT_EQ(run({"build", "odd.json", "-o", "odd.enf", "-q"}).exit_code, 0);
    const pugi::xml_document svg = draw({}, "odd.enf");
    EXPECT_TRUE(svg.select_node("//script").node().empty());
    bool found = false;
    for (const pugi::xpath_node& title : svg.select_nodes("//path/title"))
        found |= std::string(title.node().text().get()).starts_with(name);
    EXPECT_TRUE(found);
}

}  // namespace
}  // namespace enfilade::test
