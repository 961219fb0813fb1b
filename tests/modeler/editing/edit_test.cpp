#include "modeler/editing/edit.h"

#include <gtest/gtest.h>

#include <set>

#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/certify.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/model_group.h"
#include "modeler/realise.h"
#include "plans/generate.h"
#include "tests/modeler/editing/edited.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

using testing::box;
using testing::difference;
using testing::doubled_volume;
using testing::errors_of;
using testing::space_called;
using testing::spaces_labelled;

Building convex_room() { return convexify(build(testing::one_room())); }

std::uint32_t only_room(const Building& building) { return spaces_labelled(building, Label::Room).front(); }

std::vector<Volume> objects_of(const Building& building, const std::string& id) {
    std::vector<Volume> found;
    for (const Volume& volume : building.volumes)
        if (volume.label == Label::Object && building.spaces[volume.space].id == id) found.push_back(volume);
    return found;
}

/// The code that an insertion is refused with, and its sentence.
std::pair<std::string, std::string> refusal(const Building& building, const std::vector<Box>& boxes) {
    try {
        (void)insert_boxes(building, boxes);
    } catch (const InputError& error) {
        return {error.code, error.what()};
    }
    return {};
}

void expect_sound(const Building& edited) {
    EXPECT_EQ(errors_of(edited), "");
    EXPECT_EQ(difference(edited, realise(edited.stack, edited.cut_options)), "") << "than a rebuild";
}

TEST(Edit, ABoxInTheMiddleOfARoomIsOneVolumeOfItsSize) {
    const Building before = convex_room();
    const std::uint32_t room = only_room(before);
    const Box desk = box(before, room, "desk", {2, 1.25, 3, 1.75}, 0.25, 0.75);
    const Building after = insert_boxes(before, std::vector{desk});
    expect_sound(after);
    const std::vector<Volume> objects = objects_of(after, "desk");
    ASSERT_EQ(objects.size(), 1u);
    EXPECT_EQ(objects[0].z_low, desk.z_low);
    EXPECT_EQ(objects[0].z_high, desk.z_high);
    const std::uint32_t space = space_called(after, "desk");
    EXPECT_EQ(after.spaces[space].room, room);
    EXPECT_EQ(after.spaces[space].storey, before.spaces[room].storey);
    const double unit = before.frame.unit;
    EXPECT_NEAR(double(doubled_volume(after, space)) / 2 * unit * unit * unit, 0.25, 1e-12);
    EXPECT_TRUE(doubled_volume(before, room) == doubled_volume(after, room) + doubled_volume(after, space));
}

TEST(Edit, TheSceneOfAnEditedBuildingIsCertifiedAndKeepsItsObjects) {
    const Building before = convex_room();
    const Building after =
        insert_boxes(before, std::vector{box(before, only_room(before), "desk", {2, 1.25, 3, 1.75}, 0, 0.75)});
    const accel::Scene scene = export_scene(after, check(after), "{}");
    const Certification certified = certify(scene);
    EXPECT_EQ(certified.verdict, "certified");
    const Building read = read_model(scene);
    const std::uint32_t space = space_called(read, "desk");
    ASSERT_NE(space, UINT32_MAX);
    EXPECT_EQ(read.spaces[space].label, Label::Object);
    EXPECT_EQ(read.spaces[space].room, only_room(before));
    EXPECT_EQ(difference(after, read), "");
}

TEST(Edit, TakingABoxOutLeavesTheBuildingAsItWas) {
    const Building before = convexify(build(testing::two_rooms()));
    const std::uint32_t room = only_room(before);
    const Building one = insert_boxes(before, std::vector{box(before, room, "a", {0.5, 1.5, 1, 2}, 0, 1)});
    const Building two = insert_boxes(one, std::vector{box(before, room, "b", {1, 1.5, 1.5, 2}, 0, 1)});
    EXPECT_EQ(difference(remove_box(two, "b"), one), "");
    const Building none = remove_box(remove_box(two, "a"), "b");
    EXPECT_EQ(difference(none, before), "");
    EXPECT_TRUE(none.stack.boxes.empty());
    EXPECT_EQ(none.findings.size(), before.findings.size());
    try {
        (void)remove_box(one, "b");
        FAIL() << "no such box";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, "P507");
    }
}

