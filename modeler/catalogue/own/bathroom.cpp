// Bathrooms: whoever uses a piece stands at -y, its pipes leave at +y; a bathtub's long back side is at +y.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

/// A flat ring: the seat of a toilet.
void oval_seat(Shaper& s, double hx, double hy, double width, double z0, double z1, const Paint& paint) {
    const int sides = s.fine(28), steps = s.fine(2);
    std::vector<Ring> rings;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * pi * k / sides, c = std::cos(angle), sn = std::sin(angle);
        Ring& ring = rings.emplace_back();
        for (int i = 0; i < 2 * steps + 2; ++i) {  // a rounded section
            const double turn = 2 * pi * i / (2 * steps + 2);
            const double inset =
                width / 2 - width / 2 * std::copysign(std::pow(std::abs(std::cos(turn)), 0.6), std::cos(turn));
            const double z =
                mix(z0, z1, 0.5 + 0.5 * std::copysign(std::pow(std::abs(std::sin(turn)), 0.6), std::sin(turn)));
            ring.push_back({(hx - inset) * c, (hy - inset) * sn, z});
        }
    }
    s.skin(rings, paint, Ends::Looped);
}

void toilet(Shaper& s, const Size& size) {
    const double y = size.depth / 2, bowl_y = -y + 0.245;
    {  // foot
        std::vector<Ring> rings;
        const double foot[][4] = {{0, 0.115, 0.2, 0.06},
                                  {0.03, 0.11, 0.195, 0.06},
                                  {0.12, 0.095, 0.17, 0.06},
                                  {0.24, 0.11, 0.17, 0.05},
                                  {0.31, 0.13, 0.18, 0.03}};
        for (const auto& [z, hx, hy, shift] : foot)
            rings.push_back(ellipse({0, bowl_y + shift, z}, hx, hy, s.fine(28)));
        s.skin(rings, porcelain);
    }
    {
        const auto scope = s.inside(move(0, bowl_y, 0));
        vessel(s,
               {.half_bottom = {0.09, 0.14, 0},
                .half_rim = {0.178, 0.235, 0},
                .bottom = 0.2,
                .rim = 0.4,
                .floor = 0.03,
                .wall = 0.045,
                .slope = 0.5,
                .corner = 1,
                .plain = 32},
               porcelain);
        oval_seat(s, 0.184, 0.242, 0.062, 0.402, 0.42, white);
        const Ring water = ellipse({}, 0.075, 0.1, s.fine(20));
        plate(s, water, 0.272, 0.278, glass);
    }
    // The tank's foot, the tank, its lid and buttons; the seat's lid leans on it.
    block(s, {-0.13, bowl_y + 0.1, 0.12}, {0.13, y - 0.005, 0.398}, porcelain, 0.035);
    block(s, {-0.185, y - 0.17, 0.398}, {0.185, y, 0.77}, porcelain, 0.022);
    block(s, {-0.19, y - 0.178, 0.765}, {0.19, y, 0.795}, porcelain, 0.01);
    for (const double side : both) {
        const auto scope = s.inside(move(side * 0.022, y - 0.09, 0.793));
        drum(s, {}, 0.019, 0.007, chrome, 0.002, 16);
    }
    const auto lid = s.inside(move(0, y - 0.192, 0.412) * turn_x(97));
    Ring outline;
    const int steps = s.fine(24);
    for (int k = 0; k < steps; ++k) {
        const double angle = 2 * pi * k / steps;
        outline.push_back({0.18 * std::cos(angle),
                           0.2 + 0.2 * std::copysign(std::pow(std::abs(std::sin(angle)), 0.8), std::sin(angle)), 0});
    }
    plate(s, outline, -0.008, 0.01, white, 0.005);
}

void wash_bowl(Shaper& s, double hx, double hy, double bottom, double rim, double corner) {
    vessel(s,
           {.half_bottom = {0.6 * hx, 0.6 * hy, 0},
            .half_rim = {hx, hy, 0},
            .bottom = bottom,
            .rim = rim,
            .floor = 0.03,
            .wall = 0.035,
            .slope = 0.6,
            .corner = corner,
            .plain = 36},
           porcelain);
}

