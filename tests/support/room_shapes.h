#pragma once
// Contours of which random rooms are made.

#include <numbers>
#include <vector>

#include "plans/random.h"
#include "plans/vector2.h"
#include "tests/support/room_sketch.h"

namespace enfilade::testing {

using Ring = std::vector<plans::Point>;

inline constexpr double metre = 8192;
inline constexpr double whole_turn = 2 * std::numbers::pi;

/// What a family draws with.
struct Brush {
    RoomSketch& sketch;
    plans::Random& random;

    /// Mostly small, up to `most`.
    [[nodiscard]] std::uint32_t few(std::uint32_t least, std::uint32_t most) const {
        const double share = random.uniform();
        return least + std::uint32_t(share * share * share * double(most - least + 1));
    }
    /// Between low and high, spread evenly over the magnitudes.
    [[nodiscard]] double magnitude(double low, double high) const {
        return low * std::pow(high / low, random.uniform());
    }
    [[nodiscard]] double sign() const { return random.chance(0.5) ? 1 : -1; }
    void room(const Ring& ring) const { sketch.paint(Paint::Room, ring); }
    void solid(const Ring& ring) const { sketch.paint(Paint::Solid, ring); }
};

[[nodiscard]] Ring box(double x0, double y0, double x1, double y1);
/// Around the middle of a box.
[[nodiscard]] Ring box_at(plans::Point middle, double width, double depth);
[[nodiscard]] Ring circle(plans::Point middle, double radius, std::uint32_t chords, double phase = 0);
/// Appends an arc from the ring's last point to `to`, which turns by `angle` (left where positive), in chords.
void append_arc(Ring& ring, plans::Point to, double angle, std::uint32_t chords);
/// A contour whose sides turn into arcs: side k by angles[k], in chords[k].
[[nodiscard]] Ring with_arcs(const Ring& corners, const std::vector<double>& angles,
                             const std::vector<std::uint32_t>& chords);
/// What lies between two radii and two angles.
[[nodiscard]] Ring sector(plans::Point middle, double inner, double outer, double from, double to,
                          std::uint32_t inner_chords, std::uint32_t outer_chords);
/// A passage that winds inwards: round where `chords_per_turn` is not 4.
[[nodiscard]] Ring spiral(double radius, double width, double turns, std::uint32_t chords_per_turn);
[[nodiscard]] Ring turned(const Ring& ring, double angle);
[[nodiscard]] Ring moved(const Ring& ring, plans::Point by);

}  // namespace enfilade::testing
