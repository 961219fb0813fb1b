// All tracers in buildings with curved walls, slanted ones and other people's: pictures and streams against the scalar
// tracer and the oracle.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>

#include "accel/assemble.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/building_scenes.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/picture_judge.h"
#include "tests/support/random_plan.h"
#include "tests/support/stream_judge.h"
#include "tests/support/tracer_variants.h"
#include "tests/support/trying_cameras.h"
#include "tools/random_rays.h"

namespace enfilade::render {
namespace {

using test::PictureVerdict;
using test::TracerVariant;
using test::TryingCamera;

Image picture(const accel::SceneView& scene, const Camera& camera, Tracer tracer, PacketSizes packets) {
    const accel::SerialExecutor here;
    TraceOptions options;
    options.tracer = tracer;
    options.packets = packets;
    options.shading = Shading::Lambert;
    options.executor = &here;
    return trace(scene, camera, options);
}

std::string where(const TryingCamera& trying, const char* variant) {
    return std::string(variant) + ", camera " + trying.name + ", " +
           test::text_of(make_frame(trying.camera), trying.camera.width, trying.camera.height) + ": ";
}

/// Pictures of cameras everywhere, of every variant.
PictureVerdict pictures(const accel::SceneView& view, std::uint64_t seed, std::size_t step, std::string& places) {
    const test::PictureJudge judge(view);
    PictureVerdict all;
    const std::vector<TryingCamera> cameras = test::trying_cameras(view, seed);
    for (std::size_t c = seed % step; c < cameras.size(); c += step) {
        const CameraFrame frame = make_frame(cameras[c].camera);
        const Image expected = picture(view, cameras[c].camera, Tracer::Scalar, {});
        for (const TracerVariant& variant : test::tracer_variants) {
            const PictureVerdict verdict =
                judge.compare(frame, start_cell(view, frame), expected,
                              picture(view, cameras[c].camera, variant.tracer, variant.packets));
            if (!verdict.is_right()) places += where(cameras[c], variant.name) + verdict.text() + "\n";
            all.add(verdict);
        }
    }
    return all;
}

class InBuildings : public ::testing::TestWithParam<test::BuildingScene> {
protected:
    InBuildings() {
        try {
            input_ = test::scene_of(GetParam());
        } catch (const InputError&) {
        }
    }
    void SetUp() override {
        if (!input_) GTEST_SKIP() << "this plan is refused";
    }

