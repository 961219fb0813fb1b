// Beds: the head is at +y, the foot at -y.

#include <algorithm>

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

/// Cloth over a mattress: over the sides it hangs in folds.
struct Drape {
    double half_width;  ///< of what it lies on
    double from_y, to_y;
    double top;  ///< z of what it lies on
    double drop;
    double thickness;
    double seed = 0;

    /// A point of its outside: u from -1 (left hem) to 1, v from 0 (from_y) to 1.
    [[nodiscard]] Vec at(double u, double v, double inset) const {
        const double y = mix(from_y, to_y, v), girth = half_width + drop;
        const double way = std::abs(u) * girth, sign = u < 0 ? -1 : 1;
        const double over = half_width + thickness - inset, radius = 0.05;
        const double fold = std::sin(31 * y + seed + sign) * 0.6 + std::sin(17 * y + 2 * seed) * 0.4;
        const double wrinkle = 0.004 * (std::sin(9 * y + 5 * u + seed) + std::sin(6 * u - 7 * y + 3 * seed));
        const double level = top + thickness - inset;
        if (way < over - radius) return {sign * way, y, level + wrinkle * std::min(1.0, 8 * (over - radius - way))};
        const double arc = radius * pi / 2, along = way - (over - radius);
        if (along < arc) {
            const double angle = along / radius;
            return {sign * (over - radius + radius * std::sin(angle)), y, level - radius * (1 - std::cos(angle))};
        }
        const double down = along - arc, share = std::min(1.0, down / 0.2);
        return {sign * (over + 0.012 * share * (fold + 0.6)), y, level - radius - down};
    }
};

void lay(Shaper& s, const Drape& drape, const Paint& cloth) {
    const int rows = s.fine(std::max(3, static_cast<int>((drape.to_y - drape.from_y) / 0.11))), columns = s.fine(22);
    std::vector<Ring> rings;
    for (int k = 0; k <= rows; ++k) {
        const double v = static_cast<double>(k) / rows;
        const bool is_end = k == 0 || k == rows;
        Ring& ring = rings.emplace_back();
        const double thin = is_end ? 0.35 * drape.thickness : 0;  // the hems are thinner
        for (int i = 0; i <= columns; ++i) ring.push_back(drape.at(2.0 * i / columns - 1, v, thin));
        for (int i = columns; i >= 0; --i) {
            ring.push_back(drape.at(2.0 * i / columns - 1, v, drape.thickness - thin));
        }
    }
    s.skin(rings, cloth);
}

/// Seams across a drape, at detail 2 and more.
void quilt(Shaper& s, const Drape& drape, int seams, const Paint& thread) {
    if (s.detail() < 2) return;
    const int columns = s.fine(22);
    for (int k = 1; k < seams; ++k) {
        std::vector<Vec> path;
        for (int i = 1; i < columns; ++i) {
            path.push_back(drape.at(2.0 * i / columns - 1, static_cast<double>(k) / seams, 0) + Vec{0, 0, 0.0005});
        }
        tube(s, path, 0.0025, thread, 4);
    }
}

struct Bedding {
    const Paint& sheet = cotton;
    const Paint& cover = linen;
    const Paint& blanket = petrol;
    const Paint& accent = mustard;
};

/// Mattress, duvet turned back, folded blanket at the foot, pillows: over [-x, x] x [from_y, to_y], from z = base.
void make_bed(Shaper& s, double x, double from_y, double to_y, double base, int pillows, const Bedding& look) {
    const double thick = 0.2, top = base + thick, length_y = to_y - from_y;
    block(s, {-x, from_y, base}, {x, to_y, top}, look.sheet, 0.045);
    if (s.detail() > 1) {
        for (const double z : {base + 0.03, top - 0.03}) {
            tube(s,
                 rounded_rectangle({0, (from_y + to_y) / 2, z}, x + 0.001, length_y / 2 + 0.001, 0.05, s.fine(3),
                                   s.fine(6)),
                 0.005, look.sheet, 6, Ends::Looped);
        }
    }
    const Drape duvet{x, from_y - 0.015, to_y - 0.62, top, 0.19, 0.05, 1.0};
    lay(s, duvet, look.cover);
    quilt(s, duvet, 12, look.cover);
    // Its upper end, turned back.
    lay(s, {x + 0.012, to_y - 0.84, to_y - 0.60, top + 0.045, 0.16, 0.022, 2.2}, look.sheet);
    const Drape blanket{x + 0.014, from_y + 0.12, from_y + 0.58, top + 0.047, 0.2, 0.02, 0.4};
    lay(s, blanket, look.blanket);
    quilt(s, blanket, 10, look.accent);
    const double step = 2 * x / pillows;
    for (int k = 0; k < pillows; ++k) {
        const double middle = -x + (k + 0.5) * step;
        {
            const auto scope = s.inside(move(middle, to_y - 0.19, top + 0.11) * turn_x(38));
            pillow(s, {}, {std::min(0.36, step * 0.46), 0.23, 0.085}, look.sheet);
        }
        const auto scope = s.inside(move(middle, to_y - 0.32, top + 0.13) * turn_x(42) * turn_z(k % 2 == 0 ? 2 : -3));
        pillow(s, {}, {std::min(0.33, step * 0.43), 0.21, 0.075}, look.cover);
    }
    if (pillows < 2) return;
    const auto scope = s.inside(move(0.04, to_y - 0.47, top + 0.14) * turn_x(48) * turn_z(4));
    pillow(s, {}, {0.24, 0.17, 0.06}, look.accent);
}

