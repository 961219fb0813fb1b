// Offices: whoever works sits at -y.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"
#include "plans/random.h"

namespace enfilade::modeler::own {
namespace {

/// A chest of three drawers under a desk.
void pedestal(Shaper& s, double x0, double x1, double y0, double y1, double top, const Paint& body,
              const Paint& metal) {
    block(s, {x0, y0 + 0.02, 0.06}, {x1, y1, top}, body, 0.003);
    block(s, {x0 + 0.02, y0 + 0.04, 0}, {x1 - 0.02, y1 - 0.02, 0.06}, charcoal, 0);
    for (int k = 0; k < 3; ++k) {
        const double z0 = 0.065 + k * (top - 0.07) / 3, z1 = 0.065 + (k + 1) * (top - 0.07) / 3;
        front(s, {x0, y0 + 0.02, z0}, {x1, y0 + 0.02, z1 - 0.003}, body);
        bar_handle(s, {(x0 + x1) / 2, y0 + 0.002, z1 - 0.06}, 0.12, false, metal);
    }
}

/// A top on two frames of square tube; drawers on the right.
void frame_desk(Shaper& s, const Size& size, const Paint& top, const Paint& frame, const Paint* chest) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height, under = h - 0.026;
    block(s, {-x, -y, under}, {x, y, h}, top, 0.004);
    for (const double side : both) {
        const double at = side * (x - 0.06);
        for (const double f : both) {
            block(s, {at - 0.018, f * (y - 0.06) - 0.018, 0}, {at + 0.018, f * (y - 0.06) + 0.018, under}, frame,
                  0.004);
        }
        block(s, {at - 0.017, -y + 0.06, 0.001}, {at + 0.017, y - 0.06, 0.03}, frame, 0.004);
        block(s, {at - 0.017, -y + 0.06, under - 0.032}, {at + 0.017, y - 0.06, under - 0.001}, frame, 0.004);
    }
    block(s, {-x + 0.06, y - 0.075, under - 0.032}, {x - 0.06, y - 0.045, under - 0.001}, frame, 0.004);
    block(s, {-x + 0.08, y - 0.066, 0.32}, {x - 0.08, y - 0.054, under - 0.03}, top, 0.002);
    if (s.detail() > 1) {  // a grommet for the cables
        const auto scope = s.inside(move(-x + 0.2, y - 0.1, h - 0.001));
        drum(s, {}, 0.032, 0.001, charcoal, 0.0004, 20);
    }
    if (chest != nullptr) pedestal(s, x - 0.52, x - 0.09, -y + 0.04, y - 0.08, 0.6, *chest, steel);
}

/// Turned legs, two drawers under a top with a low ledge at its back.
void writing_desk(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x, -y, h - 0.024}, {x, y, h}, walnut, 0.006);
    block(s, {-x + 0.05, -y + 0.05, h - 0.13}, {x - 0.05, y - 0.02, h - 0.024}, walnut, 0.003);
    for (const double side : both) {
        for (const double f : both) {
            rod(s, {side * (x - 0.05), f * (y - 0.045), 0}, {side * (x - 0.085), f * (y - 0.08), h - 0.1}, 0.012, 0.022,
                walnut, 14);
        }
        rod(s, {side * (x - 0.06), -y + 0.055, 0.2}, {side * (x - 0.06), y - 0.055, 0.2}, 0.008, 0.008, walnut, 10);
        const double x0 = side > 0 ? 0.003 : -x + 0.055, x1 = side > 0 ? x - 0.055 : -0.003;
        front(s, {x0, -y + 0.05, h - 0.126}, {x1, -y + 0.05, h - 0.028}, walnut);
        for (const double at : {0.25, 0.75}) knob(s, {mix(x0, x1, at), -y + 0.032, h - 0.077}, 0.011, brass);
    }
    rod(s, {-x + 0.06, 0, 0.2}, {x - 0.06, 0, 0.2}, 0.008, 0.008, walnut, 10);
}

void castor(Shaper& s, Vec top) {
    const auto scope = s.inside(move(top.x, top.y, 0));
    rod(s, {0, 0, 0.04}, {0, 0, top.z}, 0.009, 0.009, steel, 8);
    block(s, {-0.006, -0.022, 0.02}, {0.006, 0.03, 0.058}, black, 0.004);
    for (const double side : both) {
        const auto wheel = s.inside(move(side * 0.0145 - 0.0075, 0.012, 0.028) * turn_y(90));
        drum(s, {}, 0.028, 0.015, charcoal, 0.006, 16);
    }
}

