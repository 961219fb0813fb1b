#include "plans/dxf/stroke_index.h"

#include "plans/vector2.h"

namespace enfilade::plans {

StrokeIndex::StrokeIndex(const std::vector<SheetStroke>& strokes) {
    boxes_.resize(strokes.size());
    for (std::uint32_t k = 0; k < strokes.size(); ++k) {
        const Stroke& stroke = strokes[k].stroke;
        PlanBox& box = boxes_[k];
        box.add(stroke.a);
        box.add(stroke.b);
        if (stroke.bulge != 0) {
            const Point chord = stroke.b - stroke.a;
            box.add((stroke.a + stroke.b) * 0.5 - turned_left(chord) * (stroke.bulge / 2));
        }
        const std::int64_t x0 = at(box.min.x), x1 = at(box.max.x), y0 = at(box.min.y), y1 = at(box.max.y);
        if ((x1 - x0 + 1) * (y1 - y0 + 1) > most_cells) {
            large_.push_back(k);
            continue;
        }
        for (std::int64_t x = x0; x <= x1; ++x)
            for (std::int64_t y = y0; y <= y1; ++y) cells_[key(x, y)].push_back(k);
    }
}

std::vector<std::uint32_t> StrokeIndex::near(const PlanBox& box) const {
    std::vector<std::uint32_t> found = large_;
    for (std::int64_t x = at(box.min.x); x <= at(box.max.x); ++x)
        for (std::int64_t y = at(box.min.y); y <= at(box.max.y); ++y)
            if (const auto bucket = cells_.find(key(x, y)); bucket != cells_.end())
                found.insert(found.end(), bucket->second.begin(), bucket->second.end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::erase_if(found, [&](std::uint32_t k) {
        const PlanBox& b = boxes_[k];
        return b.max.x < box.min.x || b.min.x > box.max.x || b.max.y < box.min.y || b.min.y > box.max.y;
    });
    return found;
}

}  // namespace enfilade::plans
