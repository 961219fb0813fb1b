// What few scenes have: ten thousand portals in a row, and floors that mirror, by every tracer.
#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/trace.h"
#include "render/trace_rays.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/picture_judge.h"
#include "tests/support/stream_judge.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/tracer_variants.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render {
namespace {

Image picture(const accel::SceneView& scene, const Camera& camera, Tracer tracer, PacketSizes packets, float mirror,
              RayStats* stats = nullptr) {
    const accel::SerialExecutor here;
    TraceOptions options;
    options.tracer = tracer;
    options.packets = packets;
    options.shading = Shading::Lambert;
    options.mirror_floor = mirror;
    options.executor = &here;
    options.stats = stats;
    return trace(scene, camera, options);
}

class WithSets : public testing::TestWithParam<test::InstructionSet> {
protected:
    WithSets() : set_(GetParam()) {}
    test::UsingInstructionSet set_;
};

using Enfilade = WithSets;

// Extreme 4: drift and depth of recursion.
TEST_P(Enfilade, OfTenThousandDoorsIsSeenToItsEnd) {
    const accel::Scene scene = accel::assemble(test::with_own_colours(test::synthetic_corridor(10000)));
    const accel::SceneView& view = scene.view();
    const double west = view.locator_nodes[0].low[0], east = view.locator_nodes[0].high[0];
    Camera camera;
    camera.eye = {west + 0.125, 0, 1};
    camera.target = {east, 0, 1};
    camera.width = camera.height = 19;
    const auto last_wall = trace_ray(view, {camera.eye, {1, 0, 0}, *accel::locate(view, {west + 0.125, 0, 1})});
    const auto& colour = view.materials[index(view.source_faces[index(last_wall.source_face)].material)].colour;
    for (const double fov : {0.0005, 0.02, 2.0, 60.0}) {
        camera.fov_deg = fov;
        const Image expected = picture(view, camera, Tracer::Scalar, {}, 0);
        EXPECT_NEAR(expected.pixel(9, 9).y, colour[1], 1e-4);
        const CameraFrame frame = make_frame(camera);
        const test::PictureJudge judge(view);
        for (std::size_t i = 0; i < test::tracer_variants.size(); i += 2) {
            const test::TracerVariant& variant = test::tracer_variants[i];
            RayStats stats;
            const Image image = picture(view, camera, variant.tracer, variant.packets, 0, &stats);
            const test::PictureVerdict verdict = judge.compare(frame, start_cell(view, frame), expected, image);
            EXPECT_TRUE(verdict.is_right()) << variant.name << ", " << fov << " degrees: " << verdict.text();
            EXPECT_NEAR(image.pixel(9, 9).y, colour[1], 1e-4) << variant.name;
            EXPECT_EQ(stats.leaks, 0u);
            if (fov == 0.0005) {
                EXPECT_GE(stats.cells, view.cells.size());
            }
        }
    }
}

TEST_P(Enfilade, OfTenThousandDoorsIsCrossedByStreams) {
    const accel::Scene scene = accel::assemble(test::synthetic_corridor(10000));
    const accel::SceneView& view = scene.view();
    const double west = view.locator_nodes[0].low[0];
    std::vector<RayQuery> rays;
    for (int i = 0; i < 50; ++i)
        rays.push_back(
            {{west + 0.125, 0, 1}, {1, i * 0x1p-18, -i * 0x1p-17}, *accel::locate(view, {west + 0.125, 0, 1})});
    std::vector<RayHit> expected(rays.size());
    trace_rays(view, rays, expected);
    const test::StreamJudge judge(view);
    test::RayTable table(rays);
    for (const Tracer tracer : {Tracer::Simd, Tracer::Packet})
        for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any}) {
            table.trace(view, {.tracer = tracer, .order = order});
            const test::StreamVerdict verdict = judge.compare(rays, expected, table);
            EXPECT_TRUE(verdict.is_right()) << verdict.text();
        }
}

using MirroringFloors = WithSets;

/// Pixels whose colours differ by more than 2e-3 of themselves and 1e-4.
std::size_t differing(const Image& a, const Image& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        bool is_same = true;
        for (std::size_t k = i; k < i + 3; ++k)
            is_same = is_same && std::abs(a.rgb[k] - b.rgb[k]) <= 2e-3f * std::abs(b.rgb[k]) + 1e-4f;
        count += is_same ? 0 : 1;
    }
    return count;
}

TEST_P(MirroringFloors, ShowTheSameInAllTracers) {
    for (const double turn : {0.0, 0.3}) {
        const accel::Scene scene = accel::assemble(test::with_own_colours(
            test::synthetic_office({.rooms_per_row = 4, .rows = 3, .storeys = 2, .turn = turn})));
        const accel::SceneView& view = scene.view();
        for (const float mirror : {0.25f, 1.0f}) {
            std::size_t pixels = 0, mirrored = 0;
            for (const test::TryingCamera& trying : test::trying_cameras(view, 51)) {
                if (trying.on_border || trying.name == "straight at a vertex") continue;
                const Image expected = picture(view, trying.camera, Tracer::Scalar, {}, mirror);
                mirrored += differing(picture(view, trying.camera, Tracer::Scalar, {}, 0), expected);
                pixels += expected.rgb.size() / 3;
                for (const test::TracerVariant& variant : test::tracer_variants) {
                    const Image image = picture(view, trying.camera, variant.tracer, variant.packets, mirror);
                    // Edges are met twice: by the ray, and by its reflection.
                    EXPECT_LE(differing(image, expected), 2u + expected.rgb.size() / 3 / 1000)
                        << variant.name << ", " << trying.name << ", mirror " << mirror << ", "
                        << test::text_of(make_frame(trying.camera), trying.camera.width, trying.camera.height);
                }
            }
            EXPECT_GT(mirrored, pixels / 20);
        }
    }
}

// The judge of this file: a picture half a pixel aside has to differ in more pixels than are let pass.
TEST(MirrorFloors, AreToldFromThoseOfANearCamera) {
    const accel::Scene scene = accel::assemble(test::with_own_colours(test::synthetic_office({.turn = 0.3})));
    std::size_t found = 0, tried = 0;
    for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 52)) {
        if (trying.on_border || trying.camera.width != 97) continue;
        CameraFrame frame = make_frame(trying.camera);
        Camera beside = trying.camera;
        beside.target = beside.target + 0.5 * length(beside.target - beside.eye) * vec_cast<double>(frame.du);
        ++tried;
        found += differing(picture(scene.view(), trying.camera, Tracer::Scalar, {}, 0.5f),
                           picture(scene.view(), beside, Tracer::Scalar, {}, 0.5f)) > 2u + 97 * 61 / 1000;
    }
    EXPECT_GT(found, tried / 2);
}

INSTANTIATE_TEST_SUITE_P(Sets, Enfilade, testing::ValuesIn(test::instruction_sets()),
                         [](const auto& one) { return one.param.name; });
INSTANTIATE_TEST_SUITE_P(Sets, MirroringFloors, testing::ValuesIn(test::instruction_sets()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace enfilade::render
