#pragma once
// Internal to plans/: which of the plan's room polygons names which place between the walls.

#include <cstdint>
#include <vector>

#include "plans/arrange_owners.h"

namespace enfilade::plans {

/// A subdivision of the outlines of one storey's places and room polygons. Its regions: places, then polygons, then
/// the bands around polygons; the `line` of a polygon's segment counts the sides of all polygons.
struct RoomOverlay {
    Overlay overlay;
    std::vector<SegmentTag> tags;
    std::uint32_t place_count = 0;
    std::uint32_t polygon_count = 0;
    std::uint32_t side_count = 0;
};

struct RoomMatch {
    std::vector<std::int64_t> polygon_area2;                    ///< [polygon_count] twice the area, grid units
    std::vector<std::int64_t> exterior_area2;                   ///< [polygon_count] of its part in the exterior
    std::vector<std::uint32_t> place_of_polygon;                ///< [polygon_count] kNone: names no place
    std::vector<std::vector<std::uint32_t>> polygons_of_place;  ///< [place_count] the largest share first
    std::vector<std::vector<std::uint32_t>> also_covered;       ///< [polygon_count] other places that lie mostly in it
};

/// `polygons`: [polygon_count] rings on the grid, counter-clockwise, by ascending id. Polygons with `band` > 0 get a
/// band of that width along each side, which tells what lies between them and the walls that they were drawn beside.
[[nodiscard]] RoomOverlay overlay_rooms(const Overlay& storeys, const Places& places,
                                        const std::vector<std::vector<GridPoint>>& polygons, double band);

/// Each polygon names the place of which it shares most, if that is half of the polygon, or half of the place.
[[nodiscard]] RoomMatch match_rooms(const RoomOverlay& rooms, const Places& places);

/// A border between two rooms of one place, without a wall.
struct RoomBorder {
    Segment segment;
    std::uint32_t side = 0;  ///< the polygon side on which it lies
};

/// Divides each place that several polygons name: a face belongs to the smallest polygon over it, then to the
/// largest whose band covers it, then to the neighbour with the longest border. `rooms`: with bands.
/// `min_area2`: smaller leftovers go to a neighbour.
[[nodiscard]] std::vector<RoomBorder> room_borders(const RoomOverlay& rooms, const RoomMatch& match,
                                                   std::int64_t min_area2);

}  // namespace enfilade::plans
