// Pictures of all tracers against the scalar one's and the oracle's, pixel by pixel, in scenes where every face has a
// colour of its own (picture_judge.h).
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/trace.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/picture_judge.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/tracer_variants.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render {
namespace {

using test::PictureVerdict;
using test::TracerVariant;
using test::TryingCamera;

struct NamedScene {
    std::string name;
    accel::SceneInput input;
};

/// A hall cut into cells without a wall between them, three and four of them meeting at a line: no edge of a source
/// face excuses anything there. One piece is lower than the others, one goes up another storey.
accel::SceneInput open_hall(double turn) {
    using accel::Label;
    const auto plot = [](double x0, double y0, double x1, double y1, double floor, double ceiling, Label label,
                         std::uint32_t space) {
        return test::Plot{test::grid(x0),
                          test::grid(y0),
                          test::grid(x1),
                          test::grid(y1),
                          {{test::grid(floor), test::grid(ceiling), label, space}}};
    };
    return test::scene_from_plots(
        {plot(-3, -2, 0, 0, 0, 2.5, Label::Room, 0), plot(0, -2, 1.5, 0, 0, 2.5, Label::Room, 0),
         plot(1.5, -2, 4, 1, 0, 2.5, Label::Room, 1), plot(-3, 0, -1, 3, 0, 2.5, Label::Room, 2),
         plot(-1, 0, 0, 3, 0, 2.5, Label::Room, 2), plot(0, 0, 1.5, 1, -0.5, 2.5, Label::Room, 3),
         plot(0, 1, 4, 3, 0, 5, Label::Stair, 4), plot(-0.46, -2.15, 0, -2, 0, 2.1, Label::Door, 5),
         plot(0, -2.15, 0.46, -2, 0, 2.1, Label::Door, 6), plot(-5, -4, 5, -2.15, -0.2, 6, Label::Exterior, 7)},
        turn);
}

std::vector<NamedScene> scenes() {
    return {
        {"open", open_hall(0)},
        {"openturned", open_hall(0.4)},
        {"openbent", open_hall(0.0003)},
        {"straight", test::synthetic_office({.rooms_per_row = 3, .rows = 4, .storeys = 2})},
        {"closed", test::synthetic_office({.rooms_per_row = 3, .rows = 2, .doors = false})},
        {"turned", test::synthetic_office({.rooms_per_row = 4, .rows = 3, .storeys = 3, .turn = 0.3})},
        {"diagonal", test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.785398163397448})},
        {"bent", test::synthetic_office({.rooms_per_row = 6, .rows = 4, .turn = 0.0002})},
        {"wide", test::synthetic_office({.rooms_per_row = 40, .rows = 2, .turn = 1.1})},
        {"corridor", test::synthetic_corridor(40)},
    };
}

Image picture(const accel::SceneView& scene, const Camera& camera, Tracer tracer, PacketSizes packets) {
    const accel::SerialExecutor here;
    TraceOptions options;
    options.tracer = tracer;
    options.packets = packets;
    options.shading = Shading::Lambert;
    options.executor = &here;
    return trace(scene, camera, options);
}

Framebuffer frame_of(const accel::SceneView& scene, const CameraFrame& frame, accel::CellId start, int width,
                     int height, Tracer tracer, PacketSizes packets) {
    const accel::SerialExecutor here;
    Framebuffer framebuffer(width, height);
    LambertOptions options;
    options.tracer = tracer;
    options.packets = packets;
    trace_lambert(scene, frame, start, options, here, framebuffer);
    return framebuffer;
}

/// Other faces inside the band: few, except from where every ray passes an edge. Some 20 per million with a fused
/// multiply-add, some 200 without.
void expect_few(const PictureVerdict& verdict, const char* what) {
    EXPECT_LE(static_cast<double>(verdict.inside_band), 8 + 400e-6 * static_cast<double>(verdict.pixels))
        << what << verdict.text();
}

/// The scene of this name, and the instruction set.
using Case = std::tuple<NamedScene, test::InstructionSet>;

class TracersAgree : public testing::TestWithParam<Case> {
protected:
    TracersAgree()
        : set_(std::get<1>(GetParam())),
          scene_(accel::assemble(test::with_own_colours(std::get<0>(GetParam()).input))),
          judge_(scene_.view()) {}

    [[nodiscard]] std::vector<TryingCamera> cameras(std::uint64_t seed) const {
        return test::trying_cameras(scene_.view(), seed);
    }

    static std::string where(const TryingCamera& trying, const TracerVariant& variant) {
        return std::string(variant.name) + ", camera " + trying.name + ", " +
               test::text_of(make_frame(trying.camera), trying.camera.width, trying.camera.height) + ": ";
    }

    test::UsingInstructionSet set_;
    accel::Scene scene_;
    test::PictureJudge judge_;
};

TEST_P(TracersAgree, OnTheFloatPictureWithTheScalarTracer) {
    const accel::SceneView& view = scene_.view();
    for (const TracerVariant& variant : test::tracer_variants) {
        PictureVerdict from_inside;
        for (const TryingCamera& trying : cameras(5)) {
            const CameraFrame frame = make_frame(trying.camera);
            const PictureVerdict verdict =
                judge_.compare(frame, start_cell(view, frame), picture(view, trying.camera, Tracer::Scalar, {}),
                               picture(view, trying.camera, variant.tracer, variant.packets));
            EXPECT_TRUE(verdict.is_right()) << where(trying, variant) << verdict.text();
            if (!trying.on_border) from_inside.add(verdict);
        }
        expect_few(from_inside, variant.name);
    }
}