void wooden_bed(Shaper& s, const Size& size, const Paint& wood, const Bedding& look) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    for (const double side : both) {
        block(s, {side > 0 ? x - 0.03 : -x, -y + 0.02, 0.2}, {side > 0 ? x : -x + 0.03, y - 0.02, 0.34}, wood, 0.006);
        post(s, {side * (x - 0.045), y - 0.055, 0}, {side * (x - 0.035), y - 0.025, h}, {0.022, 0.02, 0},
             {0.026, 0.022, 0}, wood, 0.008);
        post(s, {side * (x - 0.045), -y + 0.045, 0}, {side * (x - 0.035), -y + 0.035, 0.42}, {0.022, 0.022, 0},
             {0.027, 0.027, 0}, wood, 0.008);
    }
    block(s, {-x + 0.05, -y + 0.022, 0.2}, {x - 0.05, -y + 0.05, 0.38}, wood, 0.006);
    block(s, {-x + 0.05, y - 0.05, 0.2}, {x - 0.05, y - 0.022, 0.34}, wood, 0.006);
    for (const double z : {0.46, 0.60, 0.74, h - 0.07}) {
        const double half = z > h - 0.1 ? 0.045 : 0.03;
        if (z + half < h) slat(s, {-x + 0.05, y - 0.032, z}, {x - 0.05, y - 0.032, z}, 0.0, half, 0.01, wood);
    }
    make_bed(s, x - 0.045, -y + 0.06, y - 0.06, 0.25, size.width > 1.3 ? 2 : 1, look);
}

/// A padded head in upright channels, a padded frame.
void padded_bed(Shaper& s, const Size& size, const Paint& cloth, const Bedding& look) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x, -y, 0.1}, {x, y - 0.06, 0.33}, cloth, 0.03);
    for (const double side : both) {
        for (const double f : both) {
            rod(s, {side * (x - 0.08), f * (y - 0.1), 0}, {side * (x - 0.1), f * (y - 0.12), 0.12}, 0.016, 0.024, oak,
                12);
        }
    }
    block(s, {-x, y - 0.05, 0.1}, {x, y, h - 0.02}, cloth, 0.02);
    const int channels = static_cast<int>(std::lround(size.width / 0.19));
    for (int k = 0; k < channels; ++k) {
        const double middle = -x + (k + 0.5) * 2 * x / channels;
        const auto scope = s.inside(move(middle, y - 0.055, (h + 0.3) / 2) * turn_x(90));
        cushion(s, {}, {x / channels, (h - 0.3) / 2, 0.05}, 0.03, 0.5, cloth);
    }
    make_bed(s, x - 0.05, -y + 0.05, y - 0.1, 0.27, 2, look);
}

void bunk_bed(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2;
    for (const double sx : both) {
        for (const double sy : both) {
            block(s, {sx * (x - 0.03) - 0.03, sy * (y - 0.03) - 0.03, 0},
                  {sx * (x - 0.03) + 0.03, sy * (y - 0.03) + 0.03, size.height}, birch, 0.008);
        }
    }
    for (const double base : {0.26, 1.18}) {
        for (const double side : both) {
            block(s, {side * (x - 0.03) - 0.012, -y + 0.05, base - 0.07},
                  {side * (x - 0.03) + 0.012, y - 0.05, base + 0.06}, birch, 0.004);
            block(s, {-x + 0.05, side * (y - 0.03) - 0.012, base - 0.07},
                  {x - 0.05, side * (y - 0.03) + 0.012, base + 0.06}, birch, 0.004);
            for (const double z : {base + 0.2, base + 0.33}) {  // heads, and the fall guard above
                block(s, {-x + 0.05, side * (y - 0.03) - 0.01, z - 0.03},
                      {x - 0.05, side * (y - 0.03) + 0.01, z + 0.03}, birch, 0.004);
                if (base > 1 && (side < 0 || z > 0)) {
                    block(s, {side * (x - 0.03) - 0.01, (side > 0 ? -y + 0.55 : -y + 0.05), z - 0.03},
                          {side * (x - 0.03) + 0.01, y - 0.05, z + 0.03}, birch, 0.004);
                }
            }
        }
        block(s, {-x + 0.04, -y + 0.05, base - 0.05}, {x - 0.04, y - 0.05, base - 0.03}, birch, 0);
        const bool is_low = base < 1;
        make_bed(s, x - 0.06, -y + 0.07, y - 0.07, base - 0.03, 1,
                 {.cover = is_low ? sage : rose, .blanket = is_low ? linen : navy, .accent = cotton});
    }
    // The ladder, on the right side at the foot.
    for (const double at : {-y + 0.1, -y + 0.5}) block(s, {x - 0.025, at - 0.02, 0}, {x, at + 0.02, 1.5}, birch, 0.004);
    for (int k = 0; k < 5; ++k) {
        const double z = 0.25 + 0.24 * k;
        rod(s, {x - 0.0125, -y + 0.11, z}, {x - 0.0125, -y + 0.49, z}, 0.014, 0.014, birch, 10);
    }
}

