// Light trees know every lamp that a place sees: random places and lamps against walks in double precision.
// tools/campaign.sh lights asks for 10^7 of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "accel/assemble.h"
#include "accel/lights/light_trees.h"
#include "render/executor.h"
#include "tests/support/campaign_scenes.h"
#include "tests/support/object_scenes.h"
#include "tools/lamp_judge.h"
#include "tools/lamp_reach.h"
#include "tools/spread_lamps.h"

namespace enfilade::render {
namespace {

std::vector<test::CampaignScene> furnished(std::uint64_t series) {
    std::vector<test::CampaignScene> all;
    for (std::uint64_t k = 0; k < 6; ++k)
        all.push_back({"furnished office " + std::to_string(k),
                       test::furnished_office({.seed = 1 + k + 6 * series, .objects = 80, .turn = 0.2 * double(k)})});
    return all;
}

/// Lamps in the rooms, and as many around.
std::vector<accel::Light> lamps_of(const accel::SceneView& scene) {
    std::vector<accel::Light> lamps = tools::spread_lamps(scene, 40, tools::LampPlaces::Rooms);
    const std::vector<accel::Light> outside = tools::spread_lamps(scene, 10, tools::LampPlaces::Outside);
    lamps.insert(lamps.end(), outside.begin(), outside.end());
    return lamps;
}

void print(const std::string& name, const tools::LampPairs& tally) {
    std::cout << "lights | " << name << " | " << tally.pairs << " | " << tally.seen << " | " << tally.missed << " | "
              << tally.others << " | " << tally.outside_band << " |\n";
}

/// Judges a share of `count` pairs in each scene, on all cores.
tools::LampPairs judge(const std::vector<test::CampaignScene>& scenes, std::uint64_t count, std::uint64_t series) {
    constexpr std::uint64_t chunk = 5'000;
    const std::unique_ptr<accel::Executor> cores = make_executor();
    tools::LampPairs all;
    for (const test::CampaignScene& one : scenes) {
        const std::vector<accel::Light> lamps = lamps_of(one.scene.view());
        if (lamps.empty()) continue;
        const accel::SceneView lit = tools::with_lamps(one.scene.view(), lamps);
        const accel::LightTrees trees = accel::build_light_trees(lit, {}, *cores);
        std::unique_ptr<ObjectAccel> accel;
        ObjectTracer objects;
        if (lit.has_objects()) {
            accel = build_object_accel(lit, ObjectAccelKind::Bvh, *cores);
            objects = accel->tracer();
        }
        std::vector<tools::LampPairs> tallies(count / scenes.size() / chunk + 1);
        cores->run(tallies.size(), [&](std::size_t k) {
            tallies[k] = tools::judge_lamp_pairs(lit, trees.view(), lit.has_objects() ? &objects : nullptr,
                                                 k + 1'000'000 * series, chunk);
        });
        tools::LampPairs here;
        for (const tools::LampPairs& tally : tallies) here += tally;
        EXPECT_EQ(here.missed, 0u) << one.name;
        EXPECT_EQ(here.outside_band, 0u) << one.name;
        if (std::getenv("ENFILADE_LAMP_PAIRS") != nullptr) print(one.name, here);
        all += here;
    }
    return all;
}

TEST(LampCampaign, MissesNoLampInBuildings) {
    const bool is_campaign = std::getenv("ENFILADE_LAMP_PAIRS") != nullptr;
    const std::uint64_t count = test::asked("ENFILADE_LAMP_PAIRS", 100'000),
                        series = test::asked("ENFILADE_LAMP_SERIES", 0);
    const tools::LampPairs all = judge(test::campaign_scenes(is_campaign), count, series);
    if (is_campaign) print("all", all);
    EXPECT_GE(all.pairs, count * 9 / 10);
    EXPECT_GT(all.seen * 20, all.pairs);  // else nothing was judged
}

TEST(LampCampaign, MissesNoLampAmongFurniture) {
    const bool is_campaign = std::getenv("ENFILADE_LAMP_PAIRS") != nullptr;
    const std::uint64_t count = test::asked("ENFILADE_LAMP_PAIRS", 200'000) / 10,
                        series = test::asked("ENFILADE_LAMP_SERIES", 0);
    const tools::LampPairs all = judge(furnished(series), count, series);
    if (is_campaign) print("all furnished", all);
    EXPECT_GT(all.seen * 20, all.pairs);
}

// A judge that finds nothing is none.
TEST(LampCampaign, AJudgeSeesListsWithoutALamp) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2}));
    const std::vector<accel::Light> lamps = lamps_of(scene.view());
    const accel::SceneView lit = tools::with_lamps(scene.view(), lamps);
    const accel::SerialExecutor one;
    const accel::LightTrees trees = accel::build_light_trees(lit, {}, one);
    accel::LightTreesView without = trees.view();
    const std::vector<std::uint32_t> offsets(without.cell_offsets.size(), 0);
    without.cell_offsets = {offsets.data(), offsets.size()};
    const tools::LampPairs tally = tools::judge_lamp_pairs(lit, without, nullptr, 1, 2'000);
    EXPECT_GT(tally.missed, 20u);
    EXPECT_EQ(tally.missed, tally.outside_band);
    EXPECT_GT(tools::lamp_reach(lit, without, 100).missed, 1'000u);
}

TEST(LampReach, FindsMostListedLampsAndNoOthers) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 3, .turn = 0.3}));
    const std::vector<accel::Light> lamps = tools::spread_lamps(scene.view(), 30, tools::LampPlaces::Rooms);
    const accel::SceneView lit = tools::with_lamps(scene.view(), lamps);
    const accel::SerialExecutor one;
    const accel::LightTrees trees = accel::build_light_trees(lit, {}, one);
    const tools::LampReach reach = tools::lamp_reach(lit, trees.view(), 500);
    EXPECT_EQ(reach.missed, 0u);
    EXPECT_GT(reach.listed, 30u);
    EXPECT_LE(reach.ratio(), 1.3);
}

TEST(SpreadLamps, HangInTheirCellsByArea) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 3, .turn = 0.3}));
    const accel::SceneView& view = scene.view();
    for (const auto places : {tools::LampPlaces::Rooms, tools::LampPlaces::Outside}) {
        const std::vector<accel::Light> lamps = tools::spread_lamps(view, 500, places);
        if (lamps.empty()) continue;
        EXPECT_EQ(lamps.size(), 500u);
        for (const accel::Light& lamp : lamps) {
            const accel::Cell& cell = view.cells[index(lamp.cell)];
            EXPECT_GT(lamp.position[2], cell.z_floor);
            EXPECT_LT(lamp.position[2], cell.z_ceiling);
            EXPECT_EQ(cell.label, places == tools::LampPlaces::Rooms ? accel::Label::Room : accel::Label::Exterior);
        }
        double area = 0;
        for (const accel::Cell& cell : view.cells)
            area += cell.label == view.cells[index(lamps[0].cell)].label ? tools::floor_area(view, cell) : 0;
        for (std::size_t c = 0; c < view.cells.size(); ++c) {
            if (view.cells[c].label != view.cells[index(lamps[0].cell)].label) continue;
            const auto here = std::count_if(lamps.begin(), lamps.end(),
                                            [&](const accel::Light& lamp) { return index(lamp.cell) == c; });
            EXPECT_NEAR(double(here), 500 * tools::floor_area(view, view.cells[c]) / area, 1.01);
        }
    }
}

}  // namespace
}  // namespace enfilade::render
