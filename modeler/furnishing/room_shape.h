#pragma once
// A room as furniture meets it: its floor with holes, what its sides are, where people go in, where windows are.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "modeler/building.h"
#include "modeler/furnishing/floor_geometry.h"
#include "modeler/space_parts.h"

namespace enfilade::modeler {

/// What a side of the floor leads to, at the height of people.
enum class Beyond : std::uint8_t {
    Wall,
    Window,
    Door,
    Opening,  ///< a hole without leaf, or stairs
    Border,   ///< another room, without a wall between
    Edge      ///< no wall and no passage: the edge of a terrace, the side of stairs
};
[[nodiscard]] constexpr bool is_passage(Beyond beyond) {
    return beyond == Beyond::Door || beyond == Beyond::Opening || beyond == Beyond::Border;
}

struct RoomSide {
    plans::GridPoint a, b;  ///< the room on the left of a -> b
    Beyond beyond = Beyond::Wall;
    std::uint32_t space = UINT32_MAX;  ///< of the door, window, opening or room beyond
    std::int32_t z_low = 0;            ///< of that, grid levels
    std::int32_t z_high = 0;
    std::int32_t wall_top = 0;  ///< up to here the side is solid from the floor on, where it is a wall
};

/// A door, opening or border where people pass, or a window. The chord from a to b has the room on its left.
struct RoomOpening {
    Beyond beyond = Beyond::Door;
    std::uint32_t space = UINT32_MAX;
    plans::Point a, b;    ///< grid units
    plans::Point inward;  ///< unit vector into the room
    double width = 0;     ///< grid units, of the chord
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    Ring keep_free;  ///< the floor before it: convex, counter-clockwise
};

struct RoomShape {
    std::uint32_t space = UINT32_MAX;
    std::string id;
    std::string name;
    std::string kind;  ///< as the plan has it
    plans::GridFrame frame;
    std::vector<std::vector<RoomSide>> rings;  ///< the first is the outer one
    Floor floor;
    std::vector<RoomOpening> gates;    ///< where people pass
    std::vector<RoomOpening> windows;  ///< on the floor before them nothing stands higher than `z_low`
    std::int32_t z_floor = 0;
    std::int32_t z_ceiling = 0;
    bool open_to_sky = false;
    double area_m2 = 0;
    plans::Point middle;  ///< grid units: far from its sides
};

/// Groups the sides into gates and windows, lays the floor out. \pre rings, frame and z are set
void complete(RoomShape& room);

/// Rooms of a building, one by one.
class RoomShapes {
public:
    explicit RoomShapes(const Building& building);
    /// Those that can be furnished: rooms, and areas of the exterior that the plan names; by ascending space.
    [[nodiscard]] const std::vector<std::uint32_t>& spaces() const { return spaces_; }
    /// The largest part of the room; none where the space has none. Constant: many rooms at once may be asked for.
    [[nodiscard]] std::optional<RoomShape> shape(std::uint32_t space) const;

private:
    [[nodiscard]] RoomSide side_of(std::uint32_t half_edge, const SpacePart& part) const;
    void add_sweeps_next_door(RoomShape& room) const;

    const Building& building_;
    std::vector<SpacePart> parts_;
    std::vector<std::uint32_t> part_of_space_;  ///< the largest one
    std::vector<std::uint32_t> first_face_, faces_of_edge_;
    std::vector<std::uint32_t> spaces_;
};

}  // namespace enfilade::modeler
