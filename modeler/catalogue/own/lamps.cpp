// Lamps: floor, table, desk, ceiling, wall. Those that hang from a ceiling end at their top; those on a wall have it at
// +y.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

/// A shade of cloth: a hollow cone, open at both ends, its hems thicker, pleated at detail 2 and more.
void cloth_shade(Shaper& s, double low_radius, double high_radius, double bottom, double top, const Paint& cloth,
                 const Paint& hem) {
    const int sides = s.fine(36), rows = s.fine(2);
    const double pleat = s.detail() > 1 ? 0.012 : 0;
    std::vector<Ring> rings;
    const auto ring = [&](double t, double inset) {
        Ring points;
        const double r = mix(low_radius, high_radius, t) - inset;
        for (int k = 0; k < sides; ++k) {
            const double angle = 2 * pi * k / sides, wave = r * (1 - pleat * (k % 2));
            points.push_back({wave * std::cos(angle), wave * std::sin(angle), mix(bottom, top, t)});
        }
        rings.push_back(points);
    };
    for (int k = 0; k <= rows; ++k) ring(static_cast<double>(k) / rows, 0);
    for (int k = rows; k >= 0; --k) ring(static_cast<double>(k) / rows, 0.004);
    s.skin(rings, cloth, Ends::Looped);
    tube(s, ellipse({0, 0, bottom + 0.003}, low_radius, low_radius, s.fine(36)), 0.0035, hem, 5, Ends::Looped);
    tube(s, ellipse({0, 0, top - 0.003}, high_radius, high_radius, s.fine(36)), 0.0035, hem, 5, Ends::Looped);
    for (int k = 0; k < 3; ++k) {  // what carries it
        const auto scope = s.inside(turn_z(120 * k));
        rod(s, {0, 0, top - 0.02}, {high_radius, 0, top - 0.006}, 0.002, 0.002, hem, 5);
    }
}

void bulb(Shaper& s, Vec at, double size) {
    const auto scope = s.inside(move(at.x, at.y, at.z));
    rod(s, {0, 0, -1.35 * size}, {0, 0, -0.6 * size}, 0.5 * size, 0.5 * size, brass, 12);
    ball(s, {}, {size, size, 1.1 * size}, glow, 16);
}

void floor_lamp(Shaper& s, const Size& size) {
    const double h = size.height;
    drum(s, {}, 0.15, 0.022, iron, 0.008, 32);
    rod(s, {0, 0, 0.02}, {0, 0, h - 0.06}, 0.009, 0.009, brass, 12);
    cloth_shade(s, 0.2, 0.15, h - 0.32, h - 0.02, shade_cloth, linen);
    bulb(s, {0, 0, h - 0.15}, 0.035);
    rod(s, {0, 0, h - 0.07}, {0, 0, h}, 0.006, 0.006, brass, 10);
    const Vec cord[] = {{0.03, -0.02, h - 0.3}, {0.03, -0.02, h - 0.4}, {0.032, -0.02, h - 0.47}};
    tube(s, cord, 0.0015, brass, 5);
    ball(s, {0.032, -0.02, h - 0.475}, {0.008, 0.008, 0.01}, brass, 10);
}

/// Three legs of wood.
void tripod_lamp(Shaper& s, const Size& size) {
    const double h = size.height;
    for (int k = 0; k < 3; ++k) {
        const auto scope = s.inside(turn_z(90 + 120 * k));
        rod(s, {0.27, 0, 0}, {0.02, 0, h - 0.36}, 0.011, 0.016, oak, 14);
        rod(s, {0.148, 0, 0.55}, {0, 0, 0.55}, 0.005, 0.005, brass, 8);
    }
    drum(s, {0, 0, h - 0.39}, 0.045, 0.03, brass, 0.006, 24);
    rod(s, {0, 0, h - 0.37}, {0, 0, h - 0.05}, 0.008, 0.008, brass, 10);
    cloth_shade(s, 0.235, 0.2, h - 0.33, h, cotton, brass);
    bulb(s, {0, 0, h - 0.13}, 0.035);
}

