// Meshes as they are found: scanned, broken, without end at one vertex.

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "render/executor.h"
#include "render/object_tracer.h"
#include "render/plain_bvh.h"
#include "tests/support/object_rays.h"

namespace enfilade::render {
namespace {

using accel::MeshId;
using test::Verdict;

/// Vertices and faces of an OBJ or OFF file, faces as fans, moved and scaled into a cube of side 2 about the origin.
accel::InputMesh read_plainly(const std::filesystem::path& path) {
    accel::InputMesh mesh;
    mesh.name = path.stem().string();
    std::ifstream in(path);
    const auto add_face = [&](const std::vector<std::uint32_t>& corners) {
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    };
    if (path.extension() == ".off") {
        std::string word;
        std::size_t vertices = 0, faces = 0, edges = 0;
        in >> word >> vertices >> faces >> edges;
        mesh.vertices.resize(vertices);
        for (auto& v : mesh.vertices) in >> v[0] >> v[1] >> v[2];
        for (std::size_t f = 0; f < faces; ++f) {
            std::size_t count = 0;
            in >> count;
            std::vector<std::uint32_t> corners(count);
            for (std::uint32_t& c : corners) in >> c;
            std::getline(in, word);
            add_face(corners);
        }
    } else {
        std::string line, word;
        while (std::getline(in, line)) {
            std::istringstream words(line);
            words >> word;
            if (word == "v") {
                auto& v = mesh.vertices.emplace_back();
                words >> v[0] >> v[1] >> v[2];
            } else if (word == "f") {
                std::vector<std::uint32_t> corners;
                while (words >> word) corners.push_back(static_cast<std::uint32_t>(std::stoul(word)) - 1);
                add_face(corners);
            }
            word.clear();
        }
    }
    std::array<float, 3> low = {1e30f, 1e30f, 1e30f}, high = {-1e30f, -1e30f, -1e30f};
    for (const auto& v : mesh.vertices) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], v[k]);
            high[k] = std::max(high[k], v[k]);
        }
    }
    const float size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    for (auto& v : mesh.vertices)
        for (std::size_t k = 0; k < 3; ++k) v[k] = (v[k] - 0.5f * (low[k] + high[k])) * 2 / size;
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    return mesh;
}

class ObjectMeshes : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Shared, ObjectMeshes,
                         ::testing::Values("c3tm_stanford-bunny.obj", "c3tm_rocker-arm.obj", "c3tm_suzanne.obj",
                                           "c3tm_teapot.obj", "cgal_armadillo.off", "cgal_b9_mesh.off",
                                           "cgal_degtri_sliding.off", "cgal_elephant-with-holes.off"),
                         [](const auto& tried) {
                             std::string name = tried.param;
                             for (char& letter : name)
                                 if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
                             return name;
                         });

TEST_P(ObjectMeshes, AreHitAsByBruteForce) {
    const std::filesystem::path path = std::filesystem::path(ENFILADE_SOURCE_DIR) / "../shared/data/mesh" / GetParam();
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs " << path.filename() << " of ../shared/data/mesh";
    const accel::Scene scene = test::room_of_meshes({read_plainly(path)});
    const accel::SceneView& view = scene.view();
    const int ray_count = static_cast<int>(std::clamp<std::size_t>(8000000 / view.mesh_triangles.size(), 100, 2000));
    for (const ObjectAccelKind kind : {ObjectAccelKind::Bvh, ObjectAccelKind::Plain, ObjectAccelKind::Octree}) {
        const auto built = build_object_accel(view, kind, *make_executor());
        const ObjectTracer tracer = built->tracer();
        const double most = kind == ObjectAccelKind::Octree ? 120 : 60;  // bytes a triangle
        EXPECT_LT(static_cast<double>(built->bytes()), most * static_cast<double>(view.mesh_triangles.size()) + 5000);
        test::RandomNumbers numbers(3);
        int hits = 0, at_edges = 0;
        for (int i = 0; i < ray_count; ++i) {
            const Vec3d from = numbers.point(3), to = numbers.point(0.7);
            const ObjectRay asked =
                test::object_ray(from, i % 5 == 0 ? Vec3d{0, 0, from.z > 0 ? -1.0 : 1.0} : to - from, 0, 100);
            ObjectRay answered = asked;
            tracer.nearest(tracer.state, MeshId{0}, answered);
            const Verdict verdict = test::judge(view, MeshId{0}, asked, answered, 1e-4);
            EXPECT_NE(verdict, Verdict::Wrong) << built->name() << ", ray " << i;
            hits += verdict == Verdict::Hit;
            at_edges += verdict == Verdict::AtEdge;
        }
        EXPECT_LE(at_edges, ray_count / 50);
        if (view.mesh_triangles.size() > 100) {
            EXPECT_GT(hits, ray_count / 10);
        }
    }
}

