// Furnished rooms: every tracer sees what the scalar one sees, however cells know their objects.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "accel/locate.h"
#include "modeler/export_scene.h"
#include "modeler/objects/put_objects.h"
#include "render/executor.h"
#include "render/ray_stream.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/furnished_judge.h"
#include "tests/support/furnished_scenes.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/picture_judge.h"
#include "tests/support/tracer_variants.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render {
namespace {

using test::FurnishedHouse;
using test::FurnishedJudge;
using test::FurnishedVerdict;
using test::TracerVariant;
using test::TryingCamera;

struct Case {
    const char* name;
    FurnishedHouse house;
    std::uint64_t seed;
    std::size_t objects;
    modeler::ObjectCells cells;
};

constexpr std::array cases = {
    Case{"townhouse", FurnishedHouse::Townhouse, 1, 60, modeler::ObjectCells::List},
    Case{"crowded", FurnishedHouse::Townhouse, 2, 400, modeler::ObjectCells::List},
    Case{"office", FurnishedHouse::Office, 3, 120, modeler::ObjectCells::List},
    Case{"officecut", FurnishedHouse::Office, 3, 40, modeler::ObjectCells::Cut},
    Case{"curved", FurnishedHouse::Curved, 4, 100, modeler::ObjectCells::List},
    Case{"curvedcut", FurnishedHouse::Curved, 4, 40, modeler::ObjectCells::Cut},
};

/// Objects whose meshes hold the same triangle in several colours have one: which of them is seen, nobody has to say.
accel::Scene scene_of(FurnishedHouse house, std::uint64_t seed, std::size_t objects, modeler::ObjectCells cells) {
    const modeler::Building building = test::house(house);
    modeler::Furnishing furnishing = test::random_furnishing(building, seed, objects);
    furnishing.cells = cells;
    for (modeler::FurnishedObject& object : furnishing.objects)
        if (furnishing.meshes[object.mesh]->name == "degenerate") object.colour = {0.6f, 0.2f, 0.7f};
    std::vector<Finding> findings;
    return modeler::export_scene(modeler::put_objects(building, std::move(furnishing), findings), {}, "{}");
}

Framebuffer picture(const accel::SceneView& scene, const ObjectTracer& objects, const CameraFrame& frame,
                    accel::CellId start, int width, int height, const TracerVariant& variant, float mirror_floor = 0) {
    Framebuffer framebuffer(width, height);
    LambertOptions options;
    options.tracer = variant.tracer;
    options.packets = variant.packets;
    options.mirror_floor = mirror_floor;
    options.objects = &objects;
    trace_lambert(scene, frame, start, options, accel::SerialExecutor(), framebuffer);
    return framebuffer;
}

/// Trying cameras, and some inside of objects.
std::vector<TryingCamera> cameras_in(const accel::SceneView& scene, std::uint64_t seed) {
    std::vector<TryingCamera> cameras = test::trying_cameras(scene, seed);
    for (std::size_t k = seed % 5; k < scene.objects.size(); k += scene.objects.size() / 6 + 1) {
        const accel::PlacedObject& object = scene.objects[k];
        Camera camera;
        const auto middle = [&](std::size_t axis) {
            return 0.5 * (double{object.low[axis]} + double{object.high[axis]});
        };
        camera.eye = {static_cast<float>(middle(0)), static_cast<float>(middle(1)), static_cast<float>(middle(2))};
        camera.target = camera.eye + Vec3d{std::cos(2.4 * double(k)), std::sin(2.4 * double(k)), -0.1};
        camera.fov_deg = 90;
        camera.width = 80;
        camera.height = 75;
        const Vec3f eye = make_frame(camera).origin;
        if (!accel::locate(scene, {eye.x, eye.y, eye.z})) continue;
        cameras.push_back({"inside object " + std::to_string(k), camera, false});
    }
    return cameras;
}

class FurnishedTracers : public testing::TestWithParam<std::tuple<Case, test::InstructionSet>> {
protected:
    FurnishedTracers()
        : set_(std::get<1>(GetParam())),
          scene_(scene_of(std::get<0>(GetParam()).house, std::get<0>(GetParam()).seed, std::get<0>(GetParam()).objects,
                          std::get<0>(GetParam()).cells)),
          accel_(build_object_accel(scene_.view(), ObjectAccelKind::Bvh, accel::SerialExecutor())),
          objects_(accel_->tracer()) {}

