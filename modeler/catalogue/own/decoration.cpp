// Things that make a room a home: on the floor, on walls, on tables.

#include <iterator>

#include "modeler/catalogue/own/books.h"
#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

/// A woven ground with borders and bands, fringes at its short ends.
void rug(Shaper& s, const Size& size, const Paint& ground, const Paint& band, const Paint& accent) {
    const double x = size.width / 2 - 0.05, y = size.depth / 2, h = size.height;
    block(s, {-x, -y, 0}, {x, y, 0.75 * h}, ground, 0.004);
    const auto strip = [&](double x0, double x1, double y0, double y1, const Paint& paint) {
        block(s, {x0, y0, 0.3 * h}, {x1, y1, h}, paint, 0.002);
    };
    strip(-x + 0.08, x - 0.08, -y + 0.06, -y + 0.1, band), strip(-x + 0.08, x - 0.08, y - 0.1, y - 0.06, band);
    strip(-x + 0.08, -x + 0.12, -y + 0.1, y - 0.1, band), strip(x - 0.12, x - 0.08, -y + 0.1, y - 0.1, band);
    const int across = static_cast<int>(size.width / 0.28), along = static_cast<int>(size.depth / 0.28);
    for (int i = 0; i < across; ++i) {
        for (int k = 0; k < along; ++k) {  // diamonds
            const double cx = mix(-x + 0.28, x - 0.28, across == 1 ? 0.5 : static_cast<double>(i) / (across - 1));
            const double cy = mix(-y + 0.26, y - 0.26, along == 1 ? 0.5 : static_cast<double>(k) / (along - 1));
            const Vec outer[] = {{cx - 0.1, cy, 0}, {cx, cy - 0.1, 0}, {cx + 0.1, cy, 0}, {cx, cy + 0.1, 0}};
            plate(s, outer, 0.3 * h, 0.97 * h, (i + k) % 2 == 0 ? band : accent, 0.002);
            const Vec inner[] = {{cx - 0.05, cy, 0}, {cx, cy - 0.05, 0}, {cx + 0.05, cy, 0}, {cx, cy + 0.05, 0}};
            plate(s, inner, 0.3 * h, h, ground, 0.002);
        }
    }
    const int threads = s.detail() == 1 ? 24 : s.fine(40);
    for (const double side : both) {
        for (int k = 0; k < threads; ++k) {
            const double at = mix(-y + 0.02, y - 0.02, static_cast<double>(k) / (threads - 1)),
                         bend = 0.006 * std::sin(5.0 * k);
            rod(s, {side * (x - 0.003), at, 0.004}, {side * (x + 0.05), at + bend, 0.0035}, 0.0035, 0.002, cotton, 5);
        }
    }
}

void round_rug(Shaper& s, const Size& size, const Paint& a, const Paint& b) {
    const double r = size.width / 2;
    const int rings = 7;
    for (int k = 0; k < rings; ++k) {  // plaited rings, one around the other
        const double at = r * (k + 0.5) / rings, half = 0.5 * r / rings, h = size.height;
        const int sides = s.fine(36), steps = s.fine(3);
        std::vector<Ring> skin;
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * pi * i / sides;
            Ring& ring = skin.emplace_back();
            for (int j = 0; j <= steps; ++j) {
                const double u = 2.0 * j / steps - 1, out = at + half * u;
                const double plait = s.detail() > 1 ? 0.08 * (i % 2 == 0 ? 1 : -1) * (j % 2 == 0 ? 1 : -1) : 0;
                ring.push_back(
                    {out * std::cos(angle), out * std::sin(angle), h * (0.55 + 0.37 * (1 - u * u) * (1 + plait))});
            }
            ring.push_back({(at + half) * std::cos(angle), (at + half) * std::sin(angle), 0});
            ring.push_back({(at - half) * std::cos(angle), (at - half) * std::sin(angle), 0});
        }
        s.skin(skin, k % 3 == 2 ? b : a, Ends::Looped);
    }
}

void frame(Shaper& s, double x, double y, double h, double rail, const Paint& wood) {
    for (const double side : both) {
        block(s, {side > 0 ? x - rail : -x, -y, 0}, {side > 0 ? x : -x + rail, y, h}, wood, 0.003);
    }
    block(s, {-x + rail, -y, 0}, {x - rail, y, rail}, wood, 0.003);
    block(s, {-x + rail, -y, h - rail}, {x - rail, y, h}, wood, 0.003);
}

