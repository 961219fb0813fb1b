// Pictures by a warp's packets show what the scalar tracer shows.
#include "render/cuda/packets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "accel/assemble.h"
#include "render/cuda/buffer.h"
#include "render/cuda/device_scene.h"
#include "render/trace.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/devices.h"
#include "tests/support/picture_judge.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render::cuda {
namespace {

constexpr std::uint32_t poison = 0x00abcdefu;  // no pixel is: the highest byte of those is 255

struct Shot {
    CameraFrame frame;
    accel::CellId start;
    int width, height;
};

Shot shot_of(const accel::SceneView& scene, const Camera& camera) {
    const CameraFrame frame = make_frame(camera);
    return {frame, start_cell(scene, frame), camera.width, camera.height};
}

/// A scene on a device, and pictures of it.
class PacketScene {
public:
    PacketScene(Device& device, const accel::SceneInput& input, float mirror_floor = 0)
        : device_(&device),
          scene_(accel::assemble(input)),
          arrays_(device),
          copy_(copy_scene(scene_.view(), arrays_)),
          mirror_floor_(mirror_floor),
          judge_(scene_.view()) {}

    [[nodiscard]] const accel::SceneView& view() const { return scene_.view(); }

    [[nodiscard]] Framebuffer by_packets(const Shot& shot, PacketTiles tiles) const {
        Framebuffer picture(shot.width, shot.height);
        std::fill(picture.rgba.begin(), picture.rgba.end(), poison);
        Buffer<std::uint32_t> image(*device_, picture.rgba.size());
        device_->upload(image.data(), picture.rgba.data(), picture.rgba.size() * sizeof(std::uint32_t));
        draw_packets(*device_, {&copy_, shot.frame, lambert_look({}), shot.start, mirror_floor_, shot.width,
                                shot.height, image.data(), tiles});
        device_->wait();
        device_->download(picture.rgba.data(), image.data(), picture.rgba.size() * sizeof(std::uint32_t));
        return picture;
    }
    [[nodiscard]] Framebuffer by_scalar(const Shot& shot) const {
        Framebuffer picture(shot.width, shot.height);
        LambertOptions options;
        options.tracer = Tracer::Scalar;
        options.mirror_floor = mirror_floor_;
        const accel::SerialExecutor here;
        trace_lambert(view(), shot.frame, shot.start, options, here, picture);
        return picture;
    }
    [[nodiscard]] PacketCounts counts(const Shot& shot, PacketTiles tiles) const {
        Framebuffer picture(shot.width, shot.height);
        return count_packets({&view(), shot.frame, lambert_look({}), shot.start, mirror_floor_, shot.width, shot.height,
                              picture.rgba.data(), tiles});
    }
    [[nodiscard]] test::PictureVerdict judge(const Shot& shot, PacketTiles tiles) const {
        return judge_.compare(shot.frame, shot.start, by_scalar(shot), by_packets(shot, tiles));
    }

private:
    Device* device_;
    accel::Scene scene_;
    DeviceArrays arrays_;
    accel::SceneView copy_;
    float mirror_floor_;
    test::PictureJudge judge_;
};

accel::SceneInput coloured_office(double turn, int storeys = 2) {
    return test::with_own_colours(test::synthetic_office({.rooms_per_row = 5, .storeys = storeys, .turn = turn}));
}

std::vector<PacketTiles> all_tiles() { return {{16, 4}, {4, 4}, {8, 4}, {16, 16}, {32, 8}, {64, 4}, {64, 64}}; }

std::string text_of(PacketTiles tiles) {
    return "tiles " + std::to_string(tiles.largest) + " to " + std::to_string(tiles.smallest) + ": ";
}

/// Pixels that differ by more than one step of a channel.
std::size_t others(const Framebuffer& expected, const Framebuffer& actual) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < expected.rgba.size(); ++i)
        for (int channel = 0; channel < 32; channel += 8) {
            const int e = static_cast<int>(expected.rgba[i] >> channel & 255u);
            const int a = static_cast<int>(actual.rgba[i] >> channel & 255u);
            if (e - a > 1 || a - e > 1) {
                ++count;
                break;
            }
        }
    return count;
}

class Packets : public test::DeviceTest {};
ENFILADE_ON_DEVICES(Packets);

TEST_P(Packets, ShowTheFacesThatTheScalarTracerShows) {
    for (const double turn : {0.0, 0.3, 0.0002}) {
        const PacketScene scene(device(), coloured_office(turn));
        test::PictureVerdict all;
        for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 11)) {
            const Shot shot = shot_of(scene.view(), trying.camera);
            const test::PictureVerdict verdict = scene.judge(shot, {});
            EXPECT_TRUE(verdict.is_right())
                << trying.name << test::text_of(shot.frame, shot.width, shot.height) << verdict.text();
            if (!trying.on_border) all.add(verdict);
        }
        EXPECT_GT(all.pixels, 30'000u);
        EXPECT_LE(static_cast<double>(all.inside_band), 8 + 400e-6 * static_cast<double>(all.pixels)) << all.text();
    }
}

