#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace enfilade::plans {
namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::set<std::string> codes_in(const std::string& text, const std::regex& pattern) {
    std::set<std::string> codes;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern); match != std::sregex_iterator(); ++match)
        codes.insert((*match)[1]);
    return codes;
}

TEST(Findings, AreAllInTheTableAndNoOthers) {
    const std::filesystem::path root = ENFILADE_SOURCE_DIR;
    std::set<std::string> used;
    for (const char* folder : {"plans", "modeler"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
            used.merge(codes_in(text_of(entry.path()), std::regex("\"([KP][0-9]{3})\"")));
        }
    const std::set<std::string> listed =
        codes_in(text_of(root / "docs" / "findings.md"), std::regex("\n\\| ([KP][0-9]{3}) \\|"));
    ASSERT_GT(used.size(), 60u);
    for (const std::string& code : used)
        EXPECT_TRUE(listed.contains(code)) << code << " lacks a row in docs/findings.md";
    for (const std::string& code : listed) EXPECT_TRUE(used.contains(code)) << code << " is not used in the sources";
}

}  // namespace
}  // namespace enfilade::plans
