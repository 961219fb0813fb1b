// Kernels of single meshes answer as the scalar walks do: every octree, every layout, every schedule.
#include "render/cuda/octree_rays.h"

#include <gtest/gtest.h>

#include <cstring>

#include "render/cuda/device_scene.h"
#include "render/cuda/octree_record_trees.h"
#include "render/octree_walk.h"
#include "render/rope_walk.h"
#include "tests/render/cuda/octree_cases.h"
#include "tests/support/devices.h"

namespace enfilade::render::cuda {
namespace {

using Kind = OctreeSchedule::Kind;
using test::TriedMesh;

class DeviceOctrees : public test::DeviceTest {
protected:
    /// Numbers that differ, of `checked_`; a card may differ in one of 10^5.
    void TearDown() override {
        if (testing::Test::IsSkipped()) return;
        EXPECT_GT(checked_, 0u);
        EXPECT_GE(8 * hits_, compared_);
        EXPECT_LE(different_, device().is_card() ? checked_ / 100'000 : 0) << first_;
    }

    struct Case {
        const TriedMesh& mesh;
        const accel::Octree& tree;
        const std::vector<ObjectRay>& rays;
        std::string name;
    };

    template <class Check>
    void with_each_case(int rays_each, const Check& check, bool is_balanced = false) {
        for (const test::NamedMesh& named : test::octree_case_meshes()) {
            const TriedMesh mesh(named.mesh);
            for (accel::OctreeOptions options : test::octree_case_options()) {
                options.is_balanced = is_balanced;
                const accel::Octree tree = accel::build_octree(mesh.part(), options, cores_);
                const std::vector<ObjectRay> rays = test::octree_case_rays(mesh, tree.frame, rays_each);
                check(Case{mesh, tree, rays, named.name + ", depth " + std::to_string(tree.frame.depth)});
            }
        }
    }

    /// A batch with the rays in it.
    OctreeRays batch_of(const std::vector<ObjectRay>& rays, bool has_normals = true) {
        OctreeRays batch(device(), rays.size(), has_normals);
        std::vector<OctreeRay> packed;
        for (const ObjectRay& ray : rays) packed.push_back(test::device_ray(ray));
        batch.write(packed);
        return batch;
    }

    /// expected: the rays with their answers.
    void compare(const Case& at, const OctreeRays& batch, const std::vector<ObjectRay>& expected, const char* what) {
        const std::vector<OctreeAnswer> answers = batch.answers();
        const std::vector<Quad> normals = batch.normals();
        ASSERT_EQ(answers.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const ObjectRay& ray = expected[i];
            ++checked_;
            ++compared_;
            hits_ += ray.triangle != no_triangle ? 1 : 0;
            bool is_same = answers[i].triangle == ray.triangle && bits_of(answers[i].t) == bits_of(ray.far);
            if (is_same && ray.triangle != no_triangle && !normals.empty())
                is_same = normals[i].x == ray.normal_x && normals[i].y == ray.normal_y && normals[i].z == ray.normal_z;
            if (is_same || different_++ > 0) continue;
            first_ = at.name + ", " + what + ", ray " + std::to_string(i) + ": triangle " +
                     std::to_string(answers[i].triangle) + " at " + std::to_string(answers[i].t) + " instead of " +
                     std::to_string(ray.triangle) + " at " + std::to_string(ray.far);
        }
    }

    template <class Ask>
    std::vector<ObjectRay> answered(const std::vector<ObjectRay>& rays, const Ask& ask) {
        std::vector<ObjectRay> answered = rays;
        for (ObjectRay& ray : answered) ask(ray);
        return answered;
    }

    accel::ThreadExecutor cores_{2};
    std::size_t checked_ = 0, different_ = 0, compared_ = 0, hits_ = 0;
    std::string first_;
};
ENFILADE_ON_DEVICES(DeviceOctrees);

TEST_P(DeviceOctrees, EveryLayoutAnswersAsTheScalarWalk) {
    with_each_case(20, [&](const Case& at) {
        const accel::LinkedOctree linked(at.tree, at.mesh.part(), cores_);
        NoOctreeEvents none;
        const auto expected = answered(at.rays, [&](ObjectRay& ray) { octree_walk<false>(linked.view(), ray, none); });
        const MeshOnDevice mesh(device(), at.mesh.part(), at.mesh.places().size(), at.mesh.triangles().size());
        OctreeRays batch = batch_of(at.rays);
        for (const TriangleLayout triangles :
             {TriangleLayout::Columns, TriangleLayout::Records, TriangleLayout::Indexed}) {
            for (const bool has_octant_leaves : {false, true}) {
                const DeviceOctree octree(device(), upload_octree(device(), linked), {triangles, has_octant_leaves},
                                          &mesh);
                batch.nearest(octree, {});
                compare(at, batch, expected, "layout");
            }
        }
    });
}

TEST_P(DeviceOctrees, EveryScheduleAnswersAsTheScalarWalk) {
    with_each_case(20, [&](const Case& at) {
        const accel::LinkedOctree linked(at.tree, at.mesh.part(), cores_);
        NoOctreeEvents none;
        const auto expected = answered(at.rays, [&](ObjectRay& ray) { octree_walk<false>(linked.view(), ray, none); });
        OctreeRays batch = batch_of(at.rays);
        for (const TriangleLayout triangles : {TriangleLayout::Columns, TriangleLayout::Records}) {
            const DeviceOctree octree(device(), upload_octree(device(), linked), {triangles});
            for (const OctreeSchedule& schedule :
                 {OctreeSchedule{.kind = Kind::PerLeaf}, OctreeSchedule{.kind = Kind::WhileWhile},
                  OctreeSchedule{.kind = Kind::Postponed, .ready = 1},
                  OctreeSchedule{.kind = Kind::Postponed, .ready = 32}, OctreeSchedule{.kind = Kind::Persistent},
                  OctreeSchedule{.kind = Kind::Persistent, .ready = 8, .idle = 1, .warps_a_processor = 2}}) {
                batch.nearest(octree, schedule);
                compare(at, batch, expected, "schedule");
            }
        }
    });
}

TEST_P(DeviceOctrees, EveryDepthOfTheJumpTableFindsTheSame) {
    with_each_case(5, [&](const Case& at) {
        const accel::LinkedOctree linked(at.tree, at.mesh.part(), cores_);
        if (at.mesh.used().empty()) return;
        NoOctreeEvents none;
        const auto expected = answered(at.rays, [&](ObjectRay& ray) { octree_walk<false>(linked.view(), ray, none); });
        OctreeRays batch = batch_of(at.rays);
        for (std::uint32_t levels = at.tree.frame.depth % 2; levels <= std::min(at.tree.frame.depth, 7u); levels += 2) {
            OctreeArrays arrays = upload_octree(device(), linked);
            use_jump_levels(device(), at.tree, levels, arrays);
            const DeviceOctree octree(device(), std::move(arrays), {});
            batch.nearest(octree, {});
            compare(at, batch, expected, "jumps");
        }
        OctreeArrays arrays = upload_octree(device(), linked);
        EXPECT_THROW(use_jump_levels(device(), at.tree, at.tree.frame.depth + 1, arrays), std::invalid_argument);
    });
}

TEST_P(DeviceOctrees, RopesOfEveryKindAnswerAsTheScalarWalk) {
    for (const bool is_balanced : {true, false}) {
        with_each_case(
            10,
            [&](const Case& at) {
                OctreeRays batch = batch_of(at.rays);
                for (const bool has_stored_boxes : {true, false}) {
                    const accel::RopeOctree ropes(at.tree, at.mesh.part(), {is_balanced, has_stored_boxes}, cores_);
                    NoRopeEvents none;
                    batch.nearest(DeviceOctree(device(), ropes, false), {});
                    compare(
                        at, batch,
                        answered(at.rays, [&](ObjectRay& ray) { rope_walk<float, false>(ropes.view(), ray, none); }),
                        "ropes");
                    batch.nearest(DeviceOctree(device(), ropes, true), {});
                    compare(
                        at, batch,
                        answered(at.rays, [&](ObjectRay& ray) { rope_walk<double, false>(ropes.view(), ray, none); }),
                        "ropes in double");
                }
            },
            is_balanced);
    }
}

/// Whole rays, normals and shares of corners with them, also where a hit is known before.
TEST(RecordTrees, AnswerAsTheScalarWalkInAllTheyWrite) {
    const accel::SerialExecutor cores;
    const std::unique_ptr<Device> device = open_host(cores);
    std::size_t hits = 0;
    for (const test::NamedMesh& named : test::octree_case_meshes()) {
        const TriedMesh mesh(named.mesh);
        const accel::Octree tree = accel::build_octree(mesh.part(), device_octree_options(), cores);
        const accel::LinkedOctree linked(tree, mesh.part(), cores);
        DeviceArrays arrays(*device);
        const RecordTree record = copy_records(linked, arrays);
        for (const ObjectRay& asked : test::octree_case_rays(mesh, tree.frame, 30)) {
            NoOctreeEvents none;
            ObjectRay expected = asked, answered = asked;
            octree_walk<false>(linked.view(), expected, none);
            const RecordTrees trees = {&record};
            EXPECT_EQ(ask_blocked(trees, accel::MeshId{0}, asked), expected.triangle != no_triangle);
            ask_nearest(trees, accel::MeshId{0}, answered);
            ASSERT_EQ(std::memcmp(&answered, &expected, sizeof expected), 0) << named.name;
            hits += expected.triangle != no_triangle ? 1 : 0;
            if (expected.triangle == no_triangle) continue;
            ask_nearest(trees, accel::MeshId{0}, answered);  // the hit is known: nothing is nearer
            octree_walk<false>(linked.view(), expected, none);
            ASSERT_EQ(std::memcmp(&answered, &expected, sizeof expected), 0) << named.name;
        }
    }
    EXPECT_GT(hits, 500u);
}

TEST_P(DeviceOctrees, AnythingIsFoundWhereTheNearestIs) {
    with_each_case(20, [&](const Case& at) {
        const accel::LinkedOctree linked(at.tree, at.mesh.part(), cores_);
        const accel::RopeOctree ropes(at.tree, at.mesh.part(), {false, false}, cores_);
        OctreeRays batch = batch_of(at.rays, false);
        const DeviceOctree columns(device(), upload_octree(device(), linked), {TriangleLayout::Columns});
        const DeviceOctree records(device(), upload_octree(device(), linked), {});
        const DeviceOctree roped(device(), ropes, false);
        for (const DeviceOctree* octree : {&columns, &records, &roped}) {
            batch.nearest(*octree, {});
            const std::vector<OctreeAnswer> nearest = batch.answers();
            batch.blocked(*octree);
            const std::vector<OctreeAnswer> blocked = batch.answers();
            for (std::size_t i = 0; i < nearest.size(); ++i, ++checked_)
                if ((nearest[i].triangle == no_triangle) != (blocked[i].triangle == no_triangle)) ++different_;
        }
    });
}

TEST_P(DeviceOctrees, AHundredThousandTrianglesInALeafAreAllTested) {
    const TriedMesh mesh(test::random_soup(100'000, 0.02f, 3));
    const accel::Octree tree = accel::build_octree(mesh.part(), {.depth = 0}, cores_);
    ASSERT_EQ(tree.leaves.size(), 1u);
    ASSERT_GT(tree.leaves[0].count, 99'000u);
    const accel::LinkedOctree linked(tree, mesh.part(), cores_);
    const std::vector<ObjectRay> rays = test::octree_case_rays(mesh, tree.frame, 2);
    const auto expected = answered(rays, [&](ObjectRay& ray) { ray = mesh.nearest(ray); });
    OctreeRays batch = batch_of(rays, false);
    for (const TriangleLayout triangles : {TriangleLayout::Columns, TriangleLayout::Records}) {
        batch.nearest(DeviceOctree(device(), upload_octree(device(), linked), {triangles}), {});
        compare({mesh, tree, rays, "soup"}, batch, expected, "one leaf");
    }
}

/// A ball seen from a corner of its box's surroundings.
CameraFrame camera_of_ball(int width, int height) {
    Camera camera;
    camera.eye = {2.5, 1.5, 1};
    camera.target = {0, 0, 0};
    camera.fov_deg = 50;
    camera.width = width;
    camera.height = height;
    return make_frame(camera);
}

TEST_P(DeviceOctrees, PicturesShowWhatTheScalarWalkSees) {
    const TriedMesh mesh(test::ball_mesh(14, 1));
    const accel::Octree tree = accel::build_octree(mesh.part(), {}, cores_);
    const accel::LinkedOctree linked(tree, mesh.part(), cores_);
    const DeviceOctree octree(device(), upload_octree(device(), linked), {});
    OctreePictures pictures(device(), octree, 0xff102030u);
    Framebuffer shown;
    std::size_t lit = 0;
    for (const auto& [width, height] : {std::pair{64, 64}, std::pair{33, 7}, std::pair{1, 5}}) {
        const CameraFrame frame = camera_of_ball(width, height);
        for (const Kind kind : {Kind::PerLeaf, Kind::WhileWhile, Kind::Postponed, Kind::Persistent}) {
            pictures.draw(frame, width, height, {.kind = kind});
            pictures.read(shown);
            ASSERT_EQ(shown.rgba.size(), static_cast<std::size_t>(width * height));
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x, ++checked_) {
                    const OctreeRay asked = primary_ray(frame, {x, y});
                    ObjectRay ray = object_ray_of(asked);
                    NoOctreeEvents none;
                    const bool is_hit = octree_walk<false>(linked.view(), ray, none);
                    lit += is_hit ? 1 : 0;
                    const std::uint32_t expected =
                        is_hit ? flat_shade(asked, {ray.normal_x, ray.normal_y, ray.normal_z}) : 0xff102030u;
                    different_ += shown.rgba[static_cast<std::size_t>(y * width + x)] == expected ? 0 : 1;
                }
            }
        }
    }
    EXPECT_GT(lit, checked_ / 10);
    EXPECT_LT(lit, checked_);
}

TEST_P(DeviceOctrees, DiffuseRaysLeaveWhatWasMetOnTheSideTheyCameFrom) {
    const TriedMesh mesh(test::ball_mesh(14, 1));
    const accel::LinkedOctree linked(accel::build_octree(mesh.part(), {}, cores_), mesh.part(), cores_);
    const DeviceOctree octree(device(), upload_octree(device(), linked), {});
    OctreeRays primary(device(), 128 * 128, true), bounced(device(), 128 * 128, true);
    primary.primary(camera_of_ball(128, 128), 128, 128);
    primary.nearest(octree, {});
    bounced.diffuse(primary, octree, 1);
    const auto rays = bounced.rays(), from = primary.rays();
    const auto answers = primary.answers();
    const auto normals = primary.normals();
    double cosines = 0;
    std::size_t sent = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (answers[i].triangle == no_triangle) {
            EXPECT_LT(rays[i].far, rays[i].near);
            continue;
        }
        const Vec3f normal = {normals[i].x, normals[i].y, normals[i].z};
        const Vec3f in = {from[i].direction[0], from[i].direction[1], from[i].direction[2]};
        const Vec3f out = {rays[i].direction[0], rays[i].direction[1], rays[i].direction[2]};
        EXPECT_NEAR(dot(out, out), 1, 1e-5);
        const float cosine = dot(out, normal) / root(dot(normal, normal)) * (dot(in, normal) > 0 ? -1.0f : 1.0f);
        EXPECT_GE(cosine, -1e-5f);
        cosines += double{cosine};
        ++sent;
        const OctreeRay host =
            diffuse_ray(from[i], answers[i].t, normal, octree.size(), mixed(1 ^ mixed(static_cast<std::uint32_t>(i))));
        different_ += std::memcmp(&host, &rays[i], sizeof host) == 0 ? 0 : 1;
        ++checked_;
    }
    ASSERT_GT(sent, 2000u);
    EXPECT_EQ(sent, primary.hit_count());
    EXPECT_NEAR(cosines / static_cast<double>(sent), 2.0 / 3, 0.01);  // the mean of cosines drawn by their cosine
    bounced.diffuse(primary, octree, 2);
    EXPECT_NE(std::memcmp(bounced.rays().data(), rays.data(), rays.size() * sizeof(OctreeRay)), 0);
}

}  // namespace
}  // namespace enfilade::render::cuda
