// Orders, schedules and layouts of streams change nothing but how long they take.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "accel/assemble.h"
#include "base/error.h"
#include "tests/render/cuda/stream_table.h"
#include "tests/support/degenerate_rays.h"
#include "tests/support/devices.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"
#include "tools/random_rays.h"

namespace enfilade::render::cuda {
namespace {

class StreamVariants : public test::DeviceTest {};
ENFILADE_ON_DEVICES(StreamVariants);

constexpr RayOrder orders[] = {RayOrder::AsGiven, RayOrder::Morton, RayOrder::ByCell};
constexpr StreamSchedule schedules[] = {StreamSchedule::Whole, StreamSchedule::Deferred, StreamSchedule::Persistent,
                                        StreamSchedule::Compacted};
constexpr SectionLayout layouts[] = {SectionLayout::Columns, SectionLayout::Points, SectionLayout::Pairs};

std::string text_of(const DeviceStreamOptions& options) {
    return "order " + std::to_string(int(options.order)) + ", schedule " + std::to_string(int(options.schedule)) +
           ", layout " + std::to_string(int(options.layout)) + ", refill " + std::to_string(options.refill) +
           ", at once " + std::to_string(options.rays_at_once);
}

/// All combinations, with some sizes of parts and of refills.
std::vector<DeviceStreamOptions> variants(std::optional<InsideKind> inside = {}) {
    std::vector<DeviceStreamOptions> all;
    for (const RayOrder order : orders)
        for (const StreamSchedule schedule : schedules)
            for (const SectionLayout layout : layouts) {
                if (schedule == StreamSchedule::Whole && layout != SectionLayout::Columns) continue;
                DeviceStreamOptions options;
                options.inside = inside;
                options.order = order;
                options.schedule = schedule;
                options.layout = layout;
                constexpr int refills[] = {1, 12, 32};
                options.refill = refills[all.size() % 3];
                options.sorts_questions = all.size() % 2 == 0;
                if (all.size() % 4 == 1) options.rays_at_once = 1001;
                all.push_back(options);
            }
    return all;
}

/// Of every family, those that nobody can answer and those that leave by no side among them; limited and not.
test::RayTable tried_rays(const accel::SceneView& scene, std::size_t of_each, bool are_limited) {
    tools::RandomRays random(scene, 9);
    std::vector<RayQuery> rays;
    for (const tools::RayFamily family : tools::ray_families)
        for (const RayQuery& ray : random.take(of_each, family)) rays.push_back(ray);
    for (const test::Degenerate family : test::degenerate_families)
        if (are_limited || family != test::Degenerate::Limited)
            for (const RayQuery& ray : test::degenerate_rays(scene, family, of_each / 4, 5)) rays.push_back(ray);
    if (!are_limited)
        for (RayQuery& ray : rays) ray.max_distance = std::numeric_limits<double>::infinity();
    return test::RayTable(rays);
}

TEST_P(StreamVariants, AnswerAlikeInBareRooms) {
    const accel::Scene scene =
        accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2, .turn = 0.3}));
    for (const bool are_limited : {false, true}) {
        const test::RayTable rays = tried_rays(scene.view(), 400, are_limited);
        ASSERT_EQ(rays.max_distance.empty(), !are_limited);
        const test::SegmentTable segments = test::segments_between(rays);
        const test::Answers expected = test::scalar_answers(scene.view(), rays);
        const std::vector<std::uint8_t> seen = segments.scalar_answers(scene.view(), are_limited);
        for (const DeviceStreamOptions& options : variants()) {
            SCOPED_TRACE(text_of(options));
            DeviceStream stream(device(), scene.view(), options);
            test::expect_same(device(), expected, test::RaysOnDevice(device(), rays).ask(stream));
            test::expect_same(device(), seen, segments.ask(device(), stream, are_limited));
        }
    }
}

TEST_P(StreamVariants, AnswerAlikeInFurnishedRooms) {
    const accel::Scene scene = test::furnished_office({.seed = 11, .objects = 90, .turn = 0.2});
    const accel::SerialExecutor one;
    for (const InsideKind inside : {InsideKind::Octree, InsideKind::Bvh}) {
        const auto kind = inside == InsideKind::Octree ? ObjectAccelKind::Octree : ObjectAccelKind::Plain;
        const std::unique_ptr<ObjectAccel> accel = build_object_accel(scene.view(), kind, one);
        const ObjectTracer tracer = accel->tracer();
        for (const bool are_limited : {false, true}) {
            const test::RayTable rays = tried_rays(scene.view(), 250, are_limited);
            const test::SegmentTable segments = test::segments_between(rays);
            const test::Answers expected = test::scalar_answers(scene.view(), rays, &tracer);
            const std::vector<std::uint8_t> seen = segments.scalar_answers(scene.view(), are_limited, &tracer);
            for (const DeviceStreamOptions& options : variants(inside)) {
                SCOPED_TRACE(text_of(options));
                DeviceStream stream(device(), scene.view(), options);
                test::expect_same(device(), expected, test::RaysOnDevice(device(), rays).ask(stream));
                test::expect_same(device(), seen, segments.ask(device(), stream, are_limited));
            }
            EXPECT_GT(std::count(expected.status.begin(), expected.status.end(), WalkStatus::Object), 100);
        }
    }
}

