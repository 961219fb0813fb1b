// Light trees against walks in double precision: no lamp is missing in a list, and the planes say what the walk says.

#include "accel/lights/light_trees.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "tests/accel/light_places.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

using test::LightJudge;
using test::LitScene;

void expect_sound(const LightJudge& judge, std::size_t least_pairs) {
    EXPECT_EQ(judge.verdict.missed, 0u) << judge.verdict.first;
    EXPECT_EQ(judge.verdict.differing, 0u) << judge.verdict.first;
    EXPECT_LT(double(judge.verdict.in_band), 2e-3 * double(judge.verdict.pairs) + 5);
    EXPECT_GT(judge.verdict.pairs, least_pairs);
    EXPECT_GT(judge.verdict.seen, least_pairs / 4);
    EXPECT_LT(judge.verdict.seen, judge.verdict.pairs) << "some are hidden, too";
}

class LightTreesOfOffices : public testing::TestWithParam<double> {  // by how much the building is turned
protected:
    Scene scene = assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 4, .storeys = 2, .turn = GetParam()}));
    std::mt19937_64 random{20261122};
};

TEST_P(LightTreesOfOffices, SayWhatWalksSay) {
    const LitScene lit(scene.view(), test::random_lamps(scene.view(), 200, random));
    LightJudge judge(lit);
    test::judge_places(lit, judge, 1500, random);
    expect_sound(judge, 8000);
}

TEST_P(LightTreesOfOffices, SayWhatWalksSayOfLampsOnBorders) {
    const LitScene lit(scene.view(), test::awkward_lamps(scene.view(), 300, random));
    LightJudge judge(lit);
    test::judge_places(lit, judge, 1000, random);
    EXPECT_EQ(judge.verdict.missed, 0u) << judge.verdict.first;
    EXPECT_EQ(judge.verdict.differing, 0u) << judge.verdict.first;
    EXPECT_GT(judge.verdict.seen, 1000u);
    EXPECT_EQ(lit.trees.lamps_without_tree(), 0u) << "few ways lead from a border";
}

INSTANTIATE_TEST_SUITE_P(Turned, LightTreesOfOffices, testing::Values(0.0, 0.1, 0.7));

}  // namespace
}  // namespace enfilade::accel