void office_chair(Shaper& s, const Paint& cloth, const Paint& frame, bool has_head) {
    for (int k = 0; k < 5; ++k) {  // the star
        const double angle = 90 + 72.0 * k;
        const Vec out{std::cos(degrees(angle)), std::sin(degrees(angle)), 0};
        const Vec way[] = {0.02 * out + Vec{0, 0, 0.115}, 0.15 * out + Vec{0, 0, 0.105}, 0.29 * out + Vec{0, 0, 0.075}};
        const double thick[] = {0.027, 0.025, 0.023, 0.021, 0.019, 0.018, 0.017, 0.016, 0.0155, 0.015};
        tube(s, curve(way, s.fine(3)), thick, frame, 10);
        castor(s, 0.285 * out + Vec{0, 0, 0.08});
    }
    rod(s, {0, 0, 0.08}, {0, 0, 0.13}, 0.045, 0.038, frame, 20);
    rod(s, {0, 0, 0.12}, {0, 0, 0.3}, 0.027, 0.026, black, 18);
    rod(s, {0, 0, 0.29}, {0, 0, 0.42}, 0.016, 0.016, chrome, 14);
    block(s, {-0.09, -0.1, 0.4}, {0.09, 0.16, 0.435}, black, 0.012);
    rod(s, {0.08, -0.02, 0.415}, {0.2, -0.04, 0.405}, 0.006, 0.009, black, 8);
    cushion(s, {0, -0.02, 0.475}, {0.25, 0.245, 0.045}, 0.12, 0.42, cloth);
    if (s.detail() > 1) {
        tube(s, rounded_rectangle({0, -0.02, 0.468}, 0.2505, 0.2455, 0.12, s.fine(4), s.fine(3)), 0.004, black, 5,
             Ends::Looped);
    }
    const Vec spine[] = {{0, 0.12, 0.415}, {0, 0.23, 0.44}, {0, 0.285, 0.56}, {0, 0.3, 0.78}};
    tube(s, curve(spine, s.fine(4)), 0.02, frame, 10);
    // The back: bowed around the sitter.
    const int rows = s.fine(10), columns = s.fine(10);
    std::vector<Ring> rings;
    for (int k = 0; k <= rows; ++k) {
        // Closer together where its ends turn round.
        const double turn = -std::cos(pi * k / rows), v = 0.5 + 0.5 * turn, z = mix(0.54, 1.04, v);
        const double half =
            0.235 * std::pow(std::max(0.0, 1 - turn * turn * turn * turn), 0.32) * (1 - 0.12 * v) + 0.01;
        const double y = 0.245 + 0.02 * std::cos(4 * (v - 0.35)) + 0.05 * v * v;
        Ring& ring = rings.emplace_back();
        for (int i = 0; i <= 2 * columns + 1; ++i) {
            const bool is_back = i > columns;
            const double u = 2.0 * (is_back ? 2 * columns + 1 - i : i) / columns - 1;
            const double full =
                0.026 * std::pow(std::max(0.0, 1 - u * u * u * u), 0.4) * (k == 0 || k == rows ? 0.5 : 1) + 0.005;
            ring.push_back({half * u, y - 0.05 * (half * u) * (half * u) / 0.06 + (is_back ? full : -full), z});
        }
    }
    s.skin(rings, cloth);
    if (has_head) {
        rod(s, {0, 0.3, 0.98}, {0, 0.315, 1.13}, 0.01, 0.01, black, 8);
        const auto scope = s.inside(move(0, 0.285, 1.15) * turn_x(80));
        cushion(s, {}, {0.14, 0.07, 0.03}, 0.05, 0.45, cloth);
    }
    for (const double side : both) {
        const Vec way[] = {{side * 0.14, 0.06, 0.425},
                           {side * 0.285, 0.05, 0.43},
                           {side * 0.3, 0.045, 0.55},
                           {side * 0.3, 0.03, 0.645}};
        tube(s, curve(way, s.fine(3)), 0.013, frame, 8);
        block(s, {side * 0.3 - 0.035, -0.13, 0.645}, {side * 0.3 + 0.035, 0.13, 0.672}, black, 0.012);
    }
}

