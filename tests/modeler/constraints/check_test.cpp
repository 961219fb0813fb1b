#include "modeler/check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "modeler/build.h"
#include "modeler/constraints/constraints.h"
#include "modeler/convexify.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

/// The codes of errors, each once.
std::vector<std::string> error_codes(const CheckReport& report) {
    std::vector<std::string> codes;
    for (const Finding& finding : report.findings)
        if (finding.severity == Severity::Error && std::find(codes.begin(), codes.end(), finding.code) == codes.end())
            codes.push_back(finding.code);
    return codes;
}

using Codes = std::vector<std::string>;

/// The building with its map's arrays changed.
template <class Change>
Building with_map(Building building, Change change) {
    gmap::MapArrays arrays = building.map.arrays();
    change(arrays);
    building.map = gmap::Map(std::move(arrays));
    return building;
}

/// A dart between two volumes that carry light, and one inside a wall.
std::uint32_t portal_dart(const Building& building) {
    const gmap::MapArrays& arrays = building.map.arrays();
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d)
        if (building.volumes[arrays.cell_id[3][d]].label == Label::Room &&
            building.volumes[arrays.cell_id[3][arrays.alpha[3][d]]].label == Label::Door)
            return d;
    return 0;
}

std::uint32_t volume_of(const Building& building, Label label) {
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].label == label) return v;
    return 0;
}

TEST(Check, FindsNothingInSoundBuildings) {
    for (const plans::Plan& plan :
         {testing::one_room(), testing::two_rooms(), testing::ring_room(), testing::two_storeys()}) {
        const Building building = build(plan);
        EXPECT_EQ(error_codes(check(building)), Codes{}) << plan.name;
        EXPECT_EQ(error_codes(check(convexify(building))), Codes{}) << plan.name;
    }
}

TEST(Check, AppliesTheConstraintsInTheOrderOfTheTable) {
    const Codes table = {"T1", "T2", "T3", "T4", "T5", "T6", "T7", "T8", "G1", "G2", "G3", "G4", "G5",
                         "G6", "G7", "G8", "G9", "S1", "S2", "S3", "S4", "S5", "S6", "S7", "D1", "D2"};
    const auto in_order = [&](const Codes& codes) {
        auto at = table.begin();
        for (const std::string& code : codes) {
            at = std::find(at, table.end(), code);
            if (at++ == table.end()) return false;
        }
        return true;
    };
    const Building building = build(testing::one_room());
    const CheckReport whole = check(building), convex = check(convexify(building));
    EXPECT_TRUE(in_order(whole.codes_checked));
    EXPECT_TRUE(in_order(convex.codes_checked));
    EXPECT_EQ(std::count(whole.codes_checked.begin(), whole.codes_checked.end(), "G8"), 0);
    EXPECT_EQ(std::count(convex.codes_checked.begin(), convex.codes_checked.end(), "G8"), 1);
}

TEST(Check, T2NamesAFreeDartAndNothingElse) {
    const Building building = build(testing::two_rooms());
    const std::uint32_t d = portal_dart(building);
    const Building broken = with_map(building, [&](gmap::MapArrays& arrays) {
        // Unsew the whole face: one fault, not a dangling half of one.
        const std::uint32_t face = arrays.cell_id[2][d];
        for (std::uint32_t e = 0; e < arrays.alpha[3].size(); ++e)
            if (arrays.cell_id[2][e] == face) arrays.alpha[3][e] = e;
    });
    const CheckReport report = check(broken);
    ASSERT_FALSE(error_codes(report).empty());
    EXPECT_EQ(error_codes(report).front(), "T2");
    EXPECT_EQ(error_codes(report).size(), 1u) << "no cascade";
    EXPECT_TRUE(report.findings.front().point.has_value());
    EXPECT_FALSE(report.findings.front().elements.empty());
}

TEST(Check, G5NamesTheVolumeThatIsInsideOut) {
    Building building = build(testing::one_room());
    const std::uint32_t room = volume_of(building, Label::Room);
    // Lift the room's floor through its ceiling: the slab below now overlaps everything in between.
    const gmap::MapArrays& arrays = building.map.arrays();
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d) {
        auto& vertex = building.vertices[arrays.cell_id[0][d]];
        if (arrays.cell_id[3][d] == room && vertex[2] == building.volumes[room].z_low)
            vertex[2] = building.volumes[room].z_high + 100;
    }
    // The walls' faces cross themselves now, which is told first; measured alone, it is the room that is inside out.
    EXPECT_EQ(error_codes(check(building)), Codes{"G2"});
    Blame blame{std::vector<bool>(building.volumes.size()), std::vector<bool>(building.faces.size()),
                std::vector<bool>(building.vertices.size()), std::vector<bool>(building.spaces.size())};
    CheckReport report;
    check_partition(building, blame, report);
    EXPECT_EQ(error_codes(report), Codes{"G5"});
    const bool names_room = std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& finding) {
        return std::any_of(finding.elements.begin(), finding.elements.end(),
                           [](const ElementRef& e) { return e.kind == "room"; });
    });
    EXPECT_TRUE(names_room);
}

TEST(Check, G5SeesAHullThatIsNotTheSite) {
    Building building = build(testing::one_room());
    building.site_max[2] += 1;
    EXPECT_EQ(error_codes(check(building)), Codes{"G5"});
}

TEST(Check, G8NamesACellThatIsNotConvex) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("spur", {2, 0}, {2, 1.5}, 0.125));
    Building building = build(plan);
    building.convex = true;  // it claims to be, and is not
    const CheckReport report = check(building);
    EXPECT_EQ(error_codes(report), Codes{"G8"});
    EXPECT_GE(report.count("G8"), 1u);
    EXPECT_EQ(error_codes(check(convexify(build(plan)))), Codes{});
}

TEST(Check, G8SeesAPieceThatWasLost) {
    Building building = convexify(build(testing::ring_room()));
    // A piece claims to belong to another volume's parent: neither sums to what it was.
    const std::uint32_t room = volume_of(building, Label::Room);
    building.volumes[room].z_high += 1;
    EXPECT_EQ(error_codes(check(building)), Codes{"G8"});
}

TEST(Check, D2NamesAFaceThatJoinsOtherVolumesThanTheMap) {
    Building building = build(testing::two_rooms());
    const std::uint32_t face = building.map.arrays().cell_id[2][portal_dart(building)];
    building.faces[face].front = volume_of(building, Label::Wall);
    const CheckReport report = check(building);
    EXPECT_EQ(error_codes(report), Codes{"D2"});
    EXPECT_EQ(report.count("D2"), 1u);
    EXPECT_TRUE(report.findings.front().point.has_value());
}

TEST(Check, D2SeesAPortalThatTheMapDoesNotHave) {
    Building building = build(testing::one_room());
    const std::uint32_t room = volume_of(building, Label::Room), wall = volume_of(building, Label::Wall);
    for (Face& face : building.faces)
        if ((face.front == room && face.back == wall) || (face.front == wall && face.back == room)) {
            (face.front == wall ? face.front : face.back) = volume_of(building, Label::Door);
            break;
        }
    EXPECT_EQ(error_codes(check(building)), Codes{"D2"});
}

TEST(Check, WarningsAloneAreSound) {
    plans::Plan plan = testing::one_room();
    plan.findings.push_back({.code = "P100", .severity = Severity::Warning, .sentence = "A warning of the reader."});
    const CheckReport report = check(build(plan));
    EXPECT_EQ(report.count("P100"), 1u);
    EXPECT_TRUE(report.sound());
}

}  // namespace
}  // namespace enfilade::modeler
