// A piano, a bicycle.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

/// 88 keys from x = -width / 2, their fronts at y, their tops at z.
void keys(Shaper& s, double width, double y, double z) {
    const double pitch = width / 52;
    int white_key = 0;
    for (int key = 0; key < 88; ++key) {
        const int note = (key + 9) % 12;  // the lowest is an A
        const bool is_black = note == 1 || note == 3 || note == 6 || note == 8 || note == 10;
        const double x = -width / 2 + white_key * pitch;
        if (is_black) {
            block(s, {x - 0.005, y + 0.05, z}, {x + 0.005, y + 0.145, z + 0.011}, black, s.detail() > 1 ? 0.002 : 0);
        } else {
            block(s, {x + 0.0005, y, z - 0.018}, {x + pitch - 0.0005, y + 0.147, z}, cotton,
                  s.detail() > 1 ? 0.0011 : 0);
            ++white_key;
        }
    }
}

/// An upright piano: whoever plays sits at -y.
void piano(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height, body = 0.02, bed = 0.62;
    block(s, {-x + 0.03, body, 0.06}, {x - 0.03, y, h - 0.03}, black, 0.003);
    block(s, {-x, body - 0.03, h - 0.03}, {x, y, h}, black, 0.006);
    block(s, {-x + 0.06, body - 0.012, 0.14}, {x - 0.06, body, bed - 0.06}, black, 0.006);
    block(s, {-x + 0.06, body - 0.012, bed + 0.14}, {x - 0.06, body, h - 0.06}, black, 0.006);
    block(s, {-x + 0.02, body - 0.02, 0.03}, {x - 0.02, y, 0.1}, black, 0.004);
    for (const double side : both) {
        const double x0 = side > 0 ? x - 0.05 : -x, x1 = side > 0 ? x : -x + 0.05;
        block(s, {x0, body - 0.03, 0.02}, {x1, y, h - 0.03}, black, 0.004);
        block(s, {x0 + 0.003, -y + 0.02, bed - 0.04}, {x1 - 0.003, body, bed + 0.1}, black, 0.014);
        block(s, {x0, -y, 0.02}, {x1, body, 0.09}, black, 0.008);
        post(s, {side * (x - 0.025), -y + 0.06, 0.08}, {side * (x - 0.025), -y + 0.06, bed - 0.03}, {0.02, 0.02, 0},
             {0.024, 0.03, 0}, black, 0.006);
        for (const double at : {-y + 0.04, y - 0.06}) {
            const auto scope = s.inside(move(side * (x - 0.025) - 0.01, at, 0.017) * turn_y(90));
            drum(s, {}, 0.017, 0.02, brass, 0.003, 14);
        }
    }
    block(s, {-x + 0.04, -y + 0.02, bed - 0.045}, {x - 0.04, body, bed - 0.005}, black, 0.004);
    for (const double side : both)
        block(s, {side * (x - 0.09) - 0.045, -y + 0.04, bed - 0.006},
              {side * (x - 0.09) + 0.045, body - 0.03, bed + 0.022}, black, 0.004);
    keys(s, 2 * (x - 0.14), -y + 0.045, bed + 0.018);
    block(s, {-x + 0.135, -y + 0.19, bed + 0.018}, {x - 0.135, -y + 0.194, bed + 0.028}, book_covers[0], 0);
    block(s, {-x + 0.05, body - 0.12, bed + 0.1}, {x - 0.05, body, bed + 0.125}, black, 0.006);
    {  // a stand with music
        const auto scope = s.inside(move(0, body - 0.045, bed + 0.125) * turn_x(-12));
        block(s, {-0.32, -0.006, 0}, {0.32, 0.008, 0.24}, black, 0.004);
        block(s, {-0.32, -0.03, 0}, {0.32, -0.004, 0.01}, black, 0.002);
        for (const double side : both) {
            block(s, {side > 0 ? 0.002 : -0.2, -0.0105, 0.012}, {side > 0 ? 0.2 : -0.002, -0.0065, 0.29}, paper, 0);
            for (int line = 0; line < 6; ++line) {
                for (int k = 0; k < (s.detail() > 1 ? 5 : 2); ++k) {
                    const double z = 0.26 - 0.04 * line - 0.004 * k;
                    block(s, {side * 0.1 - 0.08, -0.0115, z}, {side * 0.1 + 0.08, -0.0103, z + 0.0009}, grey, 0);
                }
            }
        }
    }
    for (int k = -1; k <= 1; ++k) {
        const Vec way[] = {{0.07 * k, body, 0.085}, {0.07 * k, body - 0.05, 0.075}, {0.07 * k, body - 0.11, 0.07}};
        const double thick[] = {0.008, 0.011, 0.016};
        tube(s, way, thick, brass, 8);
    }
}