void table_lamp(Shaper& s, const Size& size, const Paint& body) {
    const double h = size.height;
    const Vec profile[] = {{0.075, 0, 0.0},  {0.08, 0, 0.012}, {0.05, 0, 0.03},  {0.075, 0, 0.1},
                           {0.085, 0, 0.15}, {0.06, 0, 0.21},  {0.025, 0, 0.25}, {0.018, 0, 0.28}};
    std::vector<Vec> line = curve(profile, s.fine(2));
    line.insert(line.begin(), Vec{0, 0, 0}), line.push_back({0, 0, 0.28});
    lathe(s, line, body, 28);
    rod(s, {0, 0, 0.27}, {0, 0, h - 0.02}, 0.006, 0.006, brass, 10);
    cloth_shade(s, 0.155, 0.11, h - 0.21, h, shade_cloth, linen);
    bulb(s, {0, 0, h - 0.1}, 0.028);
}

void desk_lamp(Shaper& s) {
    const Vec elbow{0, 0.1, 0.36}, head{0, -0.1, 0.5}, foot{0, 0.02, 0.02};
    drum(s, {0, 0.02, 0}, 0.085, 0.018, petrol, 0.006, 28);
    rod(s, foot, foot + Vec{0, 0, 0.035}, 0.014, 0.012, steel, 12);
    for (const double side : both) {
        const Vec off{side * 0.009, 0, 0};
        rod(s, foot + off + Vec{0, 0, 0.035}, elbow + off, 0.004, 0.004, petrol, 8);
        rod(s, elbow + off, head + off, 0.004, 0.004, petrol, 8);
    }
    for (const Vec& joint : {foot + Vec{0, 0, 0.035}, elbow, head})
        rod(s, joint - Vec{0.017, 0, 0}, joint + Vec{0.017, 0, 0}, 0.01, 0.01, steel, 12);
    if (s.detail() > 1) {  // springs
        for (const double side : both) {
            std::vector<Vec> coil;
            const int turns = 14, steps = s.fine(5);
            for (int k = 0; k <= turns * steps; ++k) {
                const double t = static_cast<double>(k) / (turns * steps), angle = 2 * pi * k / steps;
                coil.push_back(mix(foot + Vec{0, 0, 0.045}, mix(foot, elbow, 0.55), t) +
                               Vec{side * 0.016 + 0.0045 * std::cos(angle), 0.0045 * std::sin(angle), 0});
            }
            tube(s, coil, 0.0011, steel, 3);
        }
    }
    const auto scope = s.inside(move(head.x, head.y, head.z) * turn_x(-22));
    const Vec shade[] = {{0.018, 0, 0.03},   {0.03, 0, 0.02},   {0.05, 0, -0.03},  {0.075, 0, -0.085},
                         {0.072, 0, -0.085}, {0.047, 0, -0.03}, {0.028, 0, 0.014}, {0.016, 0, 0.024}};
    std::vector<Ring> rings;
    for (const Vec& p : shade) rings.push_back(ellipse({0, 0, p.z}, p.x, p.x, s.fine(28)));
    s.skin(rings, petrol, Ends::Looped);
    rod(s, {0, 0, 0.015}, {0, 0, 0.05}, 0.018, 0.014, petrol, 16);
    bulb(s, {0, 0, -0.035}, 0.026);
}

void pendant(Shaper& s, const Size& size) {
    const double h = size.height, r = size.width / 2;
    drum(s, {0, 0, h - 0.025}, 0.05, 0.025, white, 0.006, 24);
    rod(s, {0, 0, 0.2}, {0, 0, h - 0.02}, 0.003, 0.003, black, 8);
    rod(s, {0, 0, 0.19}, {0, 0, 0.25}, 0.024, 0.014, brass, 16);
    std::vector<Vec> line;
    const int steps = s.fine(7);
    for (int k = 0; k <= steps; ++k) {
        const double angle = mix(4.0, 90.0, static_cast<double>(k) / steps);
        line.push_back({r * std::sin(degrees(angle)), 0, 0.2 * std::cos(degrees(angle))});
    }
    for (int k = steps; k >= 0; --k) {
        const double angle = mix(4.0, 90.0, static_cast<double>(k) / steps);
        line.push_back(
            {(r - 0.004) * std::sin(degrees(angle)) + (k == steps ? 0.001 : 0), 0, 0.196 * std::cos(degrees(angle))});
    }
    std::vector<Ring> rings;
    for (const Vec& p : line) rings.push_back(ellipse({0, 0, p.z}, p.x, p.x, s.fine(36)));
    s.skin(rings, deep_blue, Ends::Looped);
    bulb(s, {0, 0, 0.11}, 0.04);
}

