// `build --furnish`, and what the other commands make of what stands there.

#include <fstream>

#include "accel/scene_file.h"
#include "render/image_file.h"
#include "tests/cli/program.h"
#include "tools/output_file.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

const std::string townhouse = ENFILADE_SOURCE_DIR "/plans/examples/townhouse.json";

class FurnishedOffice : public OfficeTest {
protected:
    static void SetUpTestSuite() {
        OfficeTest::SetUpTestSuite();
        furnished_ = run({"build", "office.json", "-o", "full.enf", "--furnish", "--json"});
    }
    static json result(const std::string& output, std::vector<std::string> more) {
        std::vector<std::string> words = {"build", "office.json", "-o", output, "--furnish", "--json"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out, nullptr, false);
    }
    /// A room of the plan that rules furnish.
    static std::string some_room(std::size_t number) {
        return json::parse(furnished_.out).at("furniture").at("rooms").at(number).at("id");
    }
    static void picture(const std::string& scene, const std::string& output, std::vector<std::string> more) {
        std::vector<std::string> words = {"render", scene, "-o", output, "--size", "64x64"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    static inline Outcome furnished_;
};

TEST_F(FurnishedOffice, CountsWhatItPlaced) {
    ASSERT_EQ(furnished_.exit_code, 0) << furnished_.err;
    const json furniture = json::parse(furnished_.out).at("furniture");
    EXPECT_EQ(furniture.at("rules"), "own");
    EXPECT_EQ(furniture.at("cells"), "list");
    EXPECT_GT(furniture.at("by_rule"), 20);
    EXPECT_EQ(furniture.at("objects"), furniture.at("by_rule"));
    EXPECT_GE(furniture.at("requested"), furniture.at("by_rule"));
    EXPECT_GT(furniture.at("instanced_triangles"), furniture.at("triangles"));
    std::size_t placed = 0;
    for (const json& room : furniture.at("rooms")) placed += room.at("placed").get<std::size_t>();
    EXPECT_EQ(placed, furniture.at("by_rule"));
    const accel::Scene scene = accel::open(folder() / "full.enf");
    EXPECT_EQ(scene.view().objects.size(), placed);
}

TEST_F(FurnishedOffice, IsTheSameForTheSameSeedAlone) {
    (void)result("again.enf", {});
    EXPECT_EQ(bytes_of(folder() / "again.enf"), bytes_of(folder() / "full.enf"));
    (void)result("other.enf", {"--seed", "2"});
    EXPECT_NE(bytes_of(folder() / "other.enf"), bytes_of(folder() / "full.enf"));
}

TEST_F(FurnishedOffice, StaysBareWithoutTheFlag) {
    EXPECT_EQ(accel::open(folder() / "office.enf").view().objects.size(), 0u);
    EXPECT_NE(bytes_of(folder() / "office.enf"), bytes_of(folder() / "full.enf"));
}

TEST_F(FurnishedOffice, PassesItsCheck) {
    const Outcome outcome = run({"check", "full.enf"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST_F(FurnishedOffice, MayHaveItsRoomsCut) {
    const json cut = result("cut.enf", {"--objects", "cut"});
    EXPECT_EQ(cut.at("furniture").at("cells"), "cut");
    EXPECT_GT(cut.at("furniture").at("volumes"), 10);
    EXPECT_EQ(cut.at("furniture").at("objects"), json::parse(furnished_.out).at("furniture").at("objects"));
    EXPECT_EQ(run({"check", "cut.enf", "-q"}).exit_code, 0);
}

TEST_F(FurnishedOffice, OfOneRoomGivesThePicturesOfTheFullScene) {
    const std::string plan = ENFILADE_SOURCE_DIR "/plans/examples/office-46.json", room = "s0-r9";
    const Outcome all = run({"build", plan, "-o", "all.enf", "--furnish", "--json"});
    const Outcome part = run({"build", plan, "-o", "part.enf", "--furnish", "--json", "--rooms", room});
    ASSERT_EQ(all.exit_code, 0) << all.err;
    ASSERT_EQ(part.exit_code, 0) << part.err;
    const json scoped = json::parse(part.out).at("furniture"), full = json::parse(all.out).at("furniture");
    const json scope = scoped.at("scope");
    EXPECT_LT(scope.at("cells"), scope.at("of_cells"));
    EXPECT_LT(scoped.at("objects").get<double>(), 0.6 * full.at("objects").get<double>());
    EXPECT_TRUE(full.at("scope").is_null());
    for (const char* shading : {"look", "lambert"}) {
        const std::vector<std::string> how = {"--room", room, "--shading", shading, "--mirror-floor"};
        std::vector<std::string> bare = how;
        bare.push_back("--no-objects");
        picture("all.enf", "all.exr", how);
        picture("part.enf", "part.exr", how);
        picture("part.enf", "bare.exr", bare);
        EXPECT_EQ(bytes_of(folder() / "all.exr"), bytes_of(folder() / "part.exr")) << shading;
        EXPECT_NE(bytes_of(folder() / "all.exr"), bytes_of(folder() / "bare.exr")) << shading;
    }
}

TEST_F(FurnishedOffice, OfViewsGivesTheirPictures) {
    ASSERT_EQ(run({"tour", "office.enf", "-o", "tour.json", "--views", "3", "--rooms", "2"}).exit_code, 0);
    const json scoped = result("viewed.enf", {"--views", "tour.json"});
    EXPECT_TRUE(scoped.at("furniture").at("scope").is_object());
    picture("full.enf", "full-%02d.exr", {"--views", "tour.json"});
    picture("viewed.enf", "viewed-%02d.exr", {"--views", "tour.json"});
    for (const char* number : {"00", "01", "02"}) {
        const std::string end = std::string(number) + ".exr";
        EXPECT_EQ(bytes_of(folder() / ("full-" + end)), bytes_of(folder() / ("viewed-" + end))) << number;
    }
}

TEST_F(FurnishedOffice, LitScopesAreNoSmaller) {
    const std::vector<std::string> rooms = {"--rooms", some_room(1)};
    std::vector<std::string> lit = rooms;
    lit.push_back("--lit");
    EXPECT_GE(result("lit.enf", lit).at("furniture").at("scope").at("cells"),
              result("dark.enf", rooms).at("furniture").at("scope").at("cells"));
}

TEST_F(FurnishedOffice, IsSeenTheSameByEitherTree) {
    const std::string room = some_room(0);
    picture("full.enf", "bvh.png", {"--room", room, "--object-accel", "bvh", "--shading", "lambert"});
    picture("full.enf", "plain.png", {"--room", room, "--object-accel", "plain", "--shading", "lambert"});
    const render::Image bvh = render::read_image(folder() / "bvh.png");
    const render::Image plain = render::read_image(folder() / "plain.png");
    std::size_t differing = 0;
    for (std::size_t i = 0; i < bvh.rgb.size(); ++i) differing += std::abs(bvh.rgb[i] - plain.rgb[i]) > 0.02f;
    EXPECT_LT(differing, bvh.rgb.size() / 200);
}

TEST_F(FurnishedOffice, IsListedByInfo) {
    const json info = json::parse(run({"info", "full.enf", "--json"}).out);
    EXPECT_EQ(info.at("furniture").at("objects"), json::parse(furnished_.out).at("furniture").at("objects"));
    EXPECT_TRUE(json::parse(run({"info", "office.enf", "--json"}).out).at("furniture").is_null());
    EXPECT_NE(run({"info", "full.enf"}).out.find("\nFurniture\n"), std::string::npos);
    ASSERT_EQ(run({"info", "full.enf", "--svg", "full.svg", "-q"}).exit_code, 0);
    ASSERT_EQ(run({"info", "office.enf", "--svg", "bare.svg", "-q"}).exit_code, 0);
    EXPECT_NE(bytes_of(folder() / "full.svg").find("class=\"object\""), std::string::npos);
    EXPECT_EQ(bytes_of(folder() / "bare.svg").find("class=\"object\""), std::string::npos);
}

TEST_F(FurnishedOffice, FinerPiecesHaveMoreTriangles) {
    EXPECT_GT(result("fine.enf", {"--detail", "2"}).at("furniture").at("triangles"),
              json::parse(furnished_.out).at("furniture").at("triangles"));
}

struct WrongFlags {
    std::vector<std::string> words;
    const char* says;
};

TEST_F(FurnishedOffice, WrongFlagsAreSaidAndNothingIsWritten) {
    tools::write_text(folder() / "bad-rules.json", "{\"rooms\": [}");
    const WrongFlags wrong[] = {
        {{"--lit"}, "--rooms or --views"},
        {{"--rooms", "Nowhere"}, "There is no room \"Nowhere\""},
        {{"--views", "missing.json"}, "missing.json"},
        {{"--furnish", "missing-rules.json"}, "missing-rules.json"},
        {{"--furnish", "bad-rules.json"}, "bad-rules.json"},
        {{"--catalogue", "missing.sh3f"}, "missing.sh3f"},
        {{"--objects", "boxes"}, "--objects"},
        {{"--detail", "0"}, "--detail"},
        {{"--object-triangles", "1"}, "--object-triangles"},
        {{"--seed", "red"}, "--seed"},
        {{"--seed", "-1"}, "\"-1\" is negative"},
    };
    for (const WrongFlags& flags : wrong) {
        std::vector<std::string> words = {"build", "office.json", "-o", "wrong.enf"};
        if (flags.words.front() != "--furnish") words.push_back("--furnish");
        words.insert(words.end(), flags.words.begin(), flags.words.end());
        const Outcome outcome = run(words);
        EXPECT_TRUE(outcome.exit_code == 2 || outcome.exit_code == 3) << flags.words.front() << outcome.err;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(flags.says), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder() / "wrong.enf")) << flags.words.front();
    }
}

TEST_F(FurnishedOffice, HasNoSeedWithoutRules) {
    const Outcome outcome = run({"build", "office.json", "-o", "bare.enf", "--seed", "3"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("--furnish"), std::string::npos) << outcome.err;
}

TEST_F(FurnishedOffice, RaysMeetWhatStandsThere) {
    const std::string room = some_room(0);
    picture("full.enf", "a.png", {"--room", room});
    const json with =
        json::parse(run({"render", "full.enf", "-o", "b.png", "--room", room, "--size", "16x16", "--json"}).out);
    EXPECT_GT(with.at("objects").at("count"), 20);
    const json without = json::parse(
        run({"render", "full.enf", "-o", "b.png", "--room", room, "--size", "16x16", "--json", "--no-objects"}).out);
    EXPECT_TRUE(without.at("objects").is_null());
}

}  // namespace
}  // namespace enfilade::test