void pedestal_basin(Shaper& s, const Size& size) {
    const double y = size.depth / 2;
    {
        const auto scope = s.inside(move(0, 0.06, 0) * stretch(1, 0.85, 1));
        const Vec profile[] = {{0, 0, 0},      {0.12, 0, 0},    {0.118, 0, 0.03}, {0.085, 0, 0.15},
                               {0.08, 0, 0.5}, {0.11, 0, 0.68}, {0.12, 0, 0.72},  {0, 0, 0.72}};
        lathe(s, profile, porcelain, 28);
    }
    {
        const auto scope = s.inside(move(0, -0.035, 0));
        wash_bowl(s, size.width / 2, y - 0.035, 0.68, 0.85, 0.75);
        const auto drain = s.inside(move(0, 0, 0.711));
        drum(s, {}, 0.025, 0.004, chrome, 0.001, 16);
    }
    block(s, {-0.2, y - 0.13, 0.76}, {0.2, y, 0.85}, porcelain, 0.02);
    tap(s, {0, y - 0.06, 0.85}, 0.16, 0.13, chrome);
}

void vanity(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.045;
    block(s, {-x + 0.005, face, 0.3}, {x - 0.005, y, 0.755}, oak, 0.002);
    for (const double side : both) {
        for (const double f : both)
            rod(s, {side * (x - 0.05), f * (y - 0.09) + 0.02, 0}, {side * (x - 0.06), f * (y - 0.1) + 0.02, 0.301},
                0.01, 0.014, iron, 12);
    }
    block(s, {-x, -y + 0.02, 0.755}, {x, y, 0.78}, marble, 0.004);
    for (int k = 0; k < 2; ++k) {
        front(s, {-x + 0.007, face, 0.303 + 0.226 * k}, {x - 0.007, face, 0.526 + 0.226 * k}, oak);
        bar_handle(s, {0, face - 0.018, 0.47 + 0.226 * k}, 0.3, false, iron);
    }
    {
        const auto scope = s.inside(move(0, -0.035, 0));
        wash_bowl(s, 0.23, 0.17, 0.779, 0.9, 1);
        const auto drain = s.inside(move(0, 0, 0.81));
        drum(s, {}, 0.022, 0.004, chrome, 0.001, 16);
    }
    tap(s, {0, y - 0.05, 0.78}, 0.27, 0.14, iron);
    const auto scope = s.inside(move(x - 0.11, 0.1, 0.78));  // soap in a bottle
    const Vec profile[] = {{0, 0, 0},         {0.03, 0, 0},      {0.032, 0, 0.004}, {0.032, 0, 0.1},
                           {0.012, 0, 0.118}, {0.012, 0, 0.135}, {0, 0, 0.135}};
    lathe(s, profile, terracotta, 18);
    rod(s, {0, 0, 0.13}, {0, 0, 0.155}, 0.004, 0.004, black, 8);
    rod(s, {0, 0.005, 0.155}, {0, -0.035, 0.152}, 0.005, 0.004, black, 8);
}

void bathtub(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2;
    vessel(s,
           {.half_bottom = {x - 0.16, y - 0.1, 0},
            .half_rim = {x, y, 0},
            .bottom = 0.0,
            .rim = 0.58,
            .floor = 0.12,
            .wall = 0.055,
            .slope = 0.75,
            .corner = 0.85,
            .plain = 44},
           porcelain);
    {
        const auto scope = s.inside(move(x - 0.42, 0, 0.121));
        drum(s, {}, 0.03, 0.004, chrome, 0.001, 16);
    }
    // Taps in the middle of the back side, a duck on the rim.
    const auto mixer = s.inside(move(0, y - 0.045, 0.57));
    for (const double side : both) {
        rod(s, {side * 0.09, 0, 0}, {side * 0.09, 0, 0.075}, 0.013, 0.011, chrome, 12);
        ball(s, {side * 0.09, 0, 0.085}, {0.022, 0.022, 0.014}, chrome, 12);
    }
    rod(s, {-0.1, 0, 0.05}, {0.1, 0, 0.05}, 0.012, 0.012, chrome, 12);
    const Vec spout[] = {{0, 0, 0.05}, {0, -0.02, 0.11}, {0, -0.1, 0.13}, {0, -0.135, 0.095}};
    tube(s, curve(spout, s.fine(4)), 0.012, chrome, 10);
}

