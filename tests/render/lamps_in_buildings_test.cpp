// Lamps in buildings as people draw them, furnished ones too: pairs by brute force, pictures pixel by pixel.

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "base/error.h"
#include "render/executor.h"
#include "tests/support/building_scenes.h"
#include "tests/support/furnished_scenes.h"
#include "tests/support/lamp_judge.h"

namespace enfilade::render {
namespace {

using test::LitScene;

class LampsInBuildings : public ::testing::TestWithParam<test::BuildingScene> {};

INSTANTIATE_TEST_SUITE_P(All, LampsInBuildings, ::testing::ValuesIn(test::building_scenes()),
                         [](const auto& each) { return each.param.name; });

TEST_P(LampsInBuildings, AreSeenAsByBruteForce) {
    accel::SceneInput input;
    try {
        input = test::scene_of(GetParam());
    } catch (const InputError& error) {
        GTEST_SKIP() << GetParam().name << " cannot be built: " << error.what();
    }
    LitScene lit(accel::assemble(std::move(input)));
    lit.add_random_lamps(40, 7);
    lit.add_random_lamps(8, 8, false);
    const accel::SceneView scene = lit.view();
    const test::PairTally pairs = test::judge_pairs(scene, nullptr, test::pairs_to_ask(3000), 31);
    EXPECT_EQ(pairs.wrong, 0u) << pairs.first_wrong;
    EXPECT_EQ(pairs.missed, 0u) << pairs.first_wrong;
    EXPECT_GT(pairs.lit, 100u);
    for (const Camera& camera : test::cameras_by_lamps(scene, 2, 64)) {
        const test::PictureTally tally =
            test::judge_pictures(scene, camera, {.tracer = Tracer::Scalar, .shading = Shading::Lambert}, nullptr);
        EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
        EXPECT_LE(tally.differing * 200, tally.pixels);
    }
}

class LampsAmongFurniture : public ::testing::TestWithParam<test::FurnishedHouse> {};

INSTANTIATE_TEST_SUITE_P(All, LampsAmongFurniture,
                         ::testing::Values(test::FurnishedHouse::Townhouse, test::FurnishedHouse::Office,
                                           test::FurnishedHouse::Curved));

TEST_P(LampsAmongFurniture, ThrowTheShadowsThatBruteForceSays) {
    LitScene lit(test::furnished_scene(GetParam(), 5, 60));
    lit.add_random_lamps(20, 7);
    const accel::SceneView scene = lit.view();
    const auto built = build_object_accel(scene, ObjectAccelKind::Automatic, *make_executor(1));
    const ObjectTracer objects = built->tracer();
    const test::PairTally pairs = test::judge_pairs(scene, &objects, test::pairs_to_ask(600), 32);
    EXPECT_EQ(pairs.wrong, 0u) << pairs.first_wrong;
    EXPECT_GT(pairs.lit, 20u);
    for (const Camera& camera : test::cameras_by_lamps(scene, 2, 48)) {
        const test::PictureTally tally =
            test::judge_pictures(scene, camera, {.tracer = Tracer::Scalar, .shading = Shading::Lambert}, &objects);
        EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
        EXPECT_LE(tally.differing * 50, tally.pixels);
    }
}

}  // namespace
}  // namespace enfilade::render
