#pragma once
// What the families of random_rooms.h draw.

#include "tests/support/room_shapes.h"

namespace enfilade::testing::families {

// room_families_straight.cpp
void notched(const Brush& brush);
void letters(const Brush& brush);
void comb(const Brush& brush);
void star(const Brush& brush);
void zigzag(const Brush& brush);
void courtyards(const Brush& brush);
void pinched(const Brush& brush);
void needles(const Brush& brush);
void gaps(const Brush& brush);
void steps(const Brush& brush);
void bent(const Brush& brush);
void collage(const Brush& brush);
void pebbles(const Brush& brush);

// room_families_curved.cpp
void columns(const Brush& brush);
void spirals(const Brush& brush);
void arc_walls(const Brush& brush);
void circles(const Brush& brush);
void tangents(const Brush& brush);
void lenses(const Brush& brush);
void clovers(const Brush& brush);
void curved_corridors(const Brush& brush);
void shallow_arcs(const Brush& brush);
void tiny_arcs(const Brush& brush);

}  // namespace enfilade::testing::families
