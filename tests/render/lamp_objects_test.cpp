// Shadows of what stands in rooms, by the light of lamps.

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/executor.h"
#include "render/lamp_light.h"
#include "tests/support/lamp_judge.h"
#include "tests/support/object_scenes.h"

namespace enfilade::render {
namespace {

using test::LitScene;

/// How much of each lamp a place gets, by each search, in one precision.
template <class T>
Vec3f lux(const accel::SceneView& scene, const ObjectTracer& objects, LampSearch search, Vec3d at, Vec3f normal) {
    const auto executor = make_executor(1);
    const accel::LightTrees trees = accel::build_light_trees(scene, {}, *executor);
    const Lamps lamps = {.trees = trees.view(), .search = search};
    const FurnishedRooms rooms = {objects};
    NoEvents events;
    LampLight<FurnishedRooms, NoEvents> light(scene, lamps, rooms, events);
    const auto cell = accel::locate(scene, {at.x, at.y, at.z});
    return light.at(LitPlace<T>{vec_cast<T>(at), normal, static_cast<std::uint32_t>(cell.value())});
}

/// What all searches in both precisions agree on.
Vec3f lux_by_all(const accel::SceneView& scene, const ObjectTracer& objects, Vec3d at, Vec3f normal) {
    const Vec3f expected = lux<double>(scene, objects, LampSearch::Naive, at, normal);
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree}) {
        for (const Vec3f& each :
             {lux<float>(scene, objects, search, at, normal), lux<double>(scene, objects, search, at, normal)}) {
            EXPECT_NEAR(each.x, expected.x, 1e-4 * expected.x);
            EXPECT_NEAR(each.y, expected.y, 1e-4 * expected.y);
        }
    }
    return expected;
}

/// A closed box about the middle of a room.
accel::Scene room_with_box() {
    return test::room_of_meshes({test::box_mesh({-0.3f, -0.3f, 1.7f}, {0.3f, 0.3f, 2.3f})});
}

TEST(LampObjects, CarriersThrowNoShadowOfTheirOwnLamp) {
    LitScene closed(room_with_box()), open(room_with_box());
    closed.add_lamp({0, 0, 2}, {40, 30, 20});
    open.add_lamp({0, 0, 2}, {40, 30, 20}, accel::ObjectId{0});
    const auto built = build_object_accel(open.view(), ObjectAccelKind::Automatic, *make_executor(1));
    const ObjectTracer objects = built->tracer();
    EXPECT_EQ(lux_by_all(closed.view(), objects, {0.5, 0.25, 0.5}, {0, 0, 1}).x, 0.0f);
    const Vec3f below = lux_by_all(open.view(), objects, {0, 0, 1}, {0, 0, 1});
    EXPECT_FLOAT_EQ(below.x, 40);
    EXPECT_FLOAT_EQ(below.y, 30);
    EXPECT_FLOAT_EQ(lux_by_all(open.view(), objects, {2, 0, 2}, {-1, 0, 0}).x, 10);
}

TEST(LampObjects, CarriersThrowShadowsOfOtherLamps) {
    LitScene lit(room_with_box());
    lit.add_lamp({0, 0, 2}, {40, 0, 0}, accel::ObjectId{0});
    lit.add_lamp({0, 0, 3}, {0, 40, 0});
    const auto built = build_object_accel(lit.view(), ObjectAccelKind::Automatic, *make_executor(1));
    const Vec3f below = lux_by_all(lit.view(), built->tracer(), {0, 0, 1}, {0, 0, 1});
    EXPECT_FLOAT_EQ(below.x, 40);
    EXPECT_EQ(below.y, 0.0f);
    const Vec3f beside = lux_by_all(lit.view(), built->tracer(), {2, 0, 3}, {-1, 0, 0});
    EXPECT_FLOAT_EQ(beside.y, 10);
}

