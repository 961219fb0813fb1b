// Homes that other people drew: nothing of them is lost in reading.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "plans/outline.h"
#include "plans/read.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

const std::filesystem::path folder = std::filesystem::path(ENFILADE_SOURCE_DIR) / ".." / "shared" / "data" / "sh3d";

struct Counts {
    const char* file;
    std::size_t storeys;
    std::size_t walls;  ///< with those that close gaps
    std::size_t rooms;
    std::size_t openings;
    std::size_t stairs;
    std::size_t lights;
    std::size_t furniture;
    std::size_t closed_gaps;
    std::size_t turned_doors;
};

class RealHome : public ::testing::TestWithParam<Counts> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    }
};

std::size_t count(const Plan& plan, auto Storey::*list) {
    std::size_t sum = 0;
    for (const Storey& storey : plan.storeys) sum += (storey.*list).size();
    return sum;
}
std::size_t count_code(const Plan& plan, std::string_view code) {
    std::size_t sum = 0;
    for (const Finding& finding : plan.findings) sum += finding.code == code ? 1 : 0;
    return sum;
}

TEST_P(RealHome, IsReadCompletely) {
    const Counts& expected = GetParam();
    const Plan plan = read(folder / expected.file);
    EXPECT_EQ(plan.storeys.size(), expected.storeys);
    EXPECT_EQ(count(plan, &Storey::walls), expected.walls);
    EXPECT_EQ(count(plan, &Storey::rooms), expected.rooms);
    EXPECT_EQ(count(plan, &Storey::openings), expected.openings);
    EXPECT_EQ(count(plan, &Storey::stairs), expected.stairs);
    EXPECT_EQ(count(plan, &Storey::lights), expected.lights);
    EXPECT_EQ(count(plan, &Storey::furniture), expected.furniture);
    EXPECT_EQ(count_code(plan, "P174"), expected.closed_gaps);
    EXPECT_EQ(count_code(plan, "P173"), expected.turned_doors);
    EXPECT_FALSE(has_errors(plan.findings));
}

TEST_P(RealHome, SurvivesItsOwnJson) {
    const Plan plan = read(folder / GetParam().file);
    const std::string json = write_json(plan);
    EXPECT_EQ(write_json(read_json(json, "plan.json")), json);
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealHome,
    ::testing::Values(Counts{"FreeCAD_0-JoinWall.sh3d", 1, 39, 0, 0, 0, 0, 0, 0, 0},
                      Counts{"Gel0bmstu_flat.sh3d", 1, 22, 2, 4, 0, 0, 4, 0, 0},
                      Counts{"PaddyHuang_Home.sh3d", 1, 46, 13, 5, 0, 0, 0, 5, 0},
                      Counts{"SweetHome3D_junit_holes_xml.sh3d", 2, 8, 2, 1, 1, 0, 0, 0, 0},
                      Counts{"abesalomi_baseplan.sh3d", 1, 30, 2, 7, 0, 0, 7, 0, 0},
                      Counts{"abesalomi_plan-zero-length-wall_02c45d7.sh3d", 1, 28, 2, 7, 0, 0, 0, 0, 0},
                      Counts{"abesalomi_v1.sh3d", 1, 43, 8, 12, 0, 0, 12, 0, 0},
                      Counts{"andijcr_ristrutturazione_default.sh3d", 6, 44, 15, 21, 2, 20, 120, 0, 0},
                      Counts{"jonwilliams84_Home-Clean-Base-RAL.sh3d", 3, 86, 20, 40, 1, 0, 0, 0, 0},
                      Counts{"jonwilliams84_furnished_kitchen.sh3d", 3, 86, 20, 40, 1, 0, 22, 0, 0},
                      Counts{"jonwilliams84_Home-generated_a59742d.sh3d", 2, 18, 12, 6, 0, 0, 11, 0, 1},
                      Counts{"jonwilliams84_Home-generated_c3e7188.sh3d", 2, 18, 12, 17, 0, 0, 0, 0, 4},
                      Counts{"rtreffer_home_xml.sh3d", 1, 57, 11, 18, 0, 0, 25, 0, 0},
                      Counts{"rtreffer_home-2012-2013_xml.sh3d", 1, 38, 6, 7, 0, 1, 12, 0, 0}),
    [](const ::testing::TestParamInfo<Counts>& test) {
        std::string name = test.param.file;
        for (char& c : name)
            if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
        return name;
    });

class RealHomes : public ::testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    }
    static InputError refusal(const char* file) {
        try {
            (void)read(folder / "negative" / file);
        } catch (const InputError& error) {
            return error;
        }
        ADD_FAILURE() << file << " was not refused";
        return {"", "", ""};
    }
};

TEST_F(RealHomes, WithASerialisedHomeAloneAreRefused) {
    for (const char* file : {"rtreffer_home.sh3d", "SweetHome3D_junit_holes.sh3d"}) {
        const InputError error = refusal(file);
        EXPECT_EQ(error.code, "P151") << file;
        EXPECT_NE(std::string(error.what()).find("Sweet Home 3D 5.3 or later"), std::string::npos);
    }
}

TEST_F(RealHomes, WithMalformedXmlAreRefusedAtTheirPlace) {
    const InputError error = refusal("JumpLink_beispielhaus.sh3d");
    EXPECT_EQ(error.code, "P154");
    EXPECT_EQ(error.line, 1);
    EXPECT_EQ(error.column, 1687);
}

TEST_F(RealHomes, HaveArcsOnTheSideTheyWereDrawn) {
    // Four quarters make one circle: their middles lie on it, those of mirrored arcs would not.
    const Plan plan = read(folder / "FreeCAD_0-JoinWall.sh3d");
    std::vector<WallAxis> quarters;
    std::size_t arcs = 0;
    for (const Wall& wall : plan.storeys.at(0).walls) {
        arcs += wall.arc_extent != 0 ? 1 : 0;
        if (std::abs(std::abs(wall.arc_extent) - std::numbers::pi / 2) < 1e-3)
            quarters.emplace_back(wall.start, wall.end, wall.arc_extent, 1e-6);
    }
    EXPECT_EQ(arcs, 9u);
    ASSERT_EQ(quarters.size(), 4u);
    Point centre;
    for (const WallAxis& axis : quarters) centre = centre + axis.at(0) * 0.25;
    const double radius = distance(centre, quarters[0].at(0));
    for (const WallAxis& axis : quarters) EXPECT_NEAR(distance(centre, axis.at(0.5)), radius, 0.01 * radius);
}

TEST_F(RealHomes, HaveWallsOfTwoHeights) {
    const Plan plan = read(folder / "andijcr_ristrutturazione_default.sh3d");
    std::size_t sloped = 0;
    for (const Storey& storey : plan.storeys)
        for (const Wall& wall : storey.walls) sloped += wall.height_at_start != wall.height_at_end ? 1 : 0;
    EXPECT_EQ(sloped, 4u);
}

TEST_F(RealHomes, HaveHolesThroughWallsThatOverlap) {
    const Plan plan = read(folder / "rtreffer_home-2012-2013_xml.sh3d");
    std::size_t deep = 0;
    for (const Opening& opening : plan.storeys.at(0).openings)
        deep += opening.depth_left > 0 || opening.depth_right > 0 ? 1 : 0;
    EXPECT_EQ(deep, 4u);
}

}  // namespace
}  // namespace enfilade::plans
