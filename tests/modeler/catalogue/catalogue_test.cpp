// Libraries, homes, folders and single meshes in one list; the cache.

#include "modeler/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "modeler/catalogue/fit_mesh.h"
#include "tests/plans/home_file.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::modeler::test {
namespace {

using enfilade::test::read_bytes;
using enfilade::test::TemporaryFolder;
using enfilade::test::write_bytes;
using enfilade::testing::archive;

/// A wedge: it is high at its back (z = -1 of the file) and comes down to nothing at its front (z = 1).
const std::string wedge =
    "mtllib w.mtl\nv 0 0 1\nv 1 0 1\nv 0 0 -1\nv 1 0 -1\nv 0 1 -1\nv 1 1 -1\nusemtl red\n"
    "f 1 2 6 5\nf 3 5 6 4\nf 1 5 3\nf 2 4 6\nf 1 3 4 2\n";

const std::string library_text =
    "id=Test\nname=Test\nlicense=CC0 \\u00a9\n"
    "id#1=Test#chair\nname#1=Chaise\\u0020longue chair\nmodel#1=/w/wedge.obj\nwidth#1=50\ndepth#1=60\nheight#1=90\n"
    "creator#1=Somebody\ncategory#1=Seats\ndropOnTopElevation#1=45\ndoorOrWindow#1=false\nmovable#1=true\n"
    "id#2=Test#door\nname#2=Door\nmodel#2=/w/wedge.obj\nwidth#2=90\ndepth#2=10\nheight#2=200\ndoorOrWindow#2=true\n"
    "id#3=Test#lying\nname#3=Lying wedge\nmodel#3=/w/wedge.obj\nwidth#3=100\ndepth#3=100\nheight#3=200\n"
    "modelRotation#3=1 0 0 0 0 1 0 -1 0\nelevation#3=120\ndropOnTopElevation#3=-1\n"
    "id#4=Test#none\nname#4=Nothing\nmodel#4=/absent.obj\nwidth#4=1\ndepth#4=1\nheight#4=1\n"
    "id#12=Test#old\nname#12=Old\nmodel#12=/chair.3ds\nwidth#12=1\ndepth#12=1\nheight#12=1\n"
    "id#13=Test#bed\nname#13=Bed\nmodel#13=/w/inner.zip\nwidth#13=160\ndepth#13=205\nheight#13=60\n";

std::string library() {
    return archive({{"PluginFurnitureCatalog.properties", library_text},
                    {"w/wedge.obj", wedge},
                    {"w/w.mtl", "newmtl red\nKd 1 0 0\n"},
                    {"w/inner.zip", archive({{"x/wedge.obj", wedge}, {"x/w.mtl", "newmtl red\nKd 0 1 0\n"}})},
                    {"chair.3ds", std::string(64, 'M')}});
}

class Catalogues : public ::testing::Test {
protected:
    CatalogueOptions options() const { return {.cache = folder_ / "cache"}; }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        write_bytes(folder_ / name, bytes);
        return folder_ / name;
    }
    TemporaryFolder folder_;
};

std::vector<std::string> codes_of(const Catalogue& catalogue) {
    std::vector<std::string> codes;
    for (const Finding& finding : catalogue.findings()) codes.push_back(finding.code);
    return codes;
}

std::vector<std::string> ids_of(const Catalogue& catalogue) {
    std::vector<std::string> ids;
    for (const CatalogueEntry& entry : catalogue.entries())
        if (!entry.id.starts_with("own/")) ids.push_back(entry.id);
    return ids;
}

std::string code_of(const std::filesystem::path& path, const CatalogueOptions& options) {
    try {
        Catalogue(options).add(path);
    } catch (const InputError& error) {
        return error.code;
    }
    return "";
}

TEST_F(Catalogues, ALibraryIsReadAsItsPropertiesSay) {
    Catalogue catalogue(options());
    catalogue.add(write("Test.sh3f", library()));
    EXPECT_EQ(ids_of(catalogue), (std::vector<std::string>{"Test#bed", "Test#chair", "Test#lying"}));
    const CatalogueEntry* chair = catalogue.find("Test#chair");
    ASSERT_NE(chair, nullptr);
    EXPECT_EQ(chair->name, "Chaise longue chair");
    EXPECT_EQ(chair->kind, "chair");
    EXPECT_EQ(chair->category, "Seats");
    EXPECT_EQ(chair->creator, "Somebody");
    EXPECT_EQ(chair->licence, "CC0 \xC2\xA9");
    EXPECT_NEAR(chair->width, 0.5, 1e-6);
    EXPECT_NEAR(chair->depth, 0.6, 1e-6);
    EXPECT_NEAR(chair->height, 0.9, 1e-6);
    EXPECT_NEAR(chair->top.value(), 0.45, 1e-9);
    EXPECT_EQ(chair->triangles, 8u);
    EXPECT_EQ(chair->defects, MeshDefects{});
    EXPECT_EQ(catalogue.find("Test#bed")->kind, "double_bed");
    EXPECT_NEAR(catalogue.find("Test#lying")->elevation, 1.2, 1e-9);
    EXPECT_EQ(catalogue.find("Test#lying")->top, std::nullopt);
    // The door, the absent model and the 3DS file.
    EXPECT_EQ(codes_of(catalogue), (std::vector<std::string>{"K151", "K150", "K150"}));
}

