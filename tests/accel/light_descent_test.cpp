// The descent from a lamp finds what the lists of cells say.

#include "accel/lights/light_descent.h"

#include <gtest/gtest.h>

#include <cstring>

#include "accel/assemble.h"
#include "tests/accel/light_places.h"
#include "tests/support/synthetic_objects.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

TEST(LightDescent, FindsABeamWhereACellsListHasOne) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 4, .storeys = 2, .turn = 0.1}));
    std::mt19937_64 random(11);
    const test::LitScene lit(scene.view(), test::random_lamps(scene.view(), 100, random));
    const LightTreesView trees = lit.trees.view();
    const LightDescent descent(trees, lit.lights.size());
    ASSERT_EQ(descent.view().nodes.size(), trees.beams.size()) << "each beam once";
    std::size_t held = 0, dark = 0;
    for (int k = 0; k < 20000; ++k) {
        const std::uint32_t cell = test::random_cell(scene.view(), random);
        const render::Vec3d p = test::random_point(scene.view(), cell, random);
        const auto l = static_cast<std::uint32_t>(random() % lit.lights.size());
        const Light& lamp = lit.lights[l];
        const bool is_listed = test::beam_at(trees, lamp, cell, l, p).has_value();
        const std::uint32_t found =
            descend(trees, descent.view(), l, cell, static_cast<float>(p.x) - lamp.position[0],
                    static_cast<float>(p.y) - lamp.position[1], static_cast<float>(p.z) - lamp.position[2]);
        EXPECT_EQ(found != no_beam, is_listed);
        (is_listed ? held : dark) += 1;
    }
    EXPECT_GT(held, 100u);
    EXPECT_GT(dark, 100u);
}

/// The slabs of a box, in double, along the way from p to q.
bool meets_box(const PlacedObject& object, const render::Vec3d& p, const render::Vec3d& q) {
    double enter = 0, leave = 1;
    const double from[] = {p.x, p.y, p.z}, to[] = {q.x, q.y, q.z};
    for (std::size_t k = 0; k < 3; ++k) {
        const double d = to[k] - from[k];
        double a = (double{object.low[k]} - from[k]) / d, b = (double{object.high[k]} - from[k]) / d;
        if (a > b) std::swap(a, b);
        enter = std::max(enter, a);
        leave = std::min(leave, b);
    }
    return enter <= leave;
}

TEST(BeamObjects, HoldAllThatStandsOnTheWay) {
    const SceneInput input =
        test::with_objects(test::synthetic_office({.rooms_per_row = 4, .rows = 2, .turn = 0.2}), 3, 150);
    const Scene scene = assemble(input);
    const SceneView& view = scene.view();
    std::mt19937_64 random(5);
    std::vector<Light> lamps = test::random_lamps(view, 60, random);
    lamps[0].carrier = ObjectId{0};
    const test::LitScene lit(view, lamps);
    const LightTreesView trees = lit.trees.view();
    ASSERT_EQ(trees.beam_object_lists.size(), trees.beams.size());
    std::size_t asked = 0, met = 0, all = 0;
    for (int k = 0; k < 4000; ++k) {
        const std::uint32_t cell = test::random_cell(view, random);
        const render::Vec3d p = test::random_point(view, cell, random);
        const auto l = static_cast<std::uint32_t>(random() % lamps.size());
        const auto beam = test::beam_at(trees, lamps[l], cell, l, p);
        if (!beam) continue;
        ++asked;
        const ObjectsOfBeam objects = trees.objects_of(*beam);
        EXPECT_TRUE(std::is_sorted(objects.begin(), objects.end()));
        all += objects.count;
        render::Ray<double> ray;
        const render::Vec3d way = test::place_of(lamps[l]) - p;
        if (!render::make_ray(p, way, ray)) continue;
        for (const std::uint32_t on_way : test::follow(view, ray, cell).path.cells) {
            for (std::uint32_t i = view.cell_object_offsets[on_way]; i < view.cell_object_offsets[on_way + 1]; ++i) {
                const ObjectId object = view.cell_objects[i];
                if (object == lamps[l].carrier || !meets_box(view.objects[index(object)], p, p + way)) continue;
                ++met;
                EXPECT_TRUE(std::binary_search(objects.begin(), objects.end(), object)) << "object " << index(object);
            }
            if (on_way == static_cast<std::uint32_t>(lamps[l].cell)) break;
        }
    }
    EXPECT_GT(asked, 300u);
    EXPECT_GT(met, 100u);
    EXPECT_GT(all, met / 2) << "and not every object is on every list:";
    EXPECT_LT(all, asked * view.objects.size() / 4);
}

TEST(LightTrees, OfBallsListAllThatPointsOnThemList) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.2}));
    std::mt19937_64 random(17);
    std::vector<Light> balls = test::random_lamps(scene.view(), 10, random);
    for (Light& ball : balls) ball.radius = 0.05f;
    const test::LitScene lit(scene.view(), balls, {.balls = true});
    EXPECT_EQ(lit.trees.lamps_without_tree(), balls.size());
    for (std::uint32_t l = 0; l < balls.size(); ++l)
        for (int k = 0; k < 10; ++k) {
            const Light on =
                test::lamp_at(scene.view(), test::place_of(balls[l]) + 0.0499 * test::random_direction(random));
            if (on.cell != balls[l].cell) continue;
            const test::LitScene point(scene.view(), {on});
            for (std::uint32_t c = 0; c < scene.view().cells.size(); ++c)
                EXPECT_TRUE(!test::lists(point.trees.view(), c, 0) || test::lists(lit.trees.view(), c, l)) << c;
        }
}

TEST(LightTrees, AreTheSameOnAnyNumberOfThreads) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 4, .turn = 0.1}));
    std::mt19937_64 random(2);
    const test::LitScene lit(scene.view(), test::random_lamps(scene.view(), 300, random));
    const LightTrees threaded = build_light_trees(lit.view, {}, ThreadExecutor(4));
    const LightTreesView a = lit.trees.view(), b = threaded.view();
    const auto are_equal = [](const auto& x, const auto& y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0;
    };
    EXPECT_TRUE(are_equal(a.cell_offsets, b.cell_offsets) && are_equal(a.cell_lights, b.cell_lights));
    EXPECT_TRUE(are_equal(a.beams, b.beams) && are_equal(a.planes, b.planes));
}

}  // namespace
}  // namespace enfilade::accel
