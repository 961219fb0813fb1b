// The same rooms, lamps and camera in Blender's Cycles (3.4.1), a path tracer that shares nothing with ours:
// tools/cycles_room.py made the numbers below, 4,096 samples a pixel.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "accel/assemble.h"
#include "render/path_trace.h"
#include "tests/support/lit_rooms.h"

namespace enfilade::render {
namespace {

constexpr int blocks = 8, side = 64;

/// Mean luminance of blocks of the picture, rows from the top.
constexpr std::array<std::array<double, blocks>, blocks> of_cycles = {{
    {0.170699, 0.088747, 0.101726, 0.123812, 0.154489, 0.180138, 0.176393, 0.149098},
    {0.182425, 0.078661, 0.069107, 0.074909, 0.078490, 0.079567, 0.078967, 0.090915},
    {0.182338, 0.090665, 0.084145, 0.092331, 0.085256, 0.071587, 0.077157, 0.106184},
    {0.173848, 0.094338, 0.088585, 0.099050, 0.085636, 0.078541, 0.082790, 0.109317},
    {0.161664, 0.091548, 0.083348, 0.088551, 0.079467, 0.073583, 0.082370, 0.107982},
    {0.148894, 0.085441, 0.070575, 0.088151, 0.093578, 0.079008, 0.079604, 0.098339},
    {0.135766, 0.086683, 0.087267, 0.098668, 0.109416, 0.117196, 0.114107, 0.105267},
    {0.124707, 0.095441, 0.108051, 0.120657, 0.129877, 0.134929, 0.136476, 0.131983},
}};

accel::Scene rooms() {
    accel::SceneInput input = test::closed_rooms();
    test::paint(input, {0.6f, 0.6f, 0.6f});
    test::hang(input, {1.2, 1.7, 2.0}, {60, 60, 60});
    test::hang(input, {5.4, 2.4, 2.6}, {80, 60, 40}, 0.2);
    test::hang(input, {4.9, 6.9, 1.4}, {50, 50, 50}, 0.1);
    return accel::assemble(input);
}

struct Block {
    double luminance = 0, error = 0;  ///< standard error
};

Block block_of(const PathResult& result, int row, int column) {
    constexpr int size = side / blocks;
    double sum = 0, squares = 0;
    for (int y = row * size; y < (row + 1) * size; ++y)
        for (int x = column * size; x < (column + 1) * size; ++x) {
            sum += double{dot(Vec3f{0.2126f, 0.7152f, 0.0722f}, result.image.pixel(x, y))};
            const double error = result.standard_error[static_cast<std::size_t>(y * side + x)];
            squares += error * error;
        }
    return {sum / (size * size), std::sqrt(squares) / (size * size)};
}

TEST(Paths, AgreeWithAnotherRenderer) {
    const accel::Scene scene = rooms();
    Camera camera;
    camera.eye = {0.4, 2.6, 1.5};
    camera.target = {4.6, 1.3, 1.0};
    camera.fov_deg = 75;
    camera.width = camera.height = side;
    PathOptions options;
    options.samples_per_pixel = 256;
    options.most_bounces = 256;
    options.exposure = 0.02f;
    options.sky = options.sun = 0;
    const PathResult result = trace_paths(scene.view(), camera, options);
    double sum = 0, sum_of_cycles = 0, squares = 0;
    for (int row = 0; row < blocks; ++row)
        for (int column = 0; column < blocks; ++column) {
            const Block ours = block_of(result, row, column);
            const double theirs = of_cycles[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            EXPECT_NEAR(ours.luminance, theirs, 4.5 * ours.error + 0.005 * theirs) << row << ' ' << column;
            EXPECT_LT(ours.error, 0.02 * theirs);
            const double off = ours.luminance / theirs - 1;
            squares += off * off / (blocks * blocks);
            sum += ours.luminance;
            sum_of_cycles += theirs;
        }
    EXPECT_NEAR(sum / sum_of_cycles, 1, 0.002);
    EXPECT_LT(std::sqrt(squares), 0.01);
    RecordProperty("root of the mean square of the differences", std::to_string(std::sqrt(squares)));
}

}  // namespace
}  // namespace enfilade::render