TEST(Edit, CutsOnlyRegionsThatTheBoxTouches) {
    const Building before = convexify(build(plans::generate({.rooms = 40, .curved = 0.3})));
    const std::uint32_t room = space_called(before, before.spaces[spaces_labelled(before, Label::Room)[7]].id);
    std::array<double, 2> middle = {0, 0};
    for (const Volume& volume : before.volumes)
        if (volume.space == room) {
            const auto ring = testing::floor_of(before, volume);
            middle = {before.frame.world_x(ring[0].x) / 2 + before.frame.world_x(ring[1].x) / 2,
                      before.frame.world_y(ring[0].y) / 2 + before.frame.world_y(ring[1].y) / 2};
            middle[0] = (middle[0] + before.frame.world_x(ring[2].x)) / 2;
            middle[1] = (middle[1] + before.frame.world_y(ring[2].y)) / 2;
        }
    EditCount count;
    const Building after = insert_boxes(
        before,
        std::vector{box(before, room, "x", {middle[0] - 0.1, middle[1] - 0.1, middle[0] + 0.1, middle[1] + 0.1}, 0, 1)},
        accel::SerialExecutor(), &count);
    EXPECT_GT(count.regions, 200u);
    EXPECT_GE(count.cut_again, 2u);
    EXPECT_LE(count.cut_again, 4u) << "the room, the box, what is beside them";
    expect_sound(after);
}

TEST(Edit, AWholeBuildingMayBeEditedBeforeItIsCut) {
    const Building whole = build(testing::two_rooms());
    const std::vector<Box> boxes = {box(whole, only_room(whole), "a", {0.5, 1.5, 1, 2}, 0, 1)};
    const Building edited = insert_boxes(whole, boxes);
    expect_sound(edited);
    EXPECT_EQ(difference(convexify(edited), insert_boxes(convexify(whole), boxes)), "");
}

TEST(Edit, ABoxAsLargeAsTheRoomLeavesWhatIsAbove) {
    const Building before = convex_room();
    const std::uint32_t room = only_room(before);
    const Building after = insert_boxes(before, std::vector{box(before, room, "plinth", {-1, -1, 6, 6}, 0, 0.5)});
    expect_sound(after);
    for (const Volume& volume : after.volumes)
        if (volume.space == room) {
            EXPECT_EQ(volume.z_low, before.storeys[0].z_floor + int(0.5 / before.frame.unit));
        }
    EXPECT_GT(doubled_volume(after, room), 0);
    const auto [code, sentence] = refusal(before, {box(before, room, "block", {-1, -1, 6, 6}, 0, 9)});
    EXPECT_EQ(code, "P506");
    EXPECT_NE(sentence.find("block"), std::string::npos) << sentence;
}

TEST(Edit, BoxesStandFlushWithWallsAndInCorners) {
    const Building before = convex_room();  // inside walls from 0.125 to 3.875 and 2.875
    const std::uint32_t room = only_room(before);
    const Building after =
        insert_boxes(before, std::vector{box(before, room, "corner", {3.375, 2.375, 3.875, 2.875}, 0, 2.5),
                                         box(before, room, "flush", {0.125, 1, 0.5, 2}, 0, 1),
                                         box(before, room, "into the wall", {2, 2, 2.5, 3.5}, 0, 1),
                                         box(before, room, "touches a corner", {0.125, 2.5, 0.5, 2.875}, 1, 2)});
    expect_sound(after);
    for (const char* id : {"corner", "flush", "into the wall", "touches a corner"})
        EXPECT_EQ(objects_of(after, id).size(), 1u) << id;
    const double unit = before.frame.unit;
    EXPECT_NEAR(double(doubled_volume(after, space_called(after, "into the wall"))) / 2 * unit * unit * unit,
                0.5 * 0.875, 1e-12);
}

TEST(Edit, ASplinterBetweenBoxAndWallBelongsToTheBox) {
    const Building before = convex_room();
    const std::uint32_t room = only_room(before);
    Box near = box(before, room, "near", {0.125, 1, 0.5, 2}, 0, 1);
    for (plans::GridPoint& p : near.footprint) ++p.x;
    const Building after = insert_boxes(before, std::vector{near});
    expect_sound(after);
    Box flush = box(before, room, "near", {0.125, 1, 0.5, 2}, 0, 1);
    for (plans::GridPoint& p : flush.footprint)
        if (p.x > flush.footprint[0].x) ++p.x;
    EXPECT_EQ(difference(after, insert_boxes(before, std::vector{flush})), "");
}