TEST_F(Catalogues, FrontsLookToMinusYAndBottomsStandAtTheOrigin) {
    Catalogue catalogue(options());
    catalogue.add(write("Test.sh3f", library()));
    const ObjectMesh mesh = catalogue.load(*catalogue.find("Test#chair")).mesh;
    const MeshBox box = box_of(mesh);
    EXPECT_NEAR(box.low[0], -0.25, 1e-6);
    EXPECT_NEAR(box.low[1], -0.3, 1e-6);
    EXPECT_EQ(box.low[2], 0);
    EXPECT_NEAR(box.high[2], 0.9, 1e-6);
    for (const auto& v : mesh.vertices) EXPECT_TRUE(v[2] < 0.1f || v[1] > 0.29f);  // its high side is its back
    ASSERT_EQ(mesh.materials.size(), 1u);
    EXPECT_EQ(mesh.materials[0], (ObjectMaterial{"red", {1, 0, 0}}));
    EXPECT_EQ(catalogue.load(*catalogue.find("Test#bed")).mesh.materials[0].colour, (std::array<float, 3>{0, 1, 0}));
}

TEST_F(Catalogues, ModelsAreTurnedAsTheLibrarySays) {
    // (x, y, z) goes to (x, z, -y): with y up after that, z of the file is up and y is towards the back.
    Catalogue catalogue(options());
    catalogue.add(write("Test.sh3f", library()));
    const ObjectMesh mesh = catalogue.load(*catalogue.find("Test#lying")).mesh;
    const MeshBox box = box_of(mesh);
    EXPECT_NEAR(box.high[2], 2.0, 1e-6);
    // The back of the wedge is its bottom now; what was low there lies in front.
    const auto lies_in_front = [](const std::array<float, 3>& v) { return v[2] < 0.01f && v[1] < -0.49f; };
    EXPECT_EQ(std::count_if(mesh.vertices.begin(), mesh.vertices.end(), lies_in_front), 2);
}

TEST_F(Catalogues, AHomeOffersTheModelsOfItsPieces) {
    const std::string xml =
        "<?xml version='1.0'?><home version='7200' wallHeight='250'>"
        "<doorOrWindow id='d' name='Door' model='w/wedge.obj' x='0' y='0' width='90' depth='10' height='200'/>"
        "<furnitureGroup id='g' name='G' x='0' y='0' width='1' depth='1' height='1'>"
        "<pieceOfFurniture id='a' name='Chair' model='w/wedge.obj' x='0' y='0' width='50' depth='60' height='90' "
        "modelRotation='0 0 1 0 1 0 -1 0 0'/></furnitureGroup>"
        "<pieceOfFurniture id='b' name='Chair' model='w/wedge.obj' x='9' y='0' width='45' depth='55' height='85'/>"
        "<light id='c' name='Source' model='7' x='9' y='0' width='1' depth='1' height='1'/>"
        "<pieceOfFurniture id='e' name='Box' model='gone' x='9' y='0' width='45' depth='55' height='85'/></home>";
    Catalogue catalogue(options());
    const auto path = write("mine.sh3d", archive({{"Home.xml", xml},
                                                  {"w/wedge.obj", wedge},
                                                  {"w/w.mtl", "newmtl red\nKd 1 0 0\n"},
                                                  {"7", "# a source of light\n"}}));
    catalogue.add(path);
    EXPECT_EQ(ids_of(catalogue), (std::vector<std::string>{"mine/7", "mine/w/wedge.obj"}));
    const CatalogueEntry* chair = catalogue.find("w/wedge.obj");
    ASSERT_NE(chair, nullptr);
    EXPECT_EQ(catalogue.find_in(path.string(), "w/wedge.obj"), chair);
    EXPECT_EQ(catalogue.find_in("another.sh3d", "w/wedge.obj"), nullptr);
    EXPECT_EQ(chair->kind, "chair");
    EXPECT_NEAR(chair->width, 0.45, 1e-6);  // the piece that is not turned says it
    const CatalogueEntry* source = catalogue.find("7");
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->triangles, 0u);
    EXPECT_TRUE(catalogue.load(*source).mesh.triangles.empty());
    EXPECT_EQ(codes_of(catalogue), (std::vector<std::string>{"K150", "K159"}));
}