/// Rim, tyre, spokes, hub; about the y axis.
void wheel(Shaper& s, Vec hub, double radius) {
    const auto scope = s.inside(move(hub.x, hub.y, hub.z) * turn_x(90));
    const int sides = s.fine(36);
    tube(s, ellipse({}, radius - 0.018, radius - 0.018, sides), 0.018, rubber, 8, Ends::Looped);
    tube(s, ellipse({}, radius - 0.04, radius - 0.04, sides), 0.009, steel, 6, Ends::Looped);
    rod(s, {0, 0, -0.05}, {0, 0, 0.05}, 0.012, 0.012, steel, 10);
    for (const double side : both) {
        drum(s, {0, 0, side * 0.034 - 0.0015}, 0.026, 0.003, steel, 0.001, 16);
        for (int k = 0; k < 14; ++k) {
            const double angle = 2 * pi * (k + (side > 0 ? 0.5 : 0)) / 14, lead = angle + (k % 2 == 0 ? 0.55 : -0.55);
            rod(s, {0.022 * std::cos(lead), 0.022 * std::sin(lead), side * 0.033},
                {(radius - 0.042) * std::cos(angle), (radius - 0.042) * std::sin(angle), side * 0.003}, 0.0011, 0.0011,
                chrome, 3);
        }
    }
}

// Where a bicycle's parts meet.
constexpr Vec rear{-0.52, 0, 0.34}, fore{0.52, 0, 0.34}, crank{-0.08, 0, 0.29}, seat{-0.24, 0, 0.80},
    head{0.36, 0, 0.86}, neck{0.4, 0, 0.72};
constexpr const Paint& frame = petrol;

void bicycle_frame(Shaper& s) {
    rod(s, crank, seat, 0.016, 0.015, frame, 12);
    rod(s, crank, neck, 0.018, 0.018, frame, 12);
    rod(s, seat - Vec{-0.012, 0, 0.04}, head - Vec{0, 0, 0.04}, 0.015, 0.015, frame, 12);
    rod(s, neck - Vec{-0.012, 0, 0.04}, head + Vec{-0.008, 0, 0.03}, 0.02, 0.02, frame, 12);
    for (const double side : both) {
        const Vec off{0, side * 0.05, 0}, in{0, side * 0.02, 0};
        rod(s, crank + in, rear + off, 0.009, 0.008, frame, 8);
        rod(s, seat + in - Vec{0, 0, 0.05}, rear + off, 0.008, 0.007, frame, 8);
        const Vec fork[] = {neck + in - Vec{-0.01, 0, 0.05}, mix(neck, fore, 0.6) + off + Vec{0.02, 0, 0}, fore + off};
        tube(s, curve(fork, s.fine(4)), 0.009, frame, 8);
        for (const Vec& hub : {rear, fore}) ball(s, hub + 1.1 * off, {0.011, 0.008, 0.011}, steel, 10);
    }
    rod(s, neck + Vec{0.012, -0.025, -0.05}, neck + Vec{0.012, 0.025, -0.05}, 0.016, 0.016, frame, 10);
}