TEST_P(TracersAgree, OnTheFramebufferWithTheScalarTracer) {
    const accel::SceneView& view = scene_.view();
    for (const TracerVariant& variant : test::tracer_variants) {
        PictureVerdict from_inside;
        for (const TryingCamera& trying : cameras(6)) {
            const int width = trying.camera.width, height = trying.camera.height;
            const CameraFrame frame = make_frame(trying.camera);
            const accel::CellId start = start_cell(view, frame);
            const PictureVerdict verdict =
                judge_.compare(frame, start, frame_of(view, frame, start, width, height, Tracer::Scalar, {}),
                               frame_of(view, frame, start, width, height, variant.tracer, variant.packets));
            EXPECT_TRUE(verdict.is_right()) << where(trying, variant) << verdict.text();
            if (!trying.on_border) from_inside.add(verdict);
        }
        expect_few(from_inside, variant.name);
    }
}

// Neither cells nor formulas are shared with the oracle.
TEST_P(TracersAgree, WithTheOraclesPicture) {
    const accel::Scene clear =
        accel::assemble(test::with_clear_panes(test::with_own_colours(std::get<0>(GetParam()).input)));
    const accel::SceneView& view = clear.view();
    for (TryingCamera& trying : cameras(7)) {
        if (trying.on_border) continue;
        trying.camera.width = std::min(trying.camera.width, 41);
        trying.camera.height = std::min(trying.camera.height, 41);
        const CameraFrame frame = make_frame(trying.camera);
        const Image expected = trace_by_oracle(view, trying.camera);
        for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet}) {
            const TracerVariant variant = {"oracle", tracer, {16, 4}};
            const PictureVerdict verdict = judge_.compare(frame, start_cell(view, frame), expected,
                                                          picture(view, trying.camera, tracer, variant.packets));
            EXPECT_TRUE(verdict.is_right()) << int(tracer) << where(trying, variant) << verdict.text();
        }
    }
}

// tinybvh #168, three-mesh-bvh #169: pixels exactly on vertices and edges.
TEST_P(TracersAgree, OnRaysThroughTheCornersOfEveryWall) {
    const accel::SceneView& view = scene_.view();
    const auto cell_step = static_cast<std::uint32_t>(view.cells.size() / 12);
    for (const TracerVariant& variant : test::tracer_variants)
        for (std::uint32_t c = 0; c < view.cells.size(); c += 1 + cell_step)
            for (const test::AlignedFrame& f : test::aligned_frames(view, c, 5)) {
                const PictureVerdict verdict = judge_.compare(
                    f.frame, f.start, frame_of(view, f.frame, f.start, f.width, f.height, Tracer::Scalar, {}),
                    frame_of(view, f.frame, f.start, f.width, f.height, variant.tracer, variant.packets));
                EXPECT_TRUE(verdict.is_right()) << variant.name << ", cell " << c << ", "
                                                << test::text_of(f.frame, f.width, f.height) << verdict.text();
            }
}

// Where cells meet, half of the first sides are noise: all cells have to take it for the same.
TEST_P(TracersAgree, FromVerticalLinesWhereCellsMeet) {
    const accel::SceneView& view = scene_.view();
    std::set<std::pair<float, float>> lines;
    for (std::size_t s = 0; s + 1 < view.section_x.size(); ++s) lines.insert({view.section_x[s], view.section_y[s]});
    const std::size_t step = lines.size() / 20 + 1;
    std::size_t number = 0;
    for (const auto& [x, y] : lines) {
        if (++number % step != 0) continue;
        for (const Vec3d looks : {Vec3d{1, 0.3, -0.4}, Vec3d{-0.8, 0.5, 0.1}, Vec3d{0.2, -1, -0.9}, Vec3d{-1, -1, 0}}) {
            Camera camera;
            camera.eye = {x, y, 1.25};
            camera.target = camera.eye + looks;
            camera.fov_deg = 100;
            camera.width = 61;
            camera.height = 50;
            if (!accel::locate(view, {x, y, 1.25})) continue;
            const CameraFrame frame = make_frame(camera);
            const accel::CellId start = start_cell(view, frame);
            const Image expected = picture(view, camera, Tracer::Scalar, {});
            for (std::size_t i = number % 2; i < test::tracer_variants.size(); i += 2) {
                const TracerVariant& variant = test::tracer_variants[i];
                const PictureVerdict verdict =
                    judge_.compare(frame, start, expected, picture(view, camera, variant.tracer, variant.packets));
                EXPECT_TRUE(verdict.is_right())
                    << variant.name << ", cell " << index(start) << ", "
                    << test::text_of(frame, camera.width, camera.height) << ": " << verdict.text();
            }
        }
    }
}

TEST_P(TracersAgree, OnAMillionPixels) {
    const accel::SceneView& view = scene_.view();
    for (TryingCamera& trying : cameras(8)) {
        if (trying.name != "in room") continue;
        trying.camera.width = trying.camera.height = 1024;
        const CameraFrame frame = make_frame(trying.camera);
        const accel::CellId start = start_cell(view, frame);
        const Framebuffer expected = frame_of(view, frame, start, 1024, 1024, Tracer::Scalar, {});
        for (std::size_t i = 0; i < test::tracer_variants.size(); i += 3) {
            const TracerVariant& variant = test::tracer_variants[i];
            const PictureVerdict verdict = judge_.compare(
                frame, start, expected, frame_of(view, frame, start, 1024, 1024, variant.tracer, variant.packets));
            EXPECT_TRUE(verdict.is_right()) << where(trying, variant) << verdict.text();
            expect_few(verdict, variant.name);
        }
        break;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, TracersAgree,
                         testing::Combine(testing::ValuesIn(scenes()), testing::ValuesIn(test::instruction_sets())),
                         [](const auto& one) {
                             return std::get<0>(one.param).name + "_" + std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace enfilade::render