TEST_F(Catalogues, AFolderIsReadWithWhatItsSidecarSays) {
    write("meshes/a/wedge.obj", wedge);
    write("meshes/table_top.off", "OFF\n4 1 0\n0 0 0\n200 0 0\n200 100 0\n0 100 70\n4 0 1 2 3\n");
    write("meshes/w.stl",
          "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 3\nendloop\n"
          "endfacet\nendsolid s\n");
    write("meshes/.hidden.obj", wedge);
    write(
        "meshes/catalogue.json",
        "{\"defaults\": {\"licence\": \"CC0\"}, \"meshes\": {\"a/wedge.obj\": {\"name\": \"Ramp\", \"kind\": \"vase\", "
        "\"size\": [0.5, 0, 0], \"front\": \"+x\", \"top\": 0.1}, \"w.stl\": {\"up\": \"y\"}, \"gone.ply\": {}}}");
    Catalogue catalogue(options());
    catalogue.add(folder_ / "meshes");
    EXPECT_EQ(ids_of(catalogue),
              (std::vector<std::string>{"meshes/a/wedge.obj", "meshes/table_top.off", "meshes/w.stl"}));
    const CatalogueEntry* ramp = catalogue.find("meshes/a/wedge.obj");
    EXPECT_EQ(ramp->name, "Ramp");
    EXPECT_EQ(ramp->kind, "vase");
    EXPECT_EQ(ramp->licence, "CC0");
    // +x of the file is its front: what was 2 deep is its width, and 1 unit is 0.25 m then.
    EXPECT_NEAR(ramp->width, 0.5, 1e-6);
    EXPECT_NEAR(ramp->depth, 0.25, 1e-6);
    EXPECT_NEAR(ramp->height, 0.25, 1e-6);
    const CatalogueEntry* table = catalogue.find("meshes/table_top.off");
    EXPECT_EQ(table->name, "table top");
    EXPECT_NEAR(table->width, 2, 1e-6);  // 200 m are taken as 200 cm, and told
    EXPECT_NEAR(table->height, 0.7, 1e-6);
    EXPECT_EQ(table->kind, "dining_table");
    const CatalogueEntry* stl = catalogue.find("meshes/w.stl");
    EXPECT_NEAR(stl->height, 2, 1e-6);
    EXPECT_NEAR(stl->depth, 3, 1e-6);
    EXPECT_EQ(codes_of(catalogue), (std::vector<std::string>{"K157", "K153", "K156"}));
}

TEST_F(Catalogues, SourcesThatGiveNothingAreRefused) {
    EXPECT_EQ(code_of(folder_ / "absent", options()), "K101");
    EXPECT_EQ(code_of(write("text.txt", "hello"), options()), "K102");
    EXPECT_EQ(code_of(write("cut.sh3f", library().substr(0, 300)), options()), "K103");
    EXPECT_EQ(code_of(write("empty.sh3f", ""), options()), "K103");
    EXPECT_EQ(code_of(write("other.sh3f", archive({{"a", "b"}})), options()), "K104");
    EXPECT_EQ(code_of(write("none/readme.txt", "hello").parent_path(), options()), "K106");
    EXPECT_EQ(code_of(write("empty.obj", ""), options()), "K106");
    write("side/a.obj", wedge);
    EXPECT_EQ(code_of(write("side/catalogue.json", "{\"meshes\": {\"a.obj\": {\"front\": \"+y\"}}}").parent_path(),
                      options()),
              "K105");
    EXPECT_EQ(code_of(write("side/catalogue.json", "{\"meshs\": {}}").parent_path(), options()), "P102");
    EXPECT_EQ(
        code_of(write("home.sh3d", archive({{"Home.xml", "<?xml version='1.0'?><home version='7200'/>"}})), options()),
        "");
}

TEST_F(Catalogues, WhatWasAddedIsPreferredToOurOwnAndNoIdIsTakenTwice) {
    Catalogue catalogue(options());
    const std::size_t own = catalogue.entries().size();
    write("one/Test.sh3f", library());
    write("two/Test.sh3f", library());
    catalogue.add(folder_ / "one" / "Test.sh3f");
    catalogue.add(folder_ / "two" / "Test.sh3f");
    EXPECT_EQ(catalogue.entries().size(), own + 6);
    EXPECT_EQ(ids_of(catalogue), (std::vector<std::string>{"Test#bed", "Test#chair", "Test#lying", "Test/Test#bed",
                                                           "Test/Test#chair", "Test/Test#lying"}));
    EXPECT_EQ(catalogue.of_kind("double_bed").front()->id, "Test#bed");
    for (const CatalogueEntry& entry : catalogue.entries()) EXPECT_EQ(catalogue.find(entry.id), &entry);
}

