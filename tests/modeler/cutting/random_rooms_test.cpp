// Ten thousand random rooms of every family, cut by every cutter: each partition is judged exactly.
// ENFILADE_ROOMS=100000 cuts more, ENFILADE_ROOMS_SERIES=1 others; ENFILADE_ROOM=file cuts one that failed.

#include "tests/support/random_rooms.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "modeler/cutting/sah_partition.h"
#include "tests/modeler/cutting/cut_rooms.h"
#include "tests/support/room_text.h"

namespace enfilade::modeler {
namespace {

using testing::Room;
using testing::RoomFamily;

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* const text = std::getenv(variable);
    return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

class RandomRooms : public ::testing::TestWithParam<RoomFamily> {};

TEST_P(RandomRooms, AreCutExactly) {
    const std::uint64_t families = testing::room_families().size(), series = number_from("ENFILADE_ROOMS_SERIES", 0);
    const std::uint64_t count = (number_from("ENFILADE_ROOMS", 10000) + families - 1) / families;
    std::vector<Tally> tallies(cutters().size());
    for (std::uint64_t seed = series << 32; seed < (series << 32) + count; ++seed) {
        const std::string name = std::string(GetParam().name) + " " + std::to_string(seed);
        cut_in_every_way(random_room(GetParam(), seed), name, tallies);
        if (HasFatalFailure()) return;
    }
    for (std::size_t c = 0; c < cutters().size(); ++c)
        if (tallies[c].rooms > 0) tallies[c].print(GetParam().name, cutters()[c].name);
}

bool alike(const PolygonSide& a, const PolygonSide& b) {
    return a.from == b.from && a.to == b.to && a.line == b.line && a.tag == b.tag && a.look == b.look &&
           a.faces == b.faces;
}

TEST_P(RandomRooms, AreCutAlikeAgain) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Room room = random_room(GetParam(), seed);
        for (const Cutter& cutter : cutters()) {
            if (cutter.discs) continue;
            const Partition once = cutter.cut(room), again = cutter.cut(room);
            EXPECT_TRUE(std::equal(once.sides.begin(), once.sides.end(), again.sides.begin(), again.sides.end(), alike))
                << GetParam().name << " " << seed << ", " << cutter.name;
            EXPECT_EQ(once.first_side, again.first_side);
            EXPECT_EQ(once.new_points, again.new_points);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, RandomRooms,
                         ::testing::ValuesIn(testing::room_families().begin(), testing::room_families().end()),
                         [](const auto& family) { return std::string(family.param.name); });

void cut_from_file(const std::filesystem::path& file) {
    std::ifstream in(file);
    const Room room = testing::read_room(in);
    ASSERT_GE(room.sides.size(), 3u) << file;
    std::vector<Tally> tallies(cutters().size());
    cut_in_every_way(room, file.stem().string(), tallies);
}

/// Rooms on which a cutter once failed, as small as they could be made (tests/modeler/cutting/rooms).
TEST(KeptRooms, AreCutExactly) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(ENFILADE_SOURCE_DIR "/tests/modeler/cutting/rooms")) {
        cut_from_file(entry.path());
        ++count;
    }
    EXPECT_GE(count, 21u);
}

TEST(KeptRooms, TheOneAskedForIsCutExactly) {
    const char* const file = std::getenv("ENFILADE_ROOM");
    if (!file) GTEST_SKIP() << "no room to cut again (ENFILADE_ROOM=file)";
    cut_from_file(file);
}

class LargeRooms : public ::testing::TestWithParam<testing::LargeRoom> {};

/// Ten thousand corners in a time that a user waits for: processor time, with room for sanitizers; the time itself is
/// printed.
TEST_P(LargeRooms, AreCutExactlyAndSoon) {
    const Room room = testing::large_room(GetParam(), 10000, 1);
    const std::clock_t start = std::clock();
    const Partition partition = sah_partition(room.points, room.sides, PartitionGoal::Convex, {});
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    const testing::PartitionVerdict verdict =
        testing::judge_partition(room.points, room.sides, partition, {PartitionGoal::Convex, true});
    EXPECT_EQ(verdict.text(), "");
    EXPECT_LT(seconds, 20);
    std::cout << room.sides.size() << " sides, " << partition.piece_count() << " pieces in " << seconds << " s\n";
}

std::string name_of_kind(const ::testing::TestParamInfo<testing::LargeRoom>& kind) {
    constexpr const char* names[] = {"Comb", "Star", "Spiral", "Circle", "Columns", "CurvedCorridor"};
    return names[std::size_t(kind.param)];
}

INSTANTIATE_TEST_SUITE_P(All, LargeRooms,
                         ::testing::Values(testing::LargeRoom::Comb, testing::LargeRoom::Star,
                                           testing::LargeRoom::Spiral, testing::LargeRoom::Circle,
                                           testing::LargeRoom::Columns, testing::LargeRoom::CurvedCorridor),
                         name_of_kind);

}  // namespace
}  // namespace enfilade::modeler
