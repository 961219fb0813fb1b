// Random pairs of a place and a lamp: the walk, lists and trees against brute force. ENFILADE_LAMP_PAIRS asks more.

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/executor.h"
#include "tests/support/lamp_judge.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using test::LitScene;
using test::PairTally;

LitScene lit_office(double turn, int storeys, int lamps, std::uint64_t seed) {
    LitScene lit(accel::assemble(test::synthetic_office({.storeys = storeys, .turn = turn})));
    lit.add_random_lamps(lamps, seed);
    return lit;
}

void expect_sound(const PairTally& tally) {
    EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
    EXPECT_EQ(tally.missed, 0u) << tally.first_wrong;
    EXPECT_GT(tally.lit * 20, tally.pairs);
    EXPECT_LT(tally.lit * 20, 19 * tally.pairs);
    EXPECT_LT(tally.differing * 500, tally.pairs);
}

TEST(LampPairs, AreAsBruteForceSaysInBareRooms) {
    for (const double turn : {0.0, 0.3}) {
        const LitScene lit = lit_office(turn, 1, 40, 5);
        expect_sound(test::judge_pairs(lit.view(), nullptr, test::pairs_to_ask(25000), 11));
    }
}

TEST(LampPairs, AreAsBruteForceSaysAcrossStoreys) {
    const LitScene lit = lit_office(0.7, 2, 60, 6);
    expect_sound(test::judge_pairs(lit.view(), nullptr, test::pairs_to_ask(20000), 12));
}

TEST(LampPairs, AreAsBruteForceSaysWhereLampsAreOutdoors) {
    LitScene lit = lit_office(0.3, 1, 10, 7);
    lit.add_random_lamps(30, 8, false);
    expect_sound(test::judge_pairs(lit.view(), nullptr, test::pairs_to_ask(20000), 13));
}

TEST(LampPairs, AreAsBruteForceSaysAmongFurniture) {
    for (const double turn : {0.0, 0.4}) {
        LitScene lit(test::furnished_office({.seed = 3, .objects = 60, .turn = turn}));
        lit.add_random_lamps(30, 9);
        const accel::SceneView view = lit.view();
        for (const ObjectAccelKind kind : {ObjectAccelKind::Octree, ObjectAccelKind::Plain}) {
            const auto built = build_object_accel(view, kind, *make_executor(1));
            const ObjectTracer objects = built->tracer();
            expect_sound(test::judge_pairs(view, &objects, test::pairs_to_ask(6000), 14));
        }
    }
}

}  // namespace
}  // namespace enfilade::render
