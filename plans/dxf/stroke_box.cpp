#include "plans/dxf/stroke_box.h"

#include <algorithm>
#include <cmath>

namespace enfilade::plans::dxf {

std::array<double, 4> box_of(const Stroke& stroke) {
    const Point a = stroke.a;
    const Point b = stroke.b;
    std::array<double, 4> box = {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
    if (stroke.bulge == 0 || a == b) return box;
    const double aside = (1 - stroke.bulge * stroke.bulge) / (4 * stroke.bulge);
    const Point centre = {(a.x + b.x) / 2 - aside * (b.y - a.y), (a.y + b.y) / 2 + aside * (b.x - a.x)};
    const double r = std::hypot(a.x - centre.x, a.y - centre.y);
    // Of the four extreme points of the circle those count that lie on the arc's side of its chord: right of a -> b
    // where the arc turns left.
    for (const Point e : {Point{r, 0}, Point{-r, 0}, Point{0, r}, Point{0, -r}}) {
        const Point p = {centre.x + e.x, centre.y + e.y};
        const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        if (side * stroke.bulge >= 0) continue;
        box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x), std::max(box[3], p.y)};
    }
    return box;
}

std::array<double, 4> bounds_of(const std::vector<Stroke>& strokes) {
    if (strokes.empty()) return {0, 0, 0, 0};
    std::array<double, 4> all = box_of(strokes.front());
    for (const Stroke& stroke : strokes) {
        const std::array<double, 4> box = box_of(stroke);
        all = {std::min(all[0], box[0]), std::min(all[1], box[1]), std::max(all[2], box[2]), std::max(all[3], box[3])};
    }
    return all;
}

}  // namespace enfilade::plans::dxf
