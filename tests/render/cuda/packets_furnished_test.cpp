// Packets in furnished rooms show what the scalar tracer shows, whoever knows what is inside of objects.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/cuda/buffer.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/packets.h"
#include "render/framebuffer.h"
#include "render/lambert.h"
#include "render/octree_trees.h"
#include "tests/support/devices.h"
#include "tests/support/object_scenes.h"
#include "tests/support/packets_drawn.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render::cuda {
namespace {

class FurnishedPackets : public test::DeviceTest {
protected:
    /// One picture, counted in.
    void draw(const accel::SceneView& scene, const Camera& camera, InsideKind kind, float mirror_floor,
              PacketTiles tiles, test::PictureTally& all) {
        const accel::SerialExecutor here;
        DeviceArrays arrays(device());
        const accel::SceneView copy = copy_scene(scene, arrays);
        const DeviceObjects objects(arrays, scene, copy, kind, {}, here);
        const CameraFrame frame = make_frame(camera);
        const accel::CellId start = start_cell(scene, frame);
        const Framebuffer actual =
            test::drawn_by_packets(device(), {&copy, frame, lambert_look({}), start, mirror_floor, camera.width,
                                              camera.height, nullptr, tiles, &objects});
        all.add(scalar(scene, camera, kind, mirror_floor), actual);
    }

    /// As the scalar tracer walks them, among the same trees.
    static Framebuffer scalar(const accel::SceneView& scene, const Camera& camera, InsideKind kind,
                              float mirror_floor) {
        const accel::SerialExecutor here;
        const std::unique_ptr<Device> host = open_host(here);
        DeviceArrays arrays(*host);
        const DeviceObjects objects(arrays, scene, scene, kind, {}, here);
        const CameraFrame frame = make_frame(camera);
        const Look look = lambert_look({});
        const LambertPicture picture = {&scene, &frame, &look, static_cast<std::uint32_t>(start_cell(scene, frame)),
                                        mirror_floor};
        Framebuffer result(camera.width, camera.height);
        const auto draw = [&](const auto& rooms) {
            NoEvents none;
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x)
                    result.rgba[static_cast<std::size_t>(y * camera.width + x)] =
                        encoded(lambert_pixel<float>(picture, rooms, x, y, none));
        };
        if (kind == InsideKind::Octree) draw(RoomsWith<decltype(objects.octrees())>{objects.octrees()});
        else draw(RoomsWith<decltype(objects.bvhs())>{objects.bvhs()});
        return result;
    }
};
ENFILADE_ON_DEVICES(FurnishedPackets);

TEST_P(FurnishedPackets, ShowWhatTheScalarTracerShows) {
    for (const InsideKind kind : {InsideKind::Octree, InsideKind::Bvh}) {
        const accel::Scene scene = test::furnished_office({.seed = 7, .turn = 0.3});
        test::PictureTally all;
        for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 3)) {
            if (trying.on_border || trying.name == "straight at a vertex") continue;
            draw(scene.view(), trying.camera, kind, 0, {}, all);
        }
        EXPECT_GT(all.pixels, 30'000u);
        EXPECT_LE(all.others, all.pixels / 10'000);
        EXPECT_EQ(all.unwritten, 0u);
    }
}

TEST_P(FurnishedPackets, ShowItInMirrorsAndWithAnyTiles) {
    const accel::Scene scene = test::furnished_office({.seed = 8});
    for (const PacketTiles tiles : {PacketTiles{64, 8}, PacketTiles{8, 4}, PacketTiles{32, 32}}) {
        test::PictureTally all;
        for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 4)) {
            if (trying.on_border || trying.name == "straight at a vertex") continue;
            draw(scene.view(), trying.camera, InsideKind::Octree, 0.5f, tiles, all);
        }
        EXPECT_LE(all.others, all.pixels / 10'000) << tiles.largest;
        EXPECT_EQ(all.unwritten, 0u);
    }
}

// A room so full that no set of bits names all of its objects.
TEST_P(FurnishedPackets, ShowMoreObjectsThanBitsTell) {
    const accel::Scene scene = test::furnished_office({.seed = 9, .objects = 900});
    std::uint32_t most = 0;
    for (std::size_t c = 0; c < scene.view().cells.size(); ++c)
        most = std::max(most, scene.view().cell_object_offsets[c + 1] - scene.view().cell_object_offsets[c]);
    ASSERT_GT(most, 32u);
    test::PictureTally all;
    for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 5)) {
        if (trying.on_border || trying.name == "straight at a vertex") continue;
        draw(scene.view(), trying.camera, InsideKind::Octree, 0, {}, all);
    }
    EXPECT_LE(all.others, all.pixels / 10'000);
}

TEST(CountedFurnishedPackets, FillWhatSeesNoObjects) {
    const accel::Scene scene = test::furnished_office({.seed = 7, .objects = 30});
    const accel::SerialExecutor here;
    const std::unique_ptr<Device> host = open_host(here);
    DeviceArrays arrays(*host);
    const DeviceObjects objects(arrays, scene.view(), scene.view(), InsideKind::Octree, {}, here);
    Camera camera;
    camera.eye = {2, 2, 1.6};
    camera.target = {3, 4, 1.5};
    camera.width = camera.height = 256;
    const CameraFrame frame = make_frame(camera);
    Framebuffer picture(camera.width, camera.height);
    const PacketCounts counts = count_packets({&scene.view(),
                                               frame,
                                               lambert_look({}),
                                               start_cell(scene.view(), frame),
                                               0,
                                               camera.width,
                                               camera.height,
                                               picture.rgba.data(),
                                               {},
                                               &objects});
    EXPECT_EQ(counts.filled_pixels + counts.single_pixels, picture.rgba.size());
    EXPECT_GT(counts.filled_pixels, picture.rgba.size() / 3);
    EXPECT_GT(counts.single_pixels, 100u);
}

}  // namespace
}  // namespace enfilade::render::cuda
