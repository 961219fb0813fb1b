#pragma once
// The heights of a beam: how high its rays are where they cross its last gate, and how steeply they rise. Bounds in
// double precision, each rounded outward: never too narrow.

#include <optional>

#include "accel/beam_plan.h"

namespace enfilade::accel {

/// At least and at most: ways in the plan, heights (grid units), or rises per unit of way.
struct Interval {
    double low = 0;
    double high = 0;
};

/// A stretch of a gate, in grid units.
struct RealSegment {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Where rays are in the height: `z` where they cross the reference (the last gate in a side, or the source), `slope`
/// from there on.
struct HeightBeam {
    Interval z;
    Interval slope;
};

/// How far the rays have come in the plan when they get to a face.
struct Ways {
    Interval from_source;
    Interval from_reference;
};

/// The stretch of the gate that the beam lights.
[[nodiscard]] RealSegment lit_part(const PlanBeam& beam, const Gate& gate, std::int64_t margin);

/// Distances between the points of the source and those of the segment, which may be moved by the margin.
[[nodiscard]] Interval distances(const BeamSource& source, const RealSegment& segment, std::int64_t margin);
[[nodiscard]] Interval distances(const RealSegment& a, const RealSegment& b, std::int64_t margin);
/// The greatest distance to one of these corners: how far a ray can go above their hull.
[[nodiscard]] double farthest(const BeamSource& source, const std::vector<PlanPoint>& corners);
[[nodiscard]] double farthest(const RealSegment& segment, const std::vector<PlanPoint>& corners);

/// The heights behind a gate in a side that opens from `opening.low` to `opening.high`; nothing where no ray gets
/// through. A ray exactly at a level counts as above it, as in the walk.
[[nodiscard]] std::optional<HeightBeam> through_side(const HeightBeam& beam, const Interval& source_z, const Ways& ways,
                                                     const Interval& opening);

enum class Level { Floor, Ceiling };
/// The heights behind a floor or ceiling at height `z`, still at the reference of before. `ways`: of what lies over the
/// floor.
[[nodiscard]] std::optional<HeightBeam> through_level(const HeightBeam& beam, const Interval& source_z,
                                                      const Ways& ways, Level level, const Interval& z);

}  // namespace enfilade::accel