void shower(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x, -y, 0}, {x, y, 0.03}, porcelain, 0.006);
    vessel(s,
           {.half_bottom = {x - 0.01, y - 0.01, 0},
            .half_rim = {x, y, 0},
            .bottom = 0.029,
            .rim = 0.075,
            .floor = 0.006,
            .wall = 0.045,
            .slope = 3,
            .corner = 0.08,
            .plain = 16},
           porcelain);
    {
        const auto scope = s.inside(move(0, 0, 0.036));
        drum(s, {}, 0.045, 0.004, chrome, 0.001, 20);
    }
    // One fixed pane on the right; the way in is in front.
    block(s, {x - 0.018, -y + 0.02, 0.076}, {x - 0.008, y - 0.02, h - 0.08}, glass, 0.001);
    for (const double at : {-y + 0.01, y - 0.015})
        block(s, {x - 0.025, at - 0.01, 0.072}, {x - 0.001, at + 0.015, h - 0.062}, chrome, 0.003);
    block(s, {x - 0.025, -y, h - 0.08}, {x - 0.001, y, h - 0.06}, chrome, 0.003);
    // Riser, rain head, hand shower, mixer on the back.
    rod(s, {0, y - 0.05, 1.0}, {0, y - 0.05, h - 0.12}, 0.011, 0.011, chrome, 12);
    const Vec arm[] = {
        {0, y - 0.05, h - 0.14}, {0, y - 0.07, h - 0.04}, {0, y - 0.2, h - 0.012}, {0, y - 0.38, h - 0.02}};
    tube(s, curve(arm, s.fine(4)), 0.011, chrome, 10);
    {
        const auto scope = s.inside(move(0, y - 0.38, h - 0.05));
        drum(s, {}, 0.11, 0.012, chrome, 0.004, 28);
        rod(s, {0, 0, 0.01}, {0, 0, 0.035}, 0.015, 0.012, chrome, 12);
        if (s.detail() > 1) {
            for (int k = 0; k < 24; ++k) {
                const double r = k < 8 ? 0.045 : 0.085, angle = k < 8 ? 45.0 * k : 22.5 * k;
                drum(s, {r * std::cos(degrees(angle)), r * std::sin(degrees(angle)), -0.003}, 0.004, 0.004, rubber,
                     0.001, 6);
            }
        }
    }
    rod(s, {-0.13, y - 0.05, 1.05}, {0.13, y - 0.05, 1.05}, 0.02, 0.02, chrome, 14);
    for (const double side : both) {
        rod(s, {side * 0.08, y - 0.001, 1.05}, {side * 0.08, y - 0.05, 1.05}, 0.018, 0.016, chrome, 12);
        rod(s, {side * 0.13, y - 0.05, 1.05}, {side * 0.165, y - 0.05, 1.05}, 0.026, 0.024, chrome, 14);
    }
    for (const double z : {1.3, h - 0.2}) rod(s, {0, y - 0.001, z}, {0, y - 0.055, z}, 0.012, 0.01, chrome, 10);
    const Vec hose[] = {{0.02, y - 0.06, 1.04},
                        {0.05, y - 0.07, 0.75},
                        {0.11, y - 0.08, 0.72},
                        {0.1, y - 0.09, 1.2},
                        {0.03, y - 0.085, 1.52}};
    tube(s, curve(hose, s.fine(6)), 0.006, steel, 8);
    rod(s, {0.03, y - 0.08, 1.48}, {0.0, y - 0.14, 1.66}, 0.01, 0.013, chrome, 10);
    const auto scope = s.inside(move(-0.005, y - 0.155, 1.675) * turn_x(60));
    drum(s, {}, 0.04, 0.018, chrome, 0.006, 20);
}

