#pragma once
// Internal to wall_runs: its steps.

#include <optional>
#include <vector>

#include "plans/dxf/gap.h"
#include "plans/dxf/wall_runs.h"

namespace enfilade::plans {

/// The axes as strokes, for an index of them.
[[nodiscard]] std::vector<SheetStroke> axes_of(const std::vector<WallRun>& runs);

/// Where the axis of `run`, gone on beyond one end, meets that of `other`: how far ahead of the end (negative: behind),
/// and how far beyond `other`'s nearer end (0 where it meets the run itself).
struct Meeting {
    double ahead = 0;
    double beyond = 0;
    double sine = 0;
};
[[nodiscard]] std::optional<Meeting> meeting(const WallRun& run, bool at_end, const WallRun& other);

/// Moves an end along the axis: ahead, or back where negative. Openings stay where they are.
void move_end(WallRun& run, bool at_end, double ahead);

/// Low walls close nothing off, and carry windows.
[[nodiscard]] inline bool is_low(const WallRun& run) { return run.height && *run.height < 1.8; }

/// Runs across other runs' ends: leads each end to the axis that it reaches within the walls' thickness. \post *_joined
void join_ends(std::vector<WallRun>& runs);

/// Ends that lead nowhere go on to the next wall ahead where a door or window is drawn in between.
void bridge_to_walls(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes, const StrokeIndex& index,
                     std::vector<bool>& used, const GapLimits& limits);

/// Doors and windows that are drawn over a run without a gap. `used`: [strokes], those that belong to a gap already.
void place_symbols(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes, std::vector<bool>& used);

}  // namespace enfilade::plans
