#include "modeler/objects/space_finder.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/id.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nowhere = UINT32_MAX;

/// Rooms before the air around the house, that before doorways and stairs.
int rank(Label label) {
    if (label == Label::Room) return 0;
    return label == Label::Exterior ? 1 : 2;
}

}  // namespace

std::uint32_t SpaceFinder::at(double x, double y, double z) const {
    const std::uint32_t volume = volumes_.at({x, y, z});
    if (volume == nowhere || !accel::carries_light(building_.volumes[volume].label)) return nowhere;
    const std::uint32_t space = building_.volumes[volume].space;
    const std::uint32_t room = building_.spaces[space].room;
    return room != nowhere ? room : space;
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
