// Screens and machines: they look towards -y.

#include <iterator>

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"
#include "plans/random.h"

namespace enfilade::modeler::own {
namespace {

void tv(Shaper& s, const Size& size) {
    const double x = size.width / 2, h = size.height;
    block(s, {-x, -0.012, 0.055}, {x, 0.016, h}, black, 0.005);
    block(s, {-x + 0.008, -0.0128, 0.07}, {x - 0.008, -0.01, h - 0.008}, screen, 0.0005);
    block(s, {-0.5 * x, 0.01, 0.14}, {0.5 * x, 0.045, 0.5 * h}, charcoal, 0.012);
    block(s, {-0.02, -0.0135, 0.058}, {0.02, -0.011, 0.066}, steel, 0.0008);
    for (const double side : both) {
        for (const double f : both)
            rod(s, {side * 0.62 * x, f * 0.11, 0.006}, {side * 0.58 * x, 0, 0.075}, 0.006, 0.009, charcoal, 10);
    }
}

/// Keys in rows that taper upwards.
void keyboard(Shaper& s, Vec at, double width) {
    const auto scope = s.inside(move(at.x, at.y, at.z) * turn_x(3));
    block(s, {-width / 2, -0.065, 0.002}, {width / 2, 0.065, 0.014}, light_grey, 0.004);
    const double pitch = (width - 0.02) / 15;
    const auto key = [&](double x, double y, double wide, const Paint& paint) {
        const double half = wide * pitch / 2 - 0.0012, deep = 0.0085;
        post(s, {x, y, 0.013}, {x, y, 0.02}, {half, deep, 0}, {half - 0.0014, deep - 0.0014, 0}, paint,
             s.detail() > 1 ? 0.0011 : 0);
    };
    for (int row = 0; row < 5; ++row) {
        const double y = 0.048 - 0.0215 * row;
        double from = -7.5;
        const double first = row == 2 ? 1.5 : row == 3 ? 2.0 : 1.0;
        for (int k = 0; from < 7.4; ++k) {
            double wide = k == 0 ? first : 1.0;
            if (row == 4 && k == 3) wide = 6;
            if (from + wide > 6.4) wide = 7.5 - from;
            key((from + wide / 2) * pitch, y, wide, k == 0 || from + wide > 7.4 ? grey : white);
            from += wide;
        }
    }
}

void computer(Shaper& s) {
    // The monitor on its foot.
    const double back = 0.13;
    {
        const auto scope = s.inside(move(0, back, 0.3) * turn_x(-4));
        block(s, {-0.3, -0.012, -0.17}, {0.3, 0.012, 0.18}, charcoal, 0.006);
        block(s, {-0.294, -0.0125, -0.155}, {0.294, -0.011, 0.174}, screen, 0);
        block(s, {-0.14, 0.008, -0.1}, {0.14, 0.032, 0.1}, charcoal, 0.01);
        // What is on the screen: two windows with lines.
        block(s, {-0.27, -0.0131, -0.12}, {0.02, -0.012, 0.15}, deep_blue, 0);
        block(s, {0.05, -0.0131, -0.06}, {0.27, -0.012, 0.15}, off_white, 0);
        plans::Random random({0xC0DEu});
        const Paint* inks[] = {&sage, &mustard, &off_white, &rose};
        for (int k = 0; k < 11; ++k) {
            const double z = 0.13 - 0.022 * k, from = -0.255 + 0.02 * random.below(3);
            block(s, {from, -0.0136, z - 0.005}, {from + random.uniform(0.04, 0.2), -0.0125, z + 0.002},
                  *inks[random.below(4)], 0);
        }
        for (int k = 0; k < 5; ++k) {
            block(s, {0.07 + 0.038 * k, -0.0136, -0.04}, {0.095 + 0.038 * k, -0.0125, -0.02 + 0.03 * (1 + (k * 3) % 5)},
                  k % 2 == 0 ? petrol : mustard, 0);
        }
    }
    rod(s, {0, back + 0.04, 0.008}, {0, back + 0.02, 0.26}, 0.016, 0.014, steel, 14);
    block(s, {-0.11, back - 0.06, 0}, {0.11, back + 0.1, 0.009}, steel, 0.004);
    keyboard(s, {-0.02, -0.135, 0}, 0.43);
    {  // the mouse on its mat
        block(s, {0.22, -0.22, 0}, {0.38, -0.03, 0.002}, dark_wool, 0.0005);
        const auto scope = s.inside(move(0.3, -0.13, 0.012));
        ball(s, {0, 0, 0}, {0.03, 0.05, 0.018}, white, 18);
        const auto wheel = s.inside(move(-0.004, -0.028, 0.012) * turn_y(90));
        drum(s, {}, 0.007, 0.008, charcoal, 0.002, 12);
    }
}

void laptop(Shaper& s) {
    block(s, {-0.16, -0.11, 0.004}, {0.16, 0.11, 0.017}, steel, 0.004);
    for (const double side : both)
        for (const double f : both) drum(s, {side * 0.14, f * 0.09, 0}, 0.008, 0.005, rubber, 0.001, 10);
    block(s, {-0.05, -0.1, 0.0165}, {0.05, -0.035, 0.0173}, light_grey, 0.0003);
    for (int row = 0; row < 5; ++row) {
        for (int k = 0; k < 13; ++k) {
            const double x = -0.138 + 0.023 * k, y = 0.085 - 0.0215 * row;
            if (row == 4 && k > 3 && k < 9) {
                if (k == 6)
                    block(s, {-0.0555, y - 0.009, 0.0165}, {0.0555, y + 0.009, 0.0182}, charcoal,
                          s.detail() > 1 ? 0.0008 : 0);
                continue;
            }
            block(s, {x - 0.01, y - 0.009, 0.0165}, {x + 0.01, y + 0.009, 0.0182}, charcoal,
                  s.detail() > 1 ? 0.0008 : 0);
        }
    }
    const auto scope = s.inside(move(0, 0.112, 0.014) * turn_x(-18));
    block(s, {-0.16, -0.003, 0}, {0.16, 0.004, 0.215}, steel, 0.003);
    block(s, {-0.154, -0.0036, 0.012}, {0.154, -0.002, 0.209}, screen, 0);
    block(s, {-0.13, -0.0041, 0.04}, {0.06, -0.003, 0.185}, off_white, 0);
    for (int k = 0; k < 7; ++k)
        block(s, {-0.115, -0.0046, 0.165 - 0.017 * k}, {0.03 - 0.02 * ((k * 2) % 3), -0.0036, 0.17 - 0.017 * k},
              k == 0 ? petrol : grey, 0);
    block(s, {0.08, -0.0041, 0.11}, {0.13, -0.003, 0.185}, mustard, 0);
}

void printer(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    block(s, {-x, -y + 0.06, 0.008}, {x, y - 0.03, 0.17}, off_white, 0.014);
    block(s, {-x + 0.012, -y + 0.075, 0.165}, {x - 0.012, y - 0.06, 0.215}, charcoal, 0.012);
    block(s, {-x + 0.02, -y + 0.09, 0.21}, {x - 0.02, y - 0.06, 0.228}, off_white, 0.006);
    for (const double side : both)
        for (const double f : both) drum(s, {side * (x - 0.05), f * (y - 0.11), 0}, 0.014, 0.01, rubber, 0.002, 12);
    block(s, {-0.15, -y + 0.057, 0.06}, {0.15, -y + 0.07, 0.12}, black, 0.002);
    block(s, {-0.12, -y, 0.058}, {0.12, -y + 0.09, 0.066}, charcoal, 0.002);
    block(s, {-0.105, -y + 0.005, 0.067}, {0.105, -y + 0.09, 0.07}, paper, 0);
    block(s, {x - 0.14, -y + 0.056, 0.125}, {x - 0.03, -y + 0.064, 0.155}, screen, 0.002);
    const auto scope = s.inside(move(0, y - 0.055, 0.2) * turn_x(-20));
    block(s, {-0.12, 0, 0}, {0.12, 0.008, h - 0.2}, charcoal, 0.003);
    block(s, {-0.105, -0.006, 0}, {0.105, -0.001, h - 0.19}, paper, 0);
}

void server_rack(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height, face = -y + 0.05;
    for (const double side : both) {
        for (const double f : both)
            block(s, {side * (x - 0.025) - 0.025, f * (y - 0.025) - 0.025, 0.03},
                  {side * (x - 0.025) + 0.025, f * (y - 0.025) + 0.025, h - 0.03}, charcoal, 0.004);
        block(s, {side * (x - 0.006) - 0.005, -y + 0.05, 0.05}, {side * (x - 0.006) + 0.005, y - 0.05, h - 0.05},
              charcoal, 0);
    }
    block(s, {-x, -y, h - 0.035}, {x, y, h}, charcoal, 0.005);
    block(s, {-x, -y, 0.03}, {x, y, 0.065}, charcoal, 0.005);
    for (const double side : both)
        for (const double f : both) drum(s, {side * (x - 0.07), f * (y - 0.09), 0}, 0.025, 0.031, black, 0.004, 14);
    plans::Random random({0x5E7Fu});
    double z = 0.09;
    while (z < h - 0.16) {
        const int units = 1 + static_cast<int>(random.below(3));
        const double high = 0.0445 * units;
        const bool is_empty = random.chance(0.12);
        if (!is_empty) {
            block(s, {-x + 0.055, face, z}, {x - 0.055, y - 0.12, z + high - 0.003}, units == 2 ? grey : black, 0.001);
            for (const double side : both)
                bar_handle(s, {side * (x - 0.075), face, z + high / 2}, 0.8 * high, true, steel);
            const int slots = s.detail() == 1 ? 6 : 12;
            for (int k = 0; k < slots; ++k) {  // bays and lights
                const double at = mix(-x + 0.1, x - 0.13, static_cast<double>(k) / (slots - 1));
                block(s, {at - 0.01, face - 0.003, z + 0.008}, {at + 0.012, face + 0.001, z + high - 0.012}, charcoal,
                      s.detail() > 2 ? 0.001 : 0);
                block(s, {at - 0.004, face - 0.0038, z + 0.012}, {at, face - 0.0025, z + 0.016},
                      random.chance(0.75) ? sage : mustard, 0);
            }
        }
        for (const double side : both) screw(s, {side * (x - 0.062), face, z + high / 2}, chrome);
        z += high;
    }
}

/// A bag of crisps, upright.
void pillow_bag(Shaper& s, const Paint& paint) {
    const auto scope = s.inside(move(0, 0, 0.085) * turn_x(86));
    pillow(s, {}, {0.045, 0.085, 0.03}, paint);
}

void vending_machine(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height, face = -y + 0.03, right = x - 0.26;
    // A case around a lit niche; the pane is left out, so that one sees in.
    block(s, {-x, face, 0.06}, {x, y, 0.5}, deep_blue, 0.004);
    block(s, {-x, face, h - 0.16}, {x, y, h}, deep_blue, 0.012);
    block(s, {-x, face, 0.5}, {-x + 0.05, y, h - 0.16}, deep_blue, 0.002);
    block(s, {right, face, 0.5}, {x, y, h - 0.16}, deep_blue, 0.002);
    block(s, {-x + 0.05, y - 0.05, 0.5}, {right, y, h - 0.16}, deep_blue, 0.002);
    block(s, {-x + 0.05, y - 0.12, 0.5}, {right, y - 0.05, h - 0.16}, off_white, 0);
    block(s, {-x + 0.02, face + 0.03, 0}, {x - 0.02, y - 0.03, 0.061}, black, 0);
    block(s, {-x + 0.03, face - 0.006, 0.5 - 0.02}, {right + 0.02, face + 0.004, 0.51}, steel, 0.002);
    plans::Random random({0x7E1Du});
    const Paint* goods[] = {&book_covers[0], &mustard, &petrol, &sage, &book_covers[3], &cotton};
    const double step = (h - 0.68) / 5;
    for (int row = 0; row < 5; ++row) {
        const double z = 0.5 + step * row;
        block(s, {-x + 0.05, face + 0.05, z}, {right, y - 0.12, z + 0.012}, steel, 0.001);
        block(s, {-x + 0.05, face + 0.042, z - 0.012}, {right, face + 0.051, z + 0.02}, charcoal, 0.001);
        for (int k = 0; k < 6; ++k) {
            const double at = mix(-x + 0.1, right - 0.05, k / 5.0);
            const Paint& paint = *goods[(row * 2 + k + static_cast<int>(random.below(2))) % std::size(goods)];
            for (int deep = 0; deep < (row < 4 ? 2 : 1); ++deep) {
                const auto scope = s.inside(move(at, face + 0.1 + 0.09 * deep, z + 0.013));
                if (row < 2) {  // cans
                    const Vec can[] = {{0, 0, 0},        {0.024, 0, 0},     {0.03, 0, 0.006},
                                       {0.03, 0, 0.104}, {0.025, 0, 0.115}, {0, 0, 0.113}};
                    lathe(s, can, paint, 9);
                } else if (row < 4) {  // bottles
                    const Vec bottle[] = {{0, 0, 0},         {0.028, 0, 0},    {0.03, 0, 0.01}, {0.029, 0, 0.11},
                                          {0.012, 0, 0.155}, {0.012, 0, 0.18}, {0, 0, 0.18}};
                    lathe(s, bottle, paint, 9);
                } else {
                    pillow_bag(s, paint);
                }
            }
            block(s, {at - 0.02, face + 0.0405, z - 0.006}, {at + 0.02, face + 0.043, z + 0.012}, white, 0);
        }
    }
    block(s, {right + 0.04, face - 0.006, 1.15}, {x - 0.05, face + 0.001, 1.3}, screen, 0.003);
    for (int k = 0; k < 12; ++k) {
        const double at = right + 0.07 + 0.045 * (k % 3), z = 1.08 - 0.04 * (k / 3);
        block(s, {at, face - 0.006, z - 0.012}, {at + 0.03, face + 0.001, z + 0.012}, light_grey, 0.003);
    }
    block(s, {right + 0.08, face - 0.008, 0.8}, {x - 0.09, face + 0.001, 0.87}, steel, 0.003);
    block(s, {right + 0.07, face - 0.02, 0.62}, {x - 0.08, face + 0.001, 0.7}, black, 0.006);
    block(s, {-x + 0.1, face - 0.012, 0.2}, {right - 0.03, face + 0.001, 0.38}, black, 0.006);
    block(s, {-x + 0.05, face - 0.003, h - 0.13}, {x - 0.05, face + 0.001, h - 0.04}, off_white, 0.003);
}

}  // namespace

void add_electronics(Pieces& pieces) {
    pieces.push_back(piece<"own/tv", Size{1.23, 0.233, 0.76}>("Television", "tv", "Electronics",
                                                              [](Shaper& s, const Size& size) { tv(s, size); }));
    pieces.push_back(piece<"own/computer", Size{0.68, 0.45, 0.48}>("Computer", "computer", "Electronics",
                                                                   [](Shaper& s, const Size&) { computer(s); }));
    pieces.push_back(piece<"own/computer-laptop", Size{0.32, 0.29, 0.22}>("Laptop", "computer", "Electronics",
                                                                          [](Shaper& s, const Size&) { laptop(s); }));
    pieces.push_back(piece<"own/printer", Size{0.44, 0.42, 0.36}>(
        "Printer", "printer", "Electronics", [](Shaper& s, const Size& size) { printer(s, size); }));
    pieces.push_back(piece<"own/server-rack", Size{0.6, 1.0, 2.0}>(
        "Server rack", "server_rack", "Electronics", [](Shaper& s, const Size& size) { server_rack(s, size); }));
    pieces.push_back(piece<"own/vending-machine", Size{0.95, 0.8, 1.83}>(
        "Vending machine", "vending_machine", "Electronics",
        [](Shaper& s, const Size& size) { vending_machine(s, size); }));
}

}  // namespace enfilade::modeler::own
