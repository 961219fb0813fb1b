// Plans with faults: what is said, what is written, and how the program ends.

#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class Defects : public OfficeTest {
protected:
    /// The office with one opening beyond its wall (an error) or wider than it (a warning).
    static void write_plan(const std::string& name, const char* key, double value) {
        json plan = json::parse(read_bytes(folder() / "office.json"));
        plan["storeys"][0]["openings"][0][key] = value;
        write_bytes(folder() / name, plan.dump());
    }
};

TEST_F(Defects, WritesNothingWhereTheModelHasErrors) {
    write_plan("error.json", "offset", 1000);
    const Outcome outcome = run({"build", "error.json", "-o", "error.enf", "--report", "error.txt"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_FALSE(std::filesystem::exists(folder() / "error.enf"));
    EXPECT_NE(outcome.out.find("Errors:"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find("--keep-going"), std::string::npos) << outcome.err;
    EXPECT_NE(read_bytes(folder() / "error.txt").find("not sound, 1 error"), std::string::npos);
}

TEST_F(Defects, KeepsGoingWhereToldTo) {
    write_plan("keep.json", "offset", 1000);
    const Outcome outcome = run({"build", "keep.json", "-o", "keep.enf", "--keep-going"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(std::filesystem::exists(folder() / "keep.enf"));
    EXPECT_EQ(outcome.err, "");
}

TEST_F(Defects, KeepsTheOldSceneWhereTheNewOneHasErrors) {
    ASSERT_EQ(run({"build", "office.json", "-o", "kept.enf"}).exit_code, 0);
    const std::string before = read_bytes(folder() / "kept.enf");
    write_plan("worse.json", "offset", 1000);
    EXPECT_EQ(run({"build", "worse.json", "-o", "kept.enf"}).exit_code, 1);
    EXPECT_EQ(read_bytes(folder() / "kept.enf"), before);
}

TEST_F(Defects, WarningsEndWithZeroUnlessStrict) {
    write_plan("warning.json", "width", 500);
    for (const char* command : {"build", "check", "import"}) {
        std::vector<std::string> words = {command, "warning.json"};
        if (std::string(command) != "check") words.insert(words.end(), {"-o", std::string("warning.") + command});
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
        EXPECT_NE(outcome.out.find(" warning"), std::string::npos) << command << outcome.out;
        words.emplace_back("--strict");
        EXPECT_EQ(run(words).exit_code, 1) << command;
    }
}

TEST_F(Defects, FindingsNameTheElementAndItsPlace) {
    write_plan("place.json", "offset", 1000);
    const Outcome outcome = run({"check", "place.json", "--json"});
    EXPECT_EQ(outcome.exit_code, 1);
    const json report = json::parse(outcome.out);
    EXPECT_EQ(report["sound"], false);
    json finding;
    for (const json& one : report["findings"])  // without its door the room has no way out, which is a warning
        if (one["severity"] == "error") finding = one;
    ASSERT_FALSE(finding.is_null());
    const json plan = json::parse(read_bytes(folder() / "place.json"));
    EXPECT_EQ(finding["elements"][0]["id"], plan["storeys"][0]["openings"][0]["id"]);
    EXPECT_EQ(finding["point"].size(), 3u);
    EXPECT_NE(finding["hint"], "");
}

}  // namespace
}  // namespace enfilade::test
