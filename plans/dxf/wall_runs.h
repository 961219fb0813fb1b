#pragma once
// Walls as long as they go: stretches on one axis joined across their openings, and led up to the walls they meet.

#include <optional>
#include <vector>

#include "plans/dxf/wall_bodies.h"

namespace enfilade::plans {

struct RunOpening {
    OpeningKind kind = OpeningKind::Opening;
    std::optional<OpeningKind> inside;  ///< what it is instead where rooms lie on both sides of the wall
    double u0 = 0;                      ///< metres along the run, from WallRun::start
    double u1 = 0;
    std::optional<double> sill;
    std::optional<double> head;
    bool swings = false;  ///< a door's swing is drawn
};

/// A straight wall by its axis.
struct WallRun {
    Point start;
    Point end;
    double thickness = 0;
    std::optional<double> height;
    std::vector<RunOpening> openings;  ///< by u0, apart
    bool start_joined = false;         ///< leads into another wall there
    bool end_joined = false;
};

/// What is solid between wall lines but too thick for a wall: chimneys, piers, backs of niches.
struct WallMass {
    std::vector<Point> polygon;  ///< counter-clockwise, metres
    std::optional<double> height;
};

/// Openings wider than these are taken for places without a wall (metres).
struct GapLimits {
    double drawn = 6.5;  ///< where something is drawn in the gap
    double bare = 3.0;   ///< where only the wall's ends are closed by lines across
};

/// `strokes`: all strokes of the sheet; those of doors, windows and openings tell what a gap is. Bodies on one axis are
/// one run where a face goes on, another wall crosses, or an opening lies between them. Ends within half a thickness
/// of another wall's axis are led to it. Doors and windows drawn over a wall without a gap are put into it.
/// `masses`: filled with what walls may end at besides; null: none are looked for (walls drawn as single lines).
[[nodiscard]] std::vector<WallRun> wall_runs(const WallBodies& bodies, const std::vector<SheetStroke>& strokes,
                                             std::vector<WallMass>* masses = nullptr, const GapLimits& limits = {});

}  // namespace enfilade::plans
