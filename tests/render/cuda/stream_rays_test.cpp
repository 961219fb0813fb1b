// Rays that are made on a device.
#include "render/cuda/streams_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/camera.h"
#include "render/cuda/ray_order.h"
#include "render/cuda/ray_order_keys.h"
#include "tests/support/devices.h"
#include "tests/support/lit_scene.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render::cuda {
namespace {

class StreamRays : public test::DeviceTest {};
ENFILADE_ON_DEVICES(StreamRays);

RayPicture picture_of(const accel::SceneView& scene, int width, int height) {
    Camera camera;
    camera.eye = {2, 2, 1.6};
    camera.target = {3, 4, 1.4};
    camera.width = width;
    camera.height = height;
    const CameraFrame frame = make_frame(camera);
    return {frame, start_cell(scene, frame), width, height};
}

accel::Scene office() { return accel::assemble(test::synthetic_office({.rooms_per_row = 6, .rows = 4})); }

/// Columns of rays, read back: origin, direction, cell.
struct ReadRays {
    std::vector<float> column[6];
    std::vector<accel::CellId> cell;

    ReadRays(Device& device, const RayBuffers& rays) : cell(rays.size()) {
        const DeviceRays view = rays.view();
        for (int k = 0; k < 6; ++k) {
            column[k].resize(rays.size());
            device.download(column[k].data(), k < 3 ? view.origin[k] : view.direction[k - 3],
                            rays.size() * sizeof(float));
        }
        device.download(cell.data(), view.cell, rays.size() * sizeof(accel::CellId));
    }
    [[nodiscard]] Vec3f origin(std::size_t i) const { return {column[0][i], column[1][i], column[2][i]}; }
    [[nodiscard]] Vec3f direction(std::size_t i) const { return {column[3][i], column[4][i], column[5][i]}; }
    friend bool operator==(const ReadRays&, const ReadRays&) = default;
};

TEST_P(StreamRays, OfPixelsAreTheCamerasEachOnce) {
    const accel::Scene scene = office();
    for (const int width : {32, 33}) {
        const RayPicture picture = picture_of(scene.view(), width, 12);
        const ReadRays rays(device(), primary_rays(device(), picture));
        ASSERT_EQ(rays.cell.size(), static_cast<std::size_t>(width * 12));
        std::vector<int> seen(rays.cell.size(), 0);
        for (std::size_t i = 0; i < rays.cell.size(); ++i)
            for (int y = 0; y < 12; ++y)
                for (int x = 0; x < width; ++x) {
                    const Vec3f d = picture.frame.direction(float(x) + 0.5f, float(y) + 0.5f);
                    if (d == rays.direction(i)) ++seen[static_cast<std::size_t>(y * width + x)];
                }
        EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
    }
}

TEST_P(StreamRays, ComeInTilesOfAWarp) {
    const accel::Scene scene = office();
    const RayPicture picture = picture_of(scene.view(), 16, 8);
    const ReadRays rays(device(), primary_rays(device(), picture));
    EXPECT_EQ(rays.direction(31), picture.frame.direction(7.5f, 3.5f));
    EXPECT_EQ(rays.direction(32), picture.frame.direction(8.5f, 0.5f));
    EXPECT_EQ(rays.direction(64), picture.frame.direction(0.5f, 4.5f));
}

TEST_P(StreamRays, BounceOffWhatIsSeen) {
    const accel::Scene scene = office();
    const RayPicture picture = picture_of(scene.view(), 64, 48);
    DeviceStream stream(device(), scene.view());
    const RayBuffers made = bounce_rays(device(), stream.scene(), picture, 3);
    const ReadRays rays(device(), made);
    ASSERT_EQ(rays.cell.size(), 64u * 48 * 3);
    const Buffer<WalkStatus> status(device(), made.size());
    const Buffer<float> distance(device(), made.size());
    DeviceHits hits;
    hits.status = status.data();
    hits.distance = distance.data();
    stream.nearest(made.view(), hits);
    const std::vector<float> metres = distance.read();
    std::size_t far = 0, same = 0;
    const std::vector<WalkStatus> ends = status.read();
    for (std::size_t i = 0; i < ends.size(); ++i) {
        ASSERT_EQ(ends[i], WalkStatus::Hit);
        EXPECT_NEAR(length(rays.direction(i)), 1, 2e-3);
        const accel::Cell& cell = scene.view().cells[index(rays.cell[i])];
        EXPECT_GE(rays.origin(i).z, cell.z_floor);
        EXPECT_LE(rays.origin(i).z, cell.z_ceiling);
        far += metres[i] > 0.1f ? 1 : 0;
        same += i >= 64 * 48 && rays.direction(i) == rays.direction(i - 64 * 48) ? 1 : 0;
    }
    // They leave the surface: hardly any hits one at once, and no pixel's rays are all one.
    EXPECT_GT(far, ends.size() * 97 / 100);
    EXPECT_LT(same, 10u);
}

TEST_P(StreamRays, AreTheSameNumbersOnAnyDevice) {
    const accel::Scene scene = office();
    const RayPicture picture = picture_of(scene.view(), 40, 24);
    const accel::SerialExecutor one;
    const std::unique_ptr<Device> host = open_host(one);
    DeviceStream there(device(), scene.view()), here(*host, scene.view());
    EXPECT_EQ(ReadRays(device(), shuffled(device(), bounce_rays(device(), there.scene(), picture, 2))),
              ReadRays(*host, shuffled(*host, bounce_rays(*host, here.scene(), picture, 2))));
}

TEST_P(StreamRays, GoToLampsThatStandSomewhere) {
    test::LitScene scene(accel::assemble(test::synthetic_office({})));
    scene.add_random_lamps(20, 3);
    const RayPicture picture = picture_of(scene.view(), 32, 32);
    DeviceStream stream(device(), scene.view());
    const SegmentBuffers segments = lamp_segments(device(), stream.scene(), picture, 2);
    ASSERT_EQ(segments.size(), 2048u);
    const Buffer<std::uint8_t> visible(device(), segments.size());
    stream.visible(segments.view(), visible.data());
    std::size_t seen = 0;
    for (const std::uint8_t is_seen : visible.read()) seen += is_seen;
    EXPECT_GT(seen, 20u);
    EXPECT_LT(seen, 2000u);
}

TEST(ShuffledPlaces, AreAPermutation) {
    for (const std::uint32_t count : {1u, 2u, 3u, 100u, 1024u, 5000u}) {
        std::vector<int> hits(count, 0);
        std::uint32_t neighbours = 0, last = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t k = shuffled_place(i, count);
            ASSERT_LT(k, count);
            ++hits[k];
            neighbours += k == last + 1 || last == k + 1 ? 1 : 0;
            last = k;
        }
        EXPECT_EQ(hits, std::vector<int>(count, 1));
        EXPECT_LT(neighbours, count > 1000 ? count / 50 : count + 1);
    }
}