/// Turns flat outlines drawn in x and y into pieces of a picture on the wall.
void paint_on(Shaper& s, std::span<const Vec> outline, double face, int layer, const Paint& paint) {
    const auto scope = s.inside(move(0, face, 0) * turn_x(90));
    plate(s, outline, -0.001, 0.0004 * (layer + 1), paint);
}

/// Hills, a sun, a lake.
void landscape(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height, rail = 0.022, face = 0.002;
    frame(s, x, y, h, rail, oak);
    block(s, {-x + rail - 0.002, face, rail - 0.002}, {x - rail + 0.002, y - 0.001, h - rail + 0.002}, cotton, 0);
    const double x0 = -x + 0.07, x1 = x - 0.07, z0 = 0.07, z1 = h - 0.07;
    const Vec sky[] = {{x0, z0, 0}, {x1, z0, 0}, {x1, z1, 0}, {x0, z1, 0}};
    paint_on(s, sky, face, 0, linen);
    const auto disc = s.inside(move(mix(x0, x1, 0.68), face, mix(z0, z1, 0.68)) * turn_x(90));
    plate(s, ellipse({}, 0.055, 0.055, s.fine(28)), -0.001, 0.0012, terracotta_cloth);
    const auto back = s.inside(turn_x(-90) * move(-mix(x0, x1, 0.68), -face, -mix(z0, z1, 0.68)));
    const Paint* hills[] = {&sage, &petrol, &deep_blue, &navy};
    for (int k = 0; k < 4; ++k) {
        std::vector<Vec> outline{{x1, z0, 0}};
        const int steps = s.fine(14);
        outline.insert(outline.begin(), Vec{x0, z0, 0});
        for (int i = steps; i >= 0; --i) {
            const double t = static_cast<double>(i) / steps;
            const double ridge =
                0.5 - 0.115 * k + (0.09 - 0.012 * k) * std::sin(4.5 * t + 1.7 * k) + 0.035 * std::sin(11 * t + k);
            outline.push_back({mix(x0, x1, t), mix(z0, z1, ridge), 0});
        }
        paint_on(s, outline, face, k + 3, *hills[k]);
    }
}

/// Arches and discs in a few colours.
void abstract_picture(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height, rail = 0.018, face = 0.002;
    frame(s, x, y, h, rail, iron);
    block(s, {-x + rail - 0.002, face, rail - 0.002}, {x - rail + 0.002, y - 0.001, h - rail + 0.002}, off_white, 0);
    const Paint* tones[] = {&terracotta_cloth, &mustard, &linen, &petrol};
    for (int k = 0; k < 4; ++k) {
        const double r = (0.36 - 0.08 * k) * size.width;
        std::vector<Vec> arch{{-r, 0.16 * h, 0}, {r, 0.16 * h, 0}};
        const int steps = s.fine(14);
        for (int i = 0; i <= steps; ++i) {
            const double angle = pi * i / steps;
            arch.push_back({r * std::cos(angle), 0.42 * h + r * std::sin(angle), 0});
        }
        paint_on(s, arch, face, 2 * k, *tones[k]);
    }
    std::vector<Vec> disc;
    for (const Vec& p : ellipse({0.2 * size.width, 0.83 * h, 0}, 0.1 * size.width, 0.1 * size.width, s.fine(24)))
        disc.push_back(p);
    paint_on(s, disc, face, 1, rose);
}

/// Two drapes on a rod, drawn aside: what is between them stays free.
void curtain(Shaper& s, const Size& size, const Paint& cloth) {
    const double x = size.width / 2, h = size.height, bar = h - 0.03;
    rod(s, {-x + 0.03, 0, bar}, {x - 0.03, 0, bar}, 0.012, 0.012, iron, 12);
    for (const double side : both) {
        ball(s, {side * (x - 0.022), 0, bar}, {0.022, 0.022, 0.022}, iron, 14);
        rod(s, {side * (x - 0.07), 0, bar}, {side * (x - 0.07), size.depth / 2, bar}, 0.007, 0.007, iron, 8);
        const int steps = s.fine(44), rows = s.fine(3);
        const double from = x - 0.04, to = x - 0.04 - 0.21 * size.width;
        std::vector<Ring> rings;
        for (int row = 0; row <= rows; ++row) {
            const double v = static_cast<double>(row) / rows;
            Ring& ring = rings.emplace_back();
            for (int face = 0; face < 2; ++face) {
                for (int k = 0; k <= steps; ++k) {
                    const double t = static_cast<double>(face == 0 ? k : steps - k) / steps;
                    const double fold = std::sin(2 * pi * 6 * t + 0.5 * std::sin(3 * v + 5 * t));
                    const double deep = mix(0.055, 0.03, v) * (0.75 + 0.25 * std::sin(7 * t + 2));
                    ring.push_back({side * mix(from, to - 0.02 * (1 - v), t),
                                    deep * fold + (face == 0 ? -0.002 : 0.002), mix(0.0, bar - 0.014, v)});
                }
            }
        }
        s.skin(rings, cloth);
        for (int k = 0; k < 7; ++k) {
            const auto scope = s.inside(move(side * mix(from - 0.01, to + 0.01, k / 6.0), 0, bar) * turn_y(90));
            tube(s, ellipse({}, 0.016, 0.016, s.fine(10)), 0.002, iron, 4, Ends::Looped);
        }
    }
}