/// A flat drum under the ceiling.
void ceiling_drum(Shaper& s, const Size& size) {
    const double r = size.width / 2, h = size.height;
    drum(s, {0, 0, 0}, r - 0.006, h - 0.02, glow, 0.02, 40);
    drum(s, {0, 0, h - 0.03}, r - 0.004, 0.03, white, 0.003, 40);
    const Vec band[] = {{r - 0.007, 0, 0.02}, {r, 0, 0.022}, {r, 0, h - 0.012}, {r - 0.007, 0, h - 0.01}};
    std::vector<Ring> rings;
    for (const Vec& p : band) rings.push_back(ellipse({0, 0, p.z}, p.x, p.x, s.fine(40)));
    s.skin(rings, brass, Ends::Looped);
}

/// A long panel for offices.
void office_light(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x, -y, 0.0}, {x, y, 0.05}, light_grey, 0.006);
    block(s, {-x + 0.02, -y + 0.015, -0.003}, {x - 0.02, y - 0.015, 0.01}, glow, 0.002);
    for (const double side : both) {
        rod(s, {side * (x - 0.2), 0, 0.05}, {side * (x - 0.2), 0, h}, 0.0015, 0.0015, steel, 6);
        drum(s, {side * (x - 0.2), 0, h - 0.02}, 0.02, 0.02, white, 0.004, 16);
    }
}

void wall_lamp(Shaper& s, const Size& size) {
    const double y = size.depth / 2;
    {
        const auto scope = s.inside(move(0, y, 0.1) * turn_x(90));
        drum(s, {}, 0.055, 0.02, brass, 0.006, 28);
    }
    const Vec arm[] = {{0, y - 0.01, 0.1}, {0, y - 0.07, 0.095}, {0, y - 0.11, 0.11}, {0, y - 0.115, 0.15}};
    tube(s, curve(arm, s.fine(4)), 0.008, brass, 10);
    const auto scope = s.inside(move(0, y - 0.115, 0.14));
    rod(s, {0, 0, 0}, {0, 0, 0.03}, 0.022, 0.024, brass, 16);
    const Vec shade[] = {{0, 0, 0.02},      {0.035, 0, 0.025}, {0.06, 0, 0.06},   {0.075, 0, 0.12},
                         {0.072, 0, 0.121}, {0.056, 0, 0.064}, {0.032, 0, 0.032}, {0, 0, 0.03}};
    lathe(s, shade, glow, 28);
}

}  // namespace

void add_lamps(Pieces& pieces) {
    pieces.push_back(piece<"own/floor-lamp", Size{0.407, 0.407, 1.6}>(
        "Floor lamp", "floor_lamp", "Lamps", [](Shaper& s, const Size& size) { floor_lamp(s, size); }));
    pieces.push_back(piece<"own/floor-lamp-tripod", Size{0.49, 0.52, 1.45}>(
        "Tripod lamp", "floor_lamp", "Lamps", [](Shaper& s, const Size& size) { tripod_lamp(s, size); }));
    pieces.push_back(piece<"own/table-lamp", Size{0.317, 0.317, 0.48}>(
        "Table lamp", "table_lamp", "Lamps", [](Shaper& s, const Size& size) { table_lamp(s, size, terracotta); }));
    pieces.push_back(piece<"own/table-lamp-blue", Size{0.317, 0.317, 0.48}>(
        "Table lamp, blue", "table_lamp", "Lamps",
        [](Shaper& s, const Size& size) { table_lamp(s, size, deep_blue); }));
    pieces.push_back(piece<"own/desk-lamp", Size{0.17, 0.31, 0.55}>("Desk lamp", "desk_lamp", "Lamps",
                                                                    [](Shaper& s, const Size&) { desk_lamp(s); }));
    pieces.push_back(piece<"own/ceiling-lamp", Size{0.42, 0.42, 0.75}>(
        "Pendant lamp", "ceiling_lamp", "Lamps", [](Shaper& s, const Size& size) { pendant(s, size); }));
    pieces.push_back(piece<"own/ceiling-lamp-drum", Size{0.45, 0.45, 0.12}>(
        "Ceiling lamp", "ceiling_lamp", "Lamps", [](Shaper& s, const Size& size) { ceiling_drum(s, size); }));
    pieces.push_back(piece<"own/ceiling-lamp-office", Size{1.2, 0.22, 0.35}>(
        "Office light", "office_lamp", "Lamps", [](Shaper& s, const Size& size) { office_light(s, size); }));
    pieces.push_back(piece<"own/wall-lamp", Size{0.15, 0.19, 0.216}>(
        "Wall lamp", "wall_lamp", "Lamps", [](Shaper& s, const Size& size) { wall_lamp(s, size); },
        {.elevation = 1.6}));
}

}  // namespace enfilade::modeler::own
