// Sixteen rays through an octree together answer, bit by bit, as each of them alone: with every instruction set.

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "accel/octree/linked_octree.h"
#include "render/mesh_trees.h"
#include "render/object_rays.h"
#include "render/octree_kernels.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/object_rays.h"
#include "tests/support/object_scenes.h"

namespace enfilade::render {
namespace {

using test::object_ray;
using test::RandomNumbers;
using Sixteen = std::array<ObjectRay, 16>;
using Valid = std::array<std::int32_t, 16>;

/// One mesh and its octree.
class MeshTree {
public:
    explicit MeshTree(const accel::InputMesh& mesh, const accel::OctreeOptions& options = {})
        : scene_(test::room_of_meshes({mesh})) {
        const accel::SceneView& view = scene_.view();
        const accel::ObjectMesh& of = view.meshes[0];
        used_ = sound_triangles(view, of);
        const accel::MeshPart part = mesh_part(view, of, used_);
        const accel::SerialExecutor alone;
        tree_ = accel::LinkedOctree(accel::build_octree(part, options, alone), part, alone);
    }
    [[nodiscard]] accel::OctreeView view() const { return tree_.view(); }

private:
    accel::Scene scene_;
    std::vector<std::uint32_t> used_;
    accel::LinkedOctree tree_;
};

/// By columns; what nobody uses is told from what is written.
ObjectRays columns_of(const Sixteen& rays) {
    ObjectRays columns;
    std::memset(&columns, 0x5a, sizeof columns);
    for (int i = 0; i < 16; ++i) {
        const ObjectRay& ray = rays[static_cast<std::size_t>(i)];
        columns.origin_x[i] = ray.origin_x;
        columns.origin_y[i] = ray.origin_y;
        columns.origin_z[i] = ray.origin_z;
        columns.near[i] = ray.near;
        columns.direction_x[i] = ray.direction_x;
        columns.direction_y[i] = ray.direction_y;
        columns.direction_z[i] = ray.direction_z;
        columns.far[i] = ray.far;
        columns.triangle[i] = ray.triangle;
        columns.mask[i] = ~0u;
    }
    return columns;
}

bool is_same(const ObjectRays& a, const ObjectRays& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// How many of the rays hit; fails where together they are not what they are alone.
int agree(const accel::OctreeView& tree, const Sixteen& rays, const Valid& valid) {
    ObjectRays alone = columns_of(rays);
    int hits = 0;
    one_by_one(valid.data(), alone, [&](ObjectRay& ray) {
        const bool is_hit = detail::octree_kernels().nearest(tree, ray);
        hits += is_hit ? 1 : 0;
        return is_hit;
    });
    alignas(64) std::int32_t aligned[16];
    std::memcpy(aligned, valid.data(), sizeof aligned);
    for (const bool apart : {false, true}) {
        ObjectRays together = columns_of(rays);
        const detail::OctreeKernels& kernels = *detail::octree_lane_kernels();
        (apart ? kernels.nearest16_apart : kernels.nearest16)(tree, aligned, together);
        EXPECT_TRUE(is_same(alone, together)) << kernels.name << (apart ? " apart" : "");
    }
    std::uint32_t blocked = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        ObjectRay any = rays[i];
        any.triangle = no_triangle;  // whatever was found before is of no interest
        if (valid[i] != 0 && detail::octree_kernels().blocked(tree, any)) blocked |= 1u << i;
    }
    ObjectRays together = columns_of(rays);
    EXPECT_EQ(detail::octree_lane_kernels()->blocked16(tree, aligned, together), blocked);
    return hits;
}

constexpr Valid everyone = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

Valid some_of(std::uint32_t bits) {
    Valid valid;
    for (std::size_t i = 0; i < 16; ++i) valid[i] = (bits >> i & 1u) != 0 ? -1 : 0;
    return valid;
}

/// Four by four neighbours from one point towards another.
Sixteen neighbours(const Vec3d& from, const Vec3d& to, double spread) {
    Sixteen rays;
    const Vec3d d = to - from, across = cross(d, Vec3d{0.3, 0.2, 1}), up = cross(across, d);
    for (int i = 0; i < 16; ++i) {
        const double x = spread * (i % 4 - 1.5) / length(across), y = spread * (i / 4 - 1.5) / length(up);
        rays[static_cast<std::size_t>(i)] = object_ray(from, d + x * across + y * up, 0, 1e30f);
    }
    return rays;
}

/// Every instruction set of this machine that has lanes.
template <class Check>
void with_every_set(const Check& check) {
    int sets = 0;
    for (const test::InstructionSet& set : test::instruction_sets()) {
        const test::UsingInstructionSet here(set);
        if (detail::octree_lane_kernels() == nullptr) continue;
        SCOPED_TRACE(set.name);
        check();
        ++sets;
    }
    if (sets == 0) GTEST_SKIP() << "no lanes in this build or on this machine";
}

std::vector<accel::InputMesh> meshes() {
    return {test::ball_mesh(24, 1), test::box_mesh({-1, -0.5f, -0.25f}, {1, 0.5f, 0.25f}),
            test::random_soup(700, 0.3f, 1), test::random_soup(4000, 0.02f, 2), test::random_soup(2, 1.5f, 3)};
}

TEST(OctreePacket, NeighboursAnswerAsAlone) {
    for (const accel::InputMesh& mesh : meshes()) {
        const MeshTree tree(mesh);
        with_every_set([&] {
            RandomNumbers numbers(1);
            int hits = 0;
            for (int block = 0; block < 300; ++block)
                hits +=
                    agree(tree.view(), neighbours(numbers.point(2.5), numbers.point(0.7), block % 3 == 0 ? 0.5 : 0.02),
                          everyone);
            EXPECT_GT(hits, 50);
        });
    }
}

TEST(OctreePacket, StrangersAnswerAsAlone) {
    for (const accel::InputMesh& mesh : meshes()) {
        const MeshTree tree(mesh);
        with_every_set([&] {
            RandomNumbers numbers(2);
            int hits = 0;
            for (int block = 0; block < 300; ++block) {
                Sixteen rays;
                for (ObjectRay& ray : rays) {
                    const Vec3d from = numbers.point(block % 2 == 0 ? 1 : 3);
                    ray = object_ray(from, numbers.point(1) - from, 0, 1e30f);
                }
                hits += agree(tree.view(), rays, everyone);
            }
            EXPECT_GT(hits, 50);
        });
    }
}

TEST(OctreePacket, AsksOnlyThoseThatAreValid) {
    const MeshTree tree(test::ball_mesh(6, 1));
    const Sixteen rays = neighbours({2, 0.4, 0.6}, {0, 0.8, 0}, 0.3);
    ObjectRays alone = columns_of(rays);
    one_by_one(everyone.data(), alone,
               [&](ObjectRay& ray) { return detail::octree_kernels().nearest(tree.view(), ray); });
    with_every_set([&] {
        const detail::OctreeKernels& kernels = *detail::octree_lane_kernels();
        int wrong = 0, hits = 0;
        for (std::uint32_t bits = 0; bits < 0x10000u; ++bits) {
            alignas(64) std::array<std::int32_t, 16> valid = some_of(bits);
            ObjectRays together = columns_of(rays);
            (bits % 4 == 3 ? kernels.nearest16_apart : kernels.nearest16)(tree.view(), valid.data(), together);
            for (int i = 0; i < 16; ++i) {
                const bool is_asked = (bits >> i & 1u) != 0;
                wrong += together.triangle[i] != (is_asked ? alone.triangle[i] : no_triangle) ||
                         together.far[i] != (is_asked ? alone.far[i] : 1e30f);
                hits += together.triangle[i] != no_triangle;
            }
        }
        EXPECT_EQ(wrong, 0);
        EXPECT_GT(hits, 100000);
    });
}

TEST(OctreePacket, KeepsEachRaysInterval) {
    const MeshTree tree(test::ball_mesh(20, 1));
    with_every_set([&] {
        RandomNumbers numbers(4);
        int hits = 0;
        for (int block = 0; block < 300; ++block) {
            Sixteen rays = neighbours(numbers.point(2.5), numbers.point(0.5), 0.1);
            for (std::size_t i = 0; i < 16; ++i) {
                rays[i].near = static_cast<float>(1 + numbers.next());
                rays[i].far = static_cast<float>(1 + numbers.next());
                if (i % 4 == 0) rays[i].near = -1;
                if (i % 4 == 1) rays[i].far = 1e30f;
            }
            hits += agree(tree.view(), rays, some_of(0xf7f3u));
        }
        EXPECT_GT(hits, 500);
    });
}

TEST(OctreePacket, KeepsWhatWasFoundBefore) {
    const MeshTree tree(test::ball_mesh(20, 1));
    with_every_set([&] {
        RandomNumbers numbers(5);
        for (int block = 0; block < 200; ++block) {
            Sixteen rays = neighbours(numbers.point(2), numbers.point(0.5), 0.1);
            for (std::size_t i = 0; i < 16; ++i) {
                if (i % 2 == 0) detail::octree_kernels().nearest(tree.view(), rays[i]);
                // Of equally near triangles the lowest counts: a higher number gives way, a lower one does not; and one
                // found again, though nearer, is no news.
                if (rays[i].triangle == no_triangle) continue;
                if (i % 8 == 2) rays[i].triangle += 1;
                if (i % 8 == 4) rays[i].triangle = 0;
                if (i % 8 == 6) rays[i].far *= 1.25f;
            }
            agree(tree.view(), rays, everyone);
        }
    });
}

TEST(OctreePacket, TakesRaysFromInsideAndFromFarAway) {
    const MeshTree tree(test::ball_mesh(20, 1));
    with_every_set([&] {
        RandomNumbers numbers(6);
        int hits = 0;
        for (int block = 0; block < 200; ++block) {
            Sixteen rays = neighbours(numbers.point(0.4), numbers.point(3), 0.1);
            hits += agree(tree.view(), rays, everyone);
            for (std::size_t i = 0; i < 16; ++i) {
                const double away = i % 3 == 0 ? 1 : i % 3 == 1 ? 50 : 1e6;
                const Vec3d to = numbers.point(0.6), from = to + away * numbers.point(3);
                rays[i] = object_ray(from, to - from, 0, 1e30f);
            }
            hits += agree(tree.view(), rays, everyone);
        }
        EXPECT_GT(hits, 3000);
    });
}

TEST(OctreePacket, TakesRaysAlongAxesAndInPlanesOfTheLattice) {
    std::vector<std::array<std::array<float, 3>, 3>> level;
    for (int i = 0; i < 1024; ++i) {
        const auto x = static_cast<float>(i % 32) / 16 - 1, y = static_cast<float>(i / 32) / 16 - 1, s = 1.0f / 16;
        level.push_back({{{x, y, 0}, {x + s, y, 0}, {x, y + s, 0}}});
        level.push_back({{{x + s, y, 0}, {x + s, y + s, 0}, {x, y + s, 0}}});
        level.push_back({{{x, 0, y}, {x + s, 0, y}, {x, 0, y + s}}});
    }
    for (const accel::InputMesh& mesh : {test::soup(level), test::box_mesh({-1, -1, -1}, {1, 1, 1})}) {
        const MeshTree tree(mesh, {.leaf_size = 4});
        with_every_set([&] {
            RandomNumbers numbers(7);
            int hits = 0;
            for (int block = 0; block < 300; ++block) {
                Sixteen rays;
                const double z = block % 2 == 0 ? 2 : 0.5;
                for (std::size_t i = 0; i < 16; ++i) {
                    // Through corners of triangles, and along faces of cells.
                    const double x = std::round(16 * numbers.next()) / 16, y = std::round(16 * numbers.next()) / 16;
                    const double zero = i % 2 == 0 ? 0.0 : -0.0;
                    const std::size_t axis = block % 4 == 0 ? i % 3 : static_cast<std::size_t>(block % 3);
                    const double down = i % 5 < 3 ? -1 : 1;
                    rays[i] = axis == 0   ? object_ray({-down * z, x, y}, {down, zero, zero}, 0, 1e30f)
                              : axis == 1 ? object_ray({x, -down * z, y}, {zero, down, zero}, 0, 1e30f)
                                          : object_ray({x, y, -down * z}, {zero, zero, down}, 0, 1e30f);
                    if (i % 7 == 3) rays[i].direction_x += static_cast<float>(1e-33 * numbers.next());
                }
                hits += agree(tree.view(), rays, everyone);
            }
            EXPECT_GT(hits, 500);
        });
    }
}

TEST(OctreePacket, TakesDirectionsOfAnyLength) {
    const MeshTree tree(test::ball_mesh(12, 1));
    with_every_set([&] {
        RandomNumbers numbers(11);
        int hits = 0;
        for (int block = 0; block < 200; ++block) {
            Sixteen rays = neighbours(numbers.point(2), numbers.point(0.5), 0.1);
            for (std::size_t i = 0; i < 16; ++i) {
                const float length = std::ldexp(1.0f, static_cast<int>(110 * numbers.next()));
                rays[i].direction_x *= length;
                rays[i].direction_y *= length;
                rays[i].direction_z *= length;
                rays[i].far = 3e38f;
            }
            hits += agree(tree.view(), rays, everyone);
        }
        EXPECT_GT(hits, 1000);
    });
}

TEST(OctreePacket, TakesMeshesFarFromTheirOwnOriginAndSlivers) {
    accel::InputMesh mesh = test::random_soup(3000, 0.05f, 12);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        // Every third triangle becomes a sliver towards its second corner.
        if (i % 9 == 8)
            for (std::size_t k = 0; k < 3; ++k)
                mesh.vertices[i][k] = mesh.vertices[i - 1][k] + 1e-3f * (mesh.vertices[i][k] - mesh.vertices[i - 1][k]);
        mesh.vertices[i][0] += 1000;
        mesh.vertices[i][1] -= 300;
    }
    const MeshTree tree(mesh);
    const Vec3d middle = {1000, -300, 0};
    with_every_set([&] {
        RandomNumbers numbers(13);
        int hits = 0;
        for (int block = 0; block < 600; ++block) {
            const auto& aim = mesh.vertices[static_cast<std::size_t>(block) * 7 % mesh.vertices.size()];
            const Vec3d to = block % 2 == 0 ? middle + numbers.point(0.8) : Vec3d{aim[0], aim[1], aim[2]};
            hits +=
                agree(tree.view(), neighbours(middle + numbers.point(2.5), to, block % 3 == 0 ? 1e-4 : 0.05), everyone);
        }
        EXPECT_GT(hits, 1000);
    });
}

TEST(OctreePacket, TakesMeshesThatAreHardlyOnes) {
    std::vector<std::array<std::array<float, 3>, 3>> fan, same;
    for (int i = 0; i < 500; ++i) {
        const auto a = static_cast<float>(0.0125 * i);
        fan.push_back(
            {{{0, 0, 0}, {std::cos(a), std::sin(a), 0.2f}, {std::cos(a + 0.01f), std::sin(a + 0.01f), 0.2f}}});
        same.push_back({{{-1, -1, 0.1f}, {1, -1, 0.1f}, {0, 1, 0.1f}}});
    }
    for (const accel::InputMesh& mesh :
         {test::soup(fan), test::soup(same), accel::InputMesh{}, test::soup({{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}}),
          test::soup({{{{-1, 0, 0}, {1, 0, 0}, {0, 1e-7f, 0}}}})}) {
        const MeshTree tree(mesh);
        with_every_set([&] {
            RandomNumbers numbers(8);
            for (int block = 0; block < 60; ++block)
                agree(tree.view(), neighbours(numbers.point(2), numbers.point(0.3), 0.05), everyone);
        });
    }
}

TEST(OctreePacket, TakesAnyDepthAndAnySizeOfLeaves) {
    for (const std::uint32_t depth : {0u, 1u, 3u, 9u, accel::largest_octree_depth}) {
        for (const std::uint32_t leaf_size : {1u, 5u, 16u, 40u}) {
            const MeshTree tree(test::random_soup(300, 0.2f, 9), {.depth = depth, .leaf_size = leaf_size});
            with_every_set([&] {
                RandomNumbers numbers(10);
                int hits = 0;
                for (int block = 0; block < 40; ++block)
                    hits += agree(tree.view(), neighbours(numbers.point(2.5), numbers.point(0.7), 0.1), everyone);
                EXPECT_GT(hits, 20);
            });
        }
    }
}

}  // namespace
}  // namespace enfilade::render
