// What warps do with an octree's rays, counted: schedules change when work is done, not how much of it.
#include <gtest/gtest.h>

#include "render/cuda/octree_counts.h"
#include "render/cuda/octree_rays.h"
#include "tests/render/cuda/octree_cases.h"

namespace enfilade::render::cuda {
namespace {

using Kind = OctreeSchedule::Kind;

/// Bounces in a ball of bumps: rays of one warp go different ways.
class OctreeWarps : public testing::Test {
protected:
    static constexpr int width = 128;
    OctreeWarps() {
        Camera camera;
        camera.eye = {2, 1, 1};
        camera.target = {0, 0, 0};
        camera.fov_deg = 50;
        camera.width = camera.height = width;
        OctreeRays first(*device_, width * width, true), bounced(*device_, width * width, false);
        first.primary(make_frame(camera), width, width);
        first.nearest(octree_, {});
        bounced.diffuse(first, octree_, 1);
        rays_ = bounced.rays();
        job_.rays = rays_.data();
        answers_.resize(rays_.size());
        job_.answers = answers_.data();
    }
    [[nodiscard]] CountedWarps count(const OctreeSchedule& schedule) {
        return count_octree_warps(std::get<RecordTree>(octree_.tree()), job_, static_cast<std::uint32_t>(rays_.size()),
                                  schedule);
    }

    accel::SerialExecutor cores_;
    std::unique_ptr<Device> device_ = open_host(cores_);
    test::TriedMesh mesh_{test::ball_mesh(30, 1)};
    accel::LinkedOctree linked_{accel::build_octree(mesh_.part(), {.depth = 5, .leaf_size = 8}, cores_), mesh_.part(),
                                cores_};
    DeviceOctree octree_{*device_, upload_octree(*device_, linked_), {}};
    std::vector<OctreeRay> rays_;
    std::vector<OctreeAnswer> answers_;
    OctreeJob job_ = {};
};

TEST_F(OctreeWarps, EveryScheduleEntersTheSameLeavesAndTestsTheSameTriangles) {
    const CountedWarps simple = count({.kind = Kind::PerLeaf});
    EXPECT_GT(simple.leaves, rays_.size() / 10);
    for (const OctreeSchedule& schedule :
         {OctreeSchedule{.kind = Kind::WhileWhile}, OctreeSchedule{.kind = Kind::Postponed},
          OctreeSchedule{.kind = Kind::Persistent}}) {
        const CountedWarps other = count(schedule);
        EXPECT_EQ(other.leaves, simple.leaves);
        EXPECT_EQ(other.looks, simple.looks);
        EXPECT_EQ(other.test_lanes, simple.test_lanes);
        EXPECT_EQ(other.step_lanes, other.leaves);
    }
}

TEST_F(OctreeWarps, WaitingForTrianglesTestsThemMoreTogether) {
    const CountedWarps simple = count({.kind = Kind::PerLeaf}), together = count({.kind = Kind::WhileWhile});
    EXPECT_LT(together.tests, simple.tests);
    EXPECT_GT(together.test_share(), simple.test_share());
}

TEST_F(OctreeWarps, LanesThatAreLeftStopTestingAndGoOnLater) {
    const CountedWarps all = count({.kind = Kind::Persistent, .testing = 0}),
                       some = count({.kind = Kind::Persistent, .testing = 16});
    EXPECT_EQ(some.test_lanes, all.test_lanes);
    EXPECT_GT(some.test_share(), 1.1 * all.test_share());
}

TEST_F(OctreeWarps, FetchingRaysKeepsLanesAtWork) {
    const CountedWarps fixed = count({.kind = Kind::Postponed}), fetched = count({.kind = Kind::Persistent});
    EXPECT_GT(fetched.step_share(), 1.1 * fixed.step_share());
    EXPECT_LT(fetched.steps, fixed.steps);
}

TEST_F(OctreeWarps, LeavesForDevicesTakeFewerLoadsAndTurns) {
    const auto count_with = [&](const accel::OctreeOptions& options) {
        const DeviceOctree octree(*device_, build_octree_arrays(*device_, mesh_.part(), options, cores_), {});
        return count_octree_warps(std::get<RecordTree>(octree.tree()), job_, static_cast<std::uint32_t>(rays_.size()),
                                  {});
    };
    const CountedWarps by_registers = count_with({}), one_by_one = count_with(device_octree_options());
    const auto loads = [](const CountedWarps& work) { return work.looks + work.leaves + 3 * work.test_lanes; };
    EXPECT_LT(2 * loads(one_by_one), loads(by_registers));
    EXPECT_LT(2 * one_by_one.tests, by_registers.tests);
    EXPECT_LT(one_by_one.leaves, 2 * by_registers.leaves);
}

TEST_F(OctreeWarps, RecordsAreFewerSectorsThanColumns) {
    const DeviceOctree columns(*device_, upload_octree(*device_, linked_), {TriangleLayout::Columns}),
        octant_leaves(*device_, upload_octree(*device_, linked_), {TriangleLayout::Records, true});
    const auto rays = static_cast<std::uint32_t>(rays_.size());
    const CountedWarps by_record = count({}),
                       by_column = count_octree_warps(std::get<ColumnTree>(columns.tree()), job_, rays, {}),
                       by_octant = count_octree_warps(std::get<RecordTree>(octant_leaves.tree()), job_, rays, {});
    EXPECT_EQ(by_record.test_lanes, by_column.test_lanes);
    EXPECT_LE(by_record.triangle_sectors, 2 * by_record.test_lanes);
    EXPECT_LT(2 * by_record.triangle_sectors, by_column.triangle_sectors);
    EXPECT_EQ(by_octant.triangle_sectors, by_record.triangle_sectors);
    EXPECT_LE(by_record.leaf_sectors, by_record.leaves);
    EXPECT_LE(by_octant.leaf_sectors, by_octant.leaves);
    EXPECT_EQ(by_column.leaf_sectors, by_record.leaf_sectors);
}

TEST_F(OctreeWarps, TilesGoTogetherBetterThanRows) {
    OctreeJob tiles = {};
    Camera camera;
    camera.eye = {2, 1, 1};
    camera.target = {0, 0, 0};
    camera.fov_deg = 50;
    camera.width = camera.height = width;
    tiles.camera = make_frame(camera);
    tiles.pixels = {width, width};
    tiles.answers = answers_.data();
    std::vector<OctreeRay> rows;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) rows.push_back(primary_ray(tiles.camera, {x, y}));
    OctreeJob by_rows = job_;
    by_rows.rays = rows.data();
    const auto& tree = std::get<RecordTree>(octree_.tree());
    const CountedWarps of_tiles = count_octree_warps(tree, tiles, width * width, {}),
                       of_rows = count_octree_warps(tree, by_rows, width * width, {});
    EXPECT_EQ(of_tiles.leaves, of_rows.leaves);
    EXPECT_LT(of_tiles.steps, of_rows.steps);
    EXPECT_LT(of_tiles.tests, of_rows.tests);
}

}  // namespace
}  // namespace enfilade::render::cuda
