#pragma once
// Walls as strips around their axes, joined where they meet, and openings as cross strips of them.

#include <cstdint>
#include <optional>
#include <vector>

#include "plans/plan.h"

namespace enfilade::plans {

struct OutlineOptions {
    Point origin;            ///< outlines are relative to it: 1e6 m away they are as exact as here
    double sagitta = 0.002;  ///< m, largest chord error of an arc's outer face
    double join = 0.0005;    ///< m, wall ends this close are one place
    double flat = 0.00003;   ///< m, arcs that bulge less are straight
};

/// The axis of a wall by its share `t` in [0, 1], from start to end.
class WallAxis {
public:
    WallAxis() = default;
    WallAxis(Point start, Point end, double extent, double flat);

    [[nodiscard]] Point at(double t) const;
    /// Unit vector to the left of the direction of travel.
    [[nodiscard]] Point normal(double t) const;
    /// The point at the signed distance `d` to the left; arcs end in their centre.
    [[nodiscard]] Point offset(double t, double d) const;
    /// The share of the point on the axis nearest to p.
    [[nodiscard]] double nearest(Point p) const;
    [[nodiscard]] double length() const { return length_; }
    [[nodiscard]] bool straight() const { return extent_ == 0; }
    [[nodiscard]] double extent() const { return extent_; }
    [[nodiscard]] double radius() const { return radius_; }  ///< 0 where straight

private:
    Point start_;
    Point end_;
    Point centre_;
    double extent_ = 0;
    double radius_ = 0;
    double length_ = 0;
};

/// Which part of an outline a segment belongs to. Its `facet` tells apart the segments of curved sides (by the
/// station where they begin) and of caps; straight sides have facet 0 alone.
enum class OutlinePart : std::uint8_t { Left, Right, Start, End, BeyondLeft, BeyondRight };

struct OutlinePoint {
    Point at;
    OutlinePart part = OutlinePart::Left;  ///< of the segment from here to the next point of the ring
    std::uint32_t facet = 0;
};

struct WallOutline {
    WallAxis axis;
    double half = 0;                 ///< half of the thickness
    std::vector<double> stations;    ///< shares at which both sides have a vertex, ascending from 0 to 1
    std::vector<OutlinePoint> ring;  ///< right side, end, left side, start; empty where the wall has no extent
};

/// Its sides lie on those of the host, with the same points: `part` Left and Right are lines of the host.
struct OpeningOutline {
    std::uint32_t wall = UINT32_MAX;  ///< index of the host; UINT32_MAX: none, and no ring
    std::vector<OutlinePoint> ring;
};

/// A wall end that meets nothing.
struct FreeEnd {
    std::uint32_t wall = 0;
    Point at;  ///< relative to the origin
};

/// Two sides of different walls that meet in a common end and look the same way: perhaps one line.
struct Continuation {
    std::uint32_t wall = 0;
    OutlinePart side = OutlinePart::Left;
    std::uint32_t next_wall = 0;
    OutlinePart next_side = OutlinePart::Left;
};

struct StoreyOutlines {
    std::vector<WallOutline> walls;        ///< [storey.walls.size()]
    std::vector<OpeningOutline> openings;  ///< [storey.openings.size()]
    std::vector<FreeEnd> free_ends;
    std::vector<Continuation> continuations;
};

/// Outlines of all walls and openings of one storey. At a place where wall ends meet, each wall ends in its left
/// corner, the place, its right corner; corners are where neighbouring faces intersect, cut off where that is far
/// away. An end inside another wall is cut along that wall's axis, a lone end square.
/// The same elements in another order give the same outlines.
[[nodiscard]] StoreyOutlines outlines(const Storey& storey, const OutlineOptions& options);

}  // namespace enfilade::plans