    /// All variants from all cameras.
    void expect_the_scalar_picture(std::uint64_t seed, float mirror_floor) {
        const accel::SceneView& scene = scene_.view();
        FurnishedVerdict all;
        for (const TryingCamera& trying : cameras_in(scene, seed)) {
            const int width = trying.camera.width, height = trying.camera.height;
            const CameraFrame frame = make_frame(trying.camera);
            const accel::CellId start = start_cell(scene, frame);
            FurnishedJudge judge(scene, objects_, frame, start, width, height, mirror_floor);
            for (const TracerVariant& variant : test::tracer_variants) {
                const FurnishedVerdict verdict =
                    judge.compare(picture(scene, objects_, frame, start, width, height, variant, mirror_floor));
                EXPECT_EQ(verdict.unexplained, 0u) << variant.name << ", camera " << trying.name << ", "
                                                   << test::text_of(frame, width, height) << ": " << verdict.text();
                if (!trying.on_border) all.add(verdict);
            }
        }
        RecordProperty("differing_per_million", std::to_string(1e6 * double(all.differing) / double(all.pixels)));
        // Few: what lies in one plane with another thing's face, where there is no fused multiply-add.
        EXPECT_LE(double(all.differing), 8 + 0.01 * double(all.pixels)) << all.text();
    }

    test::UsingInstructionSet set_;
    accel::Scene scene_;
    std::unique_ptr<ObjectAccel> accel_;
    ObjectTracer objects_;
};

TEST_P(FurnishedTracers, SeeTheScalarPicture) { expect_the_scalar_picture(11, 0); }

TEST_P(FurnishedTracers, SeeTheScalarPictureOverFloorsThatMirror) { expect_the_scalar_picture(12, 0.4f); }

/// Eyes in the rooms of a scene, in columns, and rays from there in all directions.
struct Stream {
    std::vector<float> origin[3], direction[3], distance;
    std::vector<accel::CellId> start, end;
    std::vector<accel::SourceFaceId> face;
    std::vector<WalkStatus> status;
    std::vector<accel::ObjectId> object;
    std::vector<std::uint32_t> triangle;

    Stream(const accel::SceneView& scene, std::size_t count)
        : distance(count), end(count), face(count), status(count), object(count), triangle(count) {
        std::mt19937_64 random(31);
        for (std::size_t i = 0; i < count; ++i) {
            const auto cell = static_cast<std::uint32_t>(random() % scene.cells.size());
            const Vec3f p = vec_cast<float>(test::random_point(scene, cell, random));
            const Vec3f d = vec_cast<float>(test::random_direction(random));
            origin[0].push_back(p.x), origin[1].push_back(p.y), origin[2].push_back(p.z);
            direction[0].push_back(d.x), direction[1].push_back(d.y), direction[2].push_back(d.z);
            start.push_back(static_cast<accel::CellId>(cell));
        }
    }
    [[nodiscard]] RayColumns rays() const {
        return {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], start, {}};
    }
    [[nodiscard]] HitColumns hits() { return {distance, face, end, status, object, triangle}; }
    [[nodiscard]] bool is_like(const Stream& other, std::size_t i) const {
        return status[i] == other.status[i] && face[i] == other.face[i] && object[i] == other.object[i] &&
               triangle[i] == other.triangle[i];
    }
};

/// Rays that do not end at the same triangle or face end near each other, but for very few: past an edge.
TEST_P(FurnishedTracers, AnswerStreamsAsTheScalarOneDoes) {
    constexpr std::size_t count = 60'000;
    const accel::SceneView& scene = scene_.view();
    Stream scalar(scene, count);
    nearest(scene, scalar.rays(), scalar.hits(), {.tracer = Tracer::Scalar, .objects = &objects_});
    std::size_t objects = 0;
    for (const WalkStatus status : scalar.status) objects += status == WalkStatus::Object ? 1 : 0;
    EXPECT_GT(objects, count / 100);
    for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any}) {
        Stream other(scene, count);
        nearest(scene, other.rays(), other.hits(), {.tracer = Tracer::Simd, .order = order, .objects = &objects_});
        std::size_t unlike = 0, far = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (scalar.is_like(other, i)) continue;
            ++unlike;
            far += std::abs(scalar.distance[i] - other.distance[i]) > 2e-3f ? 1 : 0;
        }
        EXPECT_LE(unlike, count / 2000);
        EXPECT_LE(far, 3u);
    }
}

