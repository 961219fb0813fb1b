// Light trees of buildings as people draw them against walks in double precision.

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "tests/accel/light_places.h"
#include "tests/support/building_scenes.h"

namespace enfilade::accel {
namespace {

using test::LightJudge;
using test::LitScene;

class LightTreesOfBuildings : public testing::TestWithParam<test::BuildingScene> {};

TEST_P(LightTreesOfBuildings, SayWhatWalksSay) {
    const Scene scene = assemble(test::scene_of(GetParam()));
    std::mt19937_64 random(7);
    std::vector<Light> lamps = test::random_lamps(scene.view(), 40, random);
    const std::vector<Light> more = test::awkward_lamps(scene.view(), 40, random);
    lamps.insert(lamps.end(), more.begin(), more.end());
    const LitScene lit(scene.view(), std::move(lamps));
    LightJudge judge(lit);
    test::judge_places(lit, judge, 600, random);
    EXPECT_EQ(judge.verdict.missed, 0u) << judge.verdict.first;
    EXPECT_EQ(judge.verdict.differing, 0u) << judge.verdict.first;
    EXPECT_GT(judge.verdict.seen, 300u);
}

INSTANTIATE_TEST_SUITE_P(All, LightTreesOfBuildings, testing::ValuesIn(test::building_scenes()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace enfilade::accel
