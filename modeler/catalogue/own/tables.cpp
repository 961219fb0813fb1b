// Tables: people sit at their long sides; things stand on their tops.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {
namespace {

/// Four tapered legs that splay, an apron, a top.
void four_legged(Shaper& s, const Size& size, const Paint& wood, const Paint& top, double thickness) {
    const double x = size.width / 2, y = size.depth / 2, under = size.height - thickness;
    block(s, {-x, -y, under}, {x, y, size.height}, top, 0.007);
    const double inset = std::min(0.09, 0.16 * size.depth), foot = 0.45 * inset;
    for (const double side : {-1.0, 1.0}) {
        for (const double front : {-1.0, 1.0}) {
            post(s, {side * (x - foot), front * (y - foot), 0}, {side * (x - inset), front * (y - inset), under},
                 {0.016, 0.016, 0}, {0.03, 0.03, 0}, wood, 0.008);
        }
        const double apron = std::min(0.08, 0.14 * size.height);
        block(s, {side * (x - inset) - 0.011, -y + inset, under - apron},
              {side * (x - inset) + 0.011, y - inset, under}, wood, 0.002);
        block(s, {-x + inset, side * (y - inset) - 0.011, under - apron},
              {x - inset, side * (y - inset) + 0.011, under}, wood, 0.002);
    }
}

/// A round top on one foot of three arms.
void round_table(Shaper& s, const Size& size, const Paint& top, const Paint& metal) {
    const double r = size.width / 2, h = size.height;
    drum(s, {0, 0, h - 0.026}, r, 0.026, top, 0.006, 56);
    const Vec foot[] = {{0, 0, 0},           {0.28, 0, 0},         {0.285, 0, 0.006}, {0.27, 0, 0.014}, {0.12, 0, 0.03},
                        {0.055, 0, 0.07},    {0.036, 0, 0.16},     {0.032, 0, 0.4},   {0.036, 0, 0.58}, {0.07, 0, 0.67},
                        {0.16, 0, h - 0.03}, {0.16, 0, h - 0.026}, {0, 0, h - 0.026}};
    lathe(s, foot, metal, 36);
}

/// A round top on four splayed legs, with a ring under it.
void round_wooden(Shaper& s, const Size& size, const Paint& wood) {
    const double r = size.width / 2, h = size.height;
    drum(s, {0, 0, h - 0.03}, r, 0.03, wood, 0.009, 56);
    drum(s, {0, 0, h - 0.095}, 0.62 * r, 0.066, wood, 0.003, 40);
    for (int k = 0; k < 4; ++k) {
        const auto scope = s.inside(turn_z(45 + 90 * k));
        rod(s, {0.86 * r, 0, 0}, {0.55 * r, 0, h - 0.035}, 0.014, 0.026, wood, 16);
    }
}

/// A top on two trestles.
void trestle_table(Shaper& s, const Size& size, const Paint& wood, const Paint& legs) {
    const double x = size.width / 2, y = size.depth / 2, h = size.height;
    const int boards = 5;
    for (int k = 0; k < boards; ++k) {
        const double y0 = -y + 2 * y * k / boards;
        block(s, {-x + 0.07, y0 + 0.0007, h - 0.04}, {x - 0.07, y0 + 2 * y / boards - 0.0007, h}, wood, 0.003);
    }
    for (const double side : {-1.0, 1.0}) {
        block(s, {side > 0 ? x - 0.0695 : -x, -y, h - 0.04}, {side > 0 ? x : -x + 0.0695, y, h}, wood, 0.003);
        const double at = side * (x - 0.28);
        for (const double f : {-1.0, 1.0}) {
            post(s, {at, f * (y - 0.07), 0}, {at, f * 0.1, h - 0.1}, {0.028, 0.035, 0}, {0.028, 0.035, 0}, legs, 0.006);
        }
        block(s, {at - 0.026, -y + 0.09, h - 0.1}, {at + 0.026, y - 0.09, h - 0.04}, legs, 0.005);
        block(s, {at - 0.022, -0.24, 0.22}, {at + 0.022, 0.24, 0.28}, legs, 0.005);
    }
    block(s, {-x + 0.22, -0.018, 0.28}, {x - 0.22, 0.018, 0.34}, legs, 0.004);
}

/// Two tiers: a board near the floor with magazines.
void tiered_table(Shaper& s, const Size& size) {
    const double r = size.width / 2, h = size.height;
    drum(s, {0, 0, h - 0.022}, r, 0.022, oak, 0.006, 52);
    drum(s, {0, 0, 0.14}, 0.8 * r, 0.016, oak, 0.005, 44);
    for (int k = 0; k < 3; ++k) {
        const auto scope = s.inside(turn_z(30 + 120 * k));
        rod(s, {0.93 * r, 0, 0}, {0.74 * r, 0, h - 0.02}, 0.013, 0.018, oak, 14);
    }
    for (int k = 0; k < 3; ++k) {
        const auto scope = s.inside(move(0.02, -0.02, 0.1565 + 0.006 * k) * turn_z(15 - 14 * k));
        block(s, {-0.105, -0.14, 0}, {0.105, 0.14, 0.0055},
              k == 0   ? book_covers[0]
              : k == 1 ? paper
                       : book_covers[7],
              0.001);
    }
}

}  // namespace

void add_tables(Pieces& pieces) {
    pieces.push_back(piece<"own/dining-table", Size{1.6, 0.9, 0.75}>(
        "Dining table", "dining_table", "Tables",
        [](Shaper& s, const Size& size) { four_legged(s, size, oak, oak, 0.032); }, {.top = 0.75}));
    pieces.push_back(piece<"own/coffee-table", Size{1.1, 0.6, 0.42}>(
        "Coffee table", "coffee_table", "Tables",
        [](Shaper& s, const Size& size) { four_legged(s, size, walnut, walnut, 0.028); }, {.top = 0.42}));
    pieces.push_back(piece<"own/coffee-table-round", Size{0.8, 0.8, 0.44}>(
        "Coffee table, round", "coffee_table", "Tables", [](Shaper& s, const Size& size) { tiered_table(s, size); },
        {.top = 0.44}));
    pieces.push_back(piece<"own/dining-table-long", Size{2.0, 0.95, 0.75}>(
        "Dining table, long", "dining_table", "Tables",
        [](Shaper& s, const Size& size) { trestle_table(s, size, walnut, iron); }, {.top = 0.75}));
    pieces.push_back(piece<"own/dining-table-white", Size{1.2, 0.8, 0.74}>(
        "Dining table, white", "dining_table", "Tables",
        [](Shaper& s, const Size& size) { four_legged(s, size, beech, white, 0.026); }, {.top = 0.74}));
    pieces.push_back(piece<"own/round-table", Size{1.1, 1.1, 0.74}>(
        "Round table", "round_table", "Tables", [](Shaper& s, const Size& size) { round_wooden(s, size, oak); },
        {.top = 0.74}));
    pieces.push_back(piece<"own/round-table-small", Size{0.8, 0.8, 0.73}>(
        "Round table, small", "round_table", "Tables",
        [](Shaper& s, const Size& size) { round_table(s, size, marble, iron); }, {.top = 0.73}));
}

}  // namespace enfilade::modeler::own
