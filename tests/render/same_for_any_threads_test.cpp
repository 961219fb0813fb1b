// Whatever the number of threads, and whichever columns are asked for, answers are the same bit for bit.
#include <gtest/gtest.h>

#include <cstring>

#include "accel/assemble.h"
#include "render/executor.h"
#include "render/ray_stream.h"
#include "render/trace.h"
#include "tests/support/degenerate_rays.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/ray_table.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/tracer_variants.h"
#include "tests/support/trying_cameras.h"
#include "tools/random_rays.h"

namespace enfilade::render {
namespace {

class SameForAnyThreads : public testing::TestWithParam<test::InstructionSet> {
protected:
    SameForAnyThreads()
        : set_(GetParam()),
          scene_(accel::assemble(test::synthetic_office({.rooms_per_row = 6, .rows = 4, .storeys = 2, .turn = 0.3}))) {}

    test::UsingInstructionSet set_;
    accel::Scene scene_;
    accel::SerialExecutor one_;
    accel::ThreadExecutor four_{4};
};

TEST_P(SameForAnyThreads, ArePicturesOfAllTracers) {
    const std::unique_ptr<accel::Executor> best = make_executor();
    for (const test::TryingCamera& trying : test::trying_cameras(scene_.view(), 41)) {
        if (trying.camera.width < 90) continue;
        Camera camera = trying.camera;
        camera.width = 301;
        camera.height = 203;
        for (const test::TracerVariant& variant : test::tracer_variants) {
            if (variant.packets.largest > 64) continue;
            TraceOptions options;
            options.tracer = variant.tracer;
            options.packets = variant.packets;
            options.shading = Shading::Lambert;
            options.executor = &one_;
            const Image expected = trace(scene_.view(), camera, options);
            RayStats stats;
            options.stats = &stats;
            const accel::Executor* const many[] = {&four_, best.get()};
            for (const accel::Executor* executor : many) {
                options.executor = executor;
                ASSERT_EQ(trace(scene_.view(), camera, options), expected) << variant.name << ", " << trying.name;
            }
        }
        if (trying.name == "at a corner") break;
    }
}

bool are_same(const test::RayTable& a, const test::RayTable& b) {
    return std::memcmp(a.distance.data(), b.distance.data(), a.size() * sizeof(float)) == 0 &&
           a.source_face == b.source_face && a.cell == b.cell && a.status == b.status;
}

std::vector<RayQuery> mixed_rays(const accel::SceneView& scene) {
    std::vector<RayQuery> rays = tools::RandomRays(scene, 42).take(30000);
    for (const test::Degenerate family : test::degenerate_families)
        for (const RayQuery& ray : test::degenerate_rays(scene, family, 1000, 43)) rays.push_back(ray);
    return rays;
}

TEST_P(SameForAnyThreads, AreAnswersToStreams) {
    const std::vector<RayQuery> rays = mixed_rays(scene_.view());
    for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet})
        for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any}) {
            StreamOptions options = {.tracer = tracer, .order = order};
            test::RayTable expected(rays), table(rays);
            expected.trace(scene_.view(), options);
            RayStats one, four;
            options.stats = &one;
            options.executor = &one_;
            table.trace(scene_.view(), options);
            EXPECT_TRUE(are_same(expected, table));
            options.stats = &four;
            options.executor = &four_;
            table.trace(scene_.view(), options);
            EXPECT_TRUE(are_same(expected, table));
            EXPECT_EQ(one.cells, four.cells);
            EXPECT_EQ(one.rays, four.rays);
        }
}

// Also in the middle of a batch of sixteen, and without limits.
TEST_P(SameForAnyThreads, AreAnswersWhereColumnsAreLeftOut) {
    for (const bool is_limited : {false, true}) {
        const std::vector<RayQuery> rays =
            is_limited ? mixed_rays(scene_.view()) : tools::RandomRays(scene_.view(), 44).take(5001);
        for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet})
            for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any}) {
                const StreamOptions options = {.tracer = tracer, .order = order};
                test::RayTable all(rays);
                all.trace(scene_.view(), options);
                for (unsigned mask = 0; mask < 16; ++mask) {
                    test::RayTable some(rays);
                    some.distance.assign(rays.size(), -1);
                    some.source_face.assign(rays.size(), {});
                    some.cell.assign(rays.size(), {});
                    some.status.assign(rays.size(), {});
                    HitColumns hits;
                    if ((mask & 1u) != 0) hits.distance = some.distance;
                    if ((mask & 2u) != 0) hits.source_face = some.source_face;
                    if ((mask & 4u) != 0) hits.cell = some.cell;
                    if ((mask & 8u) != 0) hits.status = some.status;
                    nearest(scene_.view(), some.columns(), hits, options);
                    if ((mask & 1u) == 0) some.distance = all.distance;
                    if ((mask & 2u) == 0) some.source_face = all.source_face;
                    if ((mask & 4u) == 0) some.cell = all.cell;
                    if ((mask & 8u) == 0) some.status = all.status;
                    EXPECT_TRUE(are_same(all, some)) << "tracer " << int(tracer) << ", columns " << mask;
                }
            }
    }
}

// Sanitizers see what is written beyond; here a fence does.
TEST_P(SameForAnyThreads, NothingIsWrittenBeyondTheColumns) {
    const std::vector<RayQuery> rays = tools::RandomRays(scene_.view(), 45).take(64);
    for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet})
        for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any})
            for (std::size_t count = 0; count <= 40; ++count) {
                test::RayTable table({rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(count)});
                std::vector<float> distance(count + 32, -3);
                std::vector<accel::SourceFaceId> face(count + 32, accel::SourceFaceId{5});
                nearest(scene_.view(), table.columns(),
                        {.distance = {distance.data(), count}, .source_face = {face.data(), count}},
                        {.tracer = tracer, .order = order});
                for (std::size_t i = count; i < count + 32; ++i) {
                    ASSERT_EQ(distance[i], -3);
                    ASSERT_EQ(face[i], accel::SourceFaceId{5});
                }
            }
}

INSTANTIATE_TEST_SUITE_P(Sets, SameForAnyThreads, testing::ValuesIn(test::instruction_sets()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace enfilade::render
