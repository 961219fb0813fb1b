#include "accel/lights/beam_objects.h"

#include <algorithm>
#include <span>

namespace enfilade::accel::detail {
namespace {

/// Whether the boxes of an object and a cell have a place in common.
bool may_touch(const SceneView& view, const PlacedObject& object, const Cell& cell) {
    if (object.low[2] > cell.z_ceiling || object.high[2] < cell.z_floor) return false;
    const float* x = view.section_x.first + cell.first_section;
    const float* y = view.section_y.first + cell.first_section;
    const auto [low_x, high_x] = std::minmax_element(x, x + cell.section_count);
    const auto [low_y, high_y] = std::minmax_element(y, y + cell.section_count);
    return object.low[0] <= *high_x && object.high[0] >= *low_x && object.low[1] <= *high_y && object.high[1] >= *low_y;
}

class ObjectLister {
public:
    ObjectLister(const SceneView& view, const LightTreesView& trees) : view_(view), trees_(trees) {}

    /// Objects of the beam, ascending; returns whether one of them is cut off in a cell on the way.
    bool list(std::uint32_t beam, ObjectId carrier, std::vector<ObjectId>& found) {
        cells_.clear();
        found.clear();
        for (std::uint32_t b = beam;; b = trees_.beams[b].parent) {
            cells_.push_back(trees_.beams[b].cell);
            if (trees_.beams[b].parent == b) break;
        }
        for (const CellId cell : cells_)
            for (const ObjectId object : objects_of(cell))
                if (object != carrier) found.push_back(object);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return std::ranges::any_of(found, [&](ObjectId object) { return is_cut(object); });
    }

private:
    [[nodiscard]] std::span<const ObjectId> objects_of(CellId cell) const {
        const std::uint32_t begin = view_.cell_object_offsets[index(cell)];
        return {view_.cell_objects.first + begin, view_.cell_object_offsets[index(cell) + 1] - begin};
    }

    [[nodiscard]] bool is_cut(ObjectId object) const {
        return std::ranges::any_of(cells_, [&](CellId cell) {
            return !std::ranges::binary_search(objects_of(cell), object) &&
                   may_touch(view_, view_.objects[index(object)], view_.cells[index(cell)]);
        });
    }

    const SceneView& view_;
    const LightTreesView& trees_;
    std::vector<CellId> cells_;
};

}  // namespace

void list_objects(const SceneView& view, const LightTreesView& trees, const Executor&, std::vector<BeamObjects>& lists,
                  std::vector<ObjectId>& objects) {
    lists.resize(trees.beams.size());
    ObjectLister lister(view, trees);
    std::vector<ObjectId> found;
    for (const CellLight& entry : trees.cell_lights) {
        if (entry.beam == no_beam) continue;
        const ObjectId carrier = view.lights[index(entry.light)].carrier;
        const bool must_walk = lister.list(entry.beam, carrier, found);
        BeamObjects& list = lists[entry.beam];
        list.first = static_cast<std::uint32_t>(objects.size());
        list.count = static_cast<std::uint32_t>(found.size()) & 0x7fffffffu;
        list.must_walk = must_walk;
        objects.insert(objects.end(), found.begin(), found.end());
    }
}

}  // namespace enfilade::accel::detail
