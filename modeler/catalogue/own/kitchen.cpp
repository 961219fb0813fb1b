// Kitchens: fronts towards -y; worktops at 0.9 m.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

constexpr double top = 0.9;
constexpr double slab = 0.038;
constexpr const Paint& cupboard = sage_lacquer;

/// Carcass and plinth under a worktop; the face is at the y that is returned.
double carcass(Shaper& s, double x, double y, const Paint& paint) {
    const double face = -y + 0.05;
    block(s, {-x, face, 0.1}, {x, y, top - slab}, paint, 0.001);
    block(s, {-x + 0.002, face + 0.04, 0}, {x - 0.002, y - 0.05, 0.101}, charcoal, 0);
    return face;
}

void kitchen_unit(Shaper& s, const Size& size, int columns, bool has_drawers) {
    const double x = size.width / 2, y = size.depth / 2, face = carcass(s, x, y, off_white);
    block(s, {-x, -y + 0.012, top - slab}, {x, y, top}, oak, 0.004);
    for (int k = 0; k < columns; ++k) {
        const double x0 = -x + 2 * x * k / columns, x1 = -x + 2 * x * (k + 1) / columns, middle = (x0 + x1) / 2;
        const double levels[] = {0.105, has_drawers ? 0.38 : 0.70, has_drawers ? 0.68 : 0.70, top - slab - 0.002};
        for (int level = 0; level < 3; ++level) {
            if (levels[level + 1] - levels[level] < 0.01) continue;
            framed_front(s, {x0 + 0.001, face, levels[level]}, {x1 - 0.001, face, levels[level + 1]}, cupboard);
            const bool is_door = !has_drawers && level == 0;
            const double z = levels[level + 1] - (is_door ? 0.13 : 0.04);
            bar_handle(s, {is_door ? x1 - 0.045 : middle, face - 0.018, z}, 0.15, is_door, brass);
        }
    }
}

/// A worktop around a hollow of 2 hx by 2 hy about (cx, cy).
void worktop_with_hole(Shaper& s, double x, double front_y, double back_y, double cx, double cy, double hx, double hy) {
    block(s, {-x, front_y, top - slab}, {x, cy - hy, top}, oak, 0.003);
    block(s, {-x, cy + hy, top - slab}, {x, back_y, top}, oak, 0.003);
    block(s, {-x, cy - hy, top - slab}, {cx - hx, cy + hy, top}, oak, 0.0005);
    block(s, {cx + hx, cy - hy, top - slab}, {x, cy + hy, top}, oak, 0.0005);
}

void kitchen_sink(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.05;
    // Carcass in boards: the bowl hangs in it.
    for (const double side : both)
        block(s, {side > 0 ? x - 0.018 : -x, face, 0.1}, {side > 0 ? x : -x + 0.018, y, top - slab}, off_white, 0);
    block(s, {-x + 0.018, face, 0.1}, {x - 0.018, y, 0.118}, off_white, 0);
    block(s, {-x + 0.018, y - 0.018, 0.118}, {x - 0.018, y, top - slab}, off_white, 0);
    block(s, {-x + 0.018, face, 0.118}, {x - 0.018, face + 0.018, top - slab}, off_white, 0);
    block(s, {-x + 0.002, face + 0.04, 0}, {x - 0.002, y - 0.05, 0.101}, charcoal, 0);
    const double cy = -0.03, hx = 0.27, hy = 0.2;
    worktop_with_hole(s, x, -y + 0.012, y, 0, cy, hx, hy);
    {
        const auto scope = s.inside(move(0, cy, 0));
        vessel(s,
               {.half_bottom = {hx - 0.03, hy - 0.03, 0},
                .half_rim = {hx + 0.012, hy + 0.012, 0},
                .bottom = top - 0.2,
                .rim = top + 0.006,
                .floor = 0.008,
                .wall = 0.022,
                .slope = 1.6,
                .corner = 0.22,
                .plain = 24},
               steel);
        const auto drain = s.inside(move(0, 0, top - 0.193));
        drum(s, {}, 0.035, 0.004, chrome, 0.002, 18);
        drum(s, {0, 0, 0.003}, 0.02, 0.003, charcoal, 0.001, 14);
    }
    tap(s, {0.0, y - 0.075, top}, 0.3, 0.19, chrome);
    for (const double side : both) {
        framed_front(s, {side > 0 ? 0.001 : -x + 0.001, face, 0.105},
                     {side > 0 ? x - 0.001 : -0.001, face, top - slab - 0.002}, cupboard);
        bar_handle(s, {side * 0.045, face - 0.018, 0.72}, 0.15, true, brass);
    }
}

