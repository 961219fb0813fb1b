#pragma once
// The floor that the leaves of a door need, on either side of its wall.

#include <vector>

#include "modeler/constraints/piece_boxes.h"
#include "modeler/constraints/wall_bodies.h"
#include "plans/outline.h"

namespace enfilade::modeler {

/// One side of a door. A plan says neither on which jamb a leaf hangs nor to which side it turns. A single leaf sweeps
/// a quarter disc around one of its jambs: what both of them have in common has to be free whichever it is. From 1.3 m
/// on there are two leaves, and both their quarter discs; from 2.6 m on doors slide.
struct DoorSweep {
    UprightBody body;
    plans::Point mouth;  ///< middle of the doorway, on the face of the wall
};

/// Those on both sides of a door; none where it slides. Curved walls: as if straight at the door.
[[nodiscard]] std::vector<DoorSweep> door_sweeps(const plans::Wall& wall, const plans::Opening& door);

/// How far a body reaches into the floor that the leaf needs, in metres; 0 where a wall other than the door's own
/// (`host`, of the storey of `bodies`) stands between the two, or where they share less than 8 cm of height.
[[nodiscard]] double depth_in_sweep(const UprightBody& body, const DoorSweep& sweep, const WallBodies& bodies,
                                    std::uint32_t host);

}  // namespace enfilade::modeler
