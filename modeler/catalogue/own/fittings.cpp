#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

constexpr double board = 0.018;
constexpr double gap = 0.0015;

}  // namespace

void bar_handle(Shaper& s, Vec centre, double span, bool is_upright, const Paint& paint) {
    const Vec half = is_upright ? Vec{0, 0, span / 2} : Vec{span / 2, 0, 0};
    const Vec bar = centre - Vec{0, 0.028, 0};
    rod(s, bar - half, bar + half, 0.0055, 0.0055, paint, 8);
    for (const double side : both) {
        rod(s, centre + (0.78 * side) * half, bar + (0.78 * side) * half, 0.0045, 0.0045, paint, 6);
    }
}

void knob(Shaper& s, Vec centre, double radius, const Paint& paint) {
    const auto scope = s.inside(move(centre.x, centre.y, centre.z) * turn_x(90));
    const Vec profile[] = {{0.45 * radius, 0, -0.002},       {0.4 * radius, 0, 0.5 * radius},
                           {0.9 * radius, 0, 0.95 * radius}, {radius, 0, 1.3 * radius},
                           {0.8 * radius, 0, 1.6 * radius},  {0, 0, 1.7 * radius}};
    lathe(s, profile, paint, 12);
}

void shell_handle(Shaper& s, Vec centre, const Paint& paint) {
    const int steps = s.fine(8);
    std::vector<Ring> rings;
    for (int k = 0; k <= steps; ++k) {
        const double angle = pi * k / steps, c = std::cos(angle), depth = 0.022 * std::sin(angle) + 0.002;
        rings.push_back({centre + Vec{-0.045 * c, 0, -0.012}, centre + Vec{-0.045 * c, -depth, -0.012},
                         centre + Vec{-0.045 * c, -0.85 * depth, 0.003}, centre + Vec{-0.045 * c, -0.4 * depth, 0.014},
                         centre + Vec{-0.045 * c, 0, 0.016}});
    }
    s.skin(rings, paint);
}

void front(Shaper& s, Vec low, Vec high, const Paint& paint) {
    block(s, {low.x + gap, low.y - board, low.z + gap}, {high.x - gap, low.y - 0.0005, high.z - gap}, paint, 0.002);
}

void framed_front(Shaper& s, Vec low, Vec high, const Paint& paint) {
    const double rail = std::min(0.06, 0.2 * std::min(high.x - low.x, high.z - low.z));
    const Vec a{low.x + gap, low.y - board, low.z + gap}, b{high.x - gap, low.y - 0.0005, high.z - gap};
    block(s, a, {a.x + rail, b.y, b.z}, paint, 0.002), block(s, {b.x - rail, a.y, a.z}, b, paint, 0.002);
    block(s, {a.x + rail, a.y, a.z}, {b.x - rail, b.y, a.z + rail}, paint, 0.002);
    block(s, {a.x + rail, a.y, b.z - rail}, {b.x - rail, b.y, b.z}, paint, 0.002);
    block(s, {a.x + rail, a.y + 0.009, a.z + rail}, {b.x - rail, b.y, b.z - rail}, paint, 0);
}

void tap(Shaper& s, Vec foot, double height, double reach, const Paint& paint) {
    {
        const auto scope = s.inside(move(foot.x, foot.y, foot.z));
        drum(s, {}, 0.026, 0.012, paint, 0.004, 16);
        rod(s, {0, 0, 0.01}, {0, 0, 0.4 * height}, 0.019, 0.017, paint, 14);
        const Vec way[] = {{0, 0, 0.3 * height},
                           {0, 0, 0.75 * height},
                           {0, -0.25 * reach, 0.97 * height},
                           {0, -0.7 * reach, 0.95 * height},
                           {0, -reach, 0.72 * height}};
        tube(s, curve(way, s.fine(4)), 0.011, paint, 10);
        rod(s, {0.015, 0, 0.32 * height}, {0.06, -0.01, 0.4 * height}, 0.006, 0.005, paint, 8);
    }
}

void screw(Shaper& s, Vec centre, const Paint& paint) {
    if (s.detail() < 3) return;
    const auto scope = s.inside(move(centre.x, centre.y, centre.z) * turn_x(90));
    drum(s, {}, 0.004, 0.0015, paint, 0.0005, 8);
}

}  // namespace enfilade::modeler::own
