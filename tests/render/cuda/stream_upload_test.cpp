// Streams that travel to a device part by part are answered as render::nearest and render::visible answer them.
#include "render/cuda/streams_upload.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "base/error.h"
#include "tests/render/cuda/stream_table.h"
#include "tests/support/degenerate_rays.h"
#include "tests/support/devices.h"
#include "tests/support/synthetic_scene.h"
#include "tools/random_rays.h"

namespace enfilade::render::cuda {
namespace {

class UploadedStreams : public test::DeviceTest {};
ENFILADE_ON_DEVICES(UploadedStreams);

test::RayTable rays_of(const accel::SceneView& scene, std::size_t count, bool are_limited) {
    tools::RandomRays random(scene, 12);
    std::vector<RayQuery> rays = random.take(count);
    if (are_limited)
        for (const RayQuery& ray : test::degenerate_rays(scene, test::Degenerate::Limited, 500, 2)) rays.push_back(ray);
    return test::RayTable(rays);
}

TEST_P(UploadedStreams, AreAnsweredWhateverTheirParts) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2}));
    DeviceStream stream(device(), scene.view());
    for (const bool are_limited : {false, true}) {
        const test::RayTable rays = rays_of(scene.view(), 2500, are_limited);
        const test::SegmentTable segments = test::segments_between(rays);
        const test::Answers expected = test::scalar_answers(scene.view(), rays);
        const std::vector<std::uint8_t> seen = segments.scalar_answers(scene.view(), are_limited);
        for (const std::uint32_t part : {100u, 1024u, 1u << 20}) {
            UploadedStream uploaded(device(), stream, part);
            test::Answers actual = test::Answers::of(rays.size());
            uploaded.nearest(rays.columns(), actual.columns());
            test::expect_same(device(), expected, actual);
            std::vector<std::uint8_t> visible(segments.size(), 77);
            uploaded.visible(segments.columns(are_limited), visible);
            test::expect_same(device(), seen, visible);
        }
    }
}

TEST_P(UploadedStreams, WriteTheColumnsThatAreWanted) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({}));
    DeviceStream stream(device(), scene.view());
    const test::RayTable rays = rays_of(scene.view(), 700, false);
    const test::Answers expected = test::scalar_answers(scene.view(), rays);
    UploadedStream uploaded(device(), stream, 64);
    std::vector<accel::SourceFaceId> faces(rays.size());
    HitColumns columns;
    columns.source_face = faces;
    uploaded.nearest(rays.columns(), columns);
    EXPECT_EQ(faces, expected.source_face);
}

TEST_P(UploadedStreams, MayBeEmptyAndMayGrow) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({}));
    DeviceStream stream(device(), scene.view());
    UploadedStream uploaded(device(), stream);
    for (const std::size_t count : {0u, 1u, 500u, 33u, 2000u}) {
        const test::RayTable rays = rays_of(scene.view(), count, false);
        test::Answers actual = test::Answers::of(rays.size());
        uploaded.nearest(rays.columns(), actual.columns());
        test::expect_same(device(), test::scalar_answers(scene.view(), rays), actual);
    }
    EXPECT_THROW(UploadedStream(device(), stream, 0), InputError);
}

}  // namespace
}  // namespace enfilade::render::cuda
