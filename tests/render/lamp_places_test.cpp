// Lamps at places where one would rather not have them: the three searches still give one light, and the right one.

#include <gtest/gtest.h>

#include <cmath>

#include "accel/assemble.h"
#include "render/executor.h"
#include "render/lamp_light.h"
#include "tests/support/lamp_judge.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using test::LitScene;

LitScene bare_office(double turn = 0) {
    return LitScene(accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = turn})));
}

/// The middle of a portal with or without glass, on its plane.
Vec3d on_portal(const accel::SceneView& view, std::uint32_t skip, bool is_glass = false) {
    for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
        const accel::Cell& cell = view.cells[c];
        if (cell.label == accel::Label::Exterior) continue;
        for (std::uint32_t s = 0; s < cell.section_count; ++s) {
            const std::uint32_t i = cell.first_section + s, j = cell.first_section + (s + 1) % cell.section_count;
            const std::uint32_t first = view.section_tails[i].first_face, end = view.section_tails[i + 1].first_face;
            float low = cell.z_floor;
            for (std::uint32_t f = first; f < end; low = view.side_faces[f].z_top, ++f) {
                const accel::Target target = view.side_faces[f].target;
                if (!target.is_portal() || target.is_glass() != is_glass || skip-- > 0) continue;
                const float high = f + 1 == end ? cell.z_ceiling : view.side_faces[f].z_top;
                return {0.5 * (double{view.section_x[i]} + double{view.section_x[j]}),
                        0.5 * (double{view.section_y[i]} + double{view.section_y[j]}),
                        0.5 * (double{low} + double{high})};
            }
        }
    }
    return {0, 0, 0};
}

/// Pictures and pairs of the scene are sound.
void expect_one_light(const LitScene& lit, bool is_lit = true) {
    const accel::SceneView view = lit.view();
    const test::PairTally pairs = test::judge_pairs(view, nullptr, 2000, 21);
    EXPECT_EQ(pairs.wrong, 0u) << pairs.first_wrong;
    EXPECT_EQ(pairs.missed, 0u);
    for (const Camera& camera : test::cameras_by_lamps(view, 2, 64)) {
        const test::PictureTally tally =
            test::judge_pictures(view, camera, {.tracer = Tracer::Scalar, .shading = Shading::Lambert}, nullptr);
        EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
        EXPECT_EQ(tally.lit > 0, is_lit);
    }
}

TEST(LampPlaces, OnPortals) {
    for (const double turn : {0.0, 0.3}) {
        LitScene lit = bare_office(turn);
        for (std::uint32_t skip = 0; skip < 12; skip += 2) lit.add_lamp(on_portal(lit.view(), skip), {50, 60, 70});
        expect_one_light(lit);
    }
}

/// Whether a pane tints the light of a lamp that lies in it, rounding decides; who sees the lamp, it does not.
TEST(LampPlaces, InPanes) {
    for (const double turn : {0.0, 0.3}) {
        LitScene lit = bare_office(turn);
        for (std::uint32_t skip = 0; skip < 8; skip += 2) lit.add_lamp(on_portal(lit.view(), skip, true), {50, 60, 70});
        const test::PairTally pairs = test::judge_pairs(lit.view(), nullptr, 2000, 22);
        EXPECT_EQ(pairs.wrong, 0u) << pairs.first_wrong;
        EXPECT_GT(pairs.lit, 50u);
    }
}

TEST(LampPlaces, OnVerticalLinesOfCells) {
    LitScene lit = bare_office(0.3);
    const accel::SceneView view = lit.view();
    for (std::uint32_t s = 0; s < view.section_count(); s += 17)
        lit.add_lamp({double{view.section_x[s]}, double{view.section_y[s]}, 1.7}, {50, 60, 70});
    expect_one_light(lit);
}

TEST(LampPlaces, OnWalls) {
    LitScene lit = bare_office(0.3);
    for (const test::OpenPlace& place : test::open_places(lit.view(), 60, 3))
        lit.add_lamp(vec_cast<double>(place.point), {50, 60, 70});
    expect_one_light(lit);
}

