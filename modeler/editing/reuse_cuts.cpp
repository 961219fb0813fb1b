#include "modeler/editing/reuse_cuts.h"

#include <algorithm>
#include <unordered_map>

#include "base/check.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

/// The number of each value in the order of their first use: equal where both sequences repeat alike.
class FirstUse {
public:
    std::uint32_t number(std::uint32_t value) {
        const auto at = std::find(values_.begin(), values_.end(), value);
        if (at != values_.end()) return std::uint32_t(at - values_.begin());
        values_.push_back(value);
        return std::uint32_t(values_.size() - 1);
    }

private:
    std::vector<std::uint32_t> values_;
};

/// A region in numbers of its own: two regions with the same are cut alike.
struct Shape {
    RegionPolygon polygon;
    std::vector<std::uint32_t> lines;    ///< ascending
    std::vector<std::uint32_t> content;  ///< all that the cutter sees
    std::size_t hash = 0;
};

Shape shape_of(const Stack& stack, RegionPolygon polygon) {
    Shape shape;
    for (const PolygonSide& side : polygon.sides) shape.lines.push_back(side.line);
    std::sort(shape.lines.begin(), shape.lines.end());
    shape.lines.erase(std::unique(shape.lines.begin(), shape.lines.end()), shape.lines.end());
    std::vector<std::uint32_t>& content = shape.content;
    content = {std::uint32_t(polygon.height), polygon.carries_light ? 1u : 0u, std::uint32_t(polygon.points.size())};
    for (const std::uint32_t p : polygon.points) {
        content.push_back(std::uint32_t(stack.points[p].x));
        content.push_back(std::uint32_t(stack.points[p].y));
    }
    FirstUse looks;
    std::uint32_t last_look = 0, last_number = 0;
    for (const PolygonSide& side : polygon.sides) {
        const auto line = std::lower_bound(shape.lines.begin(), shape.lines.end(), side.line) - shape.lines.begin();
        if (&side == polygon.sides.data() || side.look != last_look) last_number = looks.number(last_look = side.look);
        content.insert(content.end(), {side.from, side.to, std::uint32_t(line), last_number, side.faces});
    }
    for (const std::uint32_t word : content)
        shape.hash = (shape.hash ^ word) * 0x9e3779b97f4a7c15u + (shape.hash >> 29);
    shape.polygon = std::move(polygon);
    return shape;
}

/// The cut of a region for another one of the same shape.
RegionCut renumbered(const RegionCut& cut, const Shape& before, const Shape& after) {
    RegionCut result = cut;
    result.points = after.polygon.points;
    const std::size_t count = before.polygon.sides.size();
    std::vector<std::array<std::uint32_t, 2>> tags;
    for (std::size_t k = 0; k < count; ++k) tags.push_back({before.polygon.sides[k].tag, after.polygon.sides[k].tag});
    std::sort(tags.begin(), tags.end());
    for (PolygonSide& side : result.sides) {
        if (side.tag < first_disc_cut) {
            const auto at = std::lower_bound(tags.begin(), tags.end(), std::array<std::uint32_t, 2>{side.tag, 0});
            ENFILADE_CHECK(at != tags.end() && (*at)[0] == side.tag);
            side.tag = (*at)[1];
        }
        if (side.line < first_disc_line) {
            const auto at = std::lower_bound(before.lines.begin(), before.lines.end(), side.line);
            ENFILADE_CHECK(at != before.lines.end() && *at == side.line);
            side.line = after.lines[std::size_t(at - before.lines.begin())];
        }
    }
    return result;
}

}  // namespace

ReusedCuts reuse_cuts(const Stack& before, std::span<const RegionCut> cuts, const Stack& after,
                      const CutOptions& options, const accel::Executor& executor) {
    ENFILADE_CHECK(cuts.size() == before.regions.size());
    const RegionCutter old_cutter(before, options), cutter(after, options);
    std::vector<Shape> known;
    known.reserve(before.regions.size());
    std::unordered_multimap<std::size_t, std::uint32_t> by_hash;
    for (std::uint32_t r = 0; r < before.regions.size(); ++r) {
        known.push_back(shape_of(before, old_cutter.polygon(r)));
        by_hash.emplace(known.back().hash, r);
    }
    ReusedCuts result;
    result.cuts.resize(after.regions.size());
    std::vector<RegionPolygon> to_cut;
    for (std::uint32_t r = 0; r < after.regions.size(); ++r) {
        Shape shape = shape_of(after, cutter.polygon(r));
        const auto matches = [&](std::uint32_t old) { return known[old].content == shape.content; };
        std::uint32_t match = UINT32_MAX;
        if (r < known.size() && matches(r)) match = r;
        else
            for (auto [at, end] = by_hash.equal_range(shape.hash); at != end; ++at)
                if (at->second < match && matches(at->second)) match = at->second;
        if (match != UINT32_MAX) {
            result.cuts[r] = renumbered(cuts[match], known[match], shape);
        } else {
            result.cut_again.push_back(r);
            to_cut.push_back(std::move(shape.polygon));
        }
    }
    accel::parallel_for(executor, to_cut.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) result.cuts[result.cut_again[k]] = cutter.cut(std::move(to_cut[k]));
    });
    return result;
}

}  // namespace enfilade::modeler