void stove(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.05;
    block(s, {-x, face, 0.06}, {x, y, top - 0.012}, steel, 0.003);
    block(s, {-x + 0.02, face + 0.04, 0}, {x - 0.02, y - 0.05, 0.061}, charcoal, 0);
    block(s, {-x, -y + 0.02, top - 0.012}, {x, y, top - 0.002}, black, 0.003);
    const double rings[][3] = {{-0.14, -0.12, 0.085}, {0.14, -0.12, 0.07}, {-0.14, 0.13, 0.07}, {0.14, 0.13, 0.095}};
    for (const auto& [rx, ry, r] : rings) {
        const auto scope = s.inside(move(rx, ry, top - 0.003));
        drum(s, {}, r, 0.002, charcoal, 0.0008, 28);
        tube(s, ellipse({0, 0, 0.002}, r, r, s.fine(28)), 0.0016, light_grey, 3, Ends::Looped);
        tube(s, ellipse({0, 0, 0.002}, 0.6 * r, 0.6 * r, s.fine(22)), 0.0012, light_grey, 4, Ends::Looped);
    }
    // Oven door: a frame, a dark window, a bar.
    block(s, {-x + 0.005, face - 0.025, 0.22}, {x - 0.005, face, 0.74}, charcoal, 0.006);
    block(s, {-x + 0.07, face - 0.027, 0.29}, {x - 0.07, face - 0.02, 0.62}, black, 0.004);
    bar_handle(s, {0, face - 0.024, 0.69}, 0.46, false, chrome);
    block(s, {-x + 0.005, face - 0.02, 0.07}, {x - 0.005, face, 0.212}, steel, 0.003);
    block(s, {-x + 0.005, face - 0.02, 0.748}, {x - 0.005, face, top - 0.016}, steel, 0.003);
    for (int k = 0; k < 5; ++k) {
        const double at = (k - 2) * 0.11;
        if (k == 2) {
            block(s, {-0.045, face - 0.022, 0.79}, {0.045, face - 0.019, 0.845}, screen, 0.001);
            continue;
        }
        knob(s, {at, face - 0.019, 0.815}, 0.019, black);
        block(s, {at - 0.0015, face - 0.054, 0.818}, {at + 0.0015, face - 0.051, 0.833}, white, 0);
    }
}

void fridge(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.09, h = size.height, split = 0.68;
    block(s, {-x, face, 0.03}, {x, y, h}, light_grey, 0.006);
    block(s, {-x + 0.02, face + 0.03, 0}, {x - 0.02, y - 0.03, 0.031}, black, 0);
    for (const bool is_low : {true, false}) {
        const double z0 = is_low ? 0.05 : split + 0.004, z1 = is_low ? split - 0.004 : h;
        block(s, {-x, face - 0.055, z0}, {x, face - 0.006, z1}, light_grey, 0.012);
        block(s, {-x + 0.012, face - 0.0065, z0 + 0.01}, {x - 0.012, face + 0.001, z1 - 0.01}, charcoal, 0);
        bar_handle(s, {-x + 0.06, face - 0.054, is_low ? z1 - 0.24 : z0 + 0.28}, 0.36, true, steel);
    }
    block(s, {0.08, face - 0.0565, 1.52}, {0.2, face - 0.054, 1.58}, screen, 0.001);
    const Paint* magnets[] = {&mustard, &terracotta, &paper};
    for (int k = 0; k < 3; ++k) {
        block(s, {-0.02 + 0.06 * k, face - 0.058, 1.25 - 0.05 * (k % 2)},
              {0.025 + 0.06 * k + (k == 2 ? 0.04 : 0), face - 0.054, 1.29 + 0.02 * k}, *magnets[k], 0.001);
    }
}