TEST_P(StreamRays, AreSortedByTheirKeysAndStayInOrderWhereTheseAreEqual) {
    KeySorter sorter(device());
    constexpr std::size_t count = 10'000;
    sorter.reserve(count);
    std::vector<std::uint32_t> keys(count), numbers(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        keys[i] = (i * 2654435761u) >> 24 | i << 9;  // bits above the lower 8 do not count
        numbers[i] = i;
    }
    device().upload(sorter.keys(), keys.data(), count * 4);
    device().upload(sorter.numbers(), numbers.data(), count * 4);
    const std::uint32_t* sorted = sorter.sort(count, 8);
    device().wait();
    device().download(numbers.data(), sorted, count * 4);
    for (std::size_t i = 1; i < count; ++i) {
        const std::uint32_t a = keys[numbers[i - 1]] & 255, b = keys[numbers[i]] & 255;
        ASSERT_TRUE(a < b || (a == b && numbers[i - 1] < numbers[i])) << i;
    }
}

TEST(RayKeys, TellDirectionsApart) {
    EXPECT_EQ(step_of(std::nanf(""), 32), 0u);
    EXPECT_EQ(step_of(-1, 32), 0u);
    EXPECT_EQ(step_of(1e30f, 32), 31u);
    float before = -1;
    for (int degree = 1; degree < 360; ++degree) {
        const float angle = float(degree) * 3.14159265f / 180;
        const float turn = plan_turn(std::cos(angle), std::sin(angle));
        EXPECT_GT(turn, before);
        EXPECT_LE(turn, 1);
        before = turn;
    }
    const OctahedralPlace up = octahedral({0, 0, 1}), down = octahedral({0, 0, -1}), east = octahedral({1, 0, 0});
    EXPECT_EQ(up.u, 0.5f);
    EXPECT_EQ(up.v, 0.5f);
    EXPECT_EQ(down.u, 1.0f);
    EXPECT_EQ(east.u, 1.0f);
    EXPECT_EQ(east.v, 0.5f);
}

TEST(RayKeys, NumberCellsOfAnyScene) {
    OrderFrame frame = {};
    for (const std::uint32_t cells : {1u, 2u, 255u, 1u << 20, 1u << 25, 1u << 30}) {
        frame.cells = cells;
        const int bits = key_bits(frame, RayOrder::ByCell);
        const std::uint32_t key = cell_key(frame, cells - 1, {0.3f, -0.4f, 1});
        EXPECT_LE(bits, 32);
        EXPECT_EQ(std::uint64_t{key} >> bits, 0u) << cells;
        EXPECT_TRUE(cells == 1 || key > cell_key(frame, cells - 2, {-1, -1e-3f, 0}));
    }
}

}  // namespace
}  // namespace enfilade::render::cuda
