// Homes that people drew: how many of their rooms are found, and that cleaning them again changes nothing.

#include <gtest/gtest.h>

#include <filesystem>

#include "plans/layout.h"
#include "tests/plans/clean_support.h"

namespace enfilade::plans {
namespace {

struct Home {
    const char* file;
    std::size_t rooms;  ///< that its walls enclose once it is clean
    std::size_t open;   ///< named rooms that have no place of their own: balconies, and what nobody walled in
};

class CleanedHomes : public ::testing::TestWithParam<Home> {};

TEST_P(CleanedHomes, GetTheirRooms) {
    const auto file = std::filesystem::path(ENFILADE_SOURCE_DIR) / "../shared/data/sh3d" / GetParam().file;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not on this machine";
    const Plan plan = clean(read(file));
    EXPECT_EQ(write_json(clean(plan)), write_json(plan));
    const Layout layout = arrange(plan);
    std::size_t rooms = 0;
    for (const StoreyLayout& storey : layout.storeys) rooms += storey.rooms.size();
    EXPECT_EQ(rooms, GetParam().rooms);
    std::size_t open = 0;
    for (const Finding& finding : layout.findings) open += finding.code == "P310" || finding.code == "P311";
    EXPECT_EQ(open, GetParam().open);
}

INSTANTIATE_TEST_SUITE_P(Clean, CleanedHomes,
                         ::testing::Values(Home{"PaddyHuang_Home.sh3d", 13, 0},  // every door in a gap between walls
                                           Home{"andijcr_ristrutturazione_default.sh3d", 13, 0},
                                           Home{"jonwilliams84_Home-Clean-Base-RAL.sh3d", 21, 0},
                                           Home{"rtreffer_home_xml.sh3d", 11, 1},
                                           Home{"rtreffer_home-2012-2013_xml.sh3d", 6, 0},
                                           Home{"abesalomi_v1.sh3d", 8, 2}));

}  // namespace
}  // namespace enfilade::plans
