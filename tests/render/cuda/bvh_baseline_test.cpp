// Baselines answer what the walk answers, however their rays are scheduled: else they are nothing to compare with.
#include "render/cuda/bvh_baseline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "accel/assemble.h"
#include "accel/lights/light_trees.h"
#include "render/trace.h"
#include "tests/render/cuda/stream_table.h"
#include "tests/support/bvh_scenes.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/devices.h"
#include "tests/support/lit_office.h"
#include "tests/support/picture_judge.h"
#include "tests/support/stream_judge.h"
#include "tests/support/trying_cameras.h"
#include "tools/random_rays.h"

namespace enfilade::render::cuda {
namespace {

/// Both trees, each with a thread a ray and with persistent threads.
std::vector<BvhBaselineOptions> all_ways() {
    std::vector<BvhBaselineOptions> ways;
    for (const BvhKind kind : {BvhKind::Binary, BvhKind::Wide})
        for (const bool is_persistent : {false, true})
            ways.push_back({.kind = kind, .schedule = {.is_persistent = is_persistent}});
    return ways;
}

std::string text(const BvhBaselineOptions& way) {
    return std::string(way.kind == BvhKind::Wide ? "wide" : "binary") +
           (way.test == TriangleTest::Watertight ? ", watertight" : "") +
           (way.schedule.is_persistent ? ", persistent" : ", a thread a ray");
}

class BvhBaselines : public test::DeviceTest {
protected:
    accel::SerialExecutor one_;
};
ENFILADE_ON_DEVICES(BvhBaselines);

TEST_P(BvhBaselines, DrawTheFacesThatTheScalarTracerShows) {
    const accel::Scene scene = accel::assemble(test::with_own_colours(
        test::with_clear_panes(test::synthetic_office({.rooms_per_row = 4, .storeys = 2, .turn = 0.3}))));
    const test::PictureJudge judge(scene.view());
    std::vector<BvhBaselineOptions> ways = all_ways();
    for (const BvhKind kind : {BvhKind::Binary, BvhKind::Wide})
        ways.push_back({.kind = kind, .test = TriangleTest::Watertight});
    const std::vector<test::TryingCamera> cameras = test::trying_cameras(scene.view(), 3);
    for (const BvhBaselineOptions& way : ways) {
        BvhBaseline baseline(device(), scene.view(), way, one_);
        test::PictureVerdict verdict;
        Framebuffer actual;
        for (std::size_t k = 0; k < cameras.size(); k += 2) {
            const test::TryingCamera& trying = cameras[k];
            // On a border of cells the walk starts in one of them; trees know no borders.
            if (trying.on_border) continue;
            const CameraFrame frame = make_frame(trying.camera);
            const accel::CellId start = start_cell(scene.view(), frame);
            Framebuffer expected(trying.camera.width, trying.camera.height);
            trace_lambert(scene.view(), frame, start, {.tracer = Tracer::Scalar}, one_, expected);
            baseline.draw(frame, trying.camera.width, trying.camera.height);
            baseline.read(actual);
            verdict.add(judge.compare(frame, start, expected, actual));
        }
        // Rays that run exactly along an edge may be lost by the fast test.
        EXPECT_LE(verdict.leaks, way.test == TriangleTest::Fast ? 2u : 0u) << text(way) << ": " << verdict.text();
        EXPECT_EQ(verdict.outside_band + verdict.other_shade, 0u) << text(way) << ": " << verdict.text();
        EXPECT_GT(verdict.pixels, 50'000u);
    }
}

/// What a pixel shows by trying every triangle, in double.
class PixelTruth {
public:
    explicit PixelTruth(const accel::SceneView& view) : view_(view), tried_(view) {}

    [[nodiscard]] Vec3d roots(const CameraFrame& frame, int x, int y) const {
        const Vec3f d = frame.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const test::BvhTruth met = test::try_all(tried_, {frame.origin, d, 0, 3e38f, no_object});
        if (met.item == ~0u) return {1, 0, 1};
        const SceneTriangle& t = tried_.scene.triangles[met.item];
        const Vec3d a = place(met.instance, t.a), b = place(met.instance, t.b), c = place(met.instance, t.c);
        const double cosine = std::abs(dot(normalized(cross(b - a, c - a)), normalized(vec_cast<double>(d))));
        accel::MaterialId material;
        if (met.instance == no_object) {
            const accel::SourceFace& face =
                view_.source_faces[tried_.scene.looks[met.item].source_face & ~detail::sky_bit];
            if (face.surface == accel::Surface::Sky) return sky(d);
            material = face.material;
        } else {
            const std::uint32_t triangle = met.item - tried_.scene.mesh_first[tried_.scene.mesh_of[met.instance]];
            material = static_cast<accel::MaterialId>(object_material(view_, met.instance, triangle));
        }
        const auto& colour = view_.materials[index(material)].colour;
        return {std::sqrt(colour[0] * cosine), std::sqrt(colour[1] * cosine), std::sqrt(colour[2] * cosine)};
    }

private:
    static Vec3d sky(Vec3f d) {
        const Vec3f colour = sky_colour(lambert_look({}), d);
        return {std::sqrt(colour.x), std::sqrt(colour.y), std::sqrt(colour.z)};
    }
    [[nodiscard]] Vec3d place(std::uint32_t instance, const accel::Vertex& v) const {
        if (instance == no_object) return {v.x, v.y, v.z};
        const auto& m = view_.objects[instance].scene_from_object.rows;
        const auto row = [&](std::size_t r) { return m[r] * v.x + m[r + 1] * v.y + m[r + 2] * v.z + m[r + 3]; };
        return {row(0), row(4), row(8)};
    }
    const accel::SceneView& view_;
    test::TriedForest tried_;
};

TEST_P(BvhBaselines, ShadeFacesAndObjectsAsTheyAre) {
    const accel::Scene scene = test::furnished_office({.seed = 5, .objects = 60, .turn = 0.3});
    const PixelTruth truth(scene.view());
    constexpr int width = 45, height = 30;  // of no tile's size
    Camera camera;
    camera.eye = {6, 4, 1.6};
    camera.target = {9, 7, 1.0};
    camera.width = width;
    camera.height = height;
    const CameraFrame frame = make_frame(camera);
    std::vector<Vec3d> expected;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) expected.push_back(truth.roots(frame, x, y));
    for (const BvhBaselineOptions& way : all_ways()) {
        BvhBaseline baseline(device(), scene.view(), way, one_);
        baseline.draw(frame, width, height);
        Framebuffer actual;
        baseline.read(actual);
        int wrong = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const std::uint32_t pixel = actual.rgba[i];
            const double channels[] = {expected[i].x, expected[i].y, expected[i].z};
            for (unsigned k = 0; k < 3; ++k)
                if (std::abs(255 * std::min(channels[k], 1.0) - static_cast<double>(pixel >> (8 * k) & 255)) > 1.01) {
                    ++wrong;
                    break;
                }
        }
        EXPECT_LE(wrong, 2) << text(way);
    }
}

/// Of every family.
test::RayTable many_rays(const accel::SceneView& scene, std::size_t of_each, std::vector<RayQuery>& rays) {
    tools::RandomRays random(scene, 7);
    for (const tools::RayFamily family :
         {tools::RayFamily::Random, tools::RayFamily::AxisParallel, tools::RayFamily::Level})
        for (RayQuery ray : random.take(of_each, family)) {
            if (rays.size() % 3 == 1) ray.max_distance = 2.5;
            if (rays.size() % 97 == 5) ray.direction = {0, 0, 0};
            rays.push_back(ray);
        }
    return test::RayTable(rays);
}

TEST_P(BvhBaselines, AnswerStreamsAsTheScalarTracer) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .turn = 0.3}));
    const test::StreamJudge judge(scene.view());
    std::vector<RayQuery> queries;
    const test::RayTable rays = many_rays(scene.view(), 3000, queries);
    const test::Answers expected = test::scalar_answers(scene.view(), rays);
    for (const BvhBaselineOptions& way : all_ways()) {
        BvhBaseline baseline(device(), scene.view(), way, one_);
        const test::Answers actual = test::RaysOnDevice(device(), rays).ask(baseline);
        std::size_t wrong = 0, doubtful = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool both_nan = std::isnan(expected.distance[i]) && std::isnan(actual.distance[i]);
            if (expected.status[i] == actual.status[i] && expected.source_face[i] == actual.source_face[i] &&
                (both_nan || std::abs(expected.distance[i] - actual.distance[i]) <= 1e-4f * (1 + expected.distance[i])))
                continue;
            RayHit hit = {};
            hit.status = expected.status[i];
            hit.source_face = expected.source_face[i];
            hit.distance = double{expected.distance[i]};
            ++(judge.is_doubtful(queries[i], hit) ? doubtful : wrong);
        }
        EXPECT_EQ(wrong, 0u) << text(way) << " of " << rays.size();
        EXPECT_LT(doubtful, rays.size() / 500) << text(way);
    }
}