void washing_machine(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.035, h = size.height;
    block(s, {-x, face, 0.01}, {x, y, h - 0.025}, white, 0.01);
    block(s, {-x, face - 0.012, h - 0.03}, {x, y, h}, white, 0.006);
    block(s, {-x + 0.03, face + 0.03, 0}, {x - 0.03, y - 0.03, 0.011}, black, 0);
    block(s, {-x + 0.003, face - 0.008, h - 0.135}, {x - 0.003, face + 0.001, h - 0.032}, light_grey, 0.003);
    block(s, {-x + 0.015, face - 0.014, h - 0.125}, {-x + 0.19, face - 0.002, h - 0.042}, white, 0.005);
    block(s, {0.1, face - 0.0105, h - 0.11}, {0.24, face - 0.007, h - 0.06}, screen, 0.001);
    knob(s, {0.02, face - 0.008, h - 0.085}, 0.026, chrome);
    {
        const auto scope = s.inside(move(0, face, 0.42) * turn_x(90));
        const Vec frame[] = {{0.13, 0, -0.002}, {0.205, 0, -0.002}, {0.205, 0, 0.014}, {0.19, 0, 0.028},
                             {0.16, 0, 0.03},   {0.145, 0, 0.02},   {0.13, 0, 0.012}};
        std::vector<Ring> rings;
        for (const Vec& p : frame) rings.push_back(ellipse({0, 0, p.z}, p.x, p.x, s.fine(36)));
        s.skin(rings, chrome, Ends::Looped);
        const Vec window[] = {{0, 0, -0.001},   {0.135, 0, -0.001}, {0.14, 0, 0.014},
                              {0.12, 0, 0.012}, {0.07, 0, -0.0005}, {0, 0, 0.0}};
        lathe(s, std::span(window, 4), screen, 36);
        ball(s, {0, 0, 0.004}, {0.12, 0.12, 0.022}, screen, 28);
    }
    block(s, {-0.205, face - 0.036, 0.38}, {-0.172, face - 0.016, 0.46}, chrome, 0.006);
    block(s, {x - 0.14, face - 0.004, 0.045}, {x - 0.03, face + 0.001, 0.12}, light_grey, 0.003);
}

void mirror(Shaper& s, const Size& size, const Paint& wood) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height, rail = 0.035;
    block(s, {-x + 0.01, -0.002, 0.01}, {x - 0.01, y, h - 0.01}, mirror_glass, 0);
    for (const double side : both) {
        block(s, {side > 0 ? x - rail : -x, -y, 0}, {side > 0 ? x : -x + rail, y - 0.001, h}, wood, 0.005);
    }
    block(s, {-x + rail - 0.004, -y + 0.001, 0.0005}, {x - rail + 0.004, y - 0.001, rail}, wood, 0.005);
    block(s, {-x + rail - 0.004, -y + 0.001, h - rail}, {x - rail + 0.004, y - 0.001, h - 0.0005}, wood, 0.005);
}

void round_mirror(Shaper& s, const Size& size) {
    const double r = size.width / 2, y = size.depth / 2;
    const auto scope = s.inside(move(0, y, r) * turn_x(90));
    const Ring inner = ellipse({}, r - 0.012, r - 0.012, s.fine(48));
    plate(s, inner, 0.001, y, mirror_glass);
    const Vec frame[] = {{r - 0.02, 0, 0},           {r, 0, 0},
                         {r, 0, size.depth - 0.004}, {r - 0.004, 0, size.depth},
                         {r - 0.016, 0, size.depth}, {r - 0.02, 0, size.depth - 0.004}};
    std::vector<Ring> rings;
    for (const Vec& p : frame) rings.push_back(ellipse({0, 0, p.z}, p.x, p.x, s.fine(48)));
    s.skin(rings, brass, Ends::Looped);
}