    std::optional<accel::SceneInput> input_;
};

TEST_P(InBuildings, PicturesAgreeWithTheScalarTracers) {
    const accel::Scene scene = accel::assemble(test::with_own_colours(*input_));
    std::string places;
    const PictureVerdict verdict = pictures(scene.view(), 61, 1, places);
    EXPECT_TRUE(verdict.is_right()) << places;
    RecordProperty("pixels", static_cast<int>(verdict.pixels));
    RecordProperty("inside_band", static_cast<int>(verdict.inside_band));
}

TEST_P(InBuildings, PicturesAgreeWithTheOracles) {
    const accel::Scene scene = accel::assemble(test::with_clear_panes(test::with_own_colours(*input_)));
    const accel::SceneView& view = scene.view();
    const test::PictureJudge judge(view);
    const std::vector<TryingCamera> cameras = test::trying_cameras(view, 62);
    for (std::size_t c = 0; c < cameras.size(); c += 3) {
        TryingCamera trying = cameras[c];
        if (trying.on_border) continue;
        trying.camera.width = std::min(trying.camera.width, 25);
        trying.camera.height = std::min(trying.camera.height, 25);
        const CameraFrame frame = make_frame(trying.camera);
        const Image expected = trace_by_oracle(view, trying.camera);
        for (const TracerVariant& variant : test::tracer_variants) {
            if (variant.packets.largest > 64) continue;
            const PictureVerdict verdict = judge.compare(frame, start_cell(view, frame), expected,
                                                         picture(view, trying.camera, variant.tracer, variant.packets));
            EXPECT_EQ(verdict.outside_band + verdict.leaks, 0u) << where(trying, variant.name) << verdict.text();
        }
    }
}

TEST_P(InBuildings, StreamsAgreeWithTheScalarWalkAndTheOracle) {
    const accel::Scene scene = accel::assemble(*input_);
    const test::StreamJudge judge(scene.view());
    for (const tools::RayFamily family : tools::ray_families) {
        const std::vector<RayQuery> rays = tools::RandomRays(scene.view(), 63).take(4000, family);
        std::vector<RayHit> expected(rays.size());
        trace_rays(scene.view(), rays, expected);
        test::RayTable table(rays);
        for (const Tracer tracer : {Tracer::Simd, Tracer::Packet}) {
            table.trace(scene.view(), {.tracer = tracer, .order = StreamOrder::Any});
            const test::StreamVerdict verdict = judge.compare(rays, expected, table);
            EXPECT_TRUE(verdict.is_right()) << tools::name_of(family) << verdict.text();
        }
        if (family != tools::RayFamily::Random) continue;
        for (std::size_t i = 0; i < rays.size(); ++i) expected[i].source_face = table.source_face[i];
        const Agreement agreement = compare(judge.oracle(), rays, expected, judge.band());
        EXPECT_EQ(agreement.differing_outside_band, 0u);
        EXPECT_LE(agreement.differing_inside_band, 40u);
    }
}

/// The cells that the line of a ray crosses, from end to end, and whether rounding had a say in it.
template <class T>
std::pair<std::vector<std::uint32_t>, bool> whole_line(const accel::SceneView& view, const Ray<T>& ray,
                                                       std::uint32_t cell) {
    const auto back = test::follow(view, make_ray_unchecked(ray.origin, -ray.direction), cell);
    const auto forth = test::follow(view, ray, back.end.cell);
    EXPECT_EQ(forth.end.status, WalkStatus::Hit);
    return {forth.path.cells, back.path.several + back.path.none + forth.path.several + forth.path.none > 0};
}

TEST_P(InBuildings, ReversedRaysCrossReversedCells) {
    const accel::Scene scene = accel::assemble(*input_);
    const accel::SceneView& view = scene.view();
    for (const tools::RayFamily family : tools::ray_families) {
        int compared = 0;
        for (const RayQuery& query : tools::RandomRays(view, 64).take(1000, family)) {
            Ray<double> ray;
            ASSERT_TRUE(make_ray(query.origin, query.direction, ray));
            const auto [forth, doubtful] = whole_line(view, ray, static_cast<std::uint32_t>(query.cell));
            if (doubtful) continue;  // along a side that is bent by a grid unit there are two ways
            auto [back, doubtful_back] =
                whole_line(view, make_ray_unchecked(ray.origin, -ray.direction), forth.front());
            if (doubtful_back) continue;
            std::ranges::reverse(back);
            EXPECT_EQ(back, forth) << tools::name_of(family) << ": " << test::text_of(query);
            ++compared;
        }
        EXPECT_GT(compared, 300) << tools::name_of(family);
    }
}

INSTANTIATE_TEST_SUITE_P(Plans, InBuildings, ::testing::ValuesIn(test::building_scenes()),
                         [](const auto& building) { return building.param.name; });

// Walls that cross at any angle, are curved and thinner than a hair: cells of every shape.
RC_GTEST_PROP(InRandomPlans, AllTracersAgree, ()) {
    const plans::Plan plan = enfilade::testing::any_plan();
    RC_LOG() << plans::write_json(plan) << "\n";
    accel::SceneInput input;
    try {
        input = modeler::scene_input(modeler::convexify(modeler::build(plan)));
    } catch (const InputError&) {
        RC_TAG("refused");
        return;
    }
    const accel::Scene scene = accel::assemble(test::with_own_colours(input));
    std::string places;
    (void)pictures(scene.view(), *rc::gen::inRange<std::uint64_t>(0, 1000000), 10, places);
    RC_ASSERT(places == "");
}

}  // namespace
}  // namespace enfilade::render