TEST(LampPlaces, OnFloorsTheFloorStaysDark) {
    LitScene lit = bare_office();
    const accel::SceneView bare = lit.view();
    std::uint32_t room = 0;
    while (bare.cells[room].label != accel::Label::Room) ++room;
    const accel::Cell& cell = bare.cells[room];
    const double x =
        0.5 * (double{bare.section_x[cell.first_section]} + double{bare.section_x[cell.first_section + 2]});
    const double y =
        0.5 * (double{bare.section_y[cell.first_section]} + double{bare.section_y[cell.first_section + 2]});
    lit.add_lamp({x, y, double{cell.z_floor}}, {50, 60, 70});
    expect_one_light(lit);
    const accel::SceneView view = lit.view();
    NoEvents events;
    const BareRooms rooms;
    const Lamps naive = {.trees = {}, .search = LampSearch::Naive};
    LampLight<BareRooms, NoEvents> light(view, naive, rooms, events);
    const Vec3f on_floor = {static_cast<float>(x) + 0.5f, static_cast<float>(y), cell.z_floor};
    EXPECT_EQ(light.at(LitPlace<float>{on_floor, {0, 0, 1}, room}), (Vec3f{0, 0, 0}));
    const Vec3f above = {static_cast<float>(x), static_cast<float>(y), cell.z_floor + 2};
    EXPECT_FLOAT_EQ(light.at(LitPlace<float>{above, {0, 0, -1}, room}).x, 50.0f / 4);
    EXPECT_FLOAT_EQ(light.at(LitPlace<double>{vec_cast<double>(above), {0, 0, -1}, room}).z, 70.0f / 4);
}

TEST(LampPlaces, TwoAtOnePlaceShineTwice) {
    LitScene one = bare_office(), two = bare_office();
    const Vec3d at = on_portal(one.view(), 4) + Vec3d{0.01, 0.02, 0.4};
    one.add_lamp(at, {50, 60, 70});
    two.add_lamp(at, {50, 60, 70});
    two.add_lamp(at, {50, 60, 70});
    expect_one_light(two);
    const accel::SceneView single = one.view(), twice = two.view();
    const Lamps naive = {.trees = {}, .search = LampSearch::Naive};
    NoEvents events;
    const BareRooms rooms;
    LampLight<BareRooms, NoEvents> of_one(single, naive, rooms, events), of_two(twice, naive, rooms, events);
    int lit = 0;
    for (const test::OpenPlace& place : test::open_places(single, 3000, 8)) {
        const LitPlace<float> up = {place.point, {0, 0, 1}, place.cell};
        const Vec3f light = of_one.at(up);
        EXPECT_EQ(of_two.at(up), light + light);
        lit += light.x > 0 ? 1 : 0;
    }
    EXPECT_GT(lit, 50);
}

TEST(LampPlaces, BlackLampsLightNothing) {
    LitScene lit = bare_office();
    lit.add_lamp(on_portal(lit.view(), 4), {0, 0, 0});
    expect_one_light(lit, false);
}

TEST(LampPlaces, InSolidsLightNothing) {
    LitScene lit = bare_office();
    lit.add_lamp({0, 0, -50}, {500, 600, 700});
    const accel::SceneView view = lit.view();
    ASSERT_EQ(view.lights[0].cell, none<accel::CellId>);
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree}) {
        const auto executor = make_executor(1);
        const accel::LightTrees trees = accel::build_light_trees(view, {}, *executor);
        NoEvents events;
        const BareRooms rooms;
        const Lamps lamps = {.trees = trees.view(), .search = search};
        LampLight<BareRooms, NoEvents> light(view, lamps, rooms, events);
        for (const test::OpenPlace& place : test::open_places(view, 500, 4))
            EXPECT_EQ(light.at(LitPlace<float>{place.point, {0, 0, -1}, place.cell}), (Vec3f{0, 0, 0}));
    }
}

TEST(LampPlaces, NoneAtAllIsDarkness) {
    const LitScene lit = bare_office();
    const accel::SceneView view = lit.view();
    LitScene other = bare_office();
    other.add_random_lamps(3, 5);
    const test::PictureTally tally =
        test::judge_pictures(view, test::cameras_by_lamps(other.view(), 1, 32).at(0),
                             {.tracer = Tracer::Scalar, .shading = Shading::Lambert}, nullptr);
    EXPECT_EQ(tally.wrong, 0u);
    EXPECT_EQ(tally.lit, 0u);
}

TEST(LampPlaces, NearestToAFaceLightIsFinite) {
    accel::Light light = {};
    light.intensity = {1e18f, 1, 0};
    for (const float d : {1e-30f, 1e-20f, 1e-9f, 1e-3f}) {
        const Vec3f lux = illuminance(light, Vec3f{0, 0, -d}, Vec3f{0, 0, 1});
        EXPECT_TRUE(std::isfinite(lux.x)) << d;
        EXPECT_EQ(lux.z, 0.0f);
    }
    EXPECT_EQ(illuminance(light, Vec3f{0, 0, 1}, Vec3f{0, 0, 1}).x, 0.0f);
}

}  // namespace
}  // namespace enfilade::render