TEST_P(Packets, ShowThemWhateverTheSizesOfTiles) {
    const PacketScene scene(device(), coloured_office(0.3));
    for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 12)) {
        const Shot shot = shot_of(scene.view(), trying.camera);
        for (const PacketTiles tiles : all_tiles()) {
            const test::PictureVerdict verdict = scene.judge(shot, tiles);
            EXPECT_TRUE(verdict.is_right()) << text_of(tiles) << trying.name << verdict.text();
        }
    }
}

TEST_P(Packets, WriteEveryPixelOfImagesOfAnySize) {
    const PacketScene scene(device(), coloured_office(0.3));
    Camera camera;
    camera.eye = {2, 2, 1.6};
    camera.target = {3, 4, 1.5};
    for (const int width : {1, 3, 4, 63, 64, 65, 130})
        for (const int height : {1, 31, 32, 33}) {
            camera.width = width;
            camera.height = height;
            const Shot shot = shot_of(scene.view(), camera);
            for (const PacketTiles tiles : {PacketTiles{16, 4}, PacketTiles{32, 16}}) {
                const Framebuffer picture = scene.by_packets(shot, tiles);
                EXPECT_EQ(std::count(picture.rgba.begin(), picture.rgba.end(), poison), 0)
                    << width << " x " << height << ", " << text_of(tiles);
                EXPECT_TRUE(scene.judge(shot, tiles).is_right()) << width << " x " << height << ", " << text_of(tiles);
            }
        }
}

TEST_P(Packets, ShowThemWhereRaysRunThroughCornersOfWalls) {
    const PacketScene scene(device(), coloured_office(0));
    const auto cells = static_cast<std::uint32_t>(scene.view().cells.size());
    for (std::uint32_t c = 0; c < cells; c += 1 + cells / 8)
        for (const test::AlignedFrame& f : test::aligned_frames(scene.view(), c, 5)) {
            const Shot shot = {f.frame, f.start, f.width, f.height};
            const test::PictureVerdict verdict = scene.judge(shot, {});
            EXPECT_TRUE(verdict.is_right())
                << "cell " << c << ", " << test::text_of(f.frame, f.width, f.height) << verdict.text();
        }
}

TEST_P(Packets, ShowWhatFloorsMirror) {
    for (const float share : {0.4f, 1.0f}) {
        const PacketScene scene(device(), coloured_office(0.3, 1), share);
        for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 13)) {
            // Of that one a whole column runs along an edge.
            if (trying.on_border || trying.name == "straight at a vertex") continue;
            const Shot shot = shot_of(scene.view(), trying.camera);
            const Framebuffer expected = scene.by_scalar(shot), actual = scene.by_packets(shot, {});
            // The mixed colours tell no face apart; so few pixels may differ as have an edge beside them.
            EXPECT_LE(others(expected, actual), 4u) << trying.name << " of " << expected.rgba.size();
        }
    }
}

// Where floats lead a ray out of its cell behind the eye, doubles decide.
TEST_P(Packets, WalkAgainWhatRoundingLedAstray) {
    const PacketScene scene(device(), coloured_office(0.3));
    std::uint64_t astray = 0;
    for (const test::TryingCamera& trying : test::trying_cameras(scene.view(), 1)) {
        const Shot shot = shot_of(scene.view(), trying.camera);
        const PacketCounts counts = scene.counts(shot, {});
        if (counts.from_start == 0) continue;
        astray += counts.from_start;
        const test::PictureVerdict verdict = scene.judge(shot, {});
        EXPECT_TRUE(verdict.is_right()) << trying.name << verdict.text();
    }
    EXPECT_GT(astray, 0u);
}

TEST(PacketTiles, AreAsLargeAsLeavesWorkForAllMultiprocessors) {
    EXPECT_EQ(tiles_for(132, 1024, 1024, false).largest, 8);
    EXPECT_EQ(tiles_for(132, 3840, 2160, false).largest, 16);
    EXPECT_EQ(tiles_for(132, 8192, 8192, false).largest, 64);
    EXPECT_EQ(tiles_for(2, 1024, 1024, false).largest, 64);
    EXPECT_EQ(tiles_for(132, 1, 1, false).largest, 8);
    EXPECT_EQ(tiles_for(132, 1024, 1024, true).smallest, 8);
    EXPECT_EQ(tiles_for(132, 1024, 1024, false).smallest, 4);
}

TEST(CountedPackets, AreTheWholePicture) {
    const accel::Scene scene = accel::assemble(coloured_office(0.3));
    Camera camera;
    camera.eye = {2, 2, 1.6};
    camera.target = {3, 4, 1.5};
    camera.width = 257;
    camera.height = 129;
    const Shot shot = shot_of(scene.view(), camera);
    Framebuffer picture(camera.width, camera.height);
    for (const PacketTiles tiles : all_tiles()) {
        const PacketCounts counts = count_packets({&scene.view(), shot.frame, lambert_look({}), shot.start, 0,
                                                   camera.width, camera.height, picture.rgba.data(), tiles});
        EXPECT_EQ(counts.filled_pixels + counts.single_pixels, picture.rgba.size()) << text_of(tiles);
        EXPECT_GT(counts.filled_pixels, picture.rgba.size() / 2) << text_of(tiles);
        EXPECT_LT(counts.cells, picture.rgba.size() / 2) << text_of(tiles);  // a thread a pixel: one and more a pixel
    }
}

}  // namespace
}  // namespace enfilade::render::cuda