void vase(Shaper& s) {
    const Vec outside[] = {{0.045, 0, 0},  {0.07, 0, 0.05}, {0.085, 0, 0.12},
                           {0.06, 0, 0.2}, {0.03, 0, 0.25}, {0.034, 0, 0.28}};
    std::vector<Vec> line = curve(outside, s.fine(3));
    line.insert(line.begin(), Vec{0, 0, 0});
    for (const Vec& p : {Vec{0.03, 0, 0.28}, Vec{0.026, 0, 0.25}, Vec{0.05, 0, 0.2}, Vec{0, 0, 0.18}})
        line.push_back(p);
    lathe(s, line, deep_blue, 32);
}

/// A vase with twigs and blossoms.
void flowers(Shaper& s) {
    vase(s);
    plans::Random random({0xF1u});
    for (int k = 0; k < 9; ++k) {
        const double turn = degrees(137.5 * k), reach = 0.04 + 0.011 * k, rise = 0.56 - 0.016 * k;
        const Vec out{std::cos(turn), std::sin(turn), 0};
        const Vec way[] = {{0, 0, 0.19},
                           0.016 * out + Vec{0, 0, 0.29},
                           reach * 0.7 * out + Vec{0, 0, 0.6 * rise + 0.12},
                           reach * out + Vec{0, 0, rise}};
        tube(s, curve(way, s.fine(3)), 0.0018, stem, 5);
        const Paint& petal = k % 3 == 0 ? rose : k % 3 == 1 ? cotton : mustard;
        {
            const auto scope = s.inside(move(reach * out.x, reach * out.y, rise) * turn_z(137.5 * k) * turn_y(25));
            ball(s, {0, 0, 0.002}, {0.008, 0.008, 0.006}, mustard, 10);
            for (int i = 0; i < 7; ++i) {
                const double angle = 2 * pi * i / 7, size = random.uniform(0.85, 1.1);
                const Vec aim{std::cos(angle), std::sin(angle), 0.35};
                std::vector<Vec> rib;
                std::vector<double> widths;
                const int steps = s.fine(3);
                for (int j = 0; j <= steps; ++j) {
                    const double t = static_cast<double>(j) / steps;
                    rib.push_back(0.005 * aim + (0.03 * size * t) * aim - Vec{0, 0, 0.008 * t * t});
                    widths.push_back(j == 0 ? 0.002 : j == steps ? 0.0 : 0.011 * std::sin(pi * std::pow(t, 0.7)));
                }
                leaf(s, rib, widths, {0, 0, 1}, 0.2, 0.002, petal);
            }
        }
        for (int i = 0; i < 2; ++i) {
            const double angle = turn + 1.3 + 2.2 * i;
            const Vec base = 0.6 * reach * out + Vec{0, 0, 0.3 + 0.06 * i}, aim{std::cos(angle), std::sin(angle), 0.5};
            const Vec rib[] = {base, base + 0.025 * aim, base + 0.05 * aim, base + 0.07 * aim - Vec{0, 0, 0.01}};
            const double widths[] = {0, 0.009, 0.008, 0};
            leaf(s, rib, widths, {0, 0, 1}, 0.25, 0.0015, leaf_green);
        }
    }
}

void book_pile(Shaper& s) {
    plans::Random random({0xB112u});
    book_stack(s, 4, {0.2, 0.16, 0.032}, random);
}

