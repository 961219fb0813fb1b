#include "modeler/editing/edit.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "modeler/editing/place_boxes.h"
#include "modeler/editing/reuse_cuts.h"
#include "modeler/realise.h"

namespace enfilade::modeler {

Building with_boxes(const Building& building, std::vector<Box> boxes, const accel::Executor& executor,
                    EditCount* count) {
    ENFILADE_CHECK(!building.stack.regions.empty());
    const std::shared_ptr<const Stack> bare =
        building.stack.bare ? building.stack.bare : std::make_shared<const Stack>(building.stack);
    Stack stack = boxes.empty() ? *bare : place_boxes(bare, std::move(boxes));
    ReusedCuts cuts = reuse_cuts(building.stack, building.cuts, stack, building.cut_options, executor);
    if (count) *count = {stack.regions.size(), cuts.cut_again.size()};
    Building edited = realise(std::move(stack), building.cut_options, std::move(cuts.cuts));
    edited.name = building.name;
    edited.plan_json = building.plan_json;
    edited.sagitta = building.sagitta;
    edited.opaque_glass = building.opaque_glass;
    edited.furnishing = building.furnishing;
    edited.lamps = building.lamps;
    edited.pictures = building.pictures;
    edited.max_deviation = std::max(edited.max_deviation, building.max_deviation);
    std::vector<Finding> findings = building.findings;
    // What rounding has done to this stack is known anew.
    std::erase_if(findings, [](const Finding& finding) { return finding.code == "P501" || finding.code == "P502"; });
    edited.findings.insert(edited.findings.begin(), findings.begin(), findings.end());
    return edited;
}

Building insert_boxes(const Building& building, std::span<const Box> boxes, const accel::Executor& executor,
                      EditCount* count) {
    std::vector<Box> all = building.stack.boxes;
    all.insert(all.end(), boxes.begin(), boxes.end());
    return with_boxes(building, std::move(all), executor, count);
}

Building remove_box(const Building& building, std::string_view id, const accel::Executor& executor, EditCount* count) {
    std::vector<Box> boxes = building.stack.boxes;
    const auto at = std::find_if(boxes.begin(), boxes.end(), [&](const Box& box) { return box.id == id; });
    if (at == boxes.end())
        throw InputError(
            "P507", "",
            "No box \"" + std::string(id) + "\" stands in the building: give the id of one that was put in.");
    boxes.erase(at);
    return with_boxes(building, std::move(boxes), executor, count);
}

}  // namespace enfilade::modeler
