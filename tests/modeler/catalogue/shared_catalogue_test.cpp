// Meshes, homes and libraries that other people made: ../shared/data by path, Debian's libraries where they are
// installed.

#include <gtest/gtest.h>

#include "modeler/catalogue/catalogue.h"
#include "modeler/catalogue/fit_mesh.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::modeler::test {
namespace {

const std::filesystem::path shared = std::filesystem::path(ENFILADE_SOURCE_DIR) / ".." / "shared" / "data";
const std::filesystem::path debian = "/usr/share/sweethome3d/furniture";

CatalogueOptions uncached() {
    CatalogueOptions options;
    options.use_cache = false;
    return options;
}

struct Expected {
    const char* file;
    std::uint32_t triangles;
    MeshDefects defects;
};

TEST(SharedMeshes, HaveTheTrianglesAndDefectsThatTheirIndexTells) {
    if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not there";
    // A quadrangle is two triangles here, and vertices at one place are one (which makes an edge of Suzanne's crowded).
    const Expected all[] = {
        {"c3tm_stanford-bunny.obj", 69451, {.open_edges = 223}},
        {"c3tm_beetle.obj", 2053, {.open_edges = 296, .crowded_edges = 47}},
        {"c3tm_nefertiti.obj", 99938, {}},
        {"c3tm_fandisk.obj", 12946, {}},
        {"c3tm_spot.obj", 5856, {}},
        {"c3tm_suzanne.obj", 968, {.open_edges = 42, .crowded_edges = 1}},
        {"cgal_armadillo.off", 52000, {}},
        {"cgal_elephant-with-holes.off", 4463, {.open_edges = 1353}},
        {"cgal_degtri_sliding.off", 8, {.degenerate = 4, .open_edges = 6}},
        {"cgal_blobby-shuffled.off", 4050, {}},
        {"cgal_quads_to_stitch.off", 16, {.open_edges = 12}},
        {"trimesh_cubevt.obj", 12, {}},
        {"trimesh_joined_tetrahedra.obj", 8, {.crowded_edges = 3}},
        {"trimesh_polygonfaces.obj", 3, {.open_edges = 5}},
        {"trimesh_comments.off", 12, {}},
        {"trimesh_negative_indices.obj", 12, {}},
    };
    Catalogue catalogue(uncached());
    catalogue.add(shared / "mesh");
    for (const Expected& expected : all) {
        const CatalogueEntry* entry = catalogue.find(std::string("mesh/") + expected.file);
        ASSERT_NE(entry, nullptr) << expected.file;
        EXPECT_EQ(entry->triangles, expected.triangles) << expected.file;
        const MeshDefects& found = entry->defects;
        EXPECT_EQ(found.open_edges, expected.defects.open_edges) << expected.file;
        EXPECT_EQ(found.crowded_edges, expected.defects.crowded_edges) << expected.file;
        EXPECT_EQ(found.degenerate, expected.defects.degenerate) << expected.file;
        EXPECT_EQ(found.dropped, 0u) << expected.file;
    }
}

TEST(SharedHomes, GiveTheModelsOfTheirPieces) {
    const auto home = shared / "sh3d" / "andijcr_ristrutturazione_default.sh3d";
    if (!std::filesystem::exists(home)) GTEST_SKIP() << home << " is not there";
    Catalogue catalogue(uncached());
    catalogue.add(home);
    const CatalogueEntry* sofa = catalogue.find("113/mid-century-sofa.obj");
    ASSERT_NE(sofa, nullptr);
    EXPECT_EQ(sofa->kind, "sofa");
    EXPECT_NEAR(sofa->width, 1.99, 0.005);
    const LoadedMesh loaded = catalogue.load(*sofa);
    EXPECT_EQ(loaded.mesh.triangles.size(), sofa->triangles);
    // Its back is higher than its front.
    float high_back = 0;
    float high_front = 0;
    for (const auto& v : loaded.mesh.vertices) {
        if (v[1] > 0.3f) high_back = std::max(high_back, v[2]);
        if (v[1] < -0.3f) high_front = std::max(high_front, v[2]);
    }
    EXPECT_GT(high_back, high_front + 0.1f);
}

TEST(DebianLibraries, AreUsedWholly) {
    if (!std::filesystem::exists(debian)) GTEST_SKIP() << "Debian's sweethome3d-furniture is not installed";
    enfilade::test::TemporaryFolder folder;
    Catalogue catalogue({.cache = folder.path()});
    for (const char* name : {"KatorLegaz.sh3f", "Reallusion.sh3f"})
        catalogue.add(debian / name, accel::ThreadExecutor());
    std::size_t entries = 0;
    std::size_t with_kind = 0;
    for (const CatalogueEntry& entry : catalogue.entries()) {
        if (entry.id.starts_with("own/")) continue;
        ++entries;
        with_kind += !entry.kind.empty();
        EXPECT_GT(entry.triangles, 0u) << entry.id;
    }
    EXPECT_EQ(entries, 90 - 8 + 25u);  // but its doors and windows
    EXPECT_GT(with_kind, 25u);
    for (const Finding& finding : catalogue.findings()) EXPECT_NE(finding.code, "K150") << finding.sentence;
    // Sizes are what the library states, in all three directions.
    for (const CatalogueEntry& entry : catalogue.entries()) {
        if (!entry.id.starts_with("Kator")) continue;
        const MeshBox box = box_of(catalogue.load(entry).mesh);
        EXPECT_NEAR(box.side(0), entry.width, 1e-5) << entry.id;
        EXPECT_NEAR(box.side(1), entry.depth, 1e-5) << entry.id;
        EXPECT_NEAR(box.side(2), entry.height, 1e-5) << entry.id;
        EXPECT_NEAR(box.low[2], 0, 1e-6) << entry.id;
    }
}

}  // namespace
}  // namespace enfilade::modeler::test