TEST_P(BvhBaselines, SeeAlongSegmentsWhatTheScalarTracerSees) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .turn = 0.3}));
    std::vector<RayQuery> queries;
    const test::SegmentTable segments = test::segments_between(many_rays(scene.view(), 3000, queries));
    const std::vector<std::uint8_t> expected = segments.scalar_answers(scene.view(), true);
    for (const BvhBaselineOptions& way : all_ways()) {
        BvhBaseline baseline(device(), scene.view(), way, one_);
        const std::vector<std::uint8_t> actual = segments.ask(device(), baseline, true);
        std::size_t differing = 0, seen = 0;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            differing += expected[i] != actual[i] ? 1 : 0;
            seen += expected[i];
        }
        EXPECT_LE(differing, 3u) << text(way);
        EXPECT_GT(seen, 100u);
    }
}

TEST_P(BvhBaselines, OfAnyScheduleGiveTheSameToTheLastBit) {
    const accel::Scene scene = test::furnished_office({.objects = 40, .turn = 0.3});
    std::vector<RayQuery> queries;
    const test::RayTable rays = many_rays(scene.view(), 1000, queries);
    const test::RaysOnDevice there(device(), rays);
    for (const BvhKind kind : {BvhKind::Binary, BvhKind::Wide}) {
        BvhBaseline baseline(device(), scene.view(), {.kind = kind}, one_);
        const test::Answers expected = there.ask(baseline);
        for (const int fetch_below : {0, 1, 20, 32}) {
            baseline.set_schedule({.is_persistent = true, .fetch_below = fetch_below});
            const test::Answers actual = there.ask(baseline);
            // On a card, which lanes postpone records may decide between triangles in one place.
            if (device().is_card()) EXPECT_LE(test::count_differing(expected, actual), rays.size() / 1000);
            else EXPECT_EQ(test::count_differing(expected, actual), 0u) << fetch_below;
        }
    }
}

