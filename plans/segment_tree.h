#pragma once
// Which segments come close to each other, and to points: a binary space partition walked depth first, never
// stored. Robust where arcs leave thousands of tiny segments beside walls of many metres (a uniform grid is not).

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "plans/noding.h"

namespace enfilade::plans {
namespace detail {

/// Grid points min <= p <= max.
struct GridBox {
    std::int64_t min_x, min_y, max_x, max_y;
};

/// Conservative by one unit on all sides: a segment that meets a pixel whose centre lies in `box` is always found.
inline bool comes_near(const Segment& segment, const GridBox& box) {
    if (std::max(segment.a.x, segment.b.x) < box.min_x - 1 || std::min(segment.a.x, segment.b.x) > box.max_x + 1)
        return false;
    if (std::max(segment.a.y, segment.b.y) < box.min_y - 1 || std::min(segment.a.y, segment.b.y) > box.max_y + 1)
        return false;
    const std::int64_t dx = std::int64_t(segment.b.x) - segment.a.x;
    const std::int64_t dy = std::int64_t(segment.b.y) - segment.a.y;
    const std::int64_t twice_side = dx * (box.min_y + box.max_y - 2 * std::int64_t(segment.a.y)) -
                                    dy * (box.min_x + box.max_x - 2 * std::int64_t(segment.a.x));
    return std::abs(twice_side) <=
           std::abs(dx) * (box.max_y - box.min_y + 2) + std::abs(dy) * (box.max_x - box.min_x + 2);
}

/// Halves boxes as long as that lessens the pairs to be tried. Lists of all open boxes lie in one array each,
/// used as a stack.
template <class Leaf>
class SegmentTree {
public:
    SegmentTree(std::span<const Segment> segments, std::span<const GridPoint> points, Leaf leaf)
        : segments_(segments), points_(points), leaf_(leaf) {}

    void walk() {
        if (segments_.empty()) return;
        GridBox box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            list_.push_back(std::uint32_t(i));
            for (const GridPoint p : {segments_[i].a, segments_[i].b}) {
                box = {std::min<std::int64_t>(box.min_x, p.x), std::min<std::int64_t>(box.min_y, p.y),
                       std::max<std::int64_t>(box.max_x, p.x), std::max<std::int64_t>(box.max_y, p.y)};
            }
        }
        order_.resize(points_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = std::uint32_t(i);
        descend(box, 0, 0, order_.size(), 0);
    }

private:
    static constexpr std::size_t kFew = 10;  ///< measured on office floors: 6..16 are within 10 %
    static constexpr int kDeep = 60;

    /// Segments list_[first ..], points order_[point_first .. point_last).
    void descend(const GridBox& box, std::size_t first, std::size_t point_first, std::size_t point_last, int depth) {
        const std::size_t count = list_.size() - first;
        if (count == 0 || (!points_.empty() && point_first == point_last)) return;
        const bool wide = box.max_x - box.min_x >= box.max_y - box.min_y;
        if (count <= kFew || depth == kDeep ||
            !(split(box, wide, first, point_first, point_last, depth) ||
              split(box, !wide, first, point_first, point_last, depth)))
            leaf_(std::span(list_).subspan(first, count),
                  std::span(order_).subspan(point_first, point_last - point_first));
    }

    /// False, with all as it was, where halving across this axis does not pay.
    bool split(const GridBox& box, bool across_x, std::size_t first, std::size_t point_first, std::size_t point_last,
               int depth) {
        GridBox low = box;
        GridBox high = box;
        if (across_x) {
            if (box.min_x == box.max_x) return false;
            low.max_x = (box.min_x + box.max_x) >> 1;
            high.min_x = low.max_x + 1;
        } else {
            if (box.min_y == box.max_y) return false;
            low.max_y = (box.min_y + box.max_y) >> 1;
            high.min_y = low.max_y + 1;
        }
        const std::size_t last = list_.size();
        for (std::size_t i = first; i < last; ++i)
            if (comes_near(segments_[list_[i]], low)) list_.push_back(list_[i]);
        const std::size_t middle = list_.size();
        std::size_t high_count = 0;
        for (std::size_t i = first; i < last; ++i) high_count += comes_near(segments_[list_[i]], high);
        const double all = double(last - first);
        const double in_low = double(middle - last);
        const double in_high = double(high_count);
        if (in_low * in_low + in_high * in_high > 0.8 * all * all && in_low + in_high > 1.1 * all) {
            list_.resize(last);
            return false;
        }
        const auto point_middle = std::partition(
            order_.begin() + point_first, order_.begin() + point_last,
            [&](std::uint32_t p) { return across_x ? points_[p].x <= low.max_x : points_[p].y <= low.max_y; });
        const std::size_t point_split = std::size_t(point_middle - order_.begin());
        descend(low, last, point_first, point_split, depth + 1);
        list_.resize(last);
        for (std::size_t i = first; i < last; ++i)
            if (comes_near(segments_[list_[i]], high)) list_.push_back(list_[i]);
        descend(high, last, point_split, point_last, depth + 1);
        list_.resize(last);
        return true;
    }

    std::span<const Segment> segments_;
    std::span<const GridPoint> points_;
    Leaf leaf_;
    std::vector<std::uint32_t> list_;
    std::vector<std::uint32_t> order_;
};

}  // namespace detail

/// Calls `leaf(segments)` so that any two segments that meet are together in one call at least. Cost: n log n
/// where a bounded number of segments passes any place.
template <class Leaf>
void visit_close_segments(std::span<const Segment> segments, Leaf leaf) {
    const auto both = [&](std::span<const std::uint32_t> close, std::span<const std::uint32_t>) { leaf(close); };
    detail::SegmentTree<decltype(both)>(segments, {}, both).walk();
}

/// Calls `leaf(segments, points)` so that each point comes once, together with all segments that meet its pixel.
/// \pre all points lie in the bounding box of the segments
template <class Leaf>
void visit_close_points(std::span<const Segment> segments, std::span<const GridPoint> points, Leaf leaf) {
    if (!points.empty()) detail::SegmentTree<Leaf>(segments, points, leaf).walk();
}

}  // namespace enfilade::plans
