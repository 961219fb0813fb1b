// Octrees that a device builds are the host's, array by array and bit by bit.
#include "render/cuda/octree_build.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "render/cuda/octree_rays.h"
#include "render/cuda/scan.h"
#include "tests/accel/octree_meshes.h"
#include "tests/render/cuda/octree_cases.h"
#include "tests/support/devices.h"

namespace enfilade::render::cuda {
namespace {

class DeviceBuilds : public test::DeviceTest {
protected:
    struct Built {
        std::string name;
        accel::MeshPart part;
        std::size_t vertices, triangles;
    };

    /// Those of octree_cases.h, and some that are hard to split; with thousands of triangles, as large nodes have.
    template <class Check>
    void with_each_mesh(const Check& check) {
        std::vector<test::NamedMesh> named = test::octree_case_meshes();
        named.push_back({"large ball", test::ball_mesh(40, 1)});
        for (const test::NamedMesh& each : named) {
            const test::TriedMesh mesh(each.mesh);
            check(Built{each.name, mesh.part(), mesh.places().size(), mesh.triangles().size()});
        }
        std::map<std::string, test::OctreeMesh> hard = {{"needles", test::OctreeMesh::needles(300)},
                                                        {"on one vertex", test::OctreeMesh::on_one_vertex(5000)},
                                                        {"disc", test::OctreeMesh::disc(100)},
                                                        {"identical", test::OctreeMesh::identical(200)},
                                                        {"every third", test::OctreeMesh::soup(3000, 0.05)}};
        hard.at("every third").use_every(3);
        for (const auto& [name, mesh] : hard) {
            const accel::MeshPart part = mesh.part();
            check(Built{name, part, 3 * mesh.all(), mesh.all()});
        }
    }

    template <class T>
    static bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
        return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
    }

    accel::ThreadExecutor cores_{2};
};
ENFILADE_ON_DEVICES(DeviceBuilds);

TEST_P(DeviceBuilds, SumsBeforeEach) {
    std::vector<std::uint32_t> numbers(100'001), expected;
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = static_cast<std::uint32_t>(i * 2654435761u % 1000u);
        expected.push_back(sum);
        sum += numbers[i];
    }
    const Buffer<std::uint32_t> from(device(), numbers), to(device(), numbers.size());
    Scanner scanner(device());
    for (int again = 0; again < 2; ++again) {
        scanner.sums_before(from.data(), to.data(), numbers.size());
        EXPECT_EQ(to.read(), expected);
    }
    scanner.sums_before(from.data(), to.data(), 0);
}

TEST_P(DeviceBuilds, TreesAreTheHosts) {
    std::size_t leaves = 0, references = 0;
    with_each_mesh([&](const Built& each) {
        const MeshOnDevice mesh(device(), each.part, each.vertices, each.triangles);
        for (const DeviceOctreeBuild& build :
             {DeviceOctreeBuild{.leaf_size = 8}, DeviceOctreeBuild{.depth = 0, .leaf_size = 1},
              DeviceOctreeBuild{.depth = 3, .leaf_size = 0}, DeviceOctreeBuild{.depth = 7, .leaf_size = 3}}) {
            const accel::Octree host =
                accel::build_octree(each.part, {.depth = build.depth, .leaf_size = build.leaf_size}, cores_);
            const accel::Octree tree = build_octree_on(device(), mesh, build).read();
            const std::string at = each.name + ", depth " + std::to_string(host.frame.depth);
            EXPECT_EQ(tree.frame.depth, host.frame.depth) << at;
            EXPECT_EQ(tree.frame.low, host.frame.low) << at;
            EXPECT_EQ(tree.frame.cells_a_unit, host.frame.cells_a_unit) << at;
            EXPECT_EQ(tree.root, host.root) << at;
            EXPECT_TRUE(same_bytes(tree.children, host.children)) << at;
            EXPECT_TRUE(same_bytes(tree.leaves, host.leaves)) << at;
            EXPECT_TRUE(same_bytes(tree.references, host.references)) << at;
            leaves += host.leaves.size();
            references += host.references.size();
        }
    });
    EXPECT_GT(leaves, 20'000u);
    EXPECT_GT(references, 50'000u);
}

TEST_P(DeviceBuilds, ArraysForRaysAreTheHosts) {
    with_each_mesh([&](const Built& each) {
        const MeshOnDevice mesh(device(), each.part, each.vertices, each.triangles);
        for (const DeviceOctreeBuild& build : {DeviceOctreeBuild{.leaf_size = 8, .most_jump_levels = 5},
                                               DeviceOctreeBuild{.depth = 0, .leaf_size = 1, .most_jump_levels = 5},
                                               DeviceOctreeBuild{.depth = 6, .leaf_size = 2, .most_jump_levels = 5}}) {
            const accel::LinkedOctree host(
                accel::build_octree(each.part, {.depth = build.depth, .leaf_size = build.leaf_size}, cores_), each.part,
                cores_);
            const OctreeArrays expected = upload_octree(device(), host),
                               arrays = build_arrays_on(device(), mesh, build);
            const std::string at = each.name + ", depth " + std::to_string(host.view().frame.depth);
            ASSERT_EQ(arrays.view.leaves == nullptr, expected.view.leaves == nullptr) << at;
            if (expected.view.leaves == nullptr) continue;
            EXPECT_EQ(std::memcmp(&arrays.view.box, &expected.view.box, sizeof arrays.view.box), 0) << at;
            EXPECT_EQ(std::memcmp(arrays.view.low, expected.view.low, sizeof arrays.view.low), 0) << at;
            EXPECT_EQ(std::memcmp(arrays.view.high, expected.view.high, sizeof arrays.view.high), 0) << at;
            EXPECT_EQ(arrays.view.jump_levels, expected.view.jump_levels) << at;
            EXPECT_EQ(arrays.references, expected.references) << at;
            EXPECT_TRUE(same_bytes(arrays.jumps.read(), expected.jumps.read())) << at;
            EXPECT_TRUE(same_bytes(arrays.leaves.read(), expected.leaves.read())) << at;
            EXPECT_TRUE(same_bytes(arrays.corners.read(), expected.corners.read())) << at;
        }
    });
}

TEST_P(DeviceBuilds, RaysAreAnsweredWithoutTheHost) {
    const test::TriedMesh tried(test::ball_mesh(20, 1));
    const MeshOnDevice mesh(device(), tried.part(), tried.places().size(), tried.triangles().size());
    const DeviceOctree built(device(), build_arrays_on(device(), mesh, {}), {});
    const DeviceOctree uploaded(device(), build_octree_arrays(device(), tried.part(), device_octree_options(), cores_),
                                {});
    Camera camera;
    camera.eye = {2.5, 1.5, 1};
    camera.target = {0, 0, 0};
    OctreeRays rays(device(), 64 * 64, false);
    camera.width = camera.height = 64;
    rays.primary(make_frame(camera), 64, 64);
    rays.nearest(uploaded, {});
    const std::vector<OctreeAnswer> expected = rays.answers();
    EXPECT_GT(rays.hit_count(), 500u);
    rays.nearest(built, {});
    EXPECT_EQ(rays.answers(), expected);
}

TEST_P(DeviceBuilds, LeavesHaveASize) {
    const test::TriedMesh tried(test::ball_mesh(4, 1));
    const MeshOnDevice mesh(device(), tried.part(), tried.places().size(), tried.triangles().size());
    EXPECT_THROW(static_cast<void>(build_octree_on(device(), mesh, {.leaf_size = accel::OctreeOptions::automatic})),
                 std::invalid_argument);
}

}  // namespace
}  // namespace enfilade::render::cuda
