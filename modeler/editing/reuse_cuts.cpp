#include "modeler/editing/reuse_cuts.h"

#include <algorithm>
#include <unordered_map>

#include "base/check.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

std::vector<std::uint32_t> sorted_unique(std::vector<std::uint32_t> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t place_in(const std::vector<std::uint32_t>& sorted, std::uint32_t value) {
    return std::size_t(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

/// For each value the number of different ones before its first use: equal where two sequences repeat alike.
std::vector<std::uint32_t> numbered_by_first_use(const std::vector<std::uint32_t>& values) {
    const std::vector<std::uint32_t> known = sorted_unique(values);
    std::vector<std::uint32_t> number(known.size(), UINT32_MAX), result;
    std::uint32_t count = 0;
    for (const std::uint32_t value : values) {
        std::uint32_t& of = number[place_in(known, value)];
        if (of == UINT32_MAX) of = count++;
        result.push_back(of);
    }
    return result;
}

/// A region in numbers of its own: two regions with the same are cut alike.
struct Shape {
    RegionPolygon polygon;
    std::vector<std::uint32_t> lines;    ///< ascending
    std::vector<std::uint32_t> content;  ///< all that the cutter sees
    std::size_t hash = 0;
};

Shape shape_of(const Stack& stack, RegionPolygon polygon) {
    Shape shape;
    std::vector<std::uint32_t> looks;
    for (const PolygonSide& side : polygon.sides) {
        shape.lines.push_back(side.line);
        looks.push_back(side.look);
    }
    shape.lines = sorted_unique(std::move(shape.lines));
    looks = numbered_by_first_use(looks);
    std::vector<std::uint32_t>& content = shape.content;
    content = {std::uint32_t(polygon.height), polygon.carries_light ? 1u : 0u, std::uint32_t(polygon.points.size())};
    for (const std::uint32_t p : polygon.points) {
        content.push_back(std::uint32_t(stack.points[p].x));
        content.push_back(std::uint32_t(stack.points[p].y));
    }
    for (std::size_t k = 0; k < polygon.sides.size(); ++k) {
        const PolygonSide& side = polygon.sides[k];
        content.insert(content.end(),
                       {side.from, side.to, std::uint32_t(place_in(shape.lines, side.line)), looks[k], side.faces});
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
            const std::size_t at = place_in(before.lines, side.line);
            ENFILADE_CHECK(at < before.lines.size() && before.lines[at] == side.line);
            side.line = after.lines[at];
        }
    }
    return result;
}

}  // namespace

ReusedCuts reuse_cuts(const Stack& before, std::span<const RegionCut> cuts, const Stack& after,
                      const CutOptions& options, const accel::Executor& executor) {
    ENFILADE_CHECK(cuts.size() == before.regions.size());
    const RegionCutter old_cutter(before, options), cutter(after, options);
    ReusedCuts result;
    result.cuts.resize(after.regions.size());
    std::vector<std::uint32_t> changed;
    for (std::uint32_t r = 0; r < after.regions.size(); ++r) {
        if (cutter.same_in(old_cutter, r)) result.cuts[r] = cuts[r];
        else changed.push_back(r);
    }
    // What changed its number only is found by its shape.
    std::unordered_multimap<std::size_t, std::uint32_t> by_hash;
    std::vector<Shape> known;
    std::vector<std::uint32_t> known_region;
    const auto learn = [&](std::uint32_t r) {
        known_region.push_back(r);
        known.push_back(shape_of(before, old_cutter.polygon(r)));
        by_hash.emplace(known.back().hash, std::uint32_t(known.size() - 1));
    };
    for (const std::uint32_t r : changed)
        if (r < before.regions.size()) learn(r);
    for (std::uint32_t r = std::uint32_t(after.regions.size()); r < before.regions.size(); ++r) learn(r);
    std::vector<RegionPolygon> to_cut;
    for (const std::uint32_t r : changed) {
        Shape shape = shape_of(after, cutter.polygon(r));
        std::uint32_t match = UINT32_MAX;
        for (auto [at, end] = by_hash.equal_range(shape.hash); at != end; ++at)
            if (known[at->second].content == shape.content) match = std::min(match, at->second);
        if (match != UINT32_MAX) {
            result.cuts[r] = renumbered(cuts[known_region[match]], known[match], shape);
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
