#pragma once
// What doors, drawers and worktops have: handles, knobs, fronts, taps. All of them on faces that look towards -y.

#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {

inline constexpr std::array<double, 2> both = {-1, 1};

/// A bar on two feet in front of the face y = centre.y.
void bar_handle(Shaper& shaper, Vec centre, double span, bool is_upright, const Paint& paint);
void knob(Shaper& shaper, Vec centre, double radius, const Paint& paint);
/// A cup to pull at from below.
void shell_handle(Shaper& shaper, Vec centre, const Paint& paint);

/// A flat front of a door or a drawer over [low.x, high.x] x [low.z, high.z], before the face y = low.y, with a gap
/// around it; 18 mm thick.
void front(Shaper& shaper, Vec low, Vec high, const Paint& paint);
/// The same with a frame around a sunk panel.
void framed_front(Shaper& shaper, Vec low, Vec high, const Paint& paint);

/// A mixer tap that stands at `foot` and reaches forward, towards -y.
void tap(Shaper& shaper, Vec foot, double height, double reach, const Paint& paint);

/// A screw on a face towards -y, at detail 3 and more.
void screw(Shaper& shaper, Vec centre, const Paint& paint);

}  // namespace enfilade::modeler::own
