// `place`: one object at a time.

#include <algorithm>
#include <fstream>

#include "accel/scene_file.h"
#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class Place : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        for (const char* kind : {"list", "cut"})
            built_ = run({"build", ENFILADE_SOURCE_DIR "/plans/examples/townhouse.json", "-o",
                          std::string(kind) + ".enf", "-q", "--furnish", "--objects", kind});
        ASSERT_EQ(built_.exit_code, 0) << built_.err;
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static Outcome run(std::vector<std::string> words) { return enfilade_in(folder_->path(), std::move(words)); }
    static std::filesystem::path file(const std::string& name) { return *folder_ / name; }
    static json objects(const std::string& scene) {
        return json::parse(run({"place", scene, "--json"}).out).at("objects");
    }
    static json object(const std::string& scene, const std::string& id) {
        for (const json& one : objects(scene))
            if (one.at("id") == id) return one;
        return nullptr;
    }
    /// A low piece on a floor that carries nothing.
    static json free_piece(const std::string& scene) {
        const json all = objects(scene);
        for (const json& one : all)
            if (one.at("stands_on").is_null() && one.at("size")[2] < 1.2 && is_floor(one.at("position")[2]) &&
                std::ranges::none_of(all, [&](const json& other) { return other.at("stands_on") == one.at("id"); }))
                return one;
        return nullptr;
    }
    static bool is_floor(double z) { return std::abs(z) < 1e-3 || std::abs(z - 2.9) < 1e-3; }
    static std::string numbers(double x, double y) { return std::to_string(x) + "," + std::to_string(y); }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline Outcome built_;
};

TEST_F(Place, ListsWhatStandsThere) {
    const json all = objects("list.enf");
    ASSERT_GT(all.size(), 20u);
    const Outcome text = run({"place", "list.enf"});
    EXPECT_EQ(line_count(text.out), all.size());
    for (const json& one : all) EXPECT_NE(text.out.find(one.at("id").get<std::string>()), std::string::npos);
}

TEST_F(Place, TellsAnglesWithinHalfATurn) {
    std::size_t turned = 0;
    for (const json& one : objects("list.enf")) {
        const double angle = one.at("angle_deg");
        EXPECT_GT(angle, -180) << one;
        EXPECT_LE(angle, 180) << one;
        turned += angle != 0;
    }
    EXPECT_GT(turned, 5u);
    EXPECT_EQ(run({"place", "list.enf"}).out.find("-0.0 deg"), std::string::npos);
}

