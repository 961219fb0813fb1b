// Streams on a device are answered as by the scalar tracer.
#include "render/cuda/streams.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "tests/render/cuda/stream_table.h"
#include "tests/support/degenerate_rays.h"
#include "tests/support/devices.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"
#include "tools/random_rays.h"

namespace enfilade::render::cuda {
namespace {

class DeviceStreams : public test::DeviceTest {};
ENFILADE_ON_DEVICES(DeviceStreams);

accel::Scene office() {
    return accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2, .turn = 0.3}));
}

/// Of every family, some of them with limits.
test::RayTable many_rays(const accel::SceneView& scene, std::size_t of_each) {
    tools::RandomRays random(scene, 7);
    std::vector<RayQuery> rays;
    for (const tools::RayFamily family : tools::ray_families)
        for (const RayQuery& ray : random.take(of_each, family)) rays.push_back(ray);
    for (const test::Degenerate family : test::degenerate_families)
        for (const RayQuery& ray : test::degenerate_rays(scene, family, of_each / 8, 3)) rays.push_back(ray);
    return test::RayTable(rays);
}

TEST_P(DeviceStreams, FindTheFacesThatTheScalarTracerFinds) {
    const accel::Scene scene = office();
    const test::RayTable rays = many_rays(scene.view(), 4000);
    DeviceStream stream(device(), scene.view());
    const test::Answers expected = test::scalar_answers(scene.view(), rays);
    test::expect_same(device(), expected, test::RaysOnDevice(device(), rays).ask(stream));
    std::size_t of_status[5] = {};
    for (const WalkStatus status : expected.status) ++of_status[static_cast<std::size_t>(status)];
    EXPECT_GT(of_status[0], 15'000u);
    EXPECT_GT(of_status[1], 100u);
    EXPECT_GT(of_status[3], 100u);
}

TEST_P(DeviceStreams, SeeWhatTheScalarTracerSees) {
    const accel::Scene scene = office();
    const test::SegmentTable segments = test::segments_between(many_rays(scene.view(), 4000));
    DeviceStream stream(device(), scene.view());
    for (const bool cells_known : {false, true})
        test::expect_same(device(), segments.scalar_answers(scene.view(), cells_known),
                          segments.ask(device(), stream, cells_known));
}

TEST_P(DeviceStreams, MeetWhatStandsInRooms) {
    const accel::Scene scene = test::furnished_office({.seed = 3, .turn = 0.4});
    const accel::SerialExecutor one;
    const test::RayTable rays = many_rays(scene.view(), 1500);
    const test::SegmentTable segments = test::segments_between(rays);
    test::Answers expected;
    for (const InsideKind inside : {InsideKind::Octree, InsideKind::Bvh}) {
        const auto kind = inside == InsideKind::Octree ? ObjectAccelKind::Octree : ObjectAccelKind::Plain;
        const std::unique_ptr<ObjectAccel> accel = build_object_accel(scene.view(), kind, one);
        const ObjectTracer tracer = accel->tracer();
        DeviceStreamOptions options;
        options.inside = inside;
        DeviceStream stream(device(), scene.view(), options);
        expected = test::scalar_answers(scene.view(), rays, &tracer);
        test::expect_same(device(), expected, test::RaysOnDevice(device(), rays).ask(stream));
        test::expect_same(device(), segments.scalar_answers(scene.view(), true, &tracer),
                          segments.ask(device(), stream, true));
    }
    std::size_t objects = 0;
    for (const WalkStatus status : expected.status) objects += status == WalkStatus::Object ? 1 : 0;
    EXPECT_GT(objects, 500u);
}

TEST_P(DeviceStreams, LeaveOutColumnsThatAreNotWanted) {
    const accel::Scene scene = office();
    const test::RayTable rays = many_rays(scene.view(), 100);
    DeviceStream stream(device(), scene.view());
    const test::RaysOnDevice there(device(), rays);
    test::Buffer<float> distance(device(), rays.size());
    stream.nearest(there.rays(), {.distance = distance.data()});
    const std::vector<float> alone = distance.read();
    EXPECT_EQ(std::memcmp(alone.data(), there.ask(stream).distance.data(), alone.size() * sizeof(float)), 0);
    stream.nearest(there.rays(), {});
}

TEST_P(DeviceStreams, MayBeEmptyOrOfOddLength) {
    const accel::Scene scene = office();
    DeviceStream stream(device(), scene.view());
    for (const std::size_t count : {0u, 1u, 31u, 32u, 33u, 97u}) {
        tools::RandomRays random(scene.view(), count);
        const test::RayTable rays(random.take(count));
        test::expect_same(device(), test::scalar_answers(scene.view(), rays),
                          test::RaysOnDevice(device(), rays).ask(stream));
    }
}

}  // namespace
}  // namespace enfilade::render::cuda
