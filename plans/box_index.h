#pragma once
// Which walls may be near a place: buckets of a uniform grid, at most a few entries a wall.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "plans/vector2.h"

namespace enfilade::plans {

struct PlanBox {
    Point min{HUGE_VAL, HUGE_VAL};
    Point max{-HUGE_VAL, -HUGE_VAL};

    void add(Point p) {
        min = {std::fmin(min.x, p.x), std::fmin(min.y, p.y)};
        max = {std::fmax(max.x, p.x), std::fmax(max.y, p.y)};
    }
    [[nodiscard]] bool empty() const { return !(min.x <= max.x); }
    [[nodiscard]] PlanBox grown(double by) const { return {{min.x - by, min.y - by}, {max.x + by, max.y + by}}; }
};

/// Boxes by the cells of a grid with about as many cells as boxes.
class BoxIndex {
public:
    explicit BoxIndex(const std::vector<PlanBox>& boxes) {
        PlanBox all;
        double sizes = 0;
        for (const PlanBox& box : boxes) {
            if (box.empty()) continue;
            all.add(box.min);
            all.add(box.max);
            sizes += box.max.x - box.min.x + box.max.y - box.min.y;
        }
        if (all.empty()) return;
        min_ = all.min;
        const double width = all.max.x - all.min.x;
        const double height = all.max.y - all.min.y;
        const double count = double(boxes.size());
        cell_ =
            std::max({sizes / count, std::sqrt(width * height / count), std::max(width, height) / (count + 1), 1e-9});
        columns_ = std::int64_t(width / cell_) + 1;
        rows_ = std::int64_t(height / cell_) + 1;
        first_.assign(std::size_t(columns_ * rows_) + 1, 0);
        const auto each = [&](auto visit) {
            for (std::uint32_t i = 0; i < boxes.size(); ++i) {
                if (boxes[i].empty()) continue;
                for (std::int64_t y = row(boxes[i].min.y); y <= row(boxes[i].max.y); ++y)
                    for (std::int64_t x = column(boxes[i].min.x); x <= column(boxes[i].max.x); ++x)
                        visit(std::size_t(y * columns_ + x), i);
            }
        };
        each([&](std::size_t bucket, std::uint32_t) { ++first_[bucket + 1]; });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        entries_.resize(first_.back());
        std::vector<std::uint32_t> slot(first_.begin(), first_.end() - 1);
        each([&](std::size_t bucket, std::uint32_t i) { entries_[slot[bucket]++] = i; });
    }

    /// Calls `visit(index)` for all boxes that may hold p, by ascending index.
    template <class Visit>
    void near(Point p, Visit visit) const {
        if (first_.empty()) return;
        const auto bucket = std::size_t(row(p.y) * columns_ + column(p.x));
        for (std::uint32_t i = first_[bucket]; i < first_[bucket + 1]; ++i) visit(entries_[i]);
    }

private:
    [[nodiscard]] std::int64_t column(double x) const { return place(x - min_.x, columns_); }
    [[nodiscard]] std::int64_t row(double y) const { return place(y - min_.y, rows_); }
    [[nodiscard]] std::int64_t place(double d, std::int64_t count) const {
        return std::int64_t(std::clamp(d / cell_, 0.0, double(count - 1)));
    }

    Point min_;
    double cell_ = 1;
    std::int64_t columns_ = 0;
    std::int64_t rows_ = 0;
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> entries_;
};

}  // namespace enfilade::plans
