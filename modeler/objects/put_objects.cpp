#include "modeler/objects/put_objects.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "modeler/editing/edit.h"
#include "modeler/editing/place_boxes.h"
#include "modeler/objects/object_groups.h"

namespace enfilade::modeler {
namespace {

std::string called(const FurnishedObject& object) {
    return '"' + (object.name.empty() ? object.id : object.name) + '"';
}

/// By ascending id, each id once, and no mesh that nobody shows.
void bring_in_order(Furnishing& furnishing, const Building& building) {
    std::vector<FurnishedObject>& objects = furnishing.objects;
    std::sort(objects.begin(), objects.end(),
              [](const FurnishedObject& a, const FurnishedObject& b) { return a.id < b.id; });
    std::vector<std::uint32_t> numbers(furnishing.meshes.size(), UINT32_MAX);
    for (std::size_t k = 0; k < objects.size(); ++k) {
        if (k > 0 && objects[k - 1].id == objects[k].id)
            throw InputError("P508", "",
                             "Two objects have the id \"" + objects[k].id + "\": give each of them one of its own.");
        ENFILADE_CHECK(objects[k].mesh < furnishing.meshes.size() && objects[k].space < building.spaces.size());
        numbers[objects[k].mesh] = 0;
        objects[k].volume.clear();
    }
    std::vector<std::shared_ptr<const ObjectMesh>> used;
    for (std::size_t m = 0; m < numbers.size(); ++m)
        if (numbers[m] == 0) {
            numbers[m] = std::uint32_t(used.size());
            used.push_back(std::move(furnishing.meshes[m]));
        }
    furnishing.meshes = std::move(used);
    for (FurnishedObject& object : objects) object.mesh = numbers[object.mesh];
}

/// Boxes that were put in for themselves: those of the furniture that the building held go.
std::vector<Box> foreign_boxes(const Building& building) {
    std::set<std::string, std::less<>> own;
    for (const FurnishedObject& object : building.furnishing.objects)
        if (!object.volume.empty()) own.insert(object.volume);
    std::vector<Box> boxes = building.stack.boxes;
    std::erase_if(boxes, [&](const Box& box) { return own.contains(box.id); });
    return boxes;
}

/// Why a group cannot stand as a volume.
struct Refused {
    ObjectGroup group;
    std::string why;
};

class GroupPlacer {
public:
    GroupPlacer(const Building& building, std::vector<Box> boxes)
        : bare_(building.stack.bare ? building.stack.bare : std::make_shared<const Stack>(building.stack)),
          boxes_(std::move(boxes)) {}

    /// All at once where they can stand; else room by room, and one by one in rooms where some cannot.
    void place(std::vector<ObjectGroup> groups) {
        if (try_all(groups, nullptr)) return;
        std::map<std::uint32_t, std::vector<ObjectGroup>> by_room;
        for (ObjectGroup& group : groups) by_room[group.box.space].push_back(std::move(group));
        for (auto& [room, own] : by_room) {
            if (try_all(own, nullptr)) continue;
            for (ObjectGroup& group : own) {
                std::string why;
                if (!try_all({&group, 1}, &why)) refused.push_back({std::move(group), why});
            }
        }
    }

    [[nodiscard]] std::vector<Box> take_boxes() { return std::move(boxes_); }

    std::vector<ObjectGroup> placed;
    std::vector<Refused> refused;

private:
    /// Puts them with what stands, if they can; `why` says what is against it.
    bool try_all(std::span<const ObjectGroup> groups, std::string* why) {
        std::vector<Box> boxes = boxes_;
        std::set<std::uint32_t> rooms;
        for (const ObjectGroup& group : groups) {
            boxes.push_back(group.box);
            rooms.insert(group.box.space);
        }
        // What stands in other rooms is in nobody's way.
        std::vector<Box> here;
        std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(here),
                     [&](const Box& box) { return rooms.contains(box.space); });
        try {
            (void)place_boxes(bare_, std::move(here));
        } catch (const InputError& error) {
            if (why != nullptr) *why = error.what();
            return false;
        }
        boxes_ = std::move(boxes);
        placed.insert(placed.end(), groups.begin(), groups.end());
        return true;
    }

    std::shared_ptr<const Stack> bare_;
    std::vector<Box> boxes_;
};

Finding listed(const Building& building, const FurnishedObject& object, const std::string& why) {
    Finding finding{.code = "P509", .severity = Severity::Note};
    finding.sentence = called(object) + " is no volume of its own: " + why;
    finding.hint = "It is seen all the same: the cells around it list it.";
    finding.point = object.position;
    const std::uint32_t storey = building.spaces[object.space].storey;
    if (storey < building.storeys.size()) finding.storey = building.storeys[storey].id;
    finding.elements = {{"furniture", object.id, object.name}};
    return finding;
}

/// Each object becomes a volume where it can; the others keep `volume` empty.
Building with_volumes(const Building& building, Furnishing& furnishing, std::vector<Finding>& findings,
                      const accel::Executor& executor) {
    ENFILADE_CHECK(!building.stack.regions.empty());
    const auto note = [&](std::uint32_t k, const std::string& why) {
        findings.push_back(listed(building, furnishing.objects[k], why));
    };
    std::vector<std::uint32_t> candidates;
    for (std::uint32_t k = 0; k < furnishing.objects.size(); ++k) {
        const Label label = building.spaces[furnishing.objects[k].space].label;
        if (label == Label::Room || label == Label::Exterior) candidates.push_back(k);
        else note(k, "it stands in no room.");
    }
    GroupPlacer placer(building, foreign_boxes(building));
    placer.place(group_objects(furnishing.objects, candidates, building.frame));
    for (const ObjectGroup& group : placer.placed)
        for (const std::uint32_t k : group.objects) furnishing.objects[k].volume = group.box.id;
    for (const Refused& refused : placer.refused)
        for (const std::uint32_t k : refused.group.objects) note(k, refused.why);
    return with_boxes(building, placer.take_boxes(), executor);
}

}  // namespace

Building put_objects(const Building& building, Furnishing furnishing, std::vector<Finding>& findings,
                     const accel::Executor& executor) {
    bring_in_order(furnishing, building);
    Building result;
    if (furnishing.cells == ObjectCells::Cut) {
        result = with_volumes(building, furnishing, findings, executor);
    } else if (std::vector<Box> others = foreign_boxes(building); others.size() != building.stack.boxes.size()) {
        result = with_boxes(building, std::move(others), executor);
    } else {
        result = building;
    }
    result.furnishing = std::move(furnishing);
    return result;
}

}  // namespace enfilade::modeler