TEST_P(BvhBaselines, LightAsTheScalarTracerDoes) {
    const accel::Scene scene = test::lit_office();
    const accel::LightTrees trees = accel::build_light_trees(scene.view(), {}, one_);
    constexpr int side = 64;
    constexpr float exposure = 0.05f;
    const accel::Light& lamp = scene.view().lights[2];
    Camera camera;
    camera.eye = {lamp.position[0] - 0.5, lamp.position[1], 1.5};
    camera.target = {lamp.position[0] + 1, lamp.position[1] + 0.4, 1.2};
    camera.width = camera.height = side;
    const CameraFrame frame = make_frame(camera);
    const accel::CellId start = start_cell(scene.view(), frame);
    const Lamps lamps = {trees.view(), LampSearch::Tree, exposure};
    Framebuffer expected(side, side);
    trace_lambert(scene.view(), frame, start, {.tracer = Tracer::Scalar, .lamps = &lamps}, one_, expected);
    std::vector<std::uint32_t> cells;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            cells.push_back(static_cast<std::uint32_t>(
                trace_ray(scene.view(), {vec_cast<double>(frame.origin),
                                         vec_cast<double>(frame.direction(static_cast<float>(x) + 0.5f,
                                                                          static_cast<float>(y) + 0.5f)),
                                         start})
                    .cell));
    const Buffer<std::uint32_t> there(device(), cells);
    for (const BvhBaselineOptions& way : all_ways()) {
        BvhBaseline baseline(device(), scene.view(), way, one_);
        for (const LampLists& lists : {lamp_lists(trees.view()), all_lamps(scene.view())}) {
            baseline.set_lamps(scene.view(), lists, exposure);
            for (const bool from_lamps : {false, true}) {
                baseline.draw_lit(frame, side, side, there.data(), from_lamps);
                Framebuffer actual;
                baseline.read(actual);
                int unlike = 0;
                for (std::size_t i = 0; i < expected.rgba.size(); ++i)
                    for (unsigned shift = 0; shift < 24; shift += 8)
                        if (std::abs(static_cast<int>(expected.rgba[i] >> shift & 255) -
                                     static_cast<int>(actual.rgba[i] >> shift & 255)) > 1) {
                            ++unlike;
                            break;
                        }
                EXPECT_LE(unlike, side * side / 400) << text(way) << (from_lamps ? ", from lamps" : "");
            }
        }
    }
}

