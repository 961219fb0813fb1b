#pragma once
// Rooms drawn by painting over each other, then rounded as plans are.

#include <cmath>
#include <optional>
#include <vector>

#include "plans/random.h"
#include "plans/vector2.h"
#include "tests/support/room.h"

namespace enfilade::testing {

enum class Paint : std::uint8_t { Room, Solid };

/// Where a sketch is put: turned around the origin, then moved.
struct Placing {
    double turn = 0;  ///< radians
    double x = 0;     ///< grid units
    double y = 0;
};

/// Closed contours, each painted over those before it. Coordinates are grid units, of any fraction.
class RoomSketch {
public:
    /// Every side of the contour is a line of its own.
    void paint(Paint paint, const std::vector<plans::Point>& ring);
    /// Sides with the same number in `lines` are on one line.
    void paint(Paint paint, const std::vector<plans::Point>& ring, const std::vector<std::uint32_t>& lines);
    /// A line of another storey: sides that it crosses get a point there, and bend to it.
    void scratch(plans::Point a, plans::Point b);

    /// Snap-rounds all (plans/noding.h) and takes one of the connected parts painted as room, mostly the largest: sides
    /// in random order, with tags, looks and faces. None where no room is left.
    [[nodiscard]] std::optional<Room> realise(const Placing& placing, plans::Random& random) const;
    /// Largest distance of a contour's corner from the origin.
    [[nodiscard]] double reach() const;

private:
    struct Stroke {
        plans::Point a, b;
        std::uint32_t line;
        std::uint32_t contour;  ///< `scratched` for none
    };
    static constexpr std::uint32_t scratched = UINT32_MAX;

    std::vector<Stroke> strokes_;
    std::vector<Paint> paints_;  ///< [contour]
    std::uint32_t line_count_ = 0;
};

}  // namespace enfilade::testing
