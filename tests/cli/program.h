#pragma once
// The program under test, and a small building of its own making to try it on.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::test {

/// Runs `enfilade WORDS...` in `folder`.
[[nodiscard]] inline Outcome enfilade_in(const std::filesystem::path& folder, std::vector<std::string> words) {
    words.insert(words.begin(), ENFILADE_PROGRAM);
    return run_program(words, folder);
}

/// How many line ends a text has: what is said in one sentence has one.
[[nodiscard]] inline std::size_t line_count(const std::string& text) {
    return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

/// A folder with office.json, a plan of 12 rooms on two storeys, and office.enf, its scene: made once for a suite.
class OfficeTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        generated_ = run({"generate", "--rooms", "12", "--storeys", "2", "-o", "office.json"});
        built_ = run({"build", "office.json", "-o", "office.enf", "--report", "office.txt"});
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static Outcome run(std::vector<std::string> words) { return enfilade_in(folder_->path(), std::move(words)); }
    static const TemporaryFolder& folder() { return *folder_; }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline Outcome generated_;
    static inline Outcome built_;
};

}  // namespace enfilade::test
