#include "modeler/cutting/cut_cost.h"

#include <cmath>

namespace enfilade::modeler {

using plans::GridPoint;

double sah_sum(std::span<const GridPoint> points, const Partition& partition, double unit, double height,
               const CutCost& cost) {
    const auto point = [&](std::uint32_t p) {
        return p < points.size() ? points[p] : partition.new_points[p - points.size()];
    };
    double sum = 0, area = 0, perimeter = 0;
    for (std::uint32_t k = 0; k < partition.piece_count(); ++k) {
        const auto ring = partition.piece(k);
        double own_perimeter = 0;
        std::int64_t own_area2 = 0;
        double sections = 0, faces = 0;
        for (std::size_t s = 0; s < ring.size(); ++s) {
            const PolygonSide& side = ring[s];
            const PolygonSide& before = ring[(s + ring.size() - 1) % ring.size()];
            const GridPoint a = point(side.from), b = point(side.to);
            const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y) * unit;
            own_area2 += orientation(point(ring[0].from), a, b);
            own_perimeter += length;
            if (side.tag != cut_tag) perimeter += length;
            const bool goes_on = side.tag != cut_tag && before.tag != cut_tag && side.look == before.look &&
                                 goes_straight(point(before.from), a, b, before.line, side.line);
            if (goes_on) continue;
            ++sections;
            faces += side.faces;
        }
        const double own_area = double(own_area2) / 2 * unit * unit;
        area += own_area;
        sum += (own_perimeter * height + 2 * own_area) * (cost.visit + cost.section * sections + cost.face * faces);
    }
    const double surface = perimeter * height + 2 * area;
    return surface > 0 ? sum / surface : 0;
}

}  // namespace enfilade::modeler
