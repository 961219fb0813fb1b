#pragma once
// What stands in a room, and what has to stay free.

#include <cstdint>
#include <string_view>
#include <vector>

#include "modeler/catalogue/catalogue.h"
#include "modeler/furnishing/room_shape.h"
#include "modeler/furnishing/rules.h"

namespace enfilade::modeler {

/// A place for the box of a piece: grid units, radians.
struct Pose {
    plans::Point at;  ///< middle of its box
    double angle = 0;
    [[nodiscard]] plans::Point along() const;  ///< the way of its width
    [[nodiscard]] plans::Point front() const;  ///< where it looks
};

/// A piece at its place. Lengths in grid units.
struct Body {
    Pose pose;
    double width = 0, depth = 0, height = 0;
    std::int32_t z_low = 0, z_high = 0;
    Ring ring;  ///< its footprint, rounded outward
    GridBox box;
    std::string_view kind;
    const CatalogueEntry* entry = nullptr;
    std::uint32_t group = 0;             ///< pieces that were placed together; 0: what was there before
    std::uint32_t carrier = UINT32_MAX;  ///< the body on which it stands
    bool hangs = false;                  ///< on a wall or from the ceiling
    double metres_wide = 0, metres_deep = 0, metres_high = 0;  ///< its size as the object has it
};

/// A floor that stays free before a piece.
struct FreeFloor {
    Ring ring;
    GridBox box;
    std::uint32_t group = 0;
};

class Occupancy {
public:
    explicit Occupancy(const RoomShape& room) : room_(room) {}

    [[nodiscard]] const RoomShape& room() const { return room_; }
    [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
    [[nodiscard]] std::vector<Body>& bodies() { return bodies_; }

    /// Fills ring, box and levels. elevation: of its bottom above the floor, grid units
    [[nodiscard]] Body body(const CatalogueEntry& entry, const Pose& pose, double elevation) const;
    [[nodiscard]] Body body(const CatalogueEntry& entry, const Pose& pose, double elevation, double width,
                            double depth) const;
    /// The rectangle around a pose, beyond the box of width x depth by these lengths: front, behind, left, right.
    [[nodiscard]] Ring around(const Body& body, double front, double behind, double left, double right) const;

    /// Whether it may stand there: in the room, below the ceiling, sharing no place with another (but its carrier),
    /// outside what gates, windows and other groups' pieces need.
    [[nodiscard]] bool is_possible(const Body& body) const;
    /// Whether the floor is inside the room and nothing of another group stands on it.
    [[nodiscard]] bool is_free(const Ring& ring, std::uint32_t group) const;

    std::uint32_t add(Body body);
    void add_free(Ring ring, std::uint32_t group);

    struct Mark {
        std::size_t bodies, free;
    };
    [[nodiscard]] Mark mark() const { return {bodies_.size(), free_.size()}; }
    void undo(Mark mark);

private:
    [[nodiscard]] bool blocks_opening(const Body& body) const;

    const RoomShape& room_;
    std::vector<Body> bodies_;
    std::vector<FreeFloor> free_;
};

/// Whether it stands in the way of people: not what lies flat, hangs high or stands on another piece.
[[nodiscard]] bool is_obstacle(const RoomShape& room, std::int32_t z_low, std::int32_t z_high);

}  // namespace enfilade::modeler
