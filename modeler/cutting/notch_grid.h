#pragma once
// Which notches may lie in a box: buckets of a uniform grid, about one notch to a bucket.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "plans/grid.h"

namespace enfilade::modeler {

struct GridBox {
    plans::GridPoint min{INT32_MAX, INT32_MAX};
    plans::GridPoint max{INT32_MIN, INT32_MIN};

    void add(plans::GridPoint p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    [[nodiscard]] bool holds(plans::GridPoint p) const {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y;
    }
};

/// Corners of a ring, by place; they are asked for box by box and never come back once they are dropped.
class NotchGrid {
public:
    /// \pre all |coordinates| <= 2^30
    NotchGrid(std::span<const plans::GridPoint> points, const std::vector<std::uint32_t>& corners) : points_(points) {
        if (corners.empty()) return;
        GridBox all;
        for (const std::uint32_t corner : corners) all.add(points[corner]);
        min_ = all.min;
        const double width = double(all.max.x) - all.min.x, height = double(all.max.y) - all.min.y;
        const double count = double(corners.size());
        cell_ = std::max({std::sqrt(width * height / count), std::max(width, height) / count, 1.0});
        columns_ = std::int64_t(width / cell_) + 1;
        rows_ = std::int64_t(height / cell_) + 1;
        buckets_.resize(std::size_t(columns_ * rows_));
        for (const std::uint32_t corner : corners)
            bucket(column(points[corner].x), row(points[corner].y)).push_back(corner);
    }

    /// Calls `visit(corner)` for the corners in a box until one returns true; forgets those that are `dropped`.
    template <class Dropped, class Visit>
    bool find(const GridBox& box, Dropped dropped, Visit visit) {
        if (buckets_.empty()) return false;
        for (std::int64_t y = row(box.min.y); y <= row(box.max.y); ++y)
            for (std::int64_t x = column(box.min.x); x <= column(box.max.x); ++x) {
                std::erase_if(bucket(x, y), dropped);
                for (const std::uint32_t corner : bucket(x, y))
                    if (box.holds(points_[corner]) && visit(corner)) return true;
            }
        return false;
    }

private:
    [[nodiscard]] std::int64_t column(std::int32_t x) const { return place(double(x) - min_.x, columns_); }
    [[nodiscard]] std::int64_t row(std::int32_t y) const { return place(double(y) - min_.y, rows_); }
    [[nodiscard]] std::int64_t place(double d, std::int64_t count) const {
        return std::int64_t(std::clamp(d / cell_, 0.0, double(count - 1)));
    }
    [[nodiscard]] std::vector<std::uint32_t>& bucket(std::int64_t x, std::int64_t y) {
        return buckets_[std::size_t(y * columns_ + x)];
    }

    std::span<const plans::GridPoint> points_;
    plans::GridPoint min_;
    double cell_ = 1;
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace enfilade::modeler
