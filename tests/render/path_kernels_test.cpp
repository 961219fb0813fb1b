// Paths give the same bytes whichever instruction set follows them.

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "accel/assemble.h"
#include "render/kernel.h"
#include "tests/support/lit_rooms.h"
#include "tests/support/surface_places.h"

namespace enfilade::render {
namespace {

std::vector<detail::PathSum> followed(const detail::Kernels& kernels, const accel::SceneView& scene,
                                      const test::SurfacePlaces& places) {
    const Lamps lamps = {{}, LampSearch::Naive, 0.02f};
    const std::vector<std::uint32_t> ball_cells(scene.lights.size(), 0xffffffffu);
    detail::PathLight light = {};
    light.lamps = &lamps;
    light.ball_cells = ball_cells.data();
    light.sun_height = 1e-5f;
    light.most_bounces = 20;
    light.seed = 5;
    std::vector<detail::PathSum> sums(places.points.size());
    detail::PathJob job = {};
    job.scene = &scene;
    job.light = &light;
    job.end = 16;
    job.sums = sums.data();
    job.points = places.points.data();
    job.normals = places.normals.data();
    job.cells = places.cells.data();
    job.end_place = static_cast<std::uint32_t>(places.points.size());
    kernels.path_places(job);
    return sums;
}

TEST(PathKernels, OfEveryInstructionSetAddUpTheSameLight) {
    accel::SceneInput input = test::closed_rooms(0.3);
    test::hang(input, {0.9, 1.7, 2.2}, {60, 50, 40});
    test::hang(input, {1.4, 1.9, 1.1}, {30, 30, 40}, 0.1);
    const accel::Scene scene = accel::assemble(input);
    const test::SurfacePlaces places = test::surface_places(scene.view(), 300, 11);
    const std::vector<detail::PathSum> truth = followed(detail::portable_kernel_set(), scene.view(), places);
    double light = 0;
    for (const detail::PathSum& sum : truth) light += sum.rgb[1];
    EXPECT_GT(light, 0);
    for (const detail::Kernels* kernels : detail::kernel_sets()) {
        const std::vector<detail::PathSum> sums = followed(*kernels, scene.view(), places);
        EXPECT_EQ(std::memcmp(sums.data(), truth.data(), sums.size() * sizeof sums[0]), 0) << kernels->name;
    }
}

}  // namespace
}  // namespace enfilade::render