void towel_rail(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    for (const double side : both)
        rod(s, {side * (x - 0.018), 0, 0}, {side * (x - 0.018), 0, h}, 0.018, 0.018, white, 14);
    for (int k = 0; k < 14; ++k) {
        const double z = 0.06 + (h - 0.12) * k / 13 + (k % 5 == 4 ? 0.02 : 0);
        rod(s, {-x + 0.02, 0, z}, {x - 0.02, 0, z}, 0.0105, 0.0105, white, 10);
    }
    for (const double side : both) {
        for (const double z : {0.1, h - 0.1})
            rod(s, {side * (x - 0.018), 0, z}, {side * (x - 0.018), y, z}, 0.008, 0.008, white, 8);
    }
    // A towel over the upper bars: a folded sheet that hangs down on both sides.
    const int steps = s.fine(10), across = s.fine(8);
    std::vector<Ring> rings;
    for (int k = 0; k <= across; ++k) {
        const double u = 2.0 * k / across - 1, wave = 0.004 * std::sin(7 * u);
        Ring& ring = rings.emplace_back();
        const auto side = [&](double inset) {
            std::vector<Vec> line{{0.17 * u, -0.02 - wave + inset, h - 0.55}};
            for (int i = 0; i <= steps; ++i) {
                const double angle = pi * i / steps, r = 0.02 - inset;
                line.push_back({0.17 * u, -r * std::cos(angle) - (i == 0 ? wave : 0), h - 0.068 + r * std::sin(angle)});
            }
            line.push_back({0.17 * u, 0.02 - inset, h - 0.42});
            return line;
        };
        const std::vector<Vec> outer = side(0), inner = side(0.007);
        ring.insert(ring.end(), outer.begin(), outer.end());
        ring.insert(ring.end(), inner.rbegin(), inner.rend());
    }
    s.skin(rings, terracotta_cloth);
}

}  // namespace

void add_bathroom(Pieces& pieces) {
    pieces.push_back(piece<"own/toilet", Size{0.38, 0.677, 0.81}>(
        "Toilet", "toilet", "Bathroom", [](Shaper& s, const Size& size) { toilet(s, size); }));
    pieces.push_back(piece<"own/wash-basin", Size{0.58, 0.5, 1.01}>(
        "Wash basin", "wash_basin", "Bathroom", [](Shaper& s, const Size& size) { pedestal_basin(s, size); }));
    pieces.push_back(piece<"own/wash-basin-vanity", Size{0.8, 0.505, 1.055}>(
        "Wash basin on a cabinet", "wash_basin", "Bathroom", [](Shaper& s, const Size& size) { vanity(s, size); }));
    pieces.push_back(piece<"own/bathtub", Size{1.7, 0.78, 0.71}>(
        "Bathtub", "bathtub", "Bathroom", [](Shaper& s, const Size& size) { bathtub(s, size); }));
    pieces.push_back(piece<"own/shower", Size{0.9, 0.9, 2.1}>("Shower", "shower", "Bathroom",
                                                              [](Shaper& s, const Size& size) { shower(s, size); }));
    pieces.push_back(piece<"own/washing-machine", Size{0.6, 0.627, 0.85}>(
        "Washing machine", "washing_machine", "Bathroom", [](Shaper& s, const Size& size) { washing_machine(s, size); },
        {.top = 0.85}));
    pieces.push_back(piece<"own/mirror", Size{0.6, 0.03, 0.8}>(
        "Mirror", "mirror", "Bathroom", [](Shaper& s, const Size& size) { mirror(s, size, oak); },
        {.elevation = 1.15}));
    pieces.push_back(piece<"own/mirror-round", Size{0.7, 0.03, 0.7}>(
        "Round mirror", "mirror", "Bathroom", [](Shaper& s, const Size& size) { round_mirror(s, size); },
        {.elevation = 1.2}));
    pieces.push_back(piece<"own/towel-rail", Size{0.5, 0.085, 1.2}>(
        "Towel rail", "towel_rail", "Bathroom", [](Shaper& s, const Size& size) { towel_rail(s, size); },
        {.elevation = 0.5}));
}

}  // namespace enfilade::modeler::own
