// Files are there whole or not at all.

#include "tools/output_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::tools {
namespace {

TEST(OutputFile, IsNotThereBeforeItIsCommitted) {
    const test::TemporaryFolder folder;
    {
        OutputFile file(folder / "a.txt");
        test::write_bytes(file.temporary(), "half");
        EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(OutputFile, KeepsTheOldOneUntilTheNewOneIsWhole) {
    const test::TemporaryFolder folder;
    write_text(folder / "a.txt", "old");
    {
        OutputFile file(folder / "a.txt");
        test::write_bytes(file.temporary(), "half");
    }
    EXPECT_EQ(test::read_bytes(folder / "a.txt"), "old");
    write_text(folder / "a.txt", "new");
    EXPECT_EQ(test::read_bytes(folder / "a.txt"), "new");
}

TEST(OutputFile, WritesThroughLinks) {
    const test::TemporaryFolder folder;
    write_text(folder / "real.txt", "old");
    std::filesystem::create_symlink(folder / "real.txt", folder / "link.txt");
    write_text(folder / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(test::read_bytes(folder / "real.txt"), "new");
}

TEST(OutputFile, RefusesFoldersDevicesAndMissingFolders) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_text(folder.path(), ""), IoError);
    EXPECT_THROW(write_text(folder / "none/a.txt", ""), IoError);
    EXPECT_THROW(write_text("/dev/null", ""), IoError);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace enfilade::tools
