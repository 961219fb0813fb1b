// A device's pictures are those of the scalar tracer.
#include "render/cuda/pictures.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/trace.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/devices.h"
#include "tests/support/packets_drawn.h"
#include "tests/support/picture_judge.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render::cuda {
namespace {

class DevicePictures : public test::DeviceTest {};
ENFILADE_ON_DEVICES(DevicePictures);

TEST_P(DevicePictures, ShowTheFacesThatTheScalarTracerShows) {
    const accel::Scene scene = accel::assemble(test::with_own_colours(
        test::with_clear_panes(test::synthetic_office({.rooms_per_row = 8, .storeys = 2, .turn = 0.3}))));
    const accel::SerialExecutor one;
    const test::PictureJudge judge(scene.view());
    Pictures pictures(device(), scene.view());
    Pictures by_packets(device(), scene.view(), {.packets = PacketTiles{}});
    test::PictureVerdict verdict;
    Framebuffer actual;
    for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 3)) {
        const CameraFrame frame = make_frame(trying.camera);
        const accel::CellId start = start_cell(scene.view(), frame);
        Framebuffer expected(trying.camera.width, trying.camera.height);
        trace_lambert(scene.view(), frame, start, {.tracer = Tracer::Scalar}, one, expected);
        for (Pictures* drawn : {&pictures, &by_packets}) {
            drawn->draw(frame, start, trying.camera.width, trying.camera.height);
            drawn->read(actual);
            verdict.add(judge.compare(frame, start, expected, actual));
        }
    }
    EXPECT_TRUE(verdict.is_right()) << verdict.text();
    EXPECT_GT(verdict.pixels, 50'000u);
}

TEST_P(DevicePictures, ChangeTheirSizeFromFrameToFrame) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({}));
    Pictures pictures(device(), scene.view());
    Camera camera;
    camera.eye = {2, 2, 1.6};
    camera.target = {3, 4, 1.5};
    const accel::SerialExecutor one;
    for (const int width : {1, 33, 7}) {
        camera.width = width;
        camera.height = 40 - width;
        const CameraFrame frame = make_frame(camera);
        const accel::CellId start = start_cell(scene.view(), frame);
        Framebuffer expected(camera.width, camera.height), actual;
        trace_lambert(scene.view(), frame, start, {.tracer = Tracer::Scalar}, one, expected);
        pictures.draw(frame, start, camera.width, camera.height);
        pictures.read(actual);
        test::PictureTally tally;  // of a card: no pixel may differ by more than a step
        tally.add(expected, actual);
        EXPECT_EQ(tally.others, 0u);
        EXPECT_EQ(actual.rgba.size(), expected.rgba.size());
        EXPECT_TRUE(device().is_card() || actual == expected);
    }
}

}  // namespace
}  // namespace enfilade::render::cuda
