// Trees that were uploaded answer as those that were built, with nothing but what a ray reads.
#include "render/cuda/device_objects.h"

#include <gtest/gtest.h>

#include <cstring>

#include "render/mesh_trees.h"
#include "tests/support/object_rays.h"
#include "tests/support/object_scenes.h"

namespace enfilade::render::cuda {
namespace {

/// On the host's cores, where a test can read what was uploaded.
class DeviceObjectsTest : public testing::Test {
protected:
    DeviceObjectsTest() : scene_(test::furnished_office({.seed = 5})), arrays_(*device_) {}

    /// Asks both of them for the nearest triangle of every mesh: the same one, if any, on the same side.
    template <class Uploaded, class Built>
    void expect_same_answers(const Uploaded& uploaded, const Built& built) const {
        test::RandomNumbers random(3);
        int hits = 0;
        for (std::size_t m = 0; m < scene_.view().meshes.size(); ++m) {
            const auto mesh = static_cast<accel::MeshId>(m);
            for (int i = 0; i < 200; ++i) {
                const Vec3d from = random.point(3);
                ObjectRay ours = test::object_ray(from, random.point(1) - from, 0, 4), theirs = ours;
                ask_nearest(uploaded, mesh, ours);
                ask_nearest(built, mesh, theirs);
                ASSERT_EQ(std::memcmp(&ours, &theirs, sizeof ours), 0);
                ASSERT_EQ(ask_blocked(uploaded, mesh, test::object_ray(from, -from, 0, 4)),
                          ask_blocked(built, mesh, test::object_ray(from, -from, 0, 4)));
                hits += ours.triangle != no_triangle ? 1 : 0;
            }
        }
        EXPECT_GT(hits, 50);
    }

    accel::SerialExecutor one_;
    accel::Scene scene_;
    std::unique_ptr<Device> device_ = open_host(one_);
    DeviceArrays arrays_;
};

TEST_F(DeviceObjectsTest, OctreesAnswerAsOnTheHost) {
    const accel::SceneView copy = copy_scene(scene_.view(), arrays_);
    const DeviceObjects uploaded(arrays_, scene_.view(), copy, InsideKind::Octree, {}, one_);
    const std::vector<accel::LinkedOctree> built = build_octrees(scene_.view(), used_meshes(scene_.view()), {}, one_);
    std::vector<accel::OctreeView> views;
    for (const accel::LinkedOctree& tree : built) views.push_back(tree.view());
    expect_same_answers(uploaded.octrees(), OctreeTrees{views.data()});
}

TEST_F(DeviceObjectsTest, TreesOfBoxesAnswerAsOnTheHost) {
    const accel::SceneView copy = copy_scene(scene_.view(), arrays_);
    const DeviceObjects uploaded(arrays_, scene_.view(), copy, InsideKind::Bvh, {}, one_);
    const std::vector<PlainBvh> built = build_plain_bvhs(scene_.view(), used_meshes(scene_.view()), one_);
    std::vector<BvhView> views;
    for (const PlainBvh& tree : built) views.push_back(tree.view());
    expect_same_answers(uploaded.bvhs(), MeshTrees{views.data()});
}

TEST_F(DeviceObjectsTest, TreesOfBoxesReadTheScenesArraysOnTheDevice) {
    const accel::SceneView copy = copy_scene(scene_.view(), arrays_);
    const DeviceObjects uploaded(arrays_, scene_.view(), copy, InsideKind::Bvh, {}, one_);
    const auto* places = reinterpret_cast<const float*>(copy.mesh_vertices.data());
    for (std::size_t m = 0; m < copy.meshes.size(); ++m)
        EXPECT_EQ(uploaded.bvhs().of_mesh[m].places, places + 3 * std::size_t{copy.meshes[m].first_vertex});
}

TEST_F(DeviceObjectsTest, BricksStayOnTheHost) {
    const accel::SceneView copy = copy_scene(scene_.view(), arrays_);
    const std::size_t before = arrays_.bytes();
    const DeviceObjects uploaded(arrays_, scene_.view(), copy, InsideKind::Octree, {}, one_);
    EXPECT_EQ(uploaded.octrees().of_mesh[0].brick_masks, nullptr);
    EXPECT_EQ(uploaded.bytes(), arrays_.bytes() - before);
    std::size_t on_host = 0;
    for (const accel::LinkedOctree& tree : build_octrees(scene_.view(), used_meshes(scene_.view()), {}, one_))
        on_host += tree.bytes();
    EXPECT_LT(uploaded.bytes(), on_host);
}

TEST_F(DeviceObjectsTest, MeshesThatNobodyUsesHaveNoTree) {
    accel::SceneView scene = scene_.view();
    scene.cell_objects = {};  // no cell lists an object
    const accel::SceneView copy = copy_scene(scene, arrays_);
    for (const InsideKind kind : {InsideKind::Octree, InsideKind::Bvh}) {
        const DeviceObjects uploaded(arrays_, scene, copy, kind, {}, one_);
        ObjectRay ray = test::object_ray({3, 0, 0}, {-1, 0, 0}, 0, 9);
        if (kind == InsideKind::Octree) ask_nearest(uploaded.octrees(), accel::MeshId{0}, ray);
        else ask_nearest(uploaded.bvhs(), accel::MeshId{0}, ray);
        EXPECT_EQ(ray.triangle, no_triangle);
    }
}

}  // namespace
}  // namespace enfilade::render::cuda
