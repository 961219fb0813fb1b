#pragma once
// Walls from the lines that draw their faces: two parallel lines at a wall's distance hold a wall between them.

#include <cstdint>
#include <optional>
#include <vector>

#include "plans/dxf/sheet.h"

namespace enfilade::plans {

/// Lengths in metres.
struct PairLimits {
    double least = 0.03;  ///< thickness
    double most = 0.65;
    double same_line = 0.004;  ///< parallel lines this close are one line drawn twice
};

/// Faces of walls in one direction. A point of the group is `dir * u + turned_left(dir) * v`.
struct FaceLine {
    double v = 0;
    double u0 = 0;
    double u1 = 0;
    std::optional<double> height;  ///< of low walls
};
struct FaceGroup {
    Point dir;
    std::vector<FaceLine> lines;  ///< by v, then u0: collinear ones that overlap or touch are one
};

/// A straight stretch of wall in a group: between two faces.
struct WallBody {
    std::uint32_t group = 0;
    double v = 0;  ///< of its axis
    double u0 = 0;
    double u1 = 0;
    double thickness = 0;
    std::optional<double> height;
};

/// A curved one.
struct CurvedBody {
    Point centre;
    double radius = 0;  ///< of its axis
    double start = 0;
    double sweep = 0;
    double thickness = 0;
    std::optional<double> height;
};

struct WallBodies {
    std::vector<FaceGroup> groups;
    std::vector<WallBody> straight;
    std::vector<CurvedBody> curved;
    std::vector<WallBody> single;  ///< faces without a partner: thickness 0
    double paired_length = 0;      ///< of face lines
    double total_length = 0;
    double usual_thickness = 0;  ///< the most frequent one, by length
};

/// Of the wall whose face the stroke is: as its rule says; of low walls 1 m; else nothing.
[[nodiscard]] std::optional<double> wall_height(const SheetStroke& stroke);

/// Pairs each stretch of a face with the partner that makes the likeliest wall: the longest common stretch at the most
/// usual thickness first; a stretch belongs to one wall. `strokes`: those of walls. Cost: n log n, times the lines
/// within PairLimits::most of each other.
[[nodiscard]] WallBodies wall_bodies(const std::vector<SheetStroke>& strokes, const PairLimits& limits = {});

}  // namespace enfilade::plans
