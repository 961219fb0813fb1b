// The commands one after the other, as a user runs them.

#include <algorithm>
#include <thread>

#include "accel/certificate.h"
#include "accel/scene_file.h"
#include "modeler/certify.h"
#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

using Pipeline = OfficeTest;

TEST_F(Pipeline, GeneratesAndBuildsWithoutFindings) {
    EXPECT_EQ(generated_.exit_code, 0) << generated_.err;
    EXPECT_EQ(built_.exit_code, 0) << built_.err;
    EXPECT_EQ(generated_.err + built_.err, "");
    EXPECT_NE(built_.out.find("sound, no findings"), std::string::npos) << built_.out;
    // The report, then the plan's lamps, then the scene.
    const std::string report = read_bytes(folder() / "office.txt");
    EXPECT_EQ(report, built_.out.substr(0, report.size()));
    EXPECT_NE(built_.out.find(" lamps of ", report.size()), std::string::npos) << built_.out;
}

TEST_F(Pipeline, LeavesOnlyWhatWasAskedFor) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder().path()))
        names.push_back(entry.path().filename().string());
    for (const std::string& name : names) EXPECT_FALSE(name.starts_with('.')) << name;
    EXPECT_EQ(std::count(names.begin(), names.end(), "office.enf"), 1);
}

TEST_F(Pipeline, BuildsTheSameBytesAgain) {
    ASSERT_EQ(run({"build", "office.json", "-o", "again.enf", "--quiet"}).exit_code, 0);
    EXPECT_EQ(read_bytes(folder() / "office.enf"), read_bytes(folder() / "again.enf"));
}