TEST(Edit, BoxesStandOnEachOtherAndSideBySide) {
    const Building before = convex_room();
    const std::uint32_t room = only_room(before);
    const Building after = insert_boxes(
        before,
        std::vector{box(before, room, "lower", {1, 1, 2, 2}, 0, 0.5), box(before, room, "upper", {1, 1, 2, 2}, 0.5, 1),
                    box(before, room, "above", {1, 1, 2, 2}, 1.5, 2), box(before, room, "beside", {2, 1, 2.5, 2}, 0, 1),
                    box(before, room, "lamp", {1.5, 1.5, 3, 2.5}, 2.25, 2.5)});
    expect_sound(after);
    const double unit = before.frame.unit;
    for (const auto& [id, size] :
         {std::pair("lower", 0.5), {"upper", 0.5}, {"above", 0.5}, {"beside", 0.5}, {"lamp", 1.5 * 0.25}})
        EXPECT_NEAR(double(doubled_volume(after, space_called(after, id))) / 2 * unit * unit * unit, size, 1e-12) << id;
    const auto [code, sentence] = refusal(after, {box(before, room, "thief", {1.75, 1.75, 2.75, 2.75}, 0.25, 0.5)});
    EXPECT_EQ(code, "P504");
    EXPECT_NE(sentence.find("thief"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("beside"), std::string::npos) << sentence;
}

TEST(Edit, AUnitOfHeightIsKeptAUnitOfWidthRefused) {
    const Building before = convex_room();
    const std::uint32_t room = only_room(before);
    Box sheet = box(before, room, "sheet", {1, 1, 2, 2}, 1, 1.5);
    sheet.z_high = sheet.z_low + 1;
    expect_sound(insert_boxes(before, std::vector{sheet}));
    Box screen = box(before, room, "screen", {1, 1, 2, 2}, 0, 1);
    screen.footprint[1].x = screen.footprint[2].x = screen.footprint[0].x + 1;
    EXPECT_EQ(refusal(before, {screen}).first, "P505");
    for (plans::GridPoint* p : {&screen.footprint[1], &screen.footprint[2]}) p->x += 2;
    const Building after = insert_boxes(before, std::vector{screen});
    expect_sound(after);
    EXPECT_EQ(objects_of(after, "screen").size(), 1u);
}

TEST(Edit, WhatIsNoBoxOfARoomIsRefused) {
    const Building before = convex_room();
    const std::uint32_t room = only_room(before);
    const Box good = box(before, room, "good", {1, 1, 2, 2}, 0, 1);
    Box bad = good;
    bad.space = space_called(before, "s");
    EXPECT_EQ(refusal(before, {bad}).first, "P503") << "a wall";
    bad = good;
    std::reverse(bad.footprint.begin(), bad.footprint.end());
    EXPECT_EQ(refusal(before, {bad}).first, "P503") << "clockwise";
    bad = good;
    bad.z_high = bad.z_low;
    EXPECT_EQ(refusal(before, {bad}).first, "P503") << "no height";
    EXPECT_EQ(refusal(before, {good, good}).first, "P503") << "twice";
    EXPECT_EQ(refusal(before, {box(before, room, "out", {8, 8, 9, 9}, 0, 1)}).first, "P505");
    EXPECT_EQ(refusal(before, {box(before, room, "high", {1, 1, 2, 2}, 3, 4)}).first, "P505");
    EXPECT_EQ(refusal(before, {box(before, room, "in the wall", {1, 2.9, 2, 3}, 0, 1)}).first, "P505");
}

TEST(Edit, ABoxOutdoorsIsOneVolumeThroughAllLevels) {
    const Building before = convex_room();
    const Building after =
        insert_boxes(before, std::vector{box(before, exterior_space, "tree", {-2, -2, -1.5, -1.5}, 0, 4)});
    expect_sound(after);
    EXPECT_EQ(objects_of(after, "tree").size(), 1u);
}

TEST(Edit, ABoxAroundAColumnIsSeveralVolumesOfOneSpace) {
    const Building before = convexify(build(testing::ring_room()));
    const std::uint32_t room = only_room(before);
    const Building after = insert_boxes(before, std::vector{box(before, room, "table", {1.5, 1, 2.5, 2}, 0.5, 0.75)});
    expect_sound(after);
    EXPECT_GE(objects_of(after, "table").size(), 2u);
    const double unit = before.frame.unit;
    EXPECT_NEAR(double(doubled_volume(after, space_called(after, "table"))) / 2 * unit * unit * unit, (1 - 0.25) * 0.25,
                1e-12);
}

}  // namespace
}  // namespace enfilade::modeler