/// From the root to the farthest leaf.
std::uint32_t depth_of(const BvhView& bvh, std::uint32_t node) {
    std::uint32_t deepest = 0;
    for (const std::uint32_t child : bvh.nodes[node].child)
        deepest = std::max(deepest, (child & leaf_bit) != 0 ? 1 : 1 + depth_of(bvh, child));
    return deepest;
}

accel::InputMesh needles_on_one_vertex(std::uint32_t count) {
    accel::InputMesh mesh;
    mesh.vertices.push_back({0, 0, 0});
    for (std::uint32_t i = 0; i <= count; ++i) {
        const double turn = 6.283185307179586 * i / count;
        mesh.vertices.push_back({static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)), 0.25f});
        if (i < count) mesh.triangles.push_back({0, i + 1, i + 2});
    }
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    return mesh;
}

/// The same triangle many times.
accel::InputMesh copies(std::uint32_t count) {
    accel::InputMesh mesh;
    mesh.vertices = {{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f}};
    mesh.triangles.assign(count, {0, 1, 2});
    mesh.triangle_materials.assign(count, 0);
    return mesh;
}

/// Each triangle half as large as the one before, towards one point: halves by area never balance.
accel::InputMesh ever_smaller(std::uint32_t count) {
    std::vector<std::array<std::array<float, 3>, 3>> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float s = std::ldexp(1.0f, -static_cast<int>(i % 100));
        triangles.push_back({{{s, 0, 0}, {s, s, 0}, {s, 0, s}}});
    }
    return test::soup(triangles);
}

TEST(PlainBvh, StaysShallowAndSmallWhateverTheTrianglesAre) {
    const accel::Scene scene =
        test::room_of_meshes({needles_on_one_vertex(1000000), copies(300000), ever_smaller(20000),
                              test::box_mesh({-1, -1, -1}, {1, 1, 1}), copies(1)});
    const accel::SceneView& view = scene.view();
    for (std::uint32_t m = 0; m < view.meshes.size(); ++m) {
        const PlainBvh bvh(view, static_cast<MeshId>(m), *make_executor());
        EXPECT_LT(depth_of(bvh.view(), 0), largest_bvh_depth) << m;
        EXPECT_LE(bvh.bytes(), (sizeof(BvhNode) + 4) * std::size_t{view.meshes[m].triangle_count}) << m;
    }
}

TEST(PlainBvh, DoesNotDependOnTheExecutor) {
    const accel::Scene scene =
        test::room_of_meshes({needles_on_one_vertex(100000), test::random_soup(60000, 0.02f, 9)});
    for (const std::uint32_t m : {0u, 1u}) {
        const PlainBvh alone(scene.view(), static_cast<MeshId>(m), accel::SerialExecutor());
        const PlainBvh shared(scene.view(), static_cast<MeshId>(m), accel::ThreadExecutor(3));
        ASSERT_EQ(alone.bytes(), shared.bytes());
        const std::size_t nodes = (alone.bytes() - 4 * std::size_t{scene.view().meshes[m].triangle_count}) / 64;
        EXPECT_EQ(std::memcmp(alone.view().nodes, shared.view().nodes, nodes * sizeof(BvhNode)), 0);
        EXPECT_EQ(std::memcmp(alone.view().order, shared.view().order,
                              4 * std::size_t{scene.view().meshes[m].triangle_count}),
                  0);
    }
}

/// Rays at vertices and middles of edges of a closed mesh, from outside: none may pass between its triangles.
TEST(PlainBvh, LetsNothingThroughBetweenTriangles) {
    const accel::Scene scene = test::room_of_meshes({test::ball_mesh(24, 1)});
    const accel::SceneView& view = scene.view();
    const PlainBvh bvh(view, MeshId{0}, accel::SerialExecutor());
    test::RandomNumbers numbers(13);
    int count = 0;
    for (int round = 0; round < 40; ++round) {
        const Vec3d direction = normalized(numbers.point(1));
        const Vec3d from = 3.0 * direction + numbers.point(0.01);
        for (std::uint32_t t = 0; t < view.mesh_triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const accel::Vertex& a = view.mesh_vertices[view.mesh_triangles[t].corners[k]];
                const accel::Vertex& b = view.mesh_vertices[view.mesh_triangles[t].corners[(k + 1) % 3]];
                const double share = 0.25 * static_cast<double>(round % 4);
                const Vec3d p = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
                if (length(cross(from, normalized(p - from))) > 0.9) continue;  // past the rim, or along a bump
                ObjectRay ray = test::object_ray(from, p - from, 0, 100);
                ++count;
                ASSERT_TRUE(bvh_walk<false>(bvh.view(), ray)) << "triangle " << t << ", round " << round;
            }
        }
    }
    EXPECT_GT(count, 100000);
}

}  // namespace
}  // namespace enfilade::render
