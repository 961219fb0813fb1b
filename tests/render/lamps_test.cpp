// Light of lamps: however it is found out which ones a place sees, the picture is the same.

#include <gtest/gtest.h>

#include "render/executor.h"
#include "render/trace.h"
#include "tests/support/lit_office.h"

namespace enfilade::render {
namespace {

using test::lit_office;

double largest_difference(const Image& a, const Image& b, int& differing) {
    double largest = 0;
    differing = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const double d = std::abs(double{a.rgb[i]} - double{b.rgb[i]});
        largest = std::max(largest, d);
        differing += d > 1e-4 ? 1 : 0;
    }
    return largest;
}

TEST(Lamps, AreLocatedWhenASceneIsAssembled) {
    const accel::Scene scene = lit_office();
    ASSERT_GT(scene.view().lights.size(), 5u);
    for (const accel::Light& light : scene.view().lights) EXPECT_NE(light.cell, none<accel::CellId>);
}

TEST(Lamps, GiveTheSamePictureHoweverTheyAreFound) {
    const accel::Scene scene = lit_office();
    const accel::Light& lamp = scene.view().lights[2];
    Camera camera;
    camera.eye = {lamp.position[0] - 0.5, lamp.position[1], 1.5};
    camera.target = {lamp.position[0] + 1, lamp.position[1] + 0.4, 1.2};
    camera.width = camera.height = 128;
    TraceOptions options;
    options.shading = Shading::Lambert;
    options.tracer = Tracer::Scalar;
    options.lamps = LampOptions{.search = LampSearch::Naive, .exposure = 0.05f};
    const Image naive = trace(scene.view(), camera, options);
    EXPECT_GT(*std::max_element(naive.rgb.begin(), naive.rgb.end()), 0.2f);
    for (const LampSearch search : {LampSearch::Pvs, LampSearch::Tree}) {
        options.lamps->search = search;
        int differing = 0;
        largest_difference(naive, trace(scene.view(), camera, options), differing);
        EXPECT_LE(differing, 6);
    }
}

}  // namespace
}  // namespace enfilade::render
