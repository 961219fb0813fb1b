#include "modeler/objects/space_finder.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/id.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nowhere = UINT32_MAX;

bool holds(const Building& building, const Piece& piece, double x, double y) {
    bool inside = false;
    const auto point = [&](std::uint32_t k) {
        return building.points[building.corners[piece.first_corner + k].vertex];
    };
    for (std::uint32_t k = 0, before = piece.corner_count - 1; k < piece.corner_count; before = k++) {
        const plans::GridPoint a = point(before), b = point(k);
        if ((a.y > y) == (b.y > y)) continue;
        if (x < a.x + (double(b.x) - a.x) * (y - a.y) / (double(b.y) - a.y)) inside = !inside;
    }
    return inside;
}

/// Rooms before the air around the house, that before doorways and stairs.
int rank(Label label) {
    if (label == Label::Room) return 0;
    return label == Label::Exterior ? 1 : 2;
}

}  // namespace

SpaceFinder::SpaceFinder(const Building& building) : building_(building), first_volume_(building.pieces.size() + 1, 0) {
    const auto for_each_light = [&](auto visit) {
        for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
            if (accel::carries_light(building.volumes[v].label)) visit(v);
    };
    for_each_light([&](std::uint32_t v) { ++first_volume_[building.volumes[v].piece + 1]; });
    for (std::size_t p = 1; p < first_volume_.size(); ++p) first_volume_[p] += first_volume_[p - 1];
    volumes_.resize(first_volume_.back());
    std::vector<std::uint32_t> next(first_volume_.begin(), first_volume_.end() - 1);
    for_each_light([&](std::uint32_t v) { volumes_[next[building.volumes[v].piece]++] = v; });
    std::vector<plans::PlanBox> boxes(building.pieces.size());
    for (std::size_t p = 0; p < boxes.size(); ++p)
        for (std::uint32_t k = 0; k < building.pieces[p].corner_count; ++k) {
            const plans::GridPoint at = building.points[building.corners[building.pieces[p].first_corner + k].vertex];
            boxes[p].add({double(at.x), double(at.y)});
        }
    index_.emplace(boxes);
}

std::uint32_t SpaceFinder::at(double x, double y, double z) const {
    const plans::GridFrame& frame = building_.frame;
    const double gx = (x - frame.origin_x) / frame.unit, gy = (y - frame.origin_y) / frame.unit;
    const double gz = (z - frame.origin_z) / frame.unit;
    std::uint32_t found = nowhere;
    index_->near({gx, gy}, [&](std::uint32_t p) {
        if (found != nowhere || first_volume_[p] == first_volume_[p + 1]) return;
        if (!holds(building_, building_.pieces[p], gx, gy)) return;
        for (std::uint32_t i = first_volume_[p]; i < first_volume_[p + 1]; ++i) {
            const Volume& volume = building_.volumes[volumes_[i]];
            if (gz < volume.z_low || gz >= volume.z_high) continue;
            const Space& space = building_.spaces[volume.space];
            found = space.room != nowhere ? space.room : volume.space;
        }
    });
    return found;
}

std::uint32_t SpaceFinder::of(const ObjectBox& box) const {
    std::map<std::uint32_t, int> counts;
    constexpr std::array<double, 5> along = {0.02, 0.26, 0.5, 0.74, 0.98};
    constexpr std::array<double, 3> up = {0.02, 0.5, 0.98};
    const auto& [a, b, c, d] = box.footprint;
    for (const double u : along)
        for (const double v : along)
            for (const double w : up) {
                const double x = a.x + u * (b.x - a.x) + v * (d.x - a.x), y = a.y + u * (b.y - a.y) + v * (d.y - a.y);
                const std::uint32_t space = at(x, y, box.z_low + w * (box.z_high - box.z_low));
                if (space != nowhere) ++counts[space];
            }
    std::uint32_t best = nowhere;
    for (const auto& [space, count] : counts) {
        const int own = rank(building_.spaces[space].label);
        if (best == nowhere || own < rank(building_.spaces[best].label) ||
            (own == rank(building_.spaces[best].label) && count > counts[best]))
            best = space;
    }
    return best;
}

}  // namespace enfilade::modeler
