// What is random in paths, and what must not be: threads, passes and instruction sets change nothing; the noise that is
// told is the noise that there is; well spread samples beat random ones.

#include <gtest/gtest.h>

#include <cmath>

#include "accel/assemble.h"
#include "plans/random.h"
#include "render/executor.h"
#include "render/path_sampler.h"
#include "render/path_trace.h"
#include "tests/support/lit_rooms.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

/// Three rooms with five lamps, some of them balls.
accel::Scene lit_rooms() {
    accel::SceneInput input = test::closed_rooms(0.1);
    test::hang(input, {1.2, 1.7, 2.2}, {60, 50, 40});
    test::hang(input, {2.9, 1.5, 2.1}, {30, 30, 40}, 0.1);
    test::hang(input, {5.4, 2.4, 2.9}, {60, 60, 60}, 0.15);
    test::hang(input, {4.6, 3.9, 1.1}, {10, 5, 5});
    test::hang(input, {4.5, 6.9, 1.8}, {40, 40, 20}, 0.05);
    return accel::assemble(input);
}

Camera camera_inside(int side) {
    Camera camera;
    camera.eye = {0.7, 0.8, 1.5};
    camera.target = {4.0, 2.4, 1.2};
    camera.width = camera.height = side;
    return camera;
}

PathOptions plain_options(int samples) {
    PathOptions options;
    options.samples_per_pixel = samples;
    options.exposure = 0.02f;
    options.sky = options.sun = 0;
    return options;
}

TEST(Paths, AreTheSameForAnyThreadsAndPasses) {
    const accel::Scene scene = lit_rooms();
    const Camera camera = camera_inside(40);
    const auto one = make_executor(1), three = make_executor(3);
    PathOptions options = plain_options(64);
    options.executor = one.get();
    const PathResult whole = trace_paths(scene.view(), camera, options);
    options.executor = three.get();
    for (const int pass : {4, 16, 64}) {
        options.samples_per_pass = pass;
        const PathResult split = trace_paths(scene.view(), camera, options);
        EXPECT_EQ(split.image, whole.image);
        EXPECT_EQ(split.standard_error, whole.standard_error);
    }
    options.seed = 1;
    EXPECT_NE(trace_paths(scene.view(), camera, options).image, whole.image);
}

TEST(Paths, StopWhereTheyAreGoodEnough) {
    const accel::Scene scene = lit_rooms();
    const Camera camera = camera_inside(64);
    PathOptions options = plain_options(512);
    options.noise = 0.08;
    int told = 0;
    options.progress = [&](const PathProgress&) {
        ++told;
        return true;
    };
    const PathResult result = trace_paths(scene.view(), camera, options);
    const auto [least, most] = std::minmax_element(result.samples.begin(), result.samples.end());
    EXPECT_LT(*least, 512);
    EXPECT_GE(*least, 16);
    EXPECT_LT(result.noise.typical, 0.08);
    EXPECT_GT(told, 2);
    options.progress = [](const PathProgress&) { return false; };
    EXPECT_EQ(trace_paths(scene.view(), camera, options).samples[0], 8);
}

/// The root of the mean square of the difference of luminances over those of `truth` and 0.02: PathNoise::typical.
double measured_noise(const Image& image, const Image& truth) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Vec3f weights = {0.2126f, 0.7152f, 0.0722f};
            const double a = dot(weights, image.pixel(x, y)), b = dot(weights, truth.pixel(x, y));
            sum += (a - b) * (a - b) / ((b + 0.02) * (b + 0.02));
        }
    return std::sqrt(sum / (image.width * image.height));
}

TEST(PathNoise, IsWhatALongRunSays) {
    const accel::Scene scene = lit_rooms();
    const Camera camera = camera_inside(32);
    PathOptions options = plain_options(2048);
    options.seed = 99;
    const PathResult truth = trace_paths(scene.view(), camera, options);
    for (const int samples : {16, 64}) {
        options = plain_options(samples);
        const PathResult result = trace_paths(scene.view(), camera, options);
        const double measured = measured_noise(result.image, truth.image);
        EXPECT_GT(measured, 0.002);
        EXPECT_NEAR(result.noise.typical / measured, 1, 0.15) << samples << " samples";
        EXPECT_NEAR(result.noise.mean_luminance, truth.noise.mean_luminance,
                    4 * (result.noise.error_of_the_mean + truth.noise.error_of_the_mean));
    }
}

