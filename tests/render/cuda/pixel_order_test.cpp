// Which pixels a warp draws: each of them once, and those together whose rays have most in common.
#include "render/cuda/pixel_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "accel/assemble.h"
#include "render/camera.h"
#include "render/walk.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render::cuda {
namespace {

constexpr PixelOrder orders[] = {PixelOrder::Rows, PixelOrder::Tiles, PixelOrder::Morton};

TEST(PixelOrder, DrawsEachPixelOnce) {
    const int sizes[][2] = {{1, 1}, {8, 4}, {33, 5}, {64, 64}, {65, 130}, {1, 200}, {200, 1}};
    for (const PixelOrder order : orders) {
        for (const auto& size : sizes) {
            const PixelBatches batches(order, size[0], size[1]);
            std::vector<int> drawn(static_cast<std::size_t>(size[0] * size[1]), 0);
            for (std::uint32_t batch = 0; batch < batches.count; ++batch)
                for (std::uint32_t lane = 0; lane < 32; ++lane) {
                    std::uint32_t x, y;
                    if (batches.pixel(batch, lane, x, y)) ++drawn[std::size_t{y} * batches.width + x];
                }
            EXPECT_TRUE(std::ranges::all_of(drawn, [](int times) { return times == 1; }))
                << size[0] << " x " << size[1];
        }
    }
}

/// The cells that a ray enters.
struct EnteredCells : NoEvents {
    std::vector<std::uint32_t>& cells;
    explicit EnteredCells(std::vector<std::uint32_t>& entered) : cells(entered) {}
    void crossed(std::uint32_t cell) { cells.push_back(cell); }
};

/// What warps do for a picture, counted: a warp takes as many steps as its longest lane.
struct WarpWorkCounts {
    double lost = 0;      ///< steps of lanes that wait, a step that is taken
    double distinct = 0;  ///< cells that a warp reads, on average
    double of_block = 0;  ///< cells that a block of four warps reads
};

std::size_t distinct_of(std::vector<std::uint32_t> cells) {
    std::ranges::sort(cells);
    return static_cast<std::size_t>(std::unique(cells.begin(), cells.end()) - cells.begin());
}

WarpWorkCounts count_work(const accel::SceneView& scene, const Camera& camera, PixelOrder order) {
    const CameraFrame frame = make_frame(camera);
    const auto start = static_cast<std::uint32_t>(start_cell(scene, frame));
    const PixelBatches batches(order, camera.width, camera.height);
    WarpWorkCounts counts;
    double taken = 0, needed = 0, blocks = 0;
    std::vector<std::uint32_t> of_block;
    for (std::uint32_t batch = 0; batch < batches.count; ++batch) {
        std::vector<std::uint32_t> of_warp;
        std::size_t longest = 0;
        for (std::uint32_t lane = 0; lane < 32; ++lane) {
            std::uint32_t x, y;
            if (!batches.pixel(batch, lane, x, y)) continue;
            std::vector<std::uint32_t> entered = {start};
            EnteredCells events(entered);
            const Vec3f direction = frame.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            Vec3f throughput = {1, 1, 1};
            walk(scene, make_ray_unchecked(frame.origin, direction), start, NoLimit{}, throughput, events);
            longest = std::max(longest, entered.size());
            needed += static_cast<double>(entered.size());
            of_warp.insert(of_warp.end(), entered.begin(), entered.end());
        }
        taken += 32 * static_cast<double>(longest);
        counts.distinct += static_cast<double>(distinct_of(of_warp)) / batches.count;
        of_block.insert(of_block.end(), of_warp.begin(), of_warp.end());
        if (batch % 4 == 3) {
            counts.of_block += static_cast<double>(distinct_of(of_block));
            ++blocks;
            of_block.clear();
        }
    }
    counts.lost = taken / needed - 1;
    counts.of_block /= blocks;
    return counts;
}

/// Through the doors of an office, along its corridor.
class WarpsInAnOffice : public testing::Test {
protected:
    WarpsInAnOffice() : scene_(accel::assemble(test::synthetic_office({.rooms_per_row = 10, .rows = 4, .turn = 0.2}))) {
        const accel::SceneView& scene = scene_.view();
        std::uint32_t widest = 0, most = 0;  // the room with most sides: a corridor, which sees into many others
        for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
            if (scene.cells[c].label != accel::Label::Room || scene.cells[c].section_count <= most) continue;
            widest = c;
            most = scene.cells[c].section_count;
        }
        camera_.eye = test::centre_of(scene, widest);
        camera_.eye.z = scene.cells[widest].z_floor + 1.6;
        camera_.target = camera_.eye + Vec3d{0.9, 0.5, -0.05};
        camera_.width = camera_.height = 192;
        for (const PixelOrder order : orders) counts_.push_back(count_work(scene_.view(), camera_, order));
    }
    [[nodiscard]] const WarpWorkCounts& of(PixelOrder order) const { return counts_[static_cast<std::size_t>(order)]; }

    accel::Scene scene_;
    Camera camera_;
    std::vector<WarpWorkCounts> counts_;
};

TEST_F(WarpsInAnOffice, WaitLessForTilesThanForRows) {
    EXPECT_GT(of(PixelOrder::Rows).lost, 0);
    EXPECT_LT(of(PixelOrder::Tiles).lost, of(PixelOrder::Rows).lost);
    EXPECT_LE(of(PixelOrder::Morton).lost, of(PixelOrder::Tiles).lost * 1.0001);
}

TEST_F(WarpsInAnOffice, ReadFewerCellsForTilesThanForRows) {
    EXPECT_LT(of(PixelOrder::Tiles).distinct, of(PixelOrder::Rows).distinct);
}

TEST_F(WarpsInAnOffice, ShareMoreCellsWithTheNextOnesAlongAZCurve) {
    EXPECT_LE(of(PixelOrder::Morton).of_block, of(PixelOrder::Tiles).of_block);
    EXPECT_LT(of(PixelOrder::Morton).of_block, of(PixelOrder::Rows).of_block);
}

}  // namespace
}  // namespace enfilade::render::cuda
