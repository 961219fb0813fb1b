// Clusters in the lists of cells: nothing of the light is lost, and it is as near as was asked for.

#include "accel/lights/light_clusters.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "tests/accel/light_places.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

class Clusters : public testing::Test {
protected:
    Scene scene = assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 2, .turn = 0.1}));
    std::mt19937_64 random{4};
    test::LitScene lit{scene.view(), test::random_lamps(scene.view(), 2000, random)};
    LightTreesView trees = lit.trees.view();

    /// Each lamp of a list once.
    static std::vector<std::uint32_t> lamps_of(const LightTreesView& of, std::uint32_t cell) {
        std::vector<std::uint32_t> lamps;
        for (std::uint32_t k = of.cell_offsets[cell]; k < of.cell_offsets[cell + 1]; ++k) {
            const auto l = static_cast<std::uint32_t>(of.cell_lights[k].light);
            if (lamps.empty() || lamps.back() != l) lamps.push_back(l);
        }
        return lamps;
    }

    static double given(const ArrayView<Light>& lights, const std::vector<std::uint32_t>& lamps,
                        const render::Vec3d& p) {
        double sum = 0;
        for (const std::uint32_t l : lamps) {
            const render::Vec3d way = p - test::place_of(lights[l]);
            sum += double{lights[l].intensity[0]} / dot(way, way);
        }
        return sum;
    }
};

TEST_F(Clusters, OfLampsWithoutTreesShortenListsWithinTheErrorAskedFor) {
    const double error = 0.2;
    const test::LitScene flat(scene.view(), lit.lights, {.trees = false});
    const LightTreesView walked = flat.trees.view();
    const LightClusters clusters = cluster_lights(flat.view, walked, {.error = error}, SerialExecutor());
    const LightTreesView lists = clusters.lists(walked);
    for (const CellLight& entry : lists.cell_lights) ASSERT_EQ(entry.beam, no_beam) << "seen by a walk";
    const double most = 1 / ((1 - error) * (1 - error)) - 1;
    std::size_t before = 0, after = 0;
    for (std::uint32_t c = 0; c < scene.view().cells.size(); ++c) {
        const auto all = lamps_of(walked, c), shorter = lamps_of(lists, c);
        EXPECT_TRUE(std::is_sorted(shorter.begin(), shorter.end()));
        before += all.size();
        after += shorter.size();
        double intensity = 0;
        for (const std::uint32_t l : all) intensity += double{clusters.lights()[l].intensity[0]};
        for (const std::uint32_t l : shorter) intensity -= double{clusters.lights()[l].intensity[0]};
        EXPECT_NEAR(intensity, 0, 1e-2) << "in cell " << c;
        for (int k = 0; k < 5; ++k) {
            const render::Vec3d p = test::random_point(scene.view(), c, random);
            const double truth = given(clusters.lights(), all, p);
            EXPECT_NEAR(given(clusters.lights(), shorter, p), truth, most * truth);
        }
    }
    EXPECT_LT(double(after), 0.8 * double(before));
}

TEST_F(Clusters, WithABeamAreSeenAsTheirLampsWithoutAWalk) {
    const double error = 0.4;
    const LightClusters clusters = cluster_lights(lit.view, trees, {.error = error}, SerialExecutor());
    const LightTreesView lists = clusters.lists(trees);
    const double most = 1 / ((1 - error) * (1 - error)) - 1;
    std::size_t whole = 0, walked = 0, judged = 0;
    for (std::uint32_t c = 0; c < scene.view().cells.size(); ++c) {
        std::size_t walked_here = 0, whole_here = 0;
        for (std::uint32_t k = lists.cell_offsets[c]; k < lists.cell_offsets[c + 1]; ++k) {
            if (index(lists.cell_lights[k].light) < lit.lights.size()) continue;
            const std::uint32_t beam = lists.cell_lights[k].beam;
            (beam == no_beam ? walked_here : whole_here) += 1;
            if (beam != no_beam) {
                EXPECT_EQ(lists.planes_of(beam).count, 0u);
            }
        }
        whole += whole_here, walked += walked_here;
        if (walked_here > 0 || whole_here == 0) continue;
        for (int n = 0; n < 100; ++n, ++judged) {
            const render::Vec3d p = test::random_point(scene.view(), c, random);
            std::vector<std::uint32_t> seen, shown;
            for (const std::uint32_t l : lamps_of(trees, c))
                if (test::walk_sees(scene.view(), p, c, lit.lights[l])) seen.push_back(l);
            for (const std::uint32_t l : lamps_of(lists, c))
                if (l >= lit.lights.size() || test::walk_sees(scene.view(), p, c, lit.lights[l])) shown.push_back(l);
            const double truth = given(clusters.lights(), seen, p);
            EXPECT_NEAR(given(clusters.lights(), shown, p), truth, most * truth) << "in cell " << c;
        }
    }
    EXPECT_GT(whole, 1000u);
    EXPECT_GT(walked, 1000u);
    EXPECT_GE(judged, 100u);
    EXPECT_LE(clusters.listed_count(), whole + walked);
}

TEST_F(Clusters, TakeAWalkOnlyWhereTheirLampsTakeMorePlanes) {
    const LightClusters clusters = cluster_lights(lit.view, trees, {.error = 0.4}, SerialExecutor());
    const LightTreesView lists = clusters.lists(trees);
    // What a cell asks: a walk is dearer than a plane, so lists with clusters never ask for more.
    constexpr std::size_t walk = 16;
    for (std::uint32_t c = 0; c < scene.view().cells.size(); ++c) {
        std::size_t before = 0, after = 0;
        for (std::uint32_t k = trees.cell_offsets[c]; k < trees.cell_offsets[c + 1]; ++k)
            before += 1 + trees.planes_of(trees.cell_lights[k].beam).count;
        for (std::uint32_t k = lists.cell_offsets[c]; k < lists.cell_offsets[c + 1]; ++k) {
            const std::uint32_t beam = lists.cell_lights[k].beam;
            after += beam == no_beam ? walk : 1 + lists.planes_of(beam).count;
        }
        EXPECT_LE(after, before) << "in cell " << c;
    }
}

TEST_F(Clusters, StandInTheCellOfTheirLamps) {
    const LightClusters clusters = cluster_lights(lit.view, trees, {.error = 0.5}, SerialExecutor());
    EXPECT_GT(clusters.cluster_count(), 1000u);
    for (const Light& light : clusters.lights()) {
        const std::array<double, 3> p = {light.position[0], light.position[1], light.position[2]};
        EXPECT_GT(depth(scene.view(), light.cell, p), -1e-4);
    }
}

TEST_F(Clusters, AreNotMadeWhereNoErrorIsAllowed) {
    const LightTreesView lists = cluster_lights(lit.view, trees, {}, SerialExecutor()).lists(trees);
    EXPECT_EQ(lists.cell_lights.size(), trees.cell_lights.size());
}

}  // namespace
}  // namespace enfilade::accel
