// However a device's threads share a picture, it is the same picture.
#include <gtest/gtest.h>

#include "render/cuda/pictures.h"
#include "tests/support/devices.h"
#include "tests/support/rich_scene.h"
#include "tests/support/same_pictures.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render::cuda {
namespace {

class PictureSchedules : public test::DeviceTest {
protected:
    PictureSchedules() : rich_(test::furnished_office({.seed = 6, .objects = 40, .turn = 0.2})) {}

    /// Frames of an odd size by each schedule, against the first one.
    void expect_same(const accel::SceneView& scene, const PictureOptions& options) {
        const accel::SerialExecutor one;
        PictureOptions with_executor = options;
        with_executor.executor = &one;
        Pictures pictures(device(), scene, with_executor);
        const std::vector<test::TryingCamera> cameras = test::trying_cameras(scene, 31);
        test::SamePictures same(device());
        for (std::size_t k = 0; k < cameras.size(); k += 7) {
            const CameraFrame frame = make_frame(cameras[k].camera);
            const accel::CellId start = start_cell(scene, frame);
            Framebuffer first, next;
            pictures.set_schedule({.order = PixelOrder::Rows});
            pictures.draw(frame, start, 67, 45);
            pictures.read(first);
            for (const PixelOrder order : {PixelOrder::Rows, PixelOrder::Tiles, PixelOrder::Morton})
                for (const WarpWork work : {WarpWork::Once, WarpWork::Persistent})
                    for (const FrameStart how : {FrameStart::Launch, FrameStart::Graph}) {
                        pictures.set_schedule({.order = order, .work = work, .start = how});
                        pictures.draw(frame, start, 67, 45);
                        pictures.read(next);
                        same.add(first, next, cameras[k].name);
                    }
            for (const KernelShape shape : {KernelShape::Blocks64, KernelShape::Blocks256, KernelShape::FewRegisters,
                                            KernelShape::LeastRegisters}) {
                pictures.set_schedule({.shape = shape});
                pictures.draw(frame, start, 67, 45);
                pictures.read(next);
                same.add(first, next, cameras[k].name);
            }
        }
        EXPECT_GT(same.lit(), same.pixels() / 2);
    }

    test::RichScene rich_;
};
ENFILADE_ON_DEVICES(PictureSchedules);

TEST_P(PictureSchedules, ShowTheSameBareRooms) { expect_same(test::RichScene::bare(rich_.plain()), {}); }

TEST_P(PictureSchedules, ShowTheSameFurniture) { expect_same(rich_.plain(), {}); }

TEST_P(PictureSchedules, ShowTheSameLight) {
    PictureOptions options;
    options.lamps = {LampSearch::Tree, 0.1f, std::nullopt};
    expect_same(rich_.plain(), options);
}

TEST_P(PictureSchedules, ShowTheSameInDouble) {
    expect_same(test::RichScene::bare(rich_.plain()), {.precision = Precision::Double});
}

// Counters are shared by all pictures of an object: each must find them at 0, whichever kernel came before.
TEST_P(PictureSchedules, FollowEachOther) {
    const accel::SceneView scene = rich_.plain();
    const accel::SerialExecutor one;
    Pictures pictures(device(), scene, {.schedule = {.work = WarpWork::Persistent}, .executor = &one});
    const Camera camera = test::trying_cameras(scene, 32).at(0).camera;
    TraceOptions plain, look;
    plain.shading = Shading::Lambert;
    look.look.ambient_samples = 1;
    const Image first = pictures.trace(camera, plain);
    const Image lit = pictures.trace(camera, look);
    test::SamePictures same(device());
    for (int round = 0; round < 2; ++round) {
        same.add(first, pictures.trace(camera, plain), "Lambert");
        same.add(lit, pictures.trace(camera, look), "look");
        same.add(first, pictures.trace(camera, plain), "Lambert again");
    }
}

}  // namespace
}  // namespace enfilade::render::cuda
