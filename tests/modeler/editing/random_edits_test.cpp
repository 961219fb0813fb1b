// Boxes anywhere in rooms of any shape: one by one, all at once, in another order, and from scratch, it is one
// building.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/editing/edit.h"
#include "modeler/editing/footprint.h"
#include "modeler/editing/place_boxes.h"
#include "modeler/export_scene.h"
#include "modeler/realise.h"
#include "plans/generate.h"
#include "plans/read.h"
#include "tests/modeler/editing/edited.h"
#include "tests/support/random_plan.h"

namespace enfilade::modeler {
namespace {

using testing::difference;
using testing::errors_of;

/// Some buildings, made once: they do not change.
const Building& some_building(int which) {
    static std::map<int, Building> made;
    const auto at = made.find(which);
    if (at != made.end()) return at->second;
    plans::Plan plan;
    if (which == 0) plan = plans::read(ENFILADE_SOURCE_DIR "/plans/examples/townhouse.json");
    else
        plan = plans::generate(
            {.rooms = 12, .storeys = which > 4 ? 2u : 1u, .curved = 0.3, .oblique = 0.3, .seed = std::uint64_t(which)});
    return made.emplace(which, convexify(build(plan))).first->second;
}

/// A box about a point of the room's floor: anywhere, often through walls, sometimes with corners on those of the
/// floor.
Box any_box(const Building& building, std::uint32_t room, const std::string& id) {
    std::vector<const Volume*> cells;
    for (const Volume& volume : building.volumes)
        if (volume.space == room) cells.push_back(&volume);
    const Volume& cell = **rc::gen::elementOf(cells);
    const std::vector<plans::GridPoint> floor = testing::floor_of(building, cell);
    const plans::GridPoint p = *rc::gen::elementOf(floor), q = *rc::gen::elementOf(floor);
    const double t = *rc::gen::element(0.5, 0.25, 0.1, 0.0);
    Box box;
    box.space = room;
    box.id = id;
    box.footprint = rectangle_footprint(
        building.frame, building.frame.world_x(p.x) * (1 - t) + building.frame.world_x(q.x) * t,
        building.frame.world_y(p.y) * (1 - t) + building.frame.world_y(q.y) * t, *rc::gen::inRange(1, 3000) / 1000.0,
        *rc::gen::inRange(1, 2000) / 1000.0, *rc::gen::element(0.0, 0.0, 0.5, 1.2, 0.0003));
    const std::int32_t height = cell.z_high - cell.z_low;
    box.z_low = cell.z_low + *rc::gen::element(0, 0, height / 4, height / 2);
    box.z_high = box.z_low + *rc::gen::element(height / 4, height / 2, height, 1);
    return box;
}

/// Boxes of a few rooms that can stand together.
std::vector<Box> any_boxes(const Building& building, int count) {
    const std::vector<std::uint32_t> all = testing::rooms_of(building);
    const std::vector<std::uint32_t> rooms = {*rc::gen::elementOf(all), *rc::gen::elementOf(all)};
    const auto bare = std::make_shared<const Stack>(building.stack);
    std::vector<Box> boxes;
    for (int k = 0; k < count; ++k) {
        std::vector<Box> more = boxes;
        more.push_back(any_box(building, *rc::gen::elementOf(rooms), "box " + std::to_string(9 - k)));
        try {
            (void)place_boxes(bare, more);
            boxes = std::move(more);
        } catch (const InputError& error) {
            RC_ASSERT(error.code == "P504" || error.code == "P505" || error.code == "P506");
        }
    }
    RC_TAG(std::to_string(boxes.size()) + " of " + std::to_string(count) + " boxes");
    return boxes;
}

Building remove_all(Building building) {
    while (!building.stack.boxes.empty()) {
        const std::string id = building.stack.boxes.front().id;
        building = remove_box(building, id);
    }
    return building;
}

std::string text_of(const std::vector<Box>& boxes, int which) {
    std::string text = "building " + std::to_string(which) + "\n";
    for (const Box& box : boxes) {
        text += box.id + " in " + std::to_string(box.space) + ", " + std::to_string(box.z_low) + " to " +
                std::to_string(box.z_high) + ":";
        for (const plans::GridPoint p : box.footprint)
            text += " {" + std::to_string(p.x) + ", " + std::to_string(p.y) + "}";
        text += "\n";
    }
    return text;
}

RC_GTEST_PROP(RandomEdits, OfPlansAsNobodyShouldDrawThemAreSoundOrRefused, ()) {
    const plans::Plan plan = testing::any_plan();
    RC_LOG() << plans::write_json(plan) << "\n";
    std::optional<Building> before;
    try {
        before = convexify(build(plan));
    } catch (const InputError&) {
        RC_TAG("no building");
        return;
    }
    if (testing::rooms_of(*before).empty()) {
        RC_TAG("no room");
        return;
    }
    const std::string known = errors_of(*before);
    const std::vector<Box> boxes = any_boxes(*before, 3);
    RC_LOG() << text_of(boxes, -1);
    const Building after = insert_boxes(*before, boxes);
    RC_ASSERT(errors_of(after) == known);
    RC_ASSERT(difference(after, realise(after.stack, after.cut_options)) == "");
    RC_ASSERT(difference(remove_all(after), *before) == "");
}

RC_GTEST_PROP(RandomEdits, GiveOneBuildingInAnyOrderAndFromScratch, ()) {
    const int which = *rc::gen::inRange(0, 8);
    const Building& before = some_building(which);
    const std::vector<Box> boxes = any_boxes(before, 3);
    RC_LOG() << text_of(boxes, which);
    const Building at_once = insert_boxes(before, boxes);
    RC_ASSERT(difference(at_once, realise(at_once.stack, at_once.cut_options)) == "");
    Building forward = before, backward = before;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        forward = insert_boxes(forward, std::vector{boxes[k]});
        backward = insert_boxes(backward, std::vector{boxes[boxes.size() - 1 - k]});
    }
    RC_ASSERT(difference(at_once, forward) == "");
    RC_ASSERT(difference(at_once, backward) == "");
    RC_ASSERT(difference(remove_all(forward), before) == "");
}

RC_GTEST_PROP(RandomEdits, AreSound, ()) {
    const int which = *rc::gen::inRange(0, 8);
    const Building& before = some_building(which);
    const std::vector<Box> boxes = any_boxes(before, 4);
    RC_LOG() << text_of(boxes, which);
    const Building after = insert_boxes(before, boxes);
    RC_ASSERT(errors_of(after) == "");
    const auto all = [](std::uint32_t) { return true; };
    RC_ASSERT(testing::doubled_volume(before, all) == testing::doubled_volume(after, all));
    (void)export_scene(after, check(after), "{}");
}

/// The cells of a space: floor, lowest corner first, with the levels.
std::multiset<std::vector<std::int32_t>> cells_of(const Building& building, std::uint32_t space) {
    std::multiset<std::vector<std::int32_t>> cells;
    for (const Volume& volume : building.volumes) {
        if (volume.space != space || volume.label == Label::Outside) continue;
        std::vector<plans::GridPoint> floor = testing::floor_of(building, volume);
        std::rotate(floor.begin(), std::min_element(floor.begin(), floor.end()), floor.end());
        std::vector<std::int32_t> cell = {volume.z_low, volume.z_high};
        for (const plans::GridPoint p : floor) cell.insert(cell.end(), {p.x, p.y});
        cells.insert(std::move(cell));
    }
    return cells;
}

RC_GTEST_PROP(RandomEdits, LeaveOtherRoomsAsTheyAre, ()) {
    const int which = *rc::gen::inRange(1, 5);  // of one storey
    const Building& before = some_building(which);
    const std::vector<Box> boxes = any_boxes(before, 2);
    RC_LOG() << text_of(boxes, which);
    const Building after = insert_boxes(before, boxes);
    std::set<std::uint32_t> touched;
    for (const Box& box : boxes) touched.insert(box.space);
    for (const std::uint32_t room : testing::spaces_labelled(before, Label::Room))
        if (!touched.contains(room)) RC_ASSERT(cells_of(before, room) == cells_of(after, room));
}

}  // namespace
}  // namespace enfilade::modeler
