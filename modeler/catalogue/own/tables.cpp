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

}  // namespace

void add_tables(Pieces& pieces) {
    pieces.push_back(piece<"own/dining-table", Size{1.6, 0.9, 0.75}>(
        "Dining table", "dining_table", "Tables",
        [](Shaper& s, const Size& size) { four_legged(s, size, oak, oak, 0.032); }, {.top = 0.75}));
    pieces.push_back(piece<"own/coffee-table", Size{1.1, 0.6, 0.42}>(
        "Coffee table", "coffee_table", "Tables",
        [](Shaper& s, const Size& size) { four_legged(s, size, walnut, walnut, 0.028); }, {.top = 0.42}));
}

}  // namespace enfilade::modeler::own
