// Whole buildings furnished: the same on any number of threads, each room by itself, every guarantee, real homes.
#include "modeler/furnishing/furnish.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/furnishing/verify_furnished.h"
#include "plans/generate.h"

namespace enfilade::modeler {
namespace {

const std::filesystem::path source = ENFILADE_SOURCE_DIR;

CatalogueOptions without_cache() {
    CatalogueOptions options;
    options.use_cache = false;
    return options;
}

Building townhouse() { return build(plans::read(source / "plans" / "examples" / "townhouse.json")); }

Furnished furnish(const Building& building, const FurnishOptions& options = {},
                  const accel::Executor& executor = accel::SerialExecutor()) {
    return furnish(building, own_rules(), Catalogue(without_cache()), options, executor);
}

std::string text_of(const std::vector<FurnishingViolation>& violations) {
    std::string text;
    for (const FurnishingViolation& violation : violations)
        text += std::string(name_of(violation.fault)) + ": " + violation.object + " " + violation.other + "\n";
    return text;
}

TEST(Furnish, KeepsEveryGuaranteeInTheTownhouse) {
    const Building building = townhouse();
    const Furnished furnished = furnish(building);
    EXPECT_EQ(text_of(verify_furnished(building, furnished.furnishing)), "");
    EXPECT_GT(furnished.furnishing.objects.size(), 100u);
    EXPECT_EQ(furnished.rooms.size(), 15u);
}

TEST(Furnish, GivesASmallBathroomAToiletAndAShower) {
    const Building building = townhouse();
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        std::set<std::string> ids;
        for (const FurnishedObject& object : furnish(building, {.seed = seed, .spaces = {}}).furnishing.objects)
            ids.insert(object.id);
        EXPECT_TRUE(ids.contains("bath/toilet-1")) << seed;
        EXPECT_TRUE(ids.contains("bath/shower-1")) << seed;
    }
}

TEST(Furnish, FindsWhatIsMovedIntoAPlaceThatIsTaken) {
    const Building building = townhouse();
    Furnishing furnishing = furnish(building).furnishing;
    // Every object of a room to the place of another: the verifier has to see it.
    for (FurnishedObject& object : furnishing.objects) {
        if (object.id.find("/desk-1") == std::string::npos) continue;
        object.position[0] += 0.6;
        object.position[1] += 3;
        break;
    }
    EXPECT_NE(text_of(verify_furnished(building, furnishing)), "");
}

TEST(Furnish, IsTheSameOnOneAndTwoThreads) {
    const Building building = townhouse();
    const Furnished one = furnish(building), two = furnish(building, {}, accel::ThreadExecutor(2));
    EXPECT_EQ(one.furnishing.objects, two.furnishing.objects);
    ASSERT_EQ(one.furnishing.meshes.size(), two.furnishing.meshes.size());
    for (std::size_t k = 0; k < one.furnishing.meshes.size(); ++k)
        EXPECT_EQ(*one.furnishing.meshes[k], *two.furnishing.meshes[k]);
}

TEST(Furnish, FurnishesARoomAloneAsAmongAll) {
    const Building building = townhouse();
    const Furnished all = furnish(building);
    for (const RoomFurnished& room : all.rooms) {
        const Furnished alone = furnish(building, {.seed = 1, .spaces = {room.space}});
        ASSERT_EQ(alone.rooms.size(), 1u);
        std::vector<FurnishedObject> expected;
        for (const FurnishedObject& object : all.furnishing.objects)
            if (object.space == room.space) expected.push_back(object);
        ASSERT_EQ(alone.furnishing.objects.size(), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            EXPECT_EQ(alone.furnishing.objects[k].id, expected[k].id);
            EXPECT_EQ(alone.furnishing.objects[k].position, expected[k].position);
            EXPECT_EQ(alone.furnishing.objects[k].angle, expected[k].angle);
            EXPECT_EQ(alone.furnishing.objects[k].model, expected[k].model);
        }
    }
}

TEST(Furnish, GivesEachObjectAnIdOfItsOwnInOrder) {
    const Furnished furnished = furnish(townhouse());
    const auto& objects = furnished.furnishing.objects;
    std::set<std::string> ids;
    for (std::size_t k = 0; k < objects.size(); ++k) {
        EXPECT_TRUE(ids.insert(objects[k].id).second) << objects[k].id;
        if (k > 0) {
            EXPECT_LT(objects[k - 1].id, objects[k].id);
        }
        EXPECT_LT(objects[k].mesh, furnished.furnishing.meshes.size());
        EXPECT_TRUE(objects[k].by_rule);
    }
    for (const FurnishedObject& object : objects) {
        EXPECT_TRUE(object.stands_on.empty() || ids.contains(object.stands_on)) << object.stands_on;
    }
}

TEST(Furnish, SharesMeshesBetweenRooms) {
    const Building building = build(plans::generate({.rooms = 20}));
    const Furnished furnished = furnish(building);
    std::set<const ObjectMesh*> meshes;
    for (const auto& mesh : furnished.furnishing.meshes) meshes.insert(mesh.get());
    EXPECT_EQ(meshes.size(), furnished.furnishing.meshes.size());
    EXPECT_GT(furnished.furnishing.objects.size(), 3 * meshes.size());
}

TEST(Furnish, KeepsWhatWasThereAndAddsAroundIt) {
    Building building = townhouse();
    const Furnished first = furnish(building, {.seed = 3});
    building.furnishing = first.furnishing;
    for (FurnishedObject& object : building.furnishing.objects) object.by_rule = false;
    const Furnished second = furnish(building, {.seed = 4});
    std::map<std::string, FurnishedObject> there;
    for (const FurnishedObject& object : second.furnishing.objects) there.emplace(object.id, object);
    for (const FurnishedObject& object : building.furnishing.objects) {
        ASSERT_TRUE(there.contains(object.id)) << object.id;
        EXPECT_EQ(there.at(object.id), object);
    }
    EXPECT_EQ(text_of(verify_furnished(building, second.furnishing)), "");
}

TEST(Furnish, TellsAnUnnamedRoomByWhatThePlanHasPutThere) {
    Building building = townhouse();
    const Furnished before = furnish(building);
    std::set<std::uint32_t> with_bed;
    for (const FurnishedObject& object : before.furnishing.objects)
        if (object.id.find("/double_bed-1") != std::string::npos) {
            building.furnishing.objects.push_back(object);
            building.furnishing.objects.back().by_rule = false;
            with_bed.insert(object.space);
        }
    building.furnishing.meshes = before.furnishing.meshes;
    ASSERT_FALSE(with_bed.empty());
    for (Space& space : building.spaces)
        if (space.label == Label::Room) space.name = space.kind = "";
    const Furnished after = furnish(building);
    ASSERT_EQ(after.rooms.size(), 15u);
    for (const RoomFurnished& room : after.rooms)
        EXPECT_EQ(room.kind, with_bed.contains(room.space) ? "bedroom" : "default") << room.space;
}

TEST(Furnish, SaysWhatFoundNoPlaceAndWhatIsInNoCatalogue) {
    const Rules rules = read_rules_text(
        R"({"rooms": [{"kind": "toilet", "names": ["WC"], "objects": [
             {"object": "double_bed"}, {"object": "dragon"}, {"object": "bed", "with": [{"object": "unicorn", "place": "on_top"}]}]}]})",
        "mine.json");
    const Furnished furnished = furnish(townhouse(), rules, Catalogue(without_cache()), {});
    std::multiset<std::string> codes;
    for (const Finding& finding : furnished.findings) codes.insert(finding.code);
    EXPECT_EQ(codes.count("U206"), 2u) << "dragon, unicorn";
    EXPECT_EQ(codes.count("U201"), 1u) << "the toilet";
    EXPECT_EQ(codes.count("U204"), 14u) << "rooms that these rules do not know";
    for (const RoomFurnished& room : furnished.rooms)
        if (room.kind == "toilet") {
            EXPECT_EQ(room.placed, 0u);
            EXPECT_GE(room.requested, 2u);
            EXPECT_FALSE(room.not_placed.empty());
        }
}

