#pragma once
// The skeleton of a generated office floor: rows of offices along corridors, joined by cross corridors.

#include <cstdint>
#include <vector>

namespace enfilade::plans::office {

// Metres; all between wall axes.
inline constexpr double room_depth = 5.0;
inline constexpr double corridor_width = 2.4;
inline constexpr double court_depth = 9.0;
inline constexpr double spine_width = 2.6;
inline constexpr double room_width = 3.6;  ///< on average
inline constexpr double stair_slot = 3.6;
inline constexpr std::uint32_t max_side = 8;  ///< offices on one side of one corridor: keeps corridors short

/// A row: offices, a corridor along x, offices; by the y of its four wall axes.
struct Row {
    double bottom = 0;
    double corridor_low = 0;
    double corridor_high = 0;
    double top = 0;
    bool shares_bottom = false;  ///< its lower back wall is the upper one of the row below
};

/// Rows one above the other, each cut into corridor segments along x; from two rows on a cross corridor joins
/// them at the left, from three on another one at the right, so that the gaps between rows are closed courtyards.
struct Skeleton {
    std::vector<Row> rows;
    std::uint32_t segments = 1;
    double segment_length = 0;
    std::uint32_t spines = 0;

    [[nodiscard]] std::uint32_t row_count() const { return static_cast<std::uint32_t>(rows.size()); }
    [[nodiscard]] std::uint32_t corridor_count() const { return row_count() * (segments + spines); }
    [[nodiscard]] std::uint32_t side_count() const { return 2 * row_count() * segments; }
    [[nodiscard]] double x(std::uint32_t segment) const { return segment * segment_length; }
    [[nodiscard]] double length() const { return segments * segment_length; }
    /// A courtyard lies between this row and the next.
    [[nodiscard]] bool court_above(std::uint32_t row) const {
        return row + 1 < row_count() && !rows[row + 1].shares_bottom;
    }
    /// Offices on one side of one corridor segment, when the floor has `offices` of them; sides count lower, upper,
    /// then along the segments, then along the rows.
    [[nodiscard]] std::uint32_t offices_on_side(std::uint32_t side, std::uint32_t offices) const {
        const std::uint64_t sides = side_count();
        return static_cast<std::uint32_t>((side + std::uint64_t{1}) * offices / sides -
                                          std::uint64_t{side} * offices / sides);
    }
};

/// The smallest skeleton that holds `rooms` rooms, corridors counted. \pre rooms >= 2
[[nodiscard]] Skeleton plan_skeleton(std::uint32_t rooms);

}  // namespace enfilade::plans::office