void cup(Shaper& s) {
    const Vec saucer[] = {{0, 0, 0},         {0.04, 0, 0},     {0.075, 0, 0.012},
                          {0.074, 0, 0.015}, {0.04, 0, 0.005}, {0, 0, 0.004}};
    lathe(s, saucer, white, 28);
    const auto scope = s.inside(move(0, 0, 0.004));
    const Vec body[] = {{0, 0, 0},          {0.026, 0, 0},     {0.036, 0, 0.02},  {0.042, 0, 0.065},
                        {0.0395, 0, 0.066}, {0.034, 0, 0.022}, {0.024, 0, 0.006}, {0, 0, 0.006}};
    lathe(s, body, white, 28);
    drum(s, {0, 0, 0.045}, 0.037, 0.004, dark_wood, 0.001, 24);
    const Vec handle[] = {{0.038, 0, 0.055}, {0.06, 0, 0.055}, {0.064, 0, 0.036}, {0.05, 0, 0.022}, {0.035, 0, 0.02}};
    tube(s, curve(handle, s.fine(4)), 0.0038, white, 8);
    rod(s, {-0.055, -0.04, 0.012}, {0.045, -0.055, 0.012}, 0.0018, 0.0018, chrome, 6);
    ball(s, {-0.06, -0.0395, 0.0125}, {0.012, 0.008, 0.002}, chrome, 12);
}

void radiator(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    const int columns = static_cast<int>(std::lround(size.width / 0.05));
    for (int k = 0; k < columns; ++k) {
        const double at = mix(-x + 0.024, x - 0.024, static_cast<double>(k) / (columns - 1));
        for (const double f : both)
            rod(s, {at, f * (y - 0.0125), 0.03}, {at, f * (y - 0.0125), h - 0.03}, 0.0125, 0.0125, white, 10);
        for (const double z : {0.035, h - 0.035}) {
            block(s, {at - 0.022, -y + 0.002, z - 0.033}, {at + 0.022, y - 0.002, z + 0.033}, white, 0.014);
        }
    }
    const auto scope = s.inside(move(x - 0.03, 0, 0.035) * turn_y(90));
    drum(s, {}, 0.017, 0.03, light_grey, 0.004, 16);
}

void fireplace(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x, -y, 0}, {x, y, 0.04}, stone, 0.006);
    for (const double side : both) {
        block(s, {side > 0 ? x - 0.33 : -x + 0.05, -y + 0.1, 0.04}, {side > 0 ? x - 0.05 : -x + 0.33, y, h - 0.06},
              marble, 0.004);
        block(s, {side > 0 ? x - 0.31 : -x + 0.07, -y + 0.08, 0.04}, {side > 0 ? x - 0.07 : -x + 0.31, -y + 0.11, 0.16},
              marble, 0.006);
        block(s, {side > 0 ? x - 0.28 : -x + 0.1, -y + 0.085, 0.2},
              {side > 0 ? x - 0.1 : -x + 0.28, -y + 0.11, h - 0.36}, marble, 0.01);
        block(s, {side > 0 ? x - 0.31 : -x + 0.07, -y + 0.08, h - 0.32},
              {side > 0 ? x - 0.07 : -x + 0.31, -y + 0.11, h - 0.08}, marble, 0.006);
    }
    block(s, {-x + 0.32, -y + 0.1, h - 0.34}, {x - 0.32, y, h - 0.06}, marble, 0.003);
    block(s, {-x + 0.36, -y + 0.085, h - 0.3}, {x - 0.36, -y + 0.11, h - 0.11}, marble, 0.01);
    block(s, {-x + 0.03, -y + 0.06, h - 0.085}, {x - 0.03, y, h - 0.045}, marble, 0.012);
    block(s, {-x, -y + 0.03, h - 0.05}, {x, y, h}, marble, 0.01);
    // The hearth: walls of firebrick, a grate, logs.
    const double inner = x - 0.33;
    block(s, {-inner - 0.002, y - 0.04, 0.04}, {inner + 0.002, y - 0.004, h - 0.33}, charcoal, 0);
    const int rows = 6;
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < 5; ++k) {
            const double w = 2 * inner / 4.5, x0 = std::max(-inner, -inner + (k - (row % 2 == 0 ? 0 : 0.5)) * w),
                         x1 = std::min(inner, -inner + (k + (row % 2 == 0 ? 1 : 0.5)) * w);
            const double z0 = 0.05 + row * (h - 0.39) / rows;
            if (x1 - x0 > 0.02)
                block(s, {x0 + 0.003, y - 0.055, z0}, {x1 - 0.003, y - 0.039, z0 + (h - 0.39) / rows - 0.008},
                      terracotta, 0.003);
        }
    }
    for (int k = 0; k < 7; ++k) {
        const double at = mix(-0.2, 0.2, k / 6.0);
        rod(s, {at, -y + 0.13, 0.1}, {at, y - 0.08, 0.1}, 0.007, 0.007, iron, 8);
    }
    for (const double f : {-y + 0.14, y - 0.09}) {
        rod(s, {-0.23, f, 0.1}, {0.23, f, 0.1}, 0.009, 0.009, iron, 8);
        for (const double side : both) rod(s, {side * 0.2, f, 0.04}, {side * 0.2, f, 0.15}, 0.009, 0.009, iron, 8);
    }
    const double logs[][5] = {
        {-0.19, 0.0, 0.19, -0.01, 0.145}, {-0.17, 0.09, 0.18, 0.085, 0.142}, {-0.15, 0.02, 0.16, 0.08, 0.215}};
    for (const auto& [ax, ay, bx, by, z] : logs) {
        rod(s, {ax, ay, z}, {bx, by, z + 0.005}, 0.038, 0.034, bark, 12);
        for (const double side : both) {
            const Vec end = side < 0 ? Vec{ax, ay, z} : Vec{bx, by, z + 0.005},
                      out = side * unit(Vec{bx - ax, by - ay, 0});
            rod(s, end - 0.01 * out, end + 0.0015 * out, 0.029, 0.029, birch, 12);
        }
    }
}

}  // namespace

