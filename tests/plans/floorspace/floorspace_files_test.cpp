// Floor plans that other people drew: every space with an outline becomes a room, every window an opening.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <map>

#include "plans/layout.h"
#include "plans/read.h"

namespace enfilade::plans {
namespace {

const std::filesystem::path folder = std::filesystem::path(ENFILADE_SOURCE_DIR) / ".." / "shared" / "data" / "other";

struct FloorCounts {
    const char* file;
    std::size_t storeys;
    std::size_t spaces;        ///< in the file
    std::size_t without_face;  ///< of them
    std::size_t courtyards;
    std::size_t windows;  ///< in the file, and placed
    std::size_t doors;
    double top;  ///< of the highest storey's rooms, metres
};
void PrintTo(const FloorCounts& counts, std::ostream* out) { *out << counts.file; }

class FloorFileOf : public ::testing::TestWithParam<FloorCounts> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    }
    static Plan plan() { return plans::read(folder / GetParam().file); }
};

TEST_P(FloorFileOf, OthersIsReadCompletely) {
    const FloorCounts& expected = GetParam();
    const Plan read = plan();
    EXPECT_EQ(read.storeys.size(), expected.storeys);
    std::map<std::string, std::size_t> rooms;
    std::map<OpeningKind, std::size_t> openings;
    for (const Storey& storey : read.storeys) {
        for (const Room& room : storey.rooms) ++rooms[room.kind == "courtyard" ? "courtyard" : "room"];
        for (const Opening& opening : storey.openings) ++openings[opening.kind];
    }
    EXPECT_EQ(rooms["room"], expected.spaces - expected.without_face);
    EXPECT_EQ(rooms["courtyard"], expected.courtyards);
    EXPECT_EQ(openings[OpeningKind::Window], expected.windows);
    EXPECT_EQ(openings[OpeningKind::Door], expected.doors);
    EXPECT_NEAR(read.storeys.back().elevation + read.storeys.back().height, expected.top, 1e-9);
    std::size_t without = 0;
    for (const Finding& finding : read.findings)
        if (finding.code == "P759") without += finding.elements.size();
    EXPECT_EQ(without, expected.without_face);
    EXPECT_FALSE(has_errors(read.findings));
}

TEST_P(FloorFileOf, OthersHasARoomForEachSpaceBetweenItsWalls) {
    const FloorCounts& expected = GetParam();
    const Plan cleaned = clean(plan());
    EXPECT_FALSE(has_errors(cleaned.findings));
    const Layout layout = arrange(cleaned);
    std::size_t named = 0;
    std::size_t unnamed = 0;
    for (std::size_t s = 0; s < layout.storeys.size(); ++s)
        for (const FoundRoom& room : layout.storeys[s].rooms) ++(room.polygon ? named : unnamed);
    EXPECT_EQ(named, expected.spaces - expected.without_face);  // courtyards are outdoors
    EXPECT_EQ(unnamed, 0u);
    EXPECT_FALSE(has_errors(layout.findings));
}

TEST_P(FloorFileOf, OthersSurvivesOurOwnJson) {
    const std::string json = write_json(plan());
    EXPECT_EQ(write_json(read_json(json, "plan.json")), json);
}

INSTANTIATE_TEST_SUITE_P(
    Files, FloorFileOf,
    ::testing::Values(FloorCounts{"floorspace_largePlan.json", 4, 641, 38, 3, 63, 0, 74.4 * 0.3048},
                      FloorCounts{"floorspace_largeShatteredPlan.json", 3, 413, 13, 2, 42, 0, 59.7 * 0.3048},
                      FloorCounts{"floorspace_smallPlan.json", 1, 1, 0, 0, 0, 0, 8 * 0.3048},
                      FloorCounts{"floorspace_bunch-of-stuff.json", 1, 3, 0, 0, 3, 2, 8 * 0.3048},
                      FloorCounts{"floorspace_testing-floorplan-stock-photo.json", 1, 3, 0, 0, 6, 2, 8 * 0.3048},
                      FloorCounts{"floorspace_test-floorplan-down.json", 1, 2, 0, 0, 0, 0, 8 * 0.3048},
                      FloorCounts{"floorspace_test-floorplan-sides.json", 1, 3, 0, 0, 0, 0, 8 * 0.3048},
                      FloorCounts{"floorspace_floorplan-2017-08-31.json", 1, 1, 0, 0, 0, 0, 2.5},
                      FloorCounts{"floorspace_import-floorplan-test.json", 1, 1, 0, 0, 0, 0, 2.5}),
    [](const ::testing::TestParamInfo<FloorCounts>& test) {
        std::string name = std::filesystem::path(test.param.file).stem().string();
        for (char& c : name)
            if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
        return name;
    });

}  // namespace
}  // namespace enfilade::plans
