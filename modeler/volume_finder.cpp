#include "modeler/volume_finder.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nowhere = UINT32_MAX;

/// Crossings of a half-line from p + (-e^2, -e^3) towards +x, as `accel::locate` counts them.
bool holds_in_plan(const Building& building, const Piece& piece, double x, double y) {
    bool inside = false;
    const auto point = [&](std::uint32_t k) {
        return building.points[building.corners[piece.first_corner + k].vertex];
    };
    for (std::uint32_t k = 0, before = piece.corner_count - 1; k < piece.corner_count; before = k++) {
        const plans::GridPoint a = point(before), b = point(k);
        const bool upwards = b.y >= y;
        if ((a.y >= y) == upwards) continue;
        const double side = (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
        if (upwards ? side >= 0 : side <= 0) inside = !inside;
    }
    return inside;
}

}  // namespace

VolumeFinder::VolumeFinder(const Building& building)
    : building_(building), first_volume_(building.pieces.size() + 1, 0) {
    const auto for_each = [&](auto visit) {
        for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
            if (building.volumes[v].label != Label::Outside) visit(v);
    };
    for_each([&](std::uint32_t v) { ++first_volume_[building.volumes[v].piece + 1]; });
    for (std::size_t p = 1; p < first_volume_.size(); ++p) first_volume_[p] += first_volume_[p - 1];
    volumes_.resize(first_volume_.back());
    std::vector<std::uint32_t> next(first_volume_.begin(), first_volume_.end() - 1);
    for_each([&](std::uint32_t v) { volumes_[next[building.volumes[v].piece]++] = v; });
    std::vector<plans::PlanBox> boxes(building.pieces.size());
    for (std::size_t p = 0; p < boxes.size(); ++p)
        for (std::uint32_t k = 0; k < building.pieces[p].corner_count; ++k) {
            const plans::GridPoint at = building.points[building.corners[building.pieces[p].first_corner + k].vertex];
            boxes[p].add({double(at.x), double(at.y)});
        }
    index_.emplace(boxes);
}

template <class Visit>
void VolumeFinder::visit_holding(const std::array<double, 3>& place, const Visit& visit) const {
    const plans::GridFrame& frame = building_.frame;
    // What a scene keeps of a position: floats of its own frame.
    const double x = double{float(place[0] - frame.origin_x)} / frame.unit;
    const double y = double{float(place[1] - frame.origin_y)} / frame.unit;
    const double z = double{float(place[2] - frame.origin_z)} / frame.unit;
    index_->near({x, y}, [&](std::uint32_t p) {
        if (first_volume_[p] == first_volume_[p + 1] || !holds_in_plan(building_, building_.pieces[p], x, y)) return;
        for (std::uint32_t i = first_volume_[p]; i < first_volume_[p + 1]; ++i) {
            const Volume& volume = building_.volumes[volumes_[i]];
            if (z >= volume.z_low && z < volume.z_high) visit(volumes_[i]);
        }
    });
}

std::uint32_t VolumeFinder::at(const std::array<double, 3>& place) const {
    std::uint32_t found = nowhere;
    visit_holding(place, [&](std::uint32_t v) {
        const auto is_light = [&](std::uint32_t w) { return accel::carries_light(building_.volumes[w].label); };
        if (found == nowhere || (is_light(v) && !is_light(found))) found = v;
    });
    return found;
}

bool VolumeFinder::holds(std::uint32_t space, const std::array<double, 3>& place) const {
    bool found = false;
    visit_holding(place, [&](std::uint32_t v) { found = found || building_.volumes[v].space == space; });
    return found;
}

}  // namespace enfilade::modeler