void add_decoration(Pieces& pieces) {
    pieces.push_back(piece<"own/rug", Size{2.3, 1.6, 0.014}>(
        "Rug", "rug", "Decoration", [](Shaper& s, const Size& size) { rug(s, size, linen, terracotta_cloth, navy); }));
    pieces.push_back(piece<"own/rug-grey", Size{1.7, 1.2, 0.014}>(
        "Rug, grey", "rug", "Decoration", [](Shaper& s, const Size& size) { rug(s, size, wool, cotton, sage); }));
    pieces.push_back(piece<"own/rug-round", Size{1.6, 1.6, 0.015}>(
        "Round rug", "rug", "Decoration", [](Shaper& s, const Size& size) { round_rug(s, size, wicker, petrol); }));
    pieces.push_back(piece<"own/picture", Size{0.8, 0.03, 0.6}>("Landscape", "picture", "Decoration",
                                                                [](Shaper& s, const Size& size) { landscape(s, size); },
                                                                {.elevation = 1.4}));
    pieces.push_back(piece<"own/picture-abstract", Size{0.5, 0.03, 0.7}>(
        "Abstract picture", "picture", "Decoration", [](Shaper& s, const Size& size) { abstract_picture(s, size); },
        {.elevation = 1.4}));
    pieces.push_back(piece<"own/curtain", Size{1.8, 0.115, 2.3}>(
        "Curtains", "curtain", "Decoration", [](Shaper& s, const Size& size) { curtain(s, size, linen); },
        {.elevation = 0.02}));
    pieces.push_back(piece<"own/curtain-blue", Size{1.4, 0.115, 2.3}>(
        "Curtains, blue", "curtain", "Decoration", [](Shaper& s, const Size& size) { curtain(s, size, petrol); },
        {.elevation = 0.02}));
    pieces.push_back(piece<"own/vase", Size{0.17, 0.17, 0.28}>("Vase", "vase", "Decoration",
                                                               [](Shaper& s, const Size&) { vase(s); }));
    pieces.push_back(piece<"own/vase-flowers", Size{0.271, 0.27, 0.578}>("Vase with flowers", "vase", "Decoration",
                                                                         [](Shaper& s, const Size&) { flowers(s); }));
    pieces.push_back(piece<"own/book-pile", Size{0.2, 0.16, 0.104}>("Pile of books", "book_pile", "Decoration",
                                                                    [](Shaper& s, const Size&) { book_pile(s); }));
    pieces.push_back(
        piece<"own/cup", Size{0.15, 0.15, 0.07}>("Cup", "cup", "Decoration", [](Shaper& s, const Size&) { cup(s); }));
    pieces.push_back(piece<"own/radiator", Size{1.0, 0.1, 0.6}>("Radiator", "radiator", "Decoration",
                                                                [](Shaper& s, const Size& size) { radiator(s, size); },
                                                                {.elevation = 0.1}));
    pieces.push_back(piece<"own/fireplace", Size{1.4, 0.5, 1.15}>(
        "Fireplace", "fireplace", "Decoration", [](Shaper& s, const Size& size) { fireplace(s, size); },
        {.top = 1.15}));
}

}  // namespace enfilade::modeler::own