void dishwasher(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = carcass(s, x, y, light_grey);
    block(s, {-x, -y + 0.012, top - slab}, {x, y, top}, oak, 0.004);
    block(s, {-x + 0.003, face - 0.022, 0.12}, {x - 0.003, face, 0.73}, steel, 0.005);
    block(s, {-x + 0.003, face - 0.022, 0.734}, {x - 0.003, face, top - slab - 0.003}, steel, 0.004);
    bar_handle(s, {0, face - 0.021, 0.68}, 0.44, false, chrome);
    block(s, {-0.07, face - 0.0235, 0.78}, {0.05, face - 0.021, 0.82}, screen, 0.001);
    for (int k = 0; k < 4; ++k) {
        const auto scope = s.inside(move(0.1 + 0.035 * k, face - 0.021, 0.8) * turn_x(90));
        drum(s, {}, 0.009, 0.004, charcoal, 0.001, 12);
    }
}

void wall_cabinet(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.05, h = size.height;
    block(s, {-x, face, 0}, {x, y, h}, off_white, 0.001);
    for (const double side : both) {
        framed_front(s, {side > 0 ? 0.001 : -x, face, 0}, {side > 0 ? x : -0.001, face, h}, cupboard);
        bar_handle(s, {side * 0.045, face - 0.018, 0.12}, 0.13, true, brass);
    }
}

}  // namespace

void add_kitchen(Pieces& pieces) {
    pieces.push_back(piece<"own/kitchen-unit", Size{0.6, 0.62, 0.9}>(
        "Kitchen unit", "kitchen_unit", "Kitchen", [](Shaper& s, const Size& size) { kitchen_unit(s, size, 1, false); },
        {.top = 0.9}));
    pieces.push_back(piece<"own/kitchen-unit-drawers", Size{0.8, 0.62, 0.9}>(
        "Kitchen unit with drawers", "kitchen_unit", "Kitchen",
        [](Shaper& s, const Size& size) { kitchen_unit(s, size, 1, true); }, {.top = 0.9}));
    pieces.push_back(piece<"own/kitchen-sink", Size{0.8, 0.62, 1.2}>(
        "Kitchen sink", "kitchen_sink", "Kitchen", [](Shaper& s, const Size& size) { kitchen_sink(s, size); }));
    pieces.push_back(piece<"own/stove", Size{0.6, 0.628, 0.9}>("Stove", "stove", "Kitchen",
                                                               [](Shaper& s, const Size& size) { stove(s, size); }));
    pieces.push_back(piece<"own/fridge", Size{0.6, 0.68, 1.86}>("Fridge", "fridge", "Kitchen",
                                                                [](Shaper& s, const Size& size) { fridge(s, size); }));
    pieces.push_back(piece<"own/dishwasher", Size{0.6, 0.62, 0.9}>(
        "Dishwasher", "dishwasher", "Kitchen", [](Shaper& s, const Size& size) { dishwasher(s, size); }, {.top = 0.9}));
    pieces.push_back(piece<"own/wall-cabinet", Size{0.8, 0.37, 0.7}>(
        "Wall cabinet", "wall_cabinet", "Kitchen", [](Shaper& s, const Size& size) { wall_cabinet(s, size); },
        {.elevation = 1.45}));
}

}  // namespace enfilade::modeler::own
