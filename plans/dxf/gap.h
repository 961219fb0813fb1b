#pragma once
// What is drawn between two ends of a wall.

#include <optional>
#include <vector>

#include "plans/dxf/stroke_index.h"
#include "plans/dxf/wall_bodies.h"

namespace enfilade::plans {

/// A stretch of an axis: the place where a wall would go on.
struct GapPlace {
    Point dir;
    double v = 0;  ///< of the axis: points are dir * u + turned_left(dir) * v
    double u0 = 0;
    double u1 = 0;
    double thickness = 0;
};

struct GapEvidence {
    std::uint32_t door_arcs = 0;      ///< swings whose hinge or end lies at the gap
    std::uint32_t door_lines = 0;     ///< strokes of door layers
    std::uint32_t window_lines = 0;   ///< of window layers
    std::uint32_t opening_lines = 0;  ///< of layers for either
    double u0 = 0;                    ///< where along the axis something is drawn
    double u1 = 0;
    std::uint32_t other_lines = 0;  ///< along the wall within its width, of layers that say nothing
    double jamb0 = 0;               ///< where lines across close the wall's ends
    double jamb1 = 0;
    bool jambs = false;          ///< both ends are closed by a line across, one of them by the wall's own end
    std::optional<double> sill;  ///< as the mapping file has them
    std::optional<double> head;
    std::vector<std::uint32_t> strokes;  ///< those that were counted

    [[nodiscard]] bool drawn() const { return door_arcs + door_lines + window_lines + opening_lines > 0; }
    /// What is drawn fills the gap but for a stretch that may be wall, or is most of it.
    [[nodiscard]] bool fills(const GapPlace& gap) const {
        return drawn() && (u1 - u0 >= 0.5 * (gap.u1 - gap.u0) || u1 - u0 >= gap.u1 - gap.u0 - 1.0);
    }
};

/// A door's swing: hinge, and where its leaf stands open and shut.
struct DoorSwing {
    Point hinge;
    Point a;
    Point b;
};
/// Nothing for strokes that are no quarter circle of a door's size, nor of a layer that has doors.
[[nodiscard]] std::optional<DoorSwing> door_swing(const SheetStroke& stroke);

[[nodiscard]] GapEvidence gap_evidence(const GapPlace& gap, const std::vector<SheetStroke>& strokes,
                                       const StrokeIndex& index);

/// What an opening is by what is drawn in it. Where no layer tells, lines along the wall are a window to the open, and
/// between rooms a sliding or folding door (or nothing but a hole).
struct GapKind {
    OpeningKind kind = OpeningKind::Opening;
    std::optional<OpeningKind> inside;
};
[[nodiscard]] GapKind kind_of(const GapEvidence& evidence);

}  // namespace enfilade::plans