void filing_cabinet(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.035, h = size.height;
    block(s, {-x, face, 0}, {x, y, h}, light_grey, 0.004);
    for (int k = 0; k < 4; ++k) {
        const double z0 = 0.03 + k * (h - 0.045) / 4, z1 = 0.03 + (k + 1) * (h - 0.045) / 4;
        front(s, {-x + 0.008, face, z0 + 0.002}, {x - 0.008, face, z1 - 0.002}, light_grey);
        bar_handle(s, {0, face - 0.018, z1 - 0.11}, 0.13, false, steel);
        block(s, {-0.04, face - 0.0205, z1 - 0.07}, {0.04, face - 0.017, z1 - 0.035}, white, 0.001);
        screw(s, {-0.035, face - 0.0205, z1 - 0.052}, steel);
    }
    const auto scope = s.inside(move(x - 0.045, face - 0.017, h - 0.05) * turn_x(90));
    drum(s, {}, 0.009, 0.006, chrome, 0.002, 12);
}

void whiteboard(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x + 0.012, y - 0.016, 0.03}, {x - 0.012, y, h - 0.012}, white, 0.001);
    for (const double side : both) {
        block(s, {side > 0 ? x - 0.02 : -x, y - 0.022, 0.02}, {side > 0 ? x : -x + 0.02, y - 0.001, h}, steel, 0.004);
    }
    block(s, {-x + 0.01, y - 0.022, h - 0.02}, {x - 0.01, y - 0.001, h}, steel, 0.004);
    block(s, {-x + 0.01, y - 0.022, 0.02}, {x - 0.01, y - 0.001, 0.04}, steel, 0.004);
    block(s, {-0.5 * x, -y, 0}, {0.5 * x, y - 0.005, 0.012}, steel, 0.003);
    const Paint* inks[] = {&book_covers[0], &book_covers[1], &black};
    for (int k = 0; k < 3; ++k)
        rod(s, {-0.3 + 0.16 * k, -y + 0.03, 0.021}, {-0.18 + 0.16 * k, -y + 0.032, 0.021}, 0.008, 0.008, *inks[k], 10);
    block(s, {0.22, -y + 0.012, 0.012}, {0.34, -y + 0.05, 0.037}, charcoal, 0.004);
    // What is left of a meeting: a curve over two axes, and lines.
    const double on = y - 0.0175;
    std::vector<Vec> growth;
    for (int k = 0; k <= s.fine(10); ++k) {
        const double t = static_cast<double>(k) / s.fine(10);
        growth.push_back({-0.62 * x + 0.5 * x * t, on, h * (0.34 + 0.34 * t * t + 0.03 * std::sin(9 * t))});
    }
    tube(s, growth, 0.0025, book_covers[0], 4);
    const Vec axes[] = {{-0.66 * x, on, h * 0.78}, {-0.66 * x, on, h * 0.28}, {-0.06 * x, on, h * 0.28}};
    tube(s, axes, 0.0025, book_covers[1], 4);
    plans::Random random({0x3Bu});
    for (int k = 0; k < 5; ++k) {
        const double z = h * (0.78 - 0.1 * k);
        rod(s, {0.15 * x, on, z}, {(0.3 + random.uniform(0.2, 0.5)) * x, on, z}, 0.0025, 0.0025, book_covers[1], 4);
    }
}

void meeting_table(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    // A top that bulges at its long sides: everyone sees everyone.
    Ring outline;
    const int steps = s.fine(16);
    for (const double side : both) {
        for (int k = 0; k <= steps; ++k) {
            const double t = 2.0 * k / steps - 1;
            const double half = y * (0.8 + 0.2 * std::cos(t * pi / 2));
            outline.push_back({side * t * -x, side * half * -1, 0});
        }
    }
    plate(s, outline, h - 0.035, h - 0.0008, light_oak, 0.006);
    for (const double side : both) {
        for (const double f : both) {
            post(s, {side * (x - 0.36), f * (y - 0.26), 0}, {side * (x - 0.42), f * (y - 0.4), h - 0.035},
                 {0.035, 0.02, 0}, {0.045, 0.022, 0}, charcoal, 0.005);
        }
        block(s, {side * (x - 0.42) - 0.04, -y + 0.38, h - 0.075}, {side * (x - 0.42) + 0.04, y - 0.38, h - 0.034},
              charcoal, 0.004);
    }
    block(s, {-x + 0.4, -0.03, h - 0.075}, {x - 0.4, 0.03, h - 0.036}, charcoal, 0.004);
    block(s, {-0.16, -0.06, h - 0.0045}, {0.16, 0.06, h}, steel, 0.002);
}