TEST_F(Pipeline, QuietSaysNothing) {
    const Outcome outcome = run({"build", "office.json", "-o", "quiet.enf", "-q"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_TRUE(std::filesystem::exists(folder() / "quiet.enf"));
}

TEST_F(Pipeline, ImportsItsOwnPlanUnchanged) {
    const Outcome outcome = run({"import", "office.json", "-o", "imported.json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("2 storeys"), std::string::npos) << outcome.out;
    EXPECT_EQ(read_bytes(folder() / "office.json"), read_bytes(folder() / "imported.json"));
}

TEST_F(Pipeline, ChecksAPlanAndItsSceneAlike) {
    const Outcome plan = run({"check", "office.json", "--json"});
    const Outcome scene = run({"check", "office.enf", "--json"});
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_EQ(scene.exit_code, 0) << scene.err;
    const json of_plan = json::parse(plan.out);
    json of_scene = json::parse(scene.out);
    EXPECT_EQ(of_plan["sound"], true);
    EXPECT_EQ(of_scene["sound"], true);
    EXPECT_EQ(of_scene["certificate"], "certified");
    EXPECT_TRUE(of_plan["certificate"].is_null());
    EXPECT_EQ(of_scene["code_counts"].value("D3", -1), 0) << "a plan has no scene to differ from";
    of_scene["code_counts"].erase("D3");
    EXPECT_EQ(of_plan["code_counts"], of_scene["code_counts"]);
    for (const char* code : {"T1", "T2", "T3", "T4", "T5", "T6", "T7", "G5", "G8", "D2"})
        EXPECT_EQ(of_plan["code_counts"].value(code, -1), 0) << code;
}

TEST_F(Pipeline, SaysThatAStrippedSceneIsUncertified) {
    ASSERT_EQ(run({"build", "office.json", "-o", "stripped.enf", "--strip"}).exit_code, 0);
    EXPECT_LT(std::filesystem::file_size(folder() / "stripped.enf"),
              std::filesystem::file_size(folder() / "office.enf"));
    const Outcome outcome = run({"check", "stripped.enf", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["certificate"], "uncertified: no model group");
    EXPECT_TRUE(json::parse(outcome.out)["sound"].is_null());
}

TEST_F(Pipeline, NamesTheFirstDifferenceOfTwoScenes) {
    ASSERT_EQ(run({"generate", "--rooms", "12", "--storeys", "2", "--seed", "2", "-o", "other.json"}).exit_code, 0);
    ASSERT_EQ(run({"build", "other.json", "-o", "other.enf"}).exit_code, 0);
    const accel::Scene office = accel::open(folder() / "office.enf");
    const accel::Scene other = accel::open(folder() / "other.enf");
    EXPECT_FALSE(modeler::first_difference(office, office).has_value());
    EXPECT_TRUE(modeler::first_difference(office, other).has_value());
    EXPECT_EQ(modeler::certify(office).verdict, "certified");
}

TEST_F(Pipeline, BuildsTheStoreysAskedFor) {
    const Outcome outcome = run({"build", "office.json", "-o", "upper.enf", "--storeys", "1", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["scene"]["storeys"], 1);
    const Outcome wrong = run({"build", "office.json", "-o", "wrong.enf", "--storeys", "0,7"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_NE(wrong.err.find("--storeys 7"), std::string::npos) << wrong.err;
    EXPECT_FALSE(std::filesystem::exists(folder() / "wrong.enf"));
}

TEST_F(Pipeline, CutsRoomsAsAskedAndSaysHow) {
    ASSERT_EQ(run({"generate", "--rooms", "12", "--curved", "0.5", "-o", "curved.json"}).exit_code, 0);
    for (const char* method : {"sah", "hertel-mehlhorn", "diagonals"}) {
        const Outcome built = run({"build", "curved.json", "-o", "cut.enf", "--convexify", method});
        ASSERT_EQ(built.exit_code, 0) << built.err;
        const auto certificate = accel::certificate(accel::open(folder() / "cut.enf"));
        ASSERT_TRUE(certificate.has_value());
        EXPECT_EQ(json::parse(certificate->options)["convexify"], method);
        const Outcome checked = run({"check", "cut.enf", "--json"});
        EXPECT_EQ(checked.exit_code, 0) << method << checked.out;
        EXPECT_EQ(json::parse(checked.out)["certificate"], "certified") << method;
    }
}

TEST_F(Pipeline, InfoCountsTheRoomsOfThePlan) {
    const Outcome outcome = run({"info", "office.enf", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json info = json::parse(outcome.out);
    EXPECT_EQ(info["counts"]["rooms"], 12);
    EXPECT_EQ(info["rooms"].size(), 12u);
    EXPECT_EQ(info["counts"]["storeys"], 2);
    EXPECT_EQ(info["graph"]["components"], 1);
    EXPECT_EQ(info["graph"]["nodes"], info["counts"]["cells"]);
    std::size_t cells = 0;
    for (const auto& [label, count] : info["cells_by_label"].items()) cells += count.get<std::size_t>();
    EXPECT_EQ(cells, info["counts"]["cells"].get<std::size_t>());
    const Outcome text = run({"info", "office.enf"});
    for (const json& room : info["rooms"])
        EXPECT_NE(text.out.find(room["name"].get<std::string>()), std::string::npos) << room;
}

/// The width and height in the header of a PNG.
std::pair<unsigned, unsigned> png_size(const std::string& png) {
    const auto number = [&png](std::size_t at) {
        unsigned value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png.at(at + i));
        return value;
    };
    return {number(16), number(20)};
}

TEST_F(Pipeline, RendersPicturesOfTheAskedSize) {
    const std::vector<std::vector<std::string>> views = {
        {"--camera", "exterior"}, {"--camera", "dollhouse"}, {"--camera", "dollhouse:1"}};
    for (const std::vector<std::string>& view : views) {
        std::vector<std::string> words = {"render", "office.enf", "-o", "view.png", "--size", "96x64"};
        words.insert(words.end(), view.begin(), view.end());
        const Outcome outcome = run(words);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(png_size(read_bytes(folder() / "view.png")), std::pair(96u, 64u)) << view.back();
    }
}

TEST_F(Pipeline, LooksIntoARoomByName) {
    const json info = json::parse(run({"info", "office.enf", "--json"}).out);
    const std::string name = info["rooms"][0]["name"];
    const Outcome outcome = run({"render", "office.enf", "-o", "room.exr", "--room", name, "--size", "64x64"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read_bytes(folder() / "room.exr").substr(0, 4), "\x76\x2f\x31\x01");
    const Outcome wrong = run({"render", "office.enf", "-o", "wrong.png", "--room", "No such room"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_NE(wrong.err.find("No such room"), std::string::npos) << wrong.err;
}

TEST_F(Pipeline, PictureDoesNotDependOnTheThreads) {
    for (const char* threads : {"1", "2"}) {
        const Outcome outcome = run({"render", "office.enf", "-o", std::string("threads-") + threads + ".png",
                                     "--camera", "dollhouse", "--size", "80x80", "--threads", threads});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    EXPECT_EQ(read_bytes(folder() / "threads-1.png"), read_bytes(folder() / "threads-2.png"));
}

}  // namespace
}  // namespace enfilade::test
