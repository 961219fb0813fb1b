#pragma once
// Which strokes are near a place: buckets of a square grid.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "plans/box_index.h"
#include "plans/dxf/sheet.h"

namespace enfilade::plans {

/// The strokes' boxes; an arc's is that of its ends and middle.
class StrokeIndex {
public:
    explicit StrokeIndex(const std::vector<SheetStroke>& strokes);
    /// Strokes whose box meets `box`, ascending.
    [[nodiscard]] std::vector<std::uint32_t> near(const PlanBox& box) const;

private:
    static constexpr double cell = 1.0;  ///< metres
    static constexpr std::int64_t most_cells = 4096;

    [[nodiscard]] static std::int64_t at(double x) { return std::int64_t(std::floor(x / cell)); }
    [[nodiscard]] static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return (std::uint64_t(std::uint32_t(x)) << 32) | std::uint32_t(y);
    }

    std::vector<PlanBox> boxes_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
    std::vector<std::uint32_t> large_;  ///< strokes over very many cells
};

}  // namespace enfilade::plans