void reception_desk(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x, y - 0.06, 0.08}, {x, y - 0.02, h - 0.04}, white, 0.004);
    block(s, {-x + 0.02, y - 0.055, 0}, {x - 0.02, y - 0.03, 0.08}, charcoal, 0);
    block(s, {-x, y - 0.34, h - 0.04}, {x, y, h}, oak, 0.006);
    const int boards = static_cast<int>(size.width / 0.08);
    for (int k = 0; k < boards; ++k) {  // upright laths towards the visitors
        const double at = -x + (k + 0.5) * 2 * x / boards;
        block(s, {at - 0.022, y - 0.021, 0.09}, {at + 0.022, y - 0.003, h - 0.045}, oak, 0.004);
    }
    for (const double side : both) {
        block(s, {side > 0 ? x - 0.04 : -x, -y + 0.02, 0}, {side > 0 ? x : -x + 0.04, y - 0.06, 0.71}, white, 0.004);
        block(s, {side > 0 ? x - 0.04 : -x, y - 0.32, 0.7}, {side > 0 ? x : -x + 0.04, y - 0.06, h - 0.04}, white,
              0.004);
    }
    block(s, {-x, -y, 0.71}, {x, y - 0.06, 0.74}, white, 0.004);
    pedestal(s, x - 0.5, x - 0.06, -y + 0.04, y - 0.1, 0.66, white, steel);
}

void locker(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.03, h = size.height;
    block(s, {-x, face, 0.1}, {x, y, h}, grey, 0.004);
    for (const double side : both)
        block(s, {side * (x - 0.06) - 0.02, -y + 0.06, 0}, {side * (x - 0.06) + 0.02, y - 0.03, 0.101}, charcoal,
              0.003);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 2; ++row) {
            const double x0 = -x + 0.008 + column * (2 * x - 0.016) / 3, x1 = x0 + (2 * x - 0.016) / 3;
            const double z0 = 0.11 + row * (h - 0.12) / 2, z1 = z0 + (h - 0.12) / 2;
            front(s, {x0 + 0.002, face, z0 + 0.002}, {x1 - 0.002, face, z1 - 0.002},
                  column == 1 ? deep_blue : light_grey);
            for (int k = 0; k < 5; ++k) {
                const double z = z1 - 0.08 - 0.022 * k;
                block(s, {x0 + 0.07, face - 0.021, z}, {x1 - 0.07, face - 0.017, z + 0.008}, charcoal, 0.0015);
            }
            block(s, {x1 - 0.05, face - 0.03, (z0 + z1) / 2 - 0.05}, {x1 - 0.03, face - 0.016, (z0 + z1) / 2 + 0.05},
                  steel, 0.004);
            block(s, {(x0 + x1) / 2 - 0.03, face - 0.0205, z1 - 0.25}, {(x0 + x1) / 2 + 0.03, face - 0.0175, z1 - 0.22},
                  white, 0.001);
        }
    }
}

void bin(Shaper& s) {
    const Vec profile[] = {{0, 0, 0},         {0.105, 0, 0},    {0.11, 0, 0.008},  {0.135, 0, 0.295}, {0.138, 0, 0.3},
                           {0.132, 0, 0.302}, {0.128, 0, 0.29}, {0.104, 0, 0.015}, {0, 0, 0.012}};
    lathe(s, profile, charcoal, 28);
    plans::Random random({0xB1u});
    for (int k = 0; k < 5; ++k) {  // crumpled paper
        const double angle = 72.0 * k, r = 0.055;
        const auto scope = s.inside(move(r * std::cos(degrees(angle)), r * std::sin(degrees(angle)), 0.17 + 0.01 * k) *
                                    turn_z(50 * k) * turn_x(30 * k));
        std::vector<Ring> rings;
        const int rows = s.fine(5), columns = s.fine(8);
        for (int i = 0; i <= rows; ++i) {
            Ring& ring = rings.emplace_back();
            const double v = pi * i / rows;
            for (int j = 0; j < columns; ++j) {
                const double size = i == 0 || i == rows ? 0.04 : random.uniform(0.032, 0.047), u = 2 * pi * j / columns;
                const double side = i == 0 || i == rows ? 0 : std::sin(v);
                ring.push_back({size * side * std::cos(u), size * side * std::sin(u), -size * std::cos(v)});
            }
        }
        s.skin(rings, paper);
    }
}

