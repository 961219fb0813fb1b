// Sofas and armchairs: the seat opens towards -y, the back stands at +y.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {
namespace {

/// A cushion with a welt along its seam.
void piped_cushion(Shaper& s, Vec half, double corner, double softness, const Paint& cloth, const Paint& welt) {
    cushion(s, {}, half, corner, softness, cloth);
    tube(s, rounded_rectangle({}, half.x + 0.001, half.y + 0.001, corner, s.fine(4), s.fine(3)), 0.0055, welt, 5,
         Ends::Looped);
}

/// Buttons in rows on a cushion that lies flat, at detail 2 and more.
void buttons(Shaper& s, Vec half, int columns, const Paint& cloth) {
    if (s.detail() < 2) return;
    for (int k = 0; k < columns; ++k) {
        for (const double y : {-0.3, 0.3}) {
            const double x = (2.0 * (k + 0.5) / columns - 1) * 0.75;
            ball(s, {x * half.x, y * half.y, half.z * 0.98}, {0.012, 0.012, 0.006}, cloth, 10);
        }
    }
}

struct SofaLook {
    int seats = 2;
    const Paint& cloth = linen;
    const Paint& welt = linen;
    const Paint& accent = mustard;
    const Paint& wood = oak;
    int pillows = 2;
    bool is_buttoned = false;
};

void sofa(Shaper& s, const Size& size, const SofaLook& look) {
    const double x = size.width / 2, y = size.depth / 2, arm = 0.15, inner = x - arm;
    // Frame and arms.
    block(s, {-x + 0.02, -y + 0.03, 0.13}, {x - 0.02, y - 0.02, 0.30}, look.cloth, 0.02);
    for (const double side : {-1.0, 1.0}) {
        block(s, {side > 0 ? inner : -x, -y + 0.01, 0.125}, {side > 0 ? x : -inner, y - 0.01, 0.60}, look.cloth, 0.055);
        for (const double front : {-1.0, 1.0}) {
            rod(s, {side * (x - 0.06), front * (y - 0.06), 0}, {side * (x - 0.09), front * (y - 0.10), 0.135}, 0.014,
                0.024, look.wood, 12);
        }
    }
    {
        const auto scope = s.inside(move(0, y - 0.12, 0.14) * turn_x(-5));
        block(s, {-inner - 0.02, -0.06, 0.0}, {inner + 0.02, 0.07, size.height - 0.18}, look.cloth, 0.05);
    }
    // Cushions to sit on and to lean on.
    const double step = 2 * inner / look.seats;
    for (int k = 0; k < look.seats; ++k) {
        const double middle = -inner + (k + 0.5) * step;
        const Vec seat{step / 2 - 0.004, (size.depth - 0.24) / 2, 0.085};
        {
            const auto scope = s.inside(move(middle, -y + seat.y + 0.005, 0.375));
            piped_cushion(s, seat, 0.06, 0.34, look.cloth, look.welt);
        }
        const auto scope = s.inside(move(middle, y - 0.245, 0.645) * turn_x(76));
        const Vec back{step / 2 - 0.006, 0.225, 0.085};
        piped_cushion(s, back, 0.08, 0.42, look.cloth, look.welt);
        if (look.is_buttoned) buttons(s, back, 3, look.welt);
    }
    for (int k = 0; k < look.pillows; ++k) {
        const double side = k == 0 ? 1 : -1;
        const auto scope = s.inside(move(side * (inner - 0.19), y - 0.385, 0.655) * turn_z(side * 16) * turn_x(66));
        pillow(s, {}, {0.21, 0.21, 0.07}, k == 0 ? look.accent : look.welt);
    }
}

}  // namespace

void add_sofas(Pieces& pieces) {
    pieces.push_back(
        piece<"own/sofa", Size{1.9, 0.925, 0.875}>("Sofa, two seats", "sofa", "Seats", [](Shaper& s, const Size& size) {
            sofa(s, size, {.seats = 2, .cloth = wool, .welt = dark_wool, .accent = mustard, .wood = oak});
        }));
    pieces.push_back(piece<"own/sofa-large", Size{2.35, 0.955, 0.875}>(
        "Sofa, three seats", "sofa", "Seats", [](Shaper& s, const Size& size) {
            sofa(s, size, {.seats = 3, .cloth = linen, .welt = off_white, .accent = petrol, .wood = walnut});
        }));
    pieces.push_back(piece<"own/sofa-leather", Size{1.7, 0.885, 0.875}>("Leather sofa", "sofa", "Seats",
                                                                        [](Shaper& s, const Size& size) {
                                                                            sofa(s, size,
                                                                                 {.seats = 2,
                                                                                  .cloth = leather,
                                                                                  .welt = leather,
                                                                                  .accent = linen,
                                                                                  .wood = iron,
                                                                                  .pillows = 1,
                                                                                  .is_buttoned = true});
                                                                        }));
    pieces.push_back(piece<"own/armchair", Size{0.86, 0.885, 0.875}>(
        "Armchair", "armchair", "Seats", [](Shaper& s, const Size& size) {
            sofa(s, size,
                 {.seats = 1, .cloth = petrol, .welt = petrol, .wood = oak, .pillows = 0, .is_buttoned = true});
        }));
    pieces.push_back(piece<"own/armchair-rose", Size{0.82, 0.855, 0.875}>(
        "Armchair, rose", "armchair", "Seats", [](Shaper& s, const Size& size) {
            sofa(s, size, {.seats = 1, .cloth = rose, .welt = rose, .accent = linen, .wood = walnut, .pillows = 1});
        }));
}

}  // namespace enfilade::modeler::own