TEST_P(FurnishedTracers, SeeTheSamePointsAsTheScalarOne) {
    constexpr std::size_t count = 30'000;
    const accel::SceneView& scene = scene_.view();
    const Stream from(scene, 2 * count);
    const auto half = [&](const auto& column, bool second) {
        return std::span(column).subspan(second ? count : 0, count);
    };
    for (const bool is_known : {true, false}) {
        const SegmentColumns segments = {
            half(from.origin[0], false), half(from.origin[1], false),
            half(from.origin[2], false), half(from.origin[0], true),
            half(from.origin[1], true),  half(from.origin[2], true),
            half(from.start, false),     is_known ? half(from.start, true) : std::span<const accel::CellId>{}};
        std::vector<std::uint8_t> scalar(count), other(count);
        visible(scene, segments, scalar, {.tracer = Tracer::Scalar, .objects = &objects_});
        visible(scene, segments, other, {.tracer = Tracer::Simd, .objects = &objects_});
        std::size_t unlike = 0, seen = 0;
        for (std::size_t i = 0; i < count; ++i) {
            unlike += scalar[i] != other[i] ? 1 : 0;
            seen += scalar[i];
        }
        EXPECT_GT(seen, count / 200);
        EXPECT_LE(unlike, 3u);
    }
}

/// What stands in rooms looks the same, be it listed or cut out.
class ListedAndCut : public testing::TestWithParam<FurnishedHouse> {};

TEST_P(ListedAndCut, LookAlike) {
    const accel::Scene listed = scene_of(GetParam(), 7, 60, modeler::ObjectCells::List);
    const accel::Scene cut = scene_of(GetParam(), 7, 60, modeler::ObjectCells::Cut);
    EXPECT_GT(cut.view().cells.size(), listed.view().cells.size());
    const auto listed_accel = build_object_accel(listed.view(), ObjectAccelKind::Bvh, accel::SerialExecutor());
    const auto cut_accel = build_object_accel(cut.view(), ObjectAccelKind::Bvh, accel::SerialExecutor());
    const ObjectTracer listed_objects = listed_accel->tracer(), cut_objects = cut_accel->tracer();
    FurnishedVerdict all;
    for (const TryingCamera& trying : cameras_in(listed.view(), 13)) {
        if (trying.on_border) continue;
        const int width = trying.camera.width, height = trying.camera.height;
        const CameraFrame frame = make_frame(trying.camera);
        FurnishedJudge judge(listed.view(), listed_objects, frame, start_cell(listed.view(), frame), width, height);
        for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet}) {
            const FurnishedVerdict verdict = judge.compare(picture(
                cut.view(), cut_objects, frame, start_cell(cut.view(), frame), width, height, {"", tracer, {64, 8}}));
            EXPECT_EQ(verdict.unexplained, 0u) << "tracer " << int(tracer) << ", camera " << trying.name << ", "
                                               << test::text_of(frame, width, height) << ": " << verdict.text();
            all.add(verdict);
        }
    }
    // What lies in one plane with another thing's face is asked for in other cells, in another order.
    EXPECT_LE(double(all.differing), 8 + 0.01 * double(all.pixels)) << all.text();
}

INSTANTIATE_TEST_SUITE_P(Houses, ListedAndCut,
                         testing::Values(FurnishedHouse::Townhouse, FurnishedHouse::Office, FurnishedHouse::Curved));

INSTANTIATE_TEST_SUITE_P(Houses, FurnishedTracers,
                         testing::Combine(testing::ValuesIn(cases), testing::ValuesIn(test::instruction_sets())),
                         [](const auto& one) {
                             return std::string(std::get<0>(one.param).name) + "_" + std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace enfilade::render