void cardboard_box(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height - 0.002;
    block(s, {-x, -y, 0}, {x, y, h}, cardboard, 0.003);
    block(s, {-x - 0.0005, -0.025, h - 0.06}, {x + 0.0005, 0.025, size.height}, linen, 0.001);
    block(s, {-x + 0.002, -0.001, h - 0.002}, {x - 0.002, 0.001, h + 0.0005}, dark_wood, 0);
    block(s, {-0.06, -y - 0.0006, 0.05}, {0.06, -y + 0.001, 0.13}, paper, 0);
    for (int k = 0; k < 4; ++k)
        block(s, {-0.045, -y - 0.001, 0.065 + 0.015 * k}, {0.03 - 0.012 * k, -y, 0.07 + 0.015 * k}, black, 0);
}

}  // namespace

void add_office(Pieces& pieces) {
    pieces.push_back(piece<"own/desk", Size{1.4, 0.7, 0.74}>(
        "Desk, oak top", "desk", "Office", [](Shaper& s, const Size& size) { frame_desk(s, size, oak, iron, &white); },
        {.top = 0.74}));
    pieces.push_back(piece<"own/desk-white", Size{1.6, 0.8, 0.73}>(
        "Desk, white", "desk", "Office",
        [](Shaper& s, const Size& size) { frame_desk(s, size, white, light_grey, nullptr); }, {.top = 0.73}));
    pieces.push_back(piece<"own/desk-walnut", Size{1.2, 0.62, 0.75}>(
        "Writing desk", "desk", "Office", [](Shaper& s, const Size& size) { writing_desk(s, size); }, {.top = 0.75}));
    pieces.push_back(piece<"own/office-chair", Size{0.67, 0.59, 1.04}>(
        "Office chair", "office_chair", "Office",
        [](Shaper& s, const Size&) { office_chair(s, dark_wool, charcoal, false); }));
    pieces.push_back(piece<"own/office-chair-blue", Size{0.67, 0.59, 1.04}>(
        "Office chair, blue", "office_chair", "Office",
        [](Shaper& s, const Size&) { office_chair(s, deep_blue, light_grey, false); }));
    pieces.push_back(piece<"own/office-chair-head", Size{0.67, 0.59, 1.22}>(
        "Office chair with head rest", "office_chair", "Office",
        [](Shaper& s, const Size&) { office_chair(s, leather, chrome, true); }));
    pieces.push_back(piece<"own/filing-cabinet", Size{0.42, 0.637, 1.32}>(
        "Filing cabinet", "filing_cabinet", "Office", [](Shaper& s, const Size& size) { filing_cabinet(s, size); },
        {.top = 1.32}));
    pieces.push_back(piece<"own/whiteboard", Size{1.6, 0.1, 1.1}>(
        "Whiteboard", "whiteboard", "Office", [](Shaper& s, const Size& size) { whiteboard(s, size); },
        {.elevation = 0.9}));
    pieces.push_back(piece<"own/meeting-table", Size{2.6, 1.2, 0.74}>(
        "Meeting table", "meeting_table", "Office", [](Shaper& s, const Size& size) { meeting_table(s, size); },
        {.top = 0.74}));
    pieces.push_back(piece<"own/reception-desk", Size{2.0, 0.85, 1.1}>(
        "Reception desk", "reception_desk", "Office", [](Shaper& s, const Size& size) { reception_desk(s, size); }));
    pieces.push_back(piece<"own/locker", Size{0.92, 0.5, 1.8}>("Lockers", "locker", "Office",
                                                               [](Shaper& s, const Size& size) { locker(s, size); }));
    pieces.push_back(piece<"own/bin", Size{0.276, 0.276, 0.302}>("Waste bin", "bin", "Office",
                                                                 [](Shaper& s, const Size&) { bin(s); }));
    pieces.push_back(piece<"own/box", Size{0.5, 0.36, 0.32}>(
        "Cardboard box", "box", "Office", [](Shaper& s, const Size& size) { cardboard_box(s, size); }, {.top = 0.32}));
}

}  // namespace enfilade::modeler::own
