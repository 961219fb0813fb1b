// What is wrong is said in one sentence with its place, and leaves no file behind.

#include <cstdlib>

#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

class BrokenInput : public OfficeTest {
protected:
    /// Asks for exit code `code`, a single line on stderr that holds `part`, and no output file.
    static void expect_refused(std::vector<std::string> words, int code, const std::string& part) {
        const std::filesystem::path output = folder() / "refused.out.enf";
        words.insert(words.end(), {"-o", output.string()});
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, code) << outcome.err;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("enfilade: ")) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(output));
    }
};

TEST_F(BrokenInput, NamesAFileThatIsNotThere) {
    expect_refused({"build", "absent.json"}, 3, "absent.json");
    const Outcome scene = run({"info", "absent.enf"});
    EXPECT_EQ(scene.exit_code, 3);
    EXPECT_NE(scene.err.find("absent.enf"), std::string::npos) << scene.err;
}

TEST_F(BrokenInput, GivesLineAndColumnInJson) {
    write_bytes(folder() / "comma.json", "{\n  \"name\": \"house\"\n  \"storeys\": []\n}\n");
    expect_refused({"build", "comma.json"}, 2, "comma.json:3:3");
}

TEST_F(BrokenInput, RefusesUnknownKeys) {
    std::string plan = read_bytes(folder() / "office.json");
    plan.insert(plan.find('{') + 1, "\"colour_of_the_cat\": 1,");
    write_bytes(folder() / "key.json", plan);
    expect_refused({"build", "key.json"}, 2, "colour_of_the_cat");
}

TEST_F(BrokenInput, RefusesWhatIsNoPlan) {
    write_bytes(folder() / "noise.sh3d", std::string("PK\3\4 and then nothing of use"));
    expect_refused({"build", "noise.sh3d"}, 2, "noise.sh3d");
    write_bytes(folder() / "empty.json", "");
    expect_refused({"build", "empty.json"}, 2, "empty.json");
    write_bytes(folder() / "picture.png", "\x89PNG\r\n\x1a\n");
    expect_refused({"build", "picture.png"}, 2, "picture.png");
}

TEST_F(BrokenInput, RefusesAShortenedScene) {
    const std::string scene = read_bytes(folder() / "office.enf");
    for (const std::size_t size :
         {std::size_t(0), std::size_t(7), std::size_t(200), scene.size() / 2, scene.size() - 1}) {
        write_bytes(folder() / "short.enf", scene.substr(0, size));
        const Outcome outcome = run({"info", "short.enf"});
        EXPECT_EQ(outcome.exit_code, 2) << size << ": " << outcome.err;
        EXPECT_NE(outcome.err.find("short.enf"), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

TEST_F(BrokenInput, CheckFindsEveryChangedByte) {
    std::string scene = read_bytes(folder() / "office.enf");
    for (std::size_t k = 1; k <= 16; ++k) {
        const std::size_t at = scene.size() * k / 17;
        if (scene[at] == 0) continue;  // may be filling between arrays, which nothing reads
        const char before = scene[at];
        scene[at] = char(before ^ 4);
        write_bytes(folder() / "changed.enf", scene);
        scene[at] = before;
        const Outcome outcome = run({"check", "changed.enf"});
        EXPECT_TRUE(outcome.exit_code == 1 || outcome.exit_code == 2)
            << "byte " << at << ": " << outcome.exit_code << outcome.err;
    }
}

TEST_F(BrokenInput, SaysWhereItCannotWrite) {
    for (const std::string output : {"no/such/folder/a.enf", "/dev/null", "."}) {
        const Outcome outcome = run({"build", "office.json", "-o", output});
        EXPECT_EQ(outcome.exit_code, 3) << output << ": " << outcome.err;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    }
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(BrokenInput, RefusesPicturesAndExportsOfUnknownKind) {
    EXPECT_EQ(run({"render", "office.enf", "-o", "a.gif"}).exit_code, 2);
    EXPECT_EQ(run({"export", "office.enf", "-o", "a.ifc"}).exit_code, 2);
    for (const char* size : {"0x10", "10", "axb", "10x10x10", "99999999x2"})
        EXPECT_EQ(run({"render", "office.enf", "-o", "a.png", "--size", size}).exit_code, 2) << size;
    for (const char* camera : {"somewhere", "1,2,3", "1,2,3:1,2,3", "dollhouse:9", "1,2:3,4", "nan,0,0:1,1,1"})
        EXPECT_EQ(run({"render", "office.enf", "-o", "a.png", "--camera", camera}).exit_code, 2) << camera;
    EXPECT_FALSE(std::filesystem::exists(folder() / "a.png"));
}

/// The developers' files of other people: what cannot be read is refused with a sentence, never a crash.
TEST_F(BrokenInput, RefusesTheNegativeHomes) {
    const std::filesystem::path shared = std::filesystem::path(ENFILADE_SOURCE_DIR) / "../shared/data/sh3d/negative";
    if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not on this machine";
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shared)) {
        expect_refused({"build", entry.path().string()}, 2, entry.path().filename().string());
        ++files;
    }
    EXPECT_GE(files, 3u);
}

}  // namespace
}  // namespace enfilade::test
