// Octrees of meshes as they are found in files and made by us: every one of ../shared/data/mesh, broken ones with it,
// and every piece of furniture of our own.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "modeler/catalogue/own_pieces.h"
#include "modeler/meshes/mesh.h"
#include "tests/support/judge_octrees.h"

namespace enfilade::test {
namespace {

/// Faces as fans, moved into a cube of side 2 about the origin.
accel::InputMesh as_fans(const modeler::Mesh& mesh) {
    accel::InputMesh fans;
    std::array<double, 3> low = {1e300, 1e300, 1e300}, high = {-1e300, -1e300, -1e300};
    for (const auto& p : mesh.points) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-300});
    for (const auto& p : mesh.points) {
        auto& v = fans.vertices.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) v[k] = static_cast<float>((p[k] - 0.5 * (low[k] + high[k])) * 2 / size);
    }
    for (std::size_t f = 0; f + 1 < mesh.ring_first.size(); ++f)
        for (std::uint32_t i = mesh.ring_first[f] + 2; i < mesh.ring_first[f + 1]; ++i)
            if (std::max({mesh.ring[mesh.ring_first[f]], mesh.ring[i - 1], mesh.ring[i]}) < mesh.points.size())
                fans.triangles.push_back({mesh.ring[mesh.ring_first[f]], mesh.ring[i - 1], mesh.ring[i]});
    return fans;
}

/// A few rays of every family, fewer to large meshes; brute force costs some nanoseconds a triangle.
OctreeTally judge(const TriedMesh& mesh, const accel::OctreeOptions& options, int most_groups) {
    const TriedOctree octree(mesh, options);
    const std::uint64_t most = accel::octree_entries_a_triangle * mesh.used().size() + accel::octree_entries_spare;
    EXPECT_LE(octree.tree().leaves.size() + octree.tree().references.size(), most);
    const auto groups = static_cast<int>(20000 / std::max<std::size_t>(1, mesh.used().size()));
    return judge_every_family(mesh, octree, std::clamp(groups, 1, most_groups), 7);
}

TEST(OctreesOfFiles, AnswerAsBruteForce) {
    const std::filesystem::path folder = std::filesystem::path(ENFILADE_SOURCE_DIR) / "../shared/data/mesh";
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "needs ../shared/data/mesh";
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string kind = entry.path().extension().string();
        if (kind != ".obj" && kind != ".off" && kind != ".ply" && kind != ".stl") continue;
        if (entry.file_size() > 3000000) continue;  // the largest is the benchmarks'
        SCOPED_TRACE(entry.path().filename().string());
        modeler::Mesh read;
        try {
            read = modeler::read_mesh(entry.path(), {.tolerant = true});
        } catch (const std::exception&) {
            continue;  // refused with a reason, which is tested where meshes are read
        }
        const TriedMesh mesh(as_fans(read));
        if (mesh.used().empty()) continue;
        ++files;
        for (const accel::OctreeOptions& options : {accel::OctreeOptions{}, {.leaf_size = 4, .is_balanced = true}}) {
            const OctreeTally tally = judge(mesh, options, 4);
            EXPECT_GT(tally.hits, tally.rays / 10);
        }
    }
    EXPECT_GE(files, 15);
}

TEST(OctreesOfOwnPieces, AnswerAsBruteForce) {
    ASSERT_GE(modeler::own_pieces().size(), 100u);
    for (const modeler::OwnPiece& piece : modeler::own_pieces()) {
        SCOPED_TRACE(piece.entry.id);
        const modeler::ObjectMesh made = piece.make(1);
        accel::InputMesh input;
        input.vertices = made.vertices;
        input.triangles = made.triangles;
        const OctreeTally tally = judge(TriedMesh(input), {}, 1);
        EXPECT_GT(tally.hits, tally.rays / 20);
        judge(TriedMesh(input), {.depth = 16, .leaf_size = 2, .is_balanced = true}, 1);
    }
}

}  // namespace
}  // namespace enfilade::test