/// What touches the place or the lamp is not between them; a tenth of a millimetre is, two thirds of one are not.
TEST(LampObjects, WhatTouchesIsNotBetween) {
    for (const double gap : {1e-4, 7e-4}) {
        LitScene lit(room_with_box());
        lit.add_lamp({0.1, 0, 2.3 + gap}, {40, 0, 0});
        const auto built = build_object_accel(lit.view(), ObjectAccelKind::Automatic, *make_executor(1));
        const Vec3f below = lux_by_all(lit.view(), built->tracer(), {0.1, 0, 2.1}, {0, 0, 1});
        EXPECT_EQ(below.x > 0, gap < 2e-4) << gap;
    }
}

/// A view in which every third object is listed by one of its cells alone: elsewhere it is cut off.
struct CutObjects {
    std::vector<std::uint32_t> offsets;
    std::vector<accel::ObjectId> listed;
    accel::SceneView view;

    explicit CutObjects(const accel::SceneView& from) : view(from) {
        std::vector<bool> is_listed(from.objects.size(), false);
        for (std::uint32_t c = 0; c < from.cells.size(); ++c) {
            offsets.push_back(static_cast<std::uint32_t>(listed.size()));
            for (std::uint32_t k = from.cell_object_offsets[c]; k < from.cell_object_offsets[c + 1]; ++k) {
                const accel::ObjectId object = from.cell_objects[k];
                if (index(object) % 3 == 0 && is_listed[index(object)]) continue;
                is_listed[index(object)] = true;
                listed.push_back(object);
            }
        }
        offsets.push_back(static_cast<std::uint32_t>(listed.size()));
        view.cell_object_offsets = {offsets.data(), offsets.size()};
        view.cell_objects = {listed.data(), listed.size()};
    }
};

TEST(LampObjects, AreCutOffWhereNoCellListsThem) {
    LitScene lit(test::furnished_office({.seed = 5, .objects = 60, .turn = 0.4}));
    lit.add_random_lamps(25, 9);
    const accel::SceneView whole = lit.view();
    const CutObjects cut(whole);
    ASSERT_LT(cut.listed.size(), whole.cell_objects.size());
    const auto executor = make_executor(1);
    const accel::LightTrees trees = accel::build_light_trees(cut.view, {}, *executor);
    std::uint64_t walked = 0;
    for (const accel::BeamObjects& list : trees.view().beam_object_lists) walked += list.must_walk;
    EXPECT_GT(walked, 0u);
    const auto built = build_object_accel(cut.view, ObjectAccelKind::Automatic, *executor);
    const ObjectTracer objects = built->tracer();
    const test::PairTally tally = test::judge_pairs(cut.view, &objects, test::pairs_to_ask(6000), 17);
    EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
    EXPECT_GT(tally.lit, 500u);
    EXPECT_LT(tally.lit + 500, tally.pairs);
}

TEST(LampObjects, ThrowTheSameShadowsHoweverLampsAreFound) {
    for (const double turn : {0.0, 0.4}) {
        LitScene lit(test::furnished_office({.seed = 4, .objects = 60, .turn = turn}));
        lit.add_random_lamps(25, 9);
        const accel::SceneView whole = lit.view();
        const CutObjects cut(whole);
        for (const accel::SceneView& scene : {whole, cut.view}) {
            std::uint64_t lit_pixels = 0, pixels = 0;
            const auto built = build_object_accel(scene, ObjectAccelKind::Automatic, *make_executor(1));
            const ObjectTracer objects = built->tracer();
            for (const Camera& camera : test::cameras_by_lamps(scene, 2, 64)) {
                const test::PictureTally tally = test::judge_pictures(
                    scene, camera, {.tracer = Tracer::Scalar, .shading = Shading::Lambert}, &objects);
                EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
                EXPECT_LE(tally.differing * 100, tally.pixels);
                lit_pixels += tally.lit;
                pixels += tally.pixels;
            }
            EXPECT_GT(lit_pixels * 10, pixels);
        }
    }
}

}  // namespace
}  // namespace enfilade::render
