#include "plans/generate_floor.h"

#include <algorithm>
#include <cmath>

namespace enfilade::plans::office {
namespace {

struct Shape {
    std::uint32_t rows;
    std::uint32_t segments;
    std::uint32_t spines;
    [[nodiscard]] std::uint64_t corridors() const { return std::uint64_t{rows} * (segments + spines); }
    [[nodiscard]] std::uint64_t sides() const { return 2 * std::uint64_t{rows} * segments; }
};

/// About as deep as long: a row is some 16 m deep, a segment some 29 m long.
Shape shape_for(std::uint32_t corridor_segments) {
    const auto segments = std::max(1u, static_cast<std::uint32_t>(std::lround(std::sqrt(corridor_segments / 1.8))));
    const std::uint32_t rows = (corridor_segments + segments - 1) / segments;
    return {rows, segments, rows >= 3 ? 2u : rows == 2 ? 1u : 0u};
}

}  // namespace

Skeleton plan_skeleton(std::uint32_t rooms) {
    Shape shape = shape_for(1);
    // Large floors skip ahead: no shape holds more than 17 rooms a corridor segment.
    for (std::uint32_t count = std::max(1u, rooms / (4 * max_side));; ++count) {
        shape = shape_for(count);
        if (shape.corridors() + max_side * shape.sides() >= rooms) break;
    }
    const std::uint64_t offices = rooms - shape.corridors();
    const std::uint64_t longest = (offices + shape.sides() - 1) / shape.sides();

    Skeleton skeleton;
    skeleton.segments = shape.segments;
    skeleton.spines = shape.spines;
    skeleton.segment_length = room_width * static_cast<double>(std::max<std::uint64_t>(longest, 2));
    double y = 0;
    for (std::uint32_t r = 0; r < shape.rows; ++r) {
        Row row;
        row.shares_bottom = r % 2 == 1;
        if (r > 0 && !row.shares_bottom) y += court_depth;
        row.bottom = y;
        row.corridor_low = y + room_depth;
        row.corridor_high = row.corridor_low + corridor_width;
        row.top = y = row.corridor_high + room_depth;
        skeleton.rows.push_back(row);
    }
    return skeleton;
}

}  // namespace enfilade::plans::office