TEST_F(Place, RefusesThePlaceThatWasAskedForNotThatOfALoad) {
    std::string carrier;
    for (const json& one : objects("list.enf"))
        if (one.at("stands_on").is_string()) carrier = one.at("stands_on");
    ASSERT_FALSE(carrier.empty());
    const Outcome outcome = run({"place", "list.enf", "--move", carrier, "--at", "500,700,0", "-o", "far.enf"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("(500, 700, 0)"), std::string::npos) << outcome.err;
}

TEST_F(Place, TouchesNothingButTheListsOfWholeRooms) {
    const json piece = free_piece("list.enf");
    const std::string id = piece.at("id");
    const Outcome outcome =
        run({"place", "list.enf", "--turn", id, "--angle", "180", "-o", "turned.enf", "--keep-going"});
    ASSERT_LE(outcome.exit_code, 1) << outcome.err;
    const accel::Scene before = accel::open(file("list.enf")), after = accel::open(file("turned.enf"));
    ASSERT_EQ(before.arrays().size(), after.arrays().size());
    std::size_t changed = 0;
    for (std::size_t k = 0; k < before.arrays().size(); ++k) {
        const accel::SceneArray &a = before.arrays()[k], &b = after.arrays()[k];
        if (std::ranges::equal(a.bytes, b.bytes)) continue;
        ++changed;
        const std::string name(a.name);
        EXPECT_TRUE(name.find("object") != std::string::npos || name.find("cert") != std::string::npos) << name;
    }
    EXPECT_GT(changed, 0u);
    const double angle = object("turned.enf", id).at("angle_deg");
    EXPECT_NEAR(std::remainder(angle - piece.at("angle_deg").get<double>() - 180, 360), 0, 1e-6);
}

TEST_F(Place, MovesThereAndBack) {
    for (const char* kind : {"list.enf", "cut.enf"}) {
        const json piece = free_piece(kind);
        const std::string id = piece.at("id");
        const double x = piece.at("position")[0], y = piece.at("position")[1];
        std::filesystem::copy_file(file(kind), file("moving.enf"), std::filesystem::copy_options::overwrite_existing);
        const Outcome there = run({"place", "moving.enf", "--move", id, "--at", numbers(x + 0.01, y), "--keep-going"});
        ASSERT_LE(there.exit_code, 1) << there.err;
        EXPECT_NEAR(object("moving.enf", id).at("position")[0].get<double>(), x + 0.01, 1e-6) << kind;
        const Outcome back = run({"place", "moving.enf", "--move", id, "--at", numbers(x, y), "--keep-going"});
        ASSERT_LE(back.exit_code, 1) << back.err;
        EXPECT_NEAR(object("moving.enf", id).at("position")[0].get<double>(), x, 1e-6) << kind;
        EXPECT_EQ(objects("moving.enf").size(), objects(kind).size());
    }
}

TEST_F(Place, AddsAndRemoves) {
    const json piece = free_piece("list.enf");
    const double x = piece.at("position")[0], y = piece.at("position")[1], z = piece.at("position")[2];
    const std::string id = piece.at("id");
    ASSERT_EQ(run({"place", "list.enf", "--remove", id, "-o", "less.enf"}).exit_code, 0);
    EXPECT_TRUE(object("less.enf", id).is_null());
    const Outcome added =
        run({"place", "less.enf", "--add", piece.at("model"), "--at", numbers(x, y) + "," + std::to_string(z),
             "--angle", std::to_string(piece.at("angle_deg").get<double>()), "--id", "ficus", "-o", "more.enf"});
    ASSERT_EQ(added.exit_code, 0) << added.out << added.err;
    EXPECT_FALSE(object("more.enf", "ficus").is_null());
    EXPECT_EQ(objects("more.enf").size(), objects("list.enf").size());
    EXPECT_EQ(run({"check", "more.enf", "-q"}).exit_code, 0);
}

TEST_F(Place, WritesNothingWhereTheResultIsUnsound) {
    const json piece = free_piece("list.enf");
    const double x = piece.at("position")[0], y = piece.at("position")[1], z = piece.at("position")[2];
    const std::string at = numbers(x, y) + "," + std::to_string(z);
    const Outcome outcome = run({"place", "list.enf", "--add", "plant", "--at", at, "-o", "clash.enf"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE((outcome.out + outcome.err).find("S6"), std::string::npos) << outcome.out << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(file("clash.enf")));
    EXPECT_EQ(
        run({"place", "list.enf", "--add", "plant", "--at", at, "-o", "clash.enf", "--keep-going", "-q"}).exit_code, 1);
    EXPECT_TRUE(std::filesystem::exists(file("clash.enf")));
}

TEST_F(Place, SaysWhatIsWrong) {
    ASSERT_EQ(
        run({"build", ENFILADE_SOURCE_DIR "/plans/examples/curved-room.json", "-o", "stripped.enf", "-q", "--strip"})
            .exit_code,
        0);
    const std::string id = free_piece("list.enf").at("id");
    struct Case {
        std::vector<std::string> words;
        const char* says;
    };
    const Case cases[] = {
        {{"stripped.enf"}, "--strip"},
        {{"list.enf", "--move", id}, "--at"},
        {{"list.enf", "--move", id, "--at", "here"}, "no place"},
        {{"list.enf", "--move", id, "--at", "1"}, "no place"},
        {{"list.enf", "--move", id, "--at", "1,2,3,4"}, "no place"},
        {{"list.enf", "--turn", id}, "--angle"},
        {{"list.enf", "--add", "chair"}, "--at"},
        {{"list.enf", "--add", "chiar", "--at", "1,1"}, "chair"},
        {{"list.enf", "--at", "1,1"}, "--move"},
        {{"list.enf", "--angle", "1"}, "--turn"},
        {{"list.enf", "--id", "a"}, "--add"},
        {{"list.enf", "-o", "same.enf"}, "Nothing changes"},
        {{"list.enf", "--remove", id + "x"}, "place SCENE.enf"},
        {{"list.enf", "--move", id, "--at", "1e6,1e6"}, "choose a place"},
        {{"list.enf", "--add", "chair", "--at", "1,1", "--id", id}, "taken"},
        {{"list.enf", "--remove", id, "--turn", id}, "excludes"},
    };
    for (const Case& one : cases) {
        std::vector<std::string> words = {"place"};
        words.insert(words.end(), one.words.begin(), one.words.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 2) << one.says << outcome.out;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(one.says), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(std::filesystem::exists(file("same.enf")));
}

}  // namespace
}  // namespace enfilade::test
