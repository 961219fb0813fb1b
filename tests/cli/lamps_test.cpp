// `build --lamps`, and what `info`, `check`, `place` and `export` make of lamps.

#include <algorithm>
#include <fstream>

#include "accel/scene_file.h"
#include "tests/cli/program.h"
#include "tools/output_file.h"

namespace enfilade::test {
namespace {

using nlohmann::json;
using tools::write_text;

class Lamps : public OfficeTest {
protected:
    static json result(std::vector<std::string> words) {
        words.push_back("--json");
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out, nullptr, false);
    }
    static json lamps_of(const std::string& scene) { return result({"info", scene}).at("lamps"); }
    /// The scene's lamps: id, place, carrier's id.
    static std::vector<std::string> lights(const std::string& scene) {
        const accel::Scene opened = accel::open(folder() / scene);
        const accel::SceneView& view = opened.view();
        std::vector<std::string> lines;
        for (const accel::Light& light : view.lights) {
            std::string line(view.string(light.id));
            for (const float x : light.position) line += ' ' + std::to_string(x);
            for (const float x : light.intensity) line += ' ' + std::to_string(x);
            if (light.carrier != none<accel::ObjectId>)
                line += ' ' + std::string(view.string(view.objects[index(light.carrier)].id));
            lines.push_back(line);
        }
        return lines;
    }
};

TEST_F(Lamps, OfThePlanAreInItsSceneAndInInfo) {
    const json lamps = lamps_of("office.enf");
    EXPECT_GE(lamps.at("lamps"), 12);
    EXPECT_EQ(lamps.at("in_solids"), 0);
    EXPECT_EQ(lamps.at("indoors"), lamps.at("lamps"));
    const Outcome outcome = run({"info", "office.enf"});
    EXPECT_NE(outcome.out.find("\nLamps\n"), std::string::npos) << outcome.out;
}

TEST_F(Lamps, ByRuleComeInTheNumberThatAFileAsksFor) {
    write_text(folder() / "lamps.json", R"({"count": 37, "replace": true, "outdoor": {"entrance_lumen": 0}})");
    const json built = result({"build", "office.json", "-o", "counted.enf", "--lamps", "lamps.json"});
    EXPECT_EQ(built.at("lamps").at("lamps"), 37);
    EXPECT_EQ(built.at("lamps").at("dark_rooms"), 0);
    EXPECT_EQ(built.at("options").at("lamps"), "lamps.json");
}

TEST_F(Lamps, ByRuleAreTheSameEachTimeAndCertified) {
    (void)result({"build", "office.json", "-o", "one.enf", "--furnish", "--lamps"});
    (void)result({"build", "office.json", "-o", "two.enf", "--furnish", "--lamps"});
    EXPECT_EQ(lights("one.enf"), lights("two.enf"));
    EXPECT_GT(lamps_of("one.enf").at("carried"), 0);
    EXPECT_EQ(run({"check", "one.enf"}).exit_code, 0);
}

TEST_F(Lamps, GoWithTheirPieceAndStayOtherwise) {
    (void)result({"build", "office.json", "-o", "full.enf", "--furnish", "--lamps"});
    const accel::Scene scene = accel::open(folder() / "full.enf");
    const accel::SceneView& view = scene.view();
    const auto carried =
        std::ranges::find_if(view.lights, [](const accel::Light& l) { return l.carrier != none<accel::ObjectId>; });
    ASSERT_NE(carried, view.lights.end());
    const std::string id(view.string(view.objects[index(carried->carrier)].id));
    ASSERT_EQ(run({"place", "full.enf", "-o", "less.enf", "--remove", id}).exit_code, 0);
    EXPECT_EQ(lamps_of("less.enf").at("lamps").get<int>() + 1, lamps_of("full.enf").at("lamps"));
}

TEST_F(Lamps, AreThereInStrippedScenes) {
    (void)result({"build", "office.json", "-o", "full.enf", "--furnish", "--lamps"});
    (void)result({"build", "office.json", "-o", "stripped.enf", "--furnish", "--lamps", "--strip"});
    EXPECT_EQ(lights("stripped.enf"), lights("full.enf"));
}

TEST_F(Lamps, AreExportedToGltfFromStrippedScenesToo) {
    (void)result({"build", "office.json", "-o", "stripped.enf", "--lamps", "--strip"});
    ASSERT_EQ(run({"export", "stripped.enf", "-o", "office.glb"}).exit_code, 0);
    std::ifstream stream(folder() / "office.glb", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_NE(bytes.find("KHR_lights_punctual"), std::string::npos);
}

TEST_F(Lamps, InAWallAreNamedByCheck) {
    write_text(folder() / "wall.json", R"({"storeys": [{"id": "g",
        "walls": [{"id": "s", "start": [0, 0], "end": [4, 0]}, {"id": "e", "start": [4, 0], "end": [4, 3]},
                  {"id": "n", "start": [4, 3], "end": [0, 3]}, {"id": "w", "start": [0, 3], "end": [0, 0]}],
        "openings": [{"wall": "s", "offset": 1}],
        "lights": [{"id": "l", "name": "Kitchen lamp", "position": [0, 1]}]}]})");
    const Outcome outcome = run({"check", "wall.json"});
    EXPECT_EQ(outcome.exit_code, 0) << "a warning";
    EXPECT_NE((outcome.out + outcome.err).find("Kitchen lamp"), std::string::npos) << outcome.out << outcome.err;
    EXPECT_NE(run({"check", "wall.json", "--strict"}).exit_code, 0);
    ASSERT_EQ(run({"build", "wall.json", "-o", "wall.enf"}).exit_code, 0);
    EXPECT_EQ(lamps_of("wall.enf").at("in_solids"), 1);
}

TEST_F(Lamps, RulesThatAreWrongAreRefusedWithTheirPlace) {
    write_text(folder() / "wrong.json", "{\n\"romos\": []}");
    const Outcome outcome = run({"build", "office.json", "-o", "no.enf", "--lamps", "wrong.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("wrong.json:2"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("rooms"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace enfilade::test