TEST_F(Catalogues, AKeptIndexGivesTheSameWithoutReadingTheSource) {
    const auto path = write("Test.sh3f", library());
    const auto time = std::filesystem::last_write_time(path);
    Catalogue first(options());
    first.add(path);
    const ObjectMesh chair = first.load(*first.find("Test#chair")).mesh;
    // As many bytes of nonsense, as old: only who opens the file finds out.
    write_bytes(path, std::string(std::filesystem::file_size(path), '?'));
    std::filesystem::last_write_time(path, time);
    Catalogue second(options());
    second.add(path);
    EXPECT_EQ(ids_of(second), ids_of(first));
    EXPECT_EQ(codes_of(second), codes_of(first));
    for (const CatalogueEntry& entry : first.entries()) {
        const CatalogueEntry* again = second.find(entry.id);
        ASSERT_NE(again, nullptr);
        EXPECT_EQ(again->width, entry.width);
        EXPECT_EQ(again->top, entry.top);
        EXPECT_EQ(again->triangles, entry.triangles);
        EXPECT_EQ(again->defects, entry.defects);
        EXPECT_EQ(again->licence, entry.licence);
    }
    EXPECT_EQ(second.load(*second.find("Test#chair")).mesh, chair);
}

TEST_F(Catalogues, AnotherFileIsReadAnew) {
    const auto path = write("m.obj", wedge);
    EXPECT_NO_THROW(Catalogue(options()).add(path));
    write("m.obj", wedge + "f 1 2 3\n");
    Catalogue catalogue(options());
    catalogue.add(path);
    EXPECT_EQ(catalogue.entries().front().triangles, 9u);
}

TEST_F(Catalogues, ADamagedCacheIsMadeAnew) {
    const auto path = write("Test.sh3f", library());
    Catalogue first(options());
    first.add(path);
    const LoadedMesh chair = first.load(*first.find("Test#chair"));
    for (const int damage : {0, 1, 2}) {
        for (const auto& file : std::filesystem::directory_iterator(folder_ / "cache")) {
            std::string bytes = read_bytes(file.path());
            if (damage == 0) bytes.resize(bytes.size() / 2);
            if (damage == 1) bytes[bytes.size() * 2 / 3] ^= 0x11;
            if (damage == 2) bytes.clear();
            write_bytes(file.path(), bytes);
        }
        Catalogue again(options());
        again.add(path);
        EXPECT_EQ(ids_of(again), ids_of(first));
        EXPECT_EQ(again.load(*again.find("Test#chair")).mesh, chair.mesh);
        Catalogue kept(options());
        kept.add(path);
        EXPECT_EQ(ids_of(kept), ids_of(first));
    }
}

TEST_F(Catalogues, WithoutAPlaceForTheCacheEverythingStillWorks) {
    const auto path = write("Test.sh3f", library());
    CatalogueOptions nowhere;
    nowhere.cache = write("file", "no folder") / "cache";
    for (int k = 0; k < 2; ++k) {
        Catalogue catalogue(nowhere);
        EXPECT_NO_THROW(catalogue.add(path));
        EXPECT_EQ(catalogue.load(*catalogue.find("Test#chair")).mesh.triangles.size(), 8u);
    }
    CatalogueOptions none;
    none.use_cache = false;
    none.cache = folder_ / "unused";
    Catalogue(none).add(path);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "unused"));
}

TEST_F(Catalogues, ThreadsChangeNothing) {
    for (int k = 0; k < 40; ++k) write("many/" + std::to_string(k) + ".obj", wedge + (k % 3 == 0 ? "f 1 2 99\n" : ""));
    CatalogueOptions none;
    none.use_cache = false;
    Catalogue serial(none);
    serial.add(folder_ / "many");
    Catalogue threaded(none);
    threaded.add(folder_ / "many", accel::ThreadExecutor(4));
    EXPECT_EQ(ids_of(serial), ids_of(threaded));
    ASSERT_EQ(serial.findings().size(), threaded.findings().size());
    for (std::size_t k = 0; k < serial.findings().size(); ++k)
        EXPECT_EQ(serial.findings()[k].sentence, threaded.findings()[k].sentence);
    EXPECT_EQ(serial.find("many/0.obj")->defects.dropped, 1u);
}

}  // namespace
}  // namespace enfilade::modeler::test
