// Packets lit by lamps show what the scalar tracer shows: what a tile's corners decide is what its pixels would.
#include <gtest/gtest.h>

#include <algorithm>

#include "accel/assemble.h"
#include "accel/lights/light_trees.h"
#include "render/cuda/buffer.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/packets.h"
#include "render/framebuffer.h"
#include "render/lit_pixel.h"
#include "tests/support/devices.h"
#include "tests/support/lit_scene.h"
#include "tests/support/packets_drawn.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render::cuda {
namespace {

class LitPackets : public test::DeviceTest {
protected:
    /// Pictures from the cameras of a seed: by packets, and by the scalar tracer's function, pixel by pixel.
    test::PictureTally compare(const test::LitScene& lit, std::uint64_t seed, PacketTiles tiles,
                               float mirror_floor = 0) {
        const accel::SerialExecutor here;
        const accel::SceneView scene = lit.view();
        const accel::LightTrees trees = accel::build_light_trees(scene, {}, here);
        const Lamps lamps = {trees.view(), LampSearch::Tree, 0.05f};
        DeviceArrays arrays(device());
        const accel::SceneView copy = copy_scene(scene, arrays);
        const Lamps on_device = {copy_trees(trees.view(), arrays), LampSearch::Tree, 0.05f};
        test::PictureTally sum;
        for (const test::TryingCamera& trying : test::trying_cameras(scene, seed)) {
            if (trying.on_border || trying.name == "straight at a vertex") continue;
            const Camera& camera = trying.camera;
            const CameraFrame frame = make_frame(camera);
            const accel::CellId start = start_cell(scene, frame);
            const Framebuffer actual =
                test::drawn_by_packets(device(), {&copy, frame, lambert_look({}), start, mirror_floor, camera.width,
                                                  camera.height, nullptr, tiles, nullptr, &on_device});
            sum.add(expected(scene, lamps, frame, start, camera, mirror_floor), actual);
        }
        return sum;
    }

    static Framebuffer expected(const accel::SceneView& scene, const Lamps& lamps, const CameraFrame& frame,
                                accel::CellId start, const Camera& camera, float mirror_floor) {
        const Look look = lambert_look({});
        const LitPicture picture = {&scene, &frame, &look, &lamps, static_cast<std::uint32_t>(start), mirror_floor};
        Framebuffer result(camera.width, camera.height);
        NoEvents none;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x)
                result.rgba[static_cast<std::size_t>(y * camera.width + x)] =
                    encoded(lit_pixel<float>(picture, BareRooms{}, x, y, none));
        return result;
    }

    static void expect_right(const test::PictureTally& all) {
        EXPECT_GT(all.lit, all.pixels / 4);
        EXPECT_LE(all.others, all.pixels / 10'000) << "of " << all.pixels;
        EXPECT_EQ(all.unwritten, 0u);
    }

    static test::LitScene office(double turn, int lamps) {
        test::LitScene lit(accel::assemble(test::synthetic_office({.rooms_per_row = 5, .storeys = 2, .turn = turn})));
        lit.add_random_lamps(lamps, 3, false);
        return lit;
    }
};
ENFILADE_ON_DEVICES(LitPackets);

TEST_P(LitPackets, ShowTheLightThatTheScalarTracerShows) { expect_right(compare(office(0.3, 40), 3, {})); }

TEST_P(LitPackets, ShowItWhateverTheTiles) {
    for (const PacketTiles tiles : {PacketTiles{64, 8}, PacketTiles{4, 4}})
        expect_right(compare(office(0, 40), 4, tiles));
}

// More lamps in a cell than a tile's memory holds.
TEST_P(LitPackets, ShowTheLightOfManyLamps) { expect_right(compare(office(0.3, 150), 5, {})); }

TEST_P(LitPackets, ShowItAboveFloorsThatMirror) { expect_right(compare(office(0.3, 40), 6, {}, 0.4f)); }

TEST(CountedLitPackets, FillMostPixelsFromLampsOfWholeTiles) {
    const accel::SerialExecutor here;
    test::LitScene lit(accel::assemble(test::synthetic_office({.rooms_per_row = 5})));
    lit.add_random_lamps(20, 3, true);
    const accel::SceneView scene = lit.view();
    const accel::LightTrees trees = accel::build_light_trees(scene, {}, here);
    const Lamps lamps = {trees.view(), LampSearch::Tree, 0.05f};
    Camera camera;
    camera.eye = {2, 2, 1.6};
    camera.target = {3, 4, 1.5};
    camera.width = camera.height = 512;
    const CameraFrame frame = make_frame(camera);
    Framebuffer picture(camera.width, camera.height);
    const PacketCounts counts = count_packets({&scene,
                                               frame,
                                               lambert_look({}),
                                               start_cell(scene, frame),
                                               0,
                                               camera.width,
                                               camera.height,
                                               picture.rgba.data(),
                                               {},
                                               nullptr,
                                               &lamps});
    EXPECT_EQ(counts.filled_pixels + counts.single_pixels, picture.rgba.size());
    EXPECT_GT(counts.filled_pixels, picture.rgba.size() * 9 / 10);
    EXPECT_GT(counts.single_pixels, 0u);
}

}  // namespace
}  // namespace enfilade::render::cuda
