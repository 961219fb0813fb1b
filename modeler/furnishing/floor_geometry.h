#pragma once
// Convex footprints on the grid: exact tests of what lies beside, inside and across what.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plans/grid.h"
#include "plans/vector2.h"

namespace enfilade::modeler {

using Ring = std::vector<plans::GridPoint>;

struct GridBox {
    std::int32_t x_low = 0, y_low = 0, x_high = 0, y_high = 0;
    [[nodiscard]] bool meets(const GridBox& other) const {
        return x_low < other.x_high && other.x_low < x_high && y_low < other.y_high && other.y_low < y_high;
    }
};
[[nodiscard]] GridBox box_around(std::span<const plans::GridPoint> points);

/// Whether two convex rings, counter-clockwise, have inner points in common (separating axes: exact).
[[nodiscard]] bool overlap(const Ring& a, const Ring& b);
/// Whether the segment has points inside the convex ring. Exact.
[[nodiscard]] bool crosses(plans::GridPoint a, plans::GridPoint b, const Ring& ring);
/// Squared distance of a point from a convex ring, 0 inside. Grid units.
[[nodiscard]] double distance2(plans::Point p, const Ring& ring);

/// A segment of a room's outline, with the room on its left.
struct FloorSide {
    plans::GridPoint a, b;
};

/// A floor as closed loops of sides, found by their place.
class Floor {
public:
    Floor() = default;
    explicit Floor(std::vector<FloorSide> sides);

    [[nodiscard]] std::span<const FloorSide> sides() const { return sides_; }
    [[nodiscard]] const GridBox& box() const { return box_; }
    /// No side runs through the inside of the ring, and its first point lies in the floor or on its border. Exact.
    [[nodiscard]] bool holds(const Ring& ring) const;
    [[nodiscard]] bool holds(plans::GridPoint p) const;  ///< inside, or on the border
    /// How far one goes from p along the unit vector before a side is met; `most` where none is. Grid units.
    [[nodiscard]] double free_way(plans::Point p, plans::Point direction, double most) const;
    /// Calls visit(side) for those that may meet the box, some more than once.
    template <class Visit>
    void near(const GridBox& box, Visit visit) const {
        if (first_.empty()) return;
        const std::int64_t x0 = column(box.x_low), x1 = column(box.x_high);
        for (std::int64_t y = row(box.y_low); y <= row(box.y_high); ++y)
            for (std::int64_t x = x0; x <= x1; ++x) {
                const auto bucket = std::size_t(y * columns_ + x);
                for (std::uint32_t k = first_[bucket]; k < first_[bucket + 1]; ++k) visit(entries_[k]);
            }
    }

private:
    [[nodiscard]] std::int64_t column(std::int64_t x) const { return place(x - box_.x_low, columns_); }
    [[nodiscard]] std::int64_t row(std::int64_t y) const { return place(y - box_.y_low, rows_); }
    [[nodiscard]] std::int64_t place(std::int64_t d, std::int64_t count) const {
        const std::int64_t at = d / cell_;
        return d < 0 ? 0 : at >= count ? count - 1 : at;
    }

    std::vector<FloorSide> sides_;
    GridBox box_;
    std::int64_t cell_ = 1, columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> first_, entries_;
};

}  // namespace enfilade::modeler