/// A scene whose cells have forgotten every third object that they share a place with.
class ForgetfulScene {
public:
    explicit ForgetfulScene(const accel::SceneView& scene) : view_(scene) {
        for (std::size_t cell = 0; cell < scene.cells.size(); ++cell) {
            offsets_.push_back(static_cast<std::uint32_t>(objects_.size()));
            for (std::uint32_t k = scene.cell_object_offsets[cell]; k < scene.cell_object_offsets[cell + 1]; ++k)
                if ((cell + k) % 3 != 0) objects_.push_back(scene.cell_objects[k]);
        }
        offsets_.push_back(static_cast<std::uint32_t>(objects_.size()));
        view_.cell_object_offsets = {offsets_.data(), offsets_.size()};
        view_.cell_objects = {objects_.data(), objects_.size()};
    }
    [[nodiscard]] const accel::SceneView& view() const { return view_; }

private:
    accel::SceneView view_;
    std::vector<std::uint32_t> offsets_;
    std::vector<accel::ObjectId> objects_;
};

TEST_P(StreamVariants, CutObjectsOffWhereCellsDoNotListThem) {
    const accel::Scene whole = test::furnished_office({.seed = 21, .objects = 150, .turn = 0.1});
    const ForgetfulScene scene(whole.view());
    const accel::SerialExecutor one;
    const std::unique_ptr<ObjectAccel> accel = build_object_accel(scene.view(), ObjectAccelKind::Plain, one);
    const ObjectTracer tracer = accel->tracer();
    const test::RayTable rays = tried_rays(scene.view(), 1500, false);
    const test::Answers expected = test::scalar_answers(scene.view(), rays, &tracer);
    EXPECT_GT(test::count_differing(expected, test::scalar_answers(whole.view(), rays, &tracer)), 100u);
    for (const StreamSchedule schedule : schedules) {
        DeviceStreamOptions options;
        options.inside = InsideKind::Bvh;
        options.schedule = schedule;
        DeviceStream stream(device(), scene.view(), options);
        test::expect_same(device(), expected, test::RaysOnDevice(device(), rays).ask(stream));
    }
}

TEST_P(StreamVariants, AnswerPartsOfOneRayEach) {
    const accel::Scene scene = test::furnished_office({.seed = 4});
    const accel::SerialExecutor one;
    const std::unique_ptr<ObjectAccel> accel = build_object_accel(scene.view(), ObjectAccelKind::Plain, one);
    const ObjectTracer tracer = accel->tracer();
    const test::RayTable rays = tried_rays(scene.view(), 8, true);
    DeviceStreamOptions options;
    options.inside = InsideKind::Bvh;
    options.schedule = StreamSchedule::Compacted;
    options.order = RayOrder::Morton;
    options.rays_at_once = 1;
    DeviceStream stream(device(), scene.view(), options);
    test::expect_same(device(), test::scalar_answers(scene.view(), rays, &tracer),
                      test::RaysOnDevice(device(), rays).ask(stream));
}

TEST_P(StreamVariants, MayBeEmptyOrOfOddLength) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({}));
    for (const DeviceStreamOptions& options : variants()) {
        DeviceStream stream(device(), scene.view(), options);
        for (const std::size_t count : {0u, 1u, 31u, 33u}) {
            tools::RandomRays random(scene.view(), count);
            const test::RayTable rays(random.take(count));
            test::expect_same(device(), test::scalar_answers(scene.view(), rays),
                              test::RaysOnDevice(device(), rays).ask(stream));
        }
    }
}

TEST_P(StreamVariants, WalkRoomsOfManySides) {
    // Corridors along so many doors have more lines than one question holds.
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 40, .rows = 4}));
    std::size_t most = 0;
    for (const accel::Cell& cell : scene.view().cells) most = std::max<std::size_t>(most, cell.section_count);
    ASSERT_GT(most, 64u);
    const test::RayTable rays = tried_rays(scene.view(), 300, false);
    const test::Answers expected = test::scalar_answers(scene.view(), rays);
    for (const SectionLayout layout : layouts) {
        DeviceStreamOptions options;
        options.layout = layout;
        DeviceStream stream(device(), scene.view(), options);
        test::expect_same(device(), expected, test::RaysOnDevice(device(), rays).ask(stream));
    }
}

TEST_P(StreamVariants, RefuseOptionsOutOfRange) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({}));
    for (const int refill : {0, 33}) {
        DeviceStreamOptions options;
        options.refill = refill;
        EXPECT_THROW(DeviceStream(device(), scene.view(), options), InputError);
    }
    DeviceStreamOptions options;
    options.rays_at_once = 0;
    EXPECT_THROW(DeviceStream(device(), scene.view(), options), InputError);
}

}  // namespace
}  // namespace enfilade::render::cuda
