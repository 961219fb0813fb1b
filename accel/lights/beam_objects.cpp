#include "accel/lights/beam_objects.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace enfilade::accel::detail {
namespace {

/// Metres by which objects may miss a beam and still be listed, and reach into a cell and not be cut off there: what
/// tracers allow at borders (render/object_walk.h, `stretch_slack`).
constexpr double border = 1e-4;

}  // namespace

std::span<const ObjectId> BeamObjectLister::objects_of(CellId cell) const {
    const std::uint32_t begin = view_.cell_object_offsets[index(cell)];
    return {view_.cell_objects.first + begin, view_.cell_object_offsets[index(cell) + 1] - begin};
}

BeamObjectLister::Box BeamObjectLister::box_of(const Cell& cell) const {
    const float* x = view_.section_x.first + cell.first_section;
    const float* y = view_.section_y.first + cell.first_section;
    const auto [low_x, high_x] = std::minmax_element(x, x + cell.section_count);
    const auto [low_y, high_y] = std::minmax_element(y, y + cell.section_count);
    return {{*low_x, *low_y, cell.z_floor}, {*high_x, *high_y, cell.z_ceiling}};
}

/// box: around the cell. Ways from its places to the lamp stay in the box around both, and inside the planes.
bool BeamObjectLister::comes_into(const PlacedObject& object, const Box& box, const Light& light,
                                  std::span<const ConeVector> planes) const {
    for (std::size_t k = 0; k < 3; ++k)
        if (double{object.high[k]} < double{std::min(box.low[k], light.position[k])} - border ||
            double{object.low[k]} > double{std::max(box.high[k], light.position[k])} + border)
            return false;
    return std::ranges::all_of(planes, [&](const ConeVector& plane) {
        const auto most = [&](double n, std::size_t k) {
            return n * (double{n > 0 ? object.high[k] : object.low[k]} - double{light.position[k]});
        };
        return most(plane.x, 0) + most(plane.y, 1) + most(plane.z, 2) >= -border;
    });
}

bool BeamObjectLister::reaches_into(const PlacedObject& object, const Cell& cell) const {
    if (double{object.low[2]} > double{cell.z_ceiling} - border ||
        double{object.high[2]} < double{cell.z_floor} + border)
        return false;
    for (std::uint32_t i = 0; i < cell.section_count; ++i) {
        const std::uint32_t s = cell.first_section + i, t = i + 1 == cell.section_count ? cell.first_section : s + 1;
        const double x = double{view_.section_x[s]}, y = double{view_.section_y[s]};
        const double dx = double{view_.section_x[t]} - x, dy = double{view_.section_y[t]} - y;
        const double inmost = dx * (double{dx > 0 ? object.high[1] : object.low[1]} - y) -
                              dy * (double{dy > 0 ? object.low[0] : object.high[0]} - x);
        if (inmost < border * std::hypot(dx, dy)) return false;
    }
    return true;
}

/// Whether the object reaches into a cell on the way that does not list it: through the wall of its room.
bool BeamObjectLister::is_cut(const LampWalk& walk, std::uint32_t number, ObjectId object) const {
    for (;; number = walk.steps()[number].parent) {
        const CellId cell = walk.steps()[number].cell;
        if (!std::ranges::binary_search(objects_of(cell), object) &&
            reaches_into(view_.objects[index(object)], view_.cells[index(cell)]))
            return true;
        if (walk.steps()[number].parent == number) return false;
    }
}

void BeamObjectLister::list(const LampWalk& walk, const Light& light) {
    lists_.clear();
    objects_.clear();
    for (std::uint32_t k = 0; k < walk.steps().size(); ++k) add(walk, k, light);
}

void BeamObjectLister::add(const LampWalk& walk, std::uint32_t number, const Light& light) {
    const LampStep& step = walk.steps()[number];
    const BeamObjects parent = number == 0 ? BeamObjects{0, 0, 0} : lists_[step.parent];
    const std::span<const ObjectId> before = {objects_.data() + parent.first, parent.count};
    found_.clear();
    std::ranges::set_union(before, objects_of(step.cell), std::back_inserter(found_));
    const Box box = box_of(view_.cells[index(step.cell)]);
    std::erase_if(found_, [&](ObjectId object) {
        return object == light.carrier || !comes_into(view_.objects[index(object)], box, light, walk.light(step));
    });
    BeamObjects list = {parent.first, 0, 0};
    list.count = static_cast<std::uint32_t>(found_.size()) & 0x7fffffffu;
    list.must_walk = std::ranges::any_of(found_, [&](ObjectId object) { return is_cut(walk, number, object); });
    if (!std::ranges::equal(before, found_)) {
        list.first = static_cast<std::uint32_t>(objects_.size());
        objects_.insert(objects_.end(), found_.begin(), found_.end());
    }
    lists_.push_back(list);
}

}  // namespace enfilade::accel::detail