void bicycle_seat_and_bar(Shaper& s) {
    rod(s, seat - Vec{0, 0, 0.02}, seat + Vec{-0.025, 0, 0.12}, 0.012, 0.012, chrome, 12);
    {
        const auto scope = s.inside(move(-0.275, 0, 0.935));
        std::vector<Ring> rings;
        const double line[][3] = {{-0.13, 0.045, 0.012}, {-0.11, 0.078, 0.03}, {-0.05, 0.07, 0.034},
                                  {0.02, 0.035, 0.026},  {0.1, 0.02, 0.022},   {0.135, 0.012, 0.012}};
        std::vector<Vec> points;
        for (const auto& [x, half, high] : line) points.push_back({x, half, high});
        for (const Vec& p : curve(points, s.fine(3))) {
            Ring& ring = rings.emplace_back();
            for (const Vec& q : ellipse({}, p.y, p.z, s.fine(14))) ring.push_back({p.x, q.x, q.y});
        }
        s.skin(rings, leather);
    }
    rod(s, head, head + Vec{-0.02, 0, 0.12}, 0.012, 0.012, chrome, 12);
    const Vec stem_top = head + Vec{-0.02, 0, 0.12};
    const Vec bar[] = {stem_top + Vec{-0.14, -0.28, 0.02}, stem_top + Vec{-0.04, -0.25, 0.04},
                       stem_top + Vec{0.05, -0.12, 0.03},  stem_top + Vec{0.04, 0, 0},
                       stem_top + Vec{0.05, 0.12, 0.03},   stem_top + Vec{-0.04, 0.25, 0.04},
                       stem_top + Vec{-0.14, 0.28, 0.02}};
    tube(s, curve(bar, s.fine(4)), 0.01, chrome, 10);
    rod(s, stem_top, bar[3], 0.012, 0.012, chrome, 10);
    for (const double side : both)
        rod(s, stem_top + Vec{-0.15, side * 0.281, 0.019}, stem_top + Vec{-0.045, side * 0.252, 0.039}, 0.015, 0.015,
            leather, 12);
}

/// Chain ring, cranks, pedals, chain.
void bicycle_drive(Shaper& s) {
    {
        const auto scope = s.inside(move(crank.x, 0, crank.z) * turn_x(90));
        drum(s, {0, 0, 0.045}, 0.088, 0.004, steel, 0.001, 32);
        rod(s, {0, 0, -0.06}, {0, 0, 0.06}, 0.016, 0.016, steel, 12);
        for (const double side : both) {
            const Vec tip{side * 0.155, side * 0.07, side * 0.065};
            rod(s, {0, 0, side * 0.06}, tip, 0.009, 0.008, steel, 8);
            block(s, tip + Vec{-0.045, -0.012, side > 0 ? 0.005 : -0.095},
                  tip + Vec{0.045, 0.012, side > 0 ? 0.095 : -0.005}, rubber, 0.006);
        }
    }
    for (const double side : both) {
        rod(s, crank + Vec{0, -0.047, side * 0.085}, rear + Vec{0, -0.047, side * 0.034}, 0.004, 0.004, iron, 6);
    }
    {
        const auto scope = s.inside(move(rear.x, -0.047, rear.z) * turn_x(90));
        drum(s, {0, 0, -0.004}, 0.036, 0.008, iron, 0.001, 20);
    }
}

/// Mudguards, and a stand, so that it stands.
void bicycle_guards(Shaper& s) {
    for (const Vec& hub : {rear, fore}) {
        const int steps = s.fine(12);
        std::vector<Ring> rings;
        const double from = hub.x < 0 ? 35 : 40, to = hub.x < 0 ? 195 : 175;
        for (int k = 0; k <= steps; ++k) {
            const double angle = degrees(mix(from, to, static_cast<double>(k) / steps));
            const Vec out{std::cos(angle), 0, std::sin(angle)};
            const auto at = [&](double r, double y) { return hub + r * out + Vec{0, y, 0}; };
            rings.push_back({at(0.356, -0.028), at(0.362, -0.014), at(0.364, 0.0), at(0.362, 0.014), at(0.356, 0.028),
                             at(0.36, 0.014), at(0.362, 0.0), at(0.36, -0.014)});
        }
        s.skin(rings, frame);
    }
    rod(s, crank + Vec{-0.06, 0.01, 0.0}, {-0.2, 0.17, 0.006}, 0.008, 0.007, steel, 8);
}

/// Upright, its front wheel to the right (+x).
void bicycle(Shaper& s) {
    wheel(s, rear, 0.34), wheel(s, fore, 0.34);
    bicycle_frame(s);
    bicycle_seat_and_bar(s);
    bicycle_drive(s);
    bicycle_guards(s);
}

}  // namespace

void add_leisure(Pieces& pieces) {
    pieces.push_back(piece<"own/piano", Size{1.5, 0.62, 1.2}>("Piano", "piano", "Leisure",
                                                              [](Shaper& s, const Size& size) { piano(s, size); }));
    pieces.push_back(piece<"own/bicycle", Size{1.74, 0.59, 1.034}>("Bicycle", "bicycle", "Leisure",
                                                                   [](Shaper& s, const Size&) { bicycle(s); }));
}

}  // namespace enfilade::modeler::own