TEST_P(BvhBaselines, AnswerRaysOfOneMesh) {
    const accel::Scene scene = test::room_of_meshes({test::random_soup(10, 1, 1), test::ball_mesh(24, 1)});
    const TriangleScene alone = TriangleScene::of_mesh(scene.view(), accel::MeshId{1});
    ASSERT_EQ(alone.triangles.size(), scene.view().meshes[1].triangle_count);
    std::vector<OctreeRay> rays;
    for (const BvhQuery& q : test::rays_in({{-2, -2, -2}, {2, 2, 2}}, 9, 2000))
        rays.push_back({{q.origin.x, q.origin.y, q.origin.z}, 0, {q.direction.x, q.direction.y, q.direction.z}, q.far});
    const Buffer<OctreeRay> there(device(), rays);
    for (BvhBaselineOptions way : all_ways()) {
        way.mesh = accel::MeshId{1};
        BvhBaseline baseline(device(), scene.view(), way, one_);
        const Buffer<OctreeAnswer> answers(device(), rays.size());
        baseline.nearest(there.data(), answers.data(), rays.size());
        const std::vector<OctreeAnswer> actual = answers.read();
        int wrong = 0, hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const OctreeRay& r = rays[i];
            const auto truth =
                test::brute_nearest(scene.view(), accel::MeshId{1}, {r.origin[0], r.origin[1], r.origin[2]},
                                    {r.direction[0], r.direction[1], r.direction[2]}, 0, r.far);
            const bool is_hit = actual[i].triangle != no_triangle;
            hits += is_hit ? 1 : 0;
            if (truth && truth->margin < 1e-5) continue;
            if (is_hit != truth.has_value() || (is_hit && actual[i].triangle != truth->triangle) ||
                std::abs(double{actual[i].t} - (truth ? truth->t : double{r.far})) > 1e-4)
                ++wrong;
        }
        EXPECT_LE(wrong, 1) << text(way);
        EXPECT_GT(hits, 500);
    }
}

TEST_P(BvhBaselines, WithoutTriangleSeeNothing) {
    const accel::InputMesh no_area = test::soup({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}});
    const accel::Scene scene = test::room_of_meshes({no_area});
    const std::vector<OctreeRay> rays = {{{0, 0, -1}, 0, {0, 0, 1}, 5}};
    const Buffer<OctreeRay> there(device(), rays);
    for (BvhBaselineOptions way : all_ways()) {
        way.mesh = accel::MeshId{0};
        BvhBaseline baseline(device(), scene.view(), way, one_);
        const Buffer<OctreeAnswer> answers(device(), 1);
        baseline.nearest(there.data(), answers.data(), 1);
        EXPECT_EQ(answers.read()[0].triangle, no_triangle);
        EXPECT_EQ(answers.read()[0].t, 5);
    }
}

TEST_P(BvhBaselines, TellWhatTheyTake) {
    const accel::Scene scene = test::room_of_meshes({test::ball_mesh(64, 1)});
    const auto bytes = [&](BvhKind kind) {
        const BvhBaseline baseline(device(), scene.view(), {.kind = kind, .split_share = 0, .mesh_split_share = 0},
                                   one_);
        EXPECT_GT(baseline.bytes(), baseline.tree_bytes());
        EXPECT_EQ(baseline.record_count(), 2u * 128 * 64 - 2 * 128 + 12 + 1) << "poles have no area; room; instance";
        return static_cast<double>(baseline.tree_bytes()) / static_cast<double>(baseline.record_count());
    };
    const double binary = bytes(BvhKind::Binary), wide = bytes(BvhKind::Wide);
    RecordProperty("binary bytes a triangle", std::to_string(binary));
    RecordProperty("wide bytes a triangle", std::to_string(wide));
    EXPECT_LT(wide, 0.9 * binary) << wide << " " << binary;
    EXPECT_LT(wide, 80);
}

}  // namespace
}  // namespace enfilade::render::cuda