TEST(Furnish, FurnishesOfficesQuicklyAndDensely) {
    plans::GenerateOptions options;
    options.rooms = 135;
    options.curved = 0.3;
    options.oblique = 0.3;
    const Building building = build(plans::generate(options));
    const Catalogue catalogue(without_cache());
    const auto start = std::chrono::steady_clock::now();
    const Furnished furnished = furnish(building, own_rules(), catalogue, {});
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(text_of(verify_furnished(building, furnished.furnishing)), "");
    std::uint32_t placed = 0, requested = 0;
    for (const RoomFurnished& room : furnished.rooms) {
        placed += room.placed;
        requested += room.requested;
    }
    std::printf("[ figures ] %zu rooms: %u of %u pieces placed (%.1f %%), %.2f a room, %.0f ms with their meshes\n",
                furnished.rooms.size(), placed, requested, 100.0 * placed / requested,
                double(placed) / double(furnished.rooms.size()), 1e3 * took);
    EXPECT_GE(placed, 8 * furnished.rooms.size());
    EXPECT_GE(placed, requested * 9 / 10);
    EXPECT_LT(took, 10) << "0.2 s on a machine of its own";
}

TEST(Furnish, KeepsEveryGuaranteeInRealHomes) {
    const std::filesystem::path data = source / ".." / "shared" / "data";
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "../shared/data is not there";
    const Catalogue catalogue(without_cache());
    std::size_t homes = 0, objects = 0;
    for (const char* file :
         {"rtreffer_home_xml.sh3d", "jonwilliams84_Home-Clean-Base-RAL.sh3d", "andijcr_ristrutturazione_default.sh3d",
          "abesalomi_v1.sh3d", "PaddyHuang_Home.sh3d", "Gel0bmstu_flat.sh3d", "FreeCAD_0-JoinWall.sh3d"}) {
        std::filesystem::path path = data / file;
        if (!std::filesystem::exists(path)) path = data / "sh3d" / file;
        if (!std::filesystem::exists(path)) continue;
        try {
            const Building building = build(plans::read(path));
            const Furnished furnished = furnish(building, own_rules(), catalogue, {});
            EXPECT_EQ(text_of(verify_furnished(building, furnished.furnishing)), "") << file;
            ++homes;
            objects += furnished.furnishing.objects.size();
        } catch (const InputError& error) {
            ADD_FAILURE() << file << ": " << error.what();
        }
    }
    EXPECT_GE(homes, 5u);
    EXPECT_GT(objects, 20 * homes);
}

}  // namespace
}  // namespace enfilade::modeler