TEST(Paths, AreAsBrightHoweverManyLampsAreAsked) {
    const accel::Scene scene = lit_rooms();
    const Camera camera = camera_inside(32);
    const PathResult all = trace_paths(scene.view(), camera, plain_options(128));
    for (const int few : {1, 2}) {
        PathOptions options = plain_options(128);
        options.lamps_per_bounce = few;
        const PathResult some = trace_paths(scene.view(), camera, options);
        EXPECT_NEAR(some.noise.mean_luminance, all.noise.mean_luminance,
                    4 * (some.noise.error_of_the_mean + all.noise.error_of_the_mean));
        EXPECT_GT(some.noise.typical, all.noise.typical);
    }
}

TEST(Paths, AreAsBrightHoweverLampsAreSearched) {
    const accel::Scene scene = lit_rooms();
    const Camera camera = camera_inside(32);
    PathOptions options = plain_options(32);
    const PathResult trees = trace_paths(scene.view(), camera, options);
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs}) {
        options.search = search;
        const PathResult other = trace_paths(scene.view(), camera, options);
        EXPECT_LT(measured_noise(other.image, trees.image), 2e-3);  // the same samples; rounding at shadows' edges
    }
}

TEST(PathClamp, TakesLightOffAndNoise) {
    const accel::Scene scene = lit_rooms();
    const Camera camera = camera_inside(48);
    PathOptions options = plain_options(64);
    const PathResult right = trace_paths(scene.view(), camera, options);
    options.clamp = 0.2f;
    const PathResult clamped = trace_paths(scene.view(), camera, options);
    EXPECT_LT(clamped.noise.mean_luminance, right.noise.mean_luminance);
    EXPECT_GT(clamped.noise.mean_luminance, 0.5 * right.noise.mean_luminance);
    EXPECT_LT(clamped.noise.typical, right.noise.typical);
}

/// The mean square error of the share of a quarter disc, by n samples of one sequence a pixel; true_random: of as many
/// numbers that know nothing of each other.
double disc_error(std::uint32_t n, bool true_random) {
    double squares = 0;
    constexpr std::uint32_t pixels = 400;
    for (std::uint32_t p = 0; p < pixels; ++p) {
        plans::Random random{p, n};
        double inside = 0;
        for (std::uint32_t s = 0; s < n; ++s) {
            Pair pair = PathSampler(p, 5, 1, s * path_sequences).pair(3);
            if (true_random) pair = {static_cast<float>(random.uniform()), static_cast<float>(random.uniform())};
            inside += pair.u * pair.u + pair.v * pair.v < 1 ? 1 : 0;
        }
        const double error = inside / n - 3.14159265358979 / 4;
        squares += error * error;
    }
    return std::sqrt(squares / pixels);
}

TEST(PathSampler, SpreadsBetterThanChance) {
    EXPECT_LT(disc_error(64, false), 0.5 * disc_error(64, true));
    EXPECT_LT(disc_error(1024, false), 0.25 * disc_error(1024, true));
    EXPECT_LT(disc_error(1024, false), 0.2 * disc_error(64, false));  // faster than the root of the number
}

TEST(PathSampler, HasOnePointInEachStretchOfANet) {
    for (const std::uint32_t use : {0u, 7u, 77777u}) {
        for (std::uint32_t bits = 0; bits <= 6; ++bits) {  // 2^bits columns, 2^(6 - bits) rows
            std::uint64_t met = 0;
            for (std::uint32_t s = 0; s < 64; ++s) {
                const Pair p = PathSampler(3, 4, 5, s * path_sequences).pair(use);
                const auto column = static_cast<std::uint32_t>(p.u * static_cast<float>(1u << bits));
                const auto row = static_cast<std::uint32_t>(p.v * static_cast<float>(64u >> bits));
                met |= std::uint64_t{1} << (row << bits | column);
            }
            EXPECT_EQ(met, ~std::uint64_t{0}) << use << ' ' << bits;
        }
    }
}

}  // namespace
}  // namespace enfilade::render