void cot(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    for (const double sx : both) {
        for (const double sy : both) {
            post(s, {sx * (x - 0.025), sy * (y - 0.025), 0}, {sx * (x - 0.025), sy * (y - 0.025), h - 0.01},
                 {0.018, 0.018, 0}, {0.024, 0.024, 0}, white, 0.006);
            ball(s, {sx * (x - 0.025), sy * (y - 0.025), h - 0.01}, {0.02, 0.02, 0.01}, white, 12);
        }
        for (const double z : {0.3, h - 0.05}) {
            block(s, {sx * (x - 0.025) - 0.011, -y + 0.03, z - 0.02}, {sx * (x - 0.025) + 0.011, y - 0.03, z + 0.02},
                  white, 0.005);
            block(s, {-x + 0.03, sx * (y - 0.025) - 0.011, z - 0.02}, {x - 0.03, sx * (y - 0.025) + 0.011, z + 0.02},
                  white, 0.005);
        }
        for (int k = 0; k < 13; ++k) {
            const double at = mix(-y + 0.09, y - 0.09, k / 12.0);
            rod(s, {sx * (x - 0.025), at, 0.31}, {sx * (x - 0.025), at, h - 0.06}, 0.007, 0.007, white, 8);
        }
        for (int k = 0; k < 6; ++k) {
            const double at = mix(-x + 0.09, x - 0.09, k / 5.0);
            rod(s, {at, sx * (y - 0.025), 0.31}, {at, sx * (y - 0.025), h - 0.06}, 0.007, 0.007, white, 8);
        }
    }
    block(s, {-x + 0.04, -y + 0.04, 0.3}, {x - 0.04, y - 0.04, 0.43}, cotton, 0.025);
    lay(s, {x - 0.05, -y + 0.05, y - 0.45, 0.43, 0.03, 0.018, 0.7}, sage);
    const auto scope = s.inside(move(0, y - 0.22, 0.46));
    pillow(s, {}, {0.17, 0.12, 0.04}, cotton);
}

}  // namespace

void add_beds(Pieces& pieces) {
    pieces.push_back(
        piece<"own/bed", Size{1.01, 2.07, 0.92}>("Single bed, oak", "bed", "Beds", [](Shaper& s, const Size& size) {
            wooden_bed(s, size, oak, {.cover = sage, .blanket = linen, .accent = cotton});
        }));
    pieces.push_back(
        piece<"own/bed-walnut", Size{1.23, 2.09, 0.95}>("Bed, walnut", "bed", "Beds", [](Shaper& s, const Size& size) {
            wooden_bed(s, size, walnut, {.cover = off_white, .blanket = terracotta_cloth, .accent = mustard});
        }));
    pieces.push_back(piece<"own/double-bed", Size{1.76, 2.14, 1.1}>(
        "Double bed, padded", "double_bed", "Beds", [](Shaper& s, const Size& size) {
            padded_bed(s, size, wool, {.cover = linen, .blanket = petrol, .accent = mustard});
        }));
    pieces.push_back(piece<"own/double-bed-oak", Size{1.69, 2.11, 0.98}>(
        "Double bed, oak", "double_bed", "Beds", [](Shaper& s, const Size& size) {
            wooden_bed(s, size, oak, {.cover = cotton, .blanket = navy, .accent = rose});
        }));
    pieces.push_back(piece<"own/bunk-bed", Size{1.02, 2.08, 1.72}>(
        "Bunk bed", "bunk_bed", "Beds", [](Shaper& s, const Size& size) { bunk_bed(s, size); }));
    pieces.push_back(piece<"own/cot", Size{0.7, 1.32, 0.92}>("Cot", "cot", "Beds",
                                                             [](Shaper& s, const Size& size) { cot(s, size); }));
}

}  // namespace enfilade::modeler::own
