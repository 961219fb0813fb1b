#pragma once
// The steps of `clean`, in their order. Internal to it. Each leaves what it finds sound untouched.

#include <string>
#include <unordered_set>

#include "plans/clean_report.h"
#include "plans/outline.h"
#include "plans/read.h"

namespace enfilade::plans {

inline constexpr double shortest_wall = 0.01;      ///< m
inline constexpr double narrowest_opening = 0.01;  ///< m
inline constexpr double same_length = 1e-4;        ///< m, below the usual grid unit: smaller excesses are no faults
inline constexpr double level_tops = 0.01;         ///< m, wall tops that differ less are level
inline constexpr double end_margin = 0.05;         ///< m of wall kept beside openings that reached beyond it
inline constexpr double flat_arc = 0.00003;        ///< m, as in `OutlineOptions`

[[nodiscard]] inline WallAxis axis_of(const Wall& wall) { return {wall.start, wall.end, wall.arc_extent, flat_arc}; }

/// By ascending elevation; levels less than 1 m apart become one.
void clean_storeys(Plan& plan, CleanReport& report);
/// Drops storeys that hold nothing to build.
void drop_empty_storeys(Plan& plan, CleanReport& report);

/// Walls that cannot be built, or are too short. Returns whether anything changed.
bool clean_walls(Storey& storey, CleanReport& report);
/// Walls that lie on another wholly; their openings go over to it. Returns whether anything changed.
bool drop_duplicate_walls(Storey& storey, CleanReport& report);
/// Notes walls higher than their storey.
void note_high_walls(const Storey& storey, CleanReport& report);

/// Ends that nearly meet. Returns whether anything moved.
bool join_walls(Storey& storey, double join_gap, CleanReport& report);

/// Sloped tops into steps. `ids`: all in use, new ones are added. Returns whether anything changed.
bool cut_slopes(Storey& storey, double step, std::unordered_set<std::string>& ids, CleanReport& report);

/// Openings into their walls. \pre the walls are clean
void clean_openings(Storey& storey, CleanReport& report);

/// Polygons of rooms, columns, stairs and shafts; lights and furniture without a place.
void clean_rooms(Storey& storey, CleanReport& report);

}  // namespace enfilade::plans
