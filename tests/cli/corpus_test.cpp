// Every input that fuzzing kept, whole and cut off, as a user would give it to the program: read or refused in one
// sentence, in bounded time, with nothing half-written.

#include <algorithm>
#include <chrono>

#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

class Corpus : public OfficeTest {
protected:
    /// Asks that `file` ends `words` in one of the ways that a plan may end.
    static void expect_orderly(std::vector<std::string> words, const std::filesystem::path& output) {
        std::filesystem::remove(output);
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome = run(words);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_LT(seconds.count(), 20);
        EXPECT_TRUE(outcome.exit_code >= 0 && outcome.exit_code <= 2) << outcome.exit_code << ": " << outcome.err;
        if (outcome.exit_code != 2) return;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(output));
    }

    static std::vector<std::filesystem::path> files_below(const std::string& folder_name) {
        std::vector<std::filesystem::path> files;
        const std::filesystem::path root = std::filesystem::path(ENFILADE_SOURCE_DIR) / folder_name;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
            if (entry.is_regular_file()) files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        return files;
    }
};

TEST_F(Corpus, EveryKeptInputIsReadOrRefused) {
    const std::vector<std::filesystem::path> files = files_below("tests/fuzz/corpus");
    ASSERT_GT(files.size(), 6u);
    for (const std::filesystem::path& file : files) {
        SCOPED_TRACE(file.string());
        const std::filesystem::path output = folder() / "corpus.out.json";
        expect_orderly({"import", file.string(), "-o", output.string()}, output);
        expect_orderly({"check", file.string(), "--report", output.string()}, output);
    }
}

TEST_F(Corpus, EveryKeptInputCutOffIsReadOrRefused) {
    for (const std::filesystem::path& file : files_below("tests/fuzz/corpus")) {
        const std::string bytes = read_bytes(file);
        for (const std::size_t size : {bytes.size() / 3, bytes.size() - std::min<std::size_t>(bytes.size(), 5)}) {
            SCOPED_TRACE(file.string() + " up to byte " + std::to_string(size));
            const std::filesystem::path cut = folder() / ("cut" + file.extension().string());
            const std::filesystem::path output = folder() / "corpus.out.json";
            write_bytes(cut, bytes.substr(0, size));
            expect_orderly({"import", cut.string(), "-o", output.string()}, output);
        }
    }
}

}  // namespace
}  // namespace enfilade::test
