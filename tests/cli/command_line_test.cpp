// Flags and help: what a newcomer meets first.

#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

class CommandLine : public testing::Test {
protected:
    Outcome run(std::vector<std::string> words) { return enfilade_in(folder_.path(), std::move(words)); }
    TemporaryFolder folder_;
};

TEST_F(CommandLine, ShowsHelpWhereNothingIsAsked) {
    const Outcome outcome = run({});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("enfilade build"), std::string::npos);
    EXPECT_EQ(outcome.out, "");
}

TEST_F(CommandLine, EveryCommandHasHelpWithAnExample) {
    for (const char* command : {"import", "generate", "build", "check", "info", "render", "tour", "export", "bench"}) {
        const Outcome outcome = run({command, "--help"});
        EXPECT_EQ(outcome.exit_code, 0) << command;
        EXPECT_NE(outcome.out.find("Example:\n  enfilade " + std::string(command)), std::string::npos) << outcome.out;
        EXPECT_EQ(outcome.err, "") << command;
    }
}

TEST_F(CommandLine, SaysItsVersion) {
    const Outcome outcome = run({"--version"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.out.starts_with("enfilade 0.")) << outcome.out;
}

TEST_F(CommandLine, NamesTheNearestCommand) {
    const Outcome outcome = run({"biuld", "house.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("\"biuld\" (did you mean \"build\"?)"), std::string::npos) << outcome.err;
}

TEST_F(CommandLine, NamesTheNearestFlag) {
    const Outcome outcome = run({"build", "house.json", "-o", "house.enf", "--sagita-mm", "3"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("did you mean \"--sagitta-mm\"?"), std::string::npos) << outcome.err;
}

TEST_F(CommandLine, NamesTheWaysToCut) {
    const Outcome outcome = run({"check", "plan.json", "--convexify", "diagonal"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("(did you mean \"diagonals\"?): choose sah, hertel-mehlhorn or diagonals."),
              std::string::npos)
        << outcome.err;
}

TEST_F(CommandLine, RefusesMissingAndWrongValues) {
    const std::vector<std::vector<std::string>> wrong = {
        {"build"},
        {"build", "plan.json"},
        {"build", "plan.json", "-o"},
        {"build", "plan.json", "-o", "a.enf", "--snap-mm", "-1"},
        {"build", "plan.json", "-o", "a.enf", "--storeys", "ground"},
        {"build", "plan.json", "-o", "a.enf", "--glass", "wooden"},
        {"build", "plan.json", "-o", "a.enf", "--convexify", "triangles"},
        {"build", "plan.json", "-o", "a.enf", "--report", "report.pdf"},
        {"generate", "-o", "a.json"},
        {"generate", "--rooms", "many", "-o", "a.json"},
        {"generate", "--rooms", "0", "-o", "a.json"},
        {"generate", "--rooms", "3", "--storeys", "9", "-o", "a.json"},
        {"generate", "--rooms", "5", "--curved", "2", "-o", "a.json"},
        {"render", "a.enf", "-o", "a.png", "--tracer", "magic"},
        {"render", "a.enf", "-o", "a.png", "--room", "Kitchen", "--camera", "exterior"},
        {"bench", "everything"},
    };
    for (const std::vector<std::string>& words : wrong) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 2) << words[0] << ' ' << words.back() << ": " << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("enfilade: ")) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace enfilade::test
