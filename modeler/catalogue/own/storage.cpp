// What stores things: doors and drawers open towards -y.

#include "modeler/catalogue/own/books.h"
#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/fittings.h"

namespace enfilade::modeler::own {
namespace {

void tapered_feet(Shaper& s, double x, double y, double height, const Paint& wood) {
    for (const double side : both) {
        for (const double front : both) {
            rod(s, {side * x, front * y, 0}, {side * (x - 0.02), front * (y - 0.015), height + 0.004}, 0.011, 0.018,
                wood, 12);
        }
    }
}

struct DrawerLook {
    int rows = 4;
    int columns = 1;
    const Paint& body = oak;
    const Paint& face = oak;
    const Paint& metal = iron;
    double legs = 0.12;
    bool has_bars = true;
};

/// A chest on feet with drawers in rows and columns.
void drawers(Shaper& s, const Size& size, const DrawerLook& look) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.05, top = size.height - 0.024;
    tapered_feet(s, x - 0.05, y - 0.05, look.legs, look.body);
    block(s, {-x + 0.006, face, look.legs}, {x - 0.006, y - 0.004, top}, look.body, 0.003);
    block(s, {-x, -y + 0.024, top}, {x, y, size.height}, look.body, 0.005);
    const double low = look.legs + 0.012, high = top - 0.004, width = 2 * x - 0.03;
    for (int row = 0; row < look.rows; ++row) {
        const double z0 = mix(low, high, static_cast<double>(row) / look.rows);
        const double z1 = mix(low, high, (row + 1.0) / look.rows);
        for (int column = 0; column < look.columns; ++column) {
            const double x0 = -width / 2 + width * column / look.columns, x1 = x0 + width / look.columns;
            front(s, {x0, face, z0 + 0.001}, {x1, face, z1 - 0.001}, look.face);
            const Vec middle{(x0 + x1) / 2, face - 0.018, mix(z0, z1, 0.58)};
            if (look.has_bars) {
                bar_handle(s, middle, std::min(0.16, 0.35 * (x1 - x0)), false, look.metal);
            } else if (x1 - x0 > 0.5) {
                for (const double side : both) knob(s, middle + Vec{side * 0.28 * (x1 - x0), 0, 0}, 0.014, look.metal);
            } else {
                knob(s, middle, 0.014, look.metal);
            }
        }
    }
}

void wardrobe(Shaper& s, const Size& size, const Paint& body, const Paint& face, int doors, bool is_framed) {
    const double x = size.width / 2 - 0.012, y = size.depth / 2, front_y = -y + 0.05;
    block(s, {-x + 0.02, front_y + 0.03, 0}, {x - 0.02, y - 0.01, 0.075}, body, 0);
    block(s, {-x, front_y, 0.07}, {x, y, size.height - 0.05}, body, 0.003);
    block(s, {-x, front_y - 0.02, size.height - 0.05}, {x, y, size.height - 0.02}, body, 0.006);
    block(s, {-x - 0.012, front_y - 0.034, size.height - 0.022}, {x + 0.012, y, size.height}, body, 0.008);
    const double width = (2 * x - 0.012) / doors, split = is_framed ? 0.48 : 0.08;
    for (int k = 0; k < doors; ++k) {
        const double x0 = -x + 0.006 + k * width, x1 = x0 + width;
        if (is_framed) {
            framed_front(s, {x0, front_y, split}, {x1, front_y, size.height - 0.055}, face);
        } else {
            front(s, {x0, front_y, split}, {x1, front_y, size.height - 0.055}, face);
        }
        const double inner = k % 2 == 0 && doors > 1 ? x1 - 0.04 : x0 + 0.04;
        bar_handle(s, {inner, front_y - 0.018, 1.08}, 0.2, true, steel);
    }
    if (!is_framed) return;
    for (const double side : both) {  // a row of drawers below
        const double x0 = side < 0 ? -x + 0.006 : 0, x1 = side < 0 ? 0 : x - 0.006;
        for (const double z : {0.08, 0.28}) {
            front(s, {x0, front_y, z}, {x1, front_y, z + 0.198}, face);
            for (const double at : {0.22, 0.78}) knob(s, {mix(x0, x1, at), front_y - 0.018, z + 0.11}, 0.015, steel);
        }
    }
}

/// Boards around, `shelves` levels of books and a few things.
void bookshelf(Shaper& s, const Size& size, const Paint& wood, int shelves, std::uint64_t seed) {
    const double x = size.width / 2, y = size.depth / 2, board = 0.022;
    for (const double side : both) {
        block(s, {side > 0 ? x - board : -x, -y, 0}, {side > 0 ? x : -x + board, y, size.height}, wood, 0.002);
    }
    const double low = 0.07, step = (size.height - low - board) / shelves;
    for (int k = 0; k <= shelves; ++k) {
        const double z = low + k * step;
        block(s, {-x + board, -y + 0.004, z}, {x - board, y - 0.006, z + board}, wood, 0.002);
    }
    block(s, {-x + board, y - 0.008, low}, {x - board, y - 0.002, size.height - 0.01}, wood, 0);
    block(s, {-x + board, -y + 0.02, 0}, {x - board, -y + 0.035, low}, wood, 0);
    plans::Random random({0xB00Cu, seed});
    for (int k = 0; k < shelves; ++k) {
        const double z = low + k * step + board;
        book_row(s, {-x + board + 0.006, -y + 0.03, z}, x - board - 0.006, step - board - 0.02, 2 * y - 0.06, random);
    }
}

/// An open shelf of cubes: books in some, boxes or a vase in others.
void cube_shelf(Shaper& s, const Size& size, const Paint& body, int columns, int rows) {
    const double x = size.width / 2, y = size.depth / 2, board = 0.03;
    const double step_x = (size.width - board) / columns, step_z = (size.height - board) / rows;
    for (int k = 0; k <= columns; ++k) {
        block(s, {-x + k * step_x, -y + 0.001, 0.001}, {-x + k * step_x + board, y - 0.001, size.height - 0.001}, body,
              0.002);
    }
    for (int k = 0; k <= rows; ++k) {
        block(s, {-x, -y, k * step_z}, {x, y, k * step_z + board}, body, 0.002);
    }
    block(s, {-x + 0.01, y - 0.012, 0.01}, {x - 0.01, y - 0.006, size.height - 0.01}, body, 0);
    plans::Random random({0xC0BEu});
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x0 = -x + column * step_x + board, z0 = row * step_z + board;
            const double wide = step_x - board, high = step_z - board;
            const int content = (row * 3 + column * 2) % 5;
            if (content == 1 || content == 4) {  // a basket that fills it
                const auto scope = s.inside(move(x0 + wide / 2, -0.005, z0));
                vessel(s,
                       {.half_bottom = {wide / 2 - 0.03, y - 0.035, 0},
                        .half_rim = {wide / 2 - 0.015, y - 0.02, 0},
                        .rim = high * 0.78,
                        .floor = 0.01,
                        .wall = 0.008,
                        .slope = 2,
                        .corner = 0.25,
                        .plain = 16},
                       content == 1 ? wicker : wool);
            } else if (content == 3) {
                const auto scope = s.inside(move(x0 + wide * 0.5, -0.02, z0));
                const Vec profile[] = {{0, 0, 0},        {0.05, 0, 0},     {0.075, 0, 0.05},
                                       {0.07, 0, 0.11},  {0.028, 0, 0.17}, {0.03, 0, 0.21},
                                       {0.025, 0, 0.21}, {0.022, 0, 0.17}, {0, 0, 0.16}};
                lathe(s, curve(profile, s.fine(2)), marble, 20);
            } else {
                book_row(s, {x0 + 0.004, -y + 0.05, z0}, x0 + wide - 0.004, high - 0.04, 2 * y - 0.1, random);
            }
        }
    }
}

void wall_shelf(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2;
    block(s, {-x, -y, 0.06}, {x, y, 0.085}, oak, 0.003);
    for (const double side : both) {
        block(s, {side * (x - 0.12) - 0.008, y - 0.012, 0}, {side * (x - 0.12) + 0.008, y, 0.06}, iron, 0.002);
        block(s, {side * (x - 0.12) - 0.007, -y + 0.05, 0.05}, {side * (x - 0.12) + 0.007, y - 0.002, 0.0605}, iron,
              0.002);
    }
    plans::Random random({0x5E1Fu});
    book_row(s, {-x + 0.03, -y + 0.02, 0.085}, 0.08, size.height - 0.09, 2 * y - 0.05, random);
    {
        const auto scope = s.inside(move(x - 0.16, 0, 0.085));
        const Vec profile[] = {{0, 0, 0},       {0.045, 0, 0},   {0.06, 0, 0.05}, {0.055, 0, 0.1},
                               {0.048, 0, 0.1}, {0.05, 0, 0.05}, {0, 0, 0.03}};
        lathe(s, profile, terracotta, 20);
    }
}

void coat_rack(Shaper& s, const Size& size) {
    const double h = size.height;
    rod(s, {0, 0, 0.05}, {0, 0, h - 0.03}, 0.02, 0.016, beech, 14);
    ball(s, {0, 0, h - 0.025}, {0.025, 0.025, 0.025}, beech, 14);
    for (int k = 0; k < 4; ++k) {
        const auto scope = s.inside(turn_z(90 * k));
        const Vec foot[] = {{0, 0, 0.16}, {0.09, 0, 0.1}, {0.17, 0, 0.035}, {0.235, 0, 0.012}};
        const double thin[] = {0.016, 0.016, 0.014, 0.012};
        tube(s, foot, thin, beech, 8);
        for (const double level : {0.0, 1.0}) {
            const auto turned = s.inside(turn_z(45 * level) * move(0, 0, h - 0.16 - 0.25 * level));
            const Vec hook[] = {{0.01, 0, 0}, {0.07, 0, -0.005}, {0.115, 0, 0.03}, {0.12, 0, 0.07}};
            tube(s, curve(hook, s.fine(3)), 0.009, beech, 8);
            ball(s, {0.12, 0, 0.075}, {0.014, 0.014, 0.014}, beech, 10);
        }
    }
}

void umbrella_stand(Shaper& s) {
    const Vec profile[] = {{0, 0, 0},       {0.115, 0, 0},    {0.12, 0, 0.01}, {0.12, 0, 0.5},
                           {0.112, 0, 0.5}, {0.112, 0, 0.02}, {0, 0, 0.015}};
    lathe(s, profile, iron, 24);
    const auto umbrella = [&](double x, double y, double lean, const Paint& cloth) {
        const auto scope = s.inside(move(x, y, 0.02) * turn_z(40 * x / 0.04) * turn_y(lean));
        rod(s, {0, 0, 0}, {0, 0, 0.12}, 0.004, 0.006, steel, 8);
        std::vector<Ring> folds;  // rolled up
        for (int k = 0; k <= s.fine(5); ++k) {
            const double t = static_cast<double>(k) / s.fine(5);
            Ring& ring = folds.emplace_back();
            for (int i = 0; i < s.fine(16); ++i) {
                const double angle = 2 * pi * i / s.fine(16);
                const double r =
                    (0.012 + 0.025 * std::sin(pi * std::min(1.0, t * 1.15)) + 0.004) * (1 + 0.18 * std::cos(8 * angle));
                ring.push_back({r * std::cos(angle + t), r * std::sin(angle + t), 0.1 + 0.5 * t});
            }
        }
        s.skin(folds, cloth);
        rod(s, {0, 0, 0.58}, {0, 0, 0.72}, 0.006, 0.006, steel, 8);
        const Vec hook[] = {{0, 0, 0.7}, {0, 0, 0.78}, {0.02, 0, 0.815}, {0.05, 0, 0.8}, {0.058, 0, 0.76}};
        tube(s, curve(hook, s.fine(3)), 0.009, walnut, 8);
    };
    umbrella(-0.03, 0.02, -4, navy);
    umbrella(0.04, -0.02, 5, terracotta_cloth);
}

void tv_stand(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.03, h = size.height;
    tapered_feet(s, x - 0.06, y - 0.06, 0.14, oak);
    block(s, {-x, -y + 0.008, h - 0.024}, {x, y, h}, oak, 0.003);
    block(s, {-x, -y + 0.008, 0.14}, {x, y, 0.164}, oak, 0.003);
    for (const double side : both) {
        block(s, {side > 0 ? x - 0.022 : -x, -y + 0.008, 0.164}, {side > 0 ? x : -x + 0.022, y, h - 0.024}, oak, 0);
        block(s, {side * 0.24 - 0.01, face, 0.164}, {side * 0.24 + 0.01, y, h - 0.024}, oak, 0);
        const double x0 = side > 0 ? 0.25 : -x + 0.022, x1 = side > 0 ? x - 0.022 : -0.25;
        block(s, {x0, face + 0.002, 0.164}, {x1, y - 0.02, h - 0.024}, oak, 0);
        front(s, {x0, face, 0.164}, {x1, face, h - 0.024}, white);
        knob(s, {side > 0 ? x0 + 0.05 : x1 - 0.05, face - 0.018, 0.3}, 0.011, oak);
    }
    block(s, {-0.23, y - 0.014, 0.164}, {0.23, y - 0.006, h - 0.024}, oak, 0);
    block(s, {-0.23, face + 0.02, 0.29}, {0.23, y - 0.014, 0.305}, oak, 0.001);
    block(s, {-0.19, face + 0.05, 0.306}, {0.18, y - 0.05, 0.355}, black, 0.004);
    block(s, {-0.17, face + 0.0485, 0.325}, {-0.05, face + 0.055, 0.335}, steel, 0);
    block(s, {-0.16, face + 0.06, 0.165}, {0.16, y - 0.05, 0.205}, charcoal, 0.004);
}

void dressing_table(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, top = 0.75;
    block(s, {-x, -y, top - 0.022}, {x, y, top}, white, 0.005);
    for (const double side : both) {
        for (const double f : both) {
            post(s, {side * (x - 0.03), f * (y - 0.04), 0}, {side * (x - 0.045), f * (y - 0.05), top - 0.14},
                 {0.012, 0.012, 0}, {0.02, 0.02, 0}, white, 0.004);
        }
        const double x0 = side > 0 ? 0.004 : -x + 0.025, x1 = side > 0 ? x - 0.025 : -0.004;
        front(s, {x0, -y + 0.05, top - 0.138}, {x1, -y + 0.05, top - 0.026}, white);
        knob(s, {(x0 + x1) / 2, -y + 0.032, top - 0.082}, 0.012, brass);
    }
    block(s, {-x + 0.02, -y + 0.05, top - 0.142}, {x - 0.02, y - 0.02, top - 0.022}, white, 0.002);
    // An oval mirror on a stand.
    const auto scope = s.inside(move(0, y - 0.05, top + 0.35) * turn_x(83));
    const Ring oval = ellipse({}, 0.24, 0.32, s.fine(36));
    plate(s, oval, -0.012, 0.004, mirror_glass, 0.002);
    tube(s, oval, 0.014, brass, 8, Ends::Looped);
    for (const double side : both) {
        rod(s, {side * 0.1, -0.362, -0.01}, {side * 0.1, -0.28, -0.008}, 0.008, 0.008, brass, 10);
    }
}

void shoe_cabinet(Shaper& s, const Size& size) {
    const double x = size.width / 2, y = size.depth / 2, face = -y + 0.035;
    block(s, {-x + 0.01, face, 0.04}, {x - 0.01, y, size.height - 0.02}, white, 0.002);
    block(s, {-x, -y + 0.01, size.height - 0.02}, {x, y, size.height}, oak, 0.003);
    block(s, {-x + 0.03, face + 0.03, 0}, {x - 0.03, y - 0.01, 0.04}, charcoal, 0);
    for (int k = 0; k < 3; ++k) {
        const double z = 0.045 + k * (size.height - 0.07) / 3;
        front(s, {-x + 0.012, face, z}, {x - 0.012, face, z + (size.height - 0.07) / 3 - 0.006}, white);
        knob(s, {0, face - 0.018, z + (size.height - 0.07) / 3 - 0.05}, 0.01, oak);
    }
}

}  // namespace

void add_storage(Pieces& pieces) {
    pieces.push_back(piece<"own/chest-of-drawers", Size{0.9, 0.45, 0.86}>(
        "Chest of drawers", "chest_of_drawers", "Storage",
        [](Shaper& s, const Size& size) {
            drawers(s, size, {.rows = 4, .body = walnut, .face = walnut, .metal = brass, .has_bars = false});
        },
        {.top = 0.86}));
    pieces.push_back(piece<"own/chest-of-drawers-white", Size{1.2, 0.48, 0.78}>(
        "Chest of drawers, white", "chest_of_drawers", "Storage",
        [](Shaper& s, const Size& size) {
            drawers(s, size, {.rows = 3, .columns = 2, .body = white, .face = white, .metal = steel});
        },
        {.top = 0.78}));
    pieces.push_back(piece<"own/sideboard", Size{1.6, 0.45, 0.75}>(
        "Sideboard", "sideboard", "Storage",
        [](Shaper& s, const Size& size) {
            drawers(s, size, {.rows = 2, .columns = 4, .body = oak, .face = deep_blue, .metal = brass, .legs = 0.18});
        },
        {.top = 0.75}));
    pieces.push_back(piece<"own/bedside-table", Size{0.45, 0.39, 0.5}>(
        "Bedside table", "bedside_table", "Storage",
        [](Shaper& s, const Size& size) {
            drawers(s, size, {.rows = 2, .body = oak, .face = white, .metal = oak, .legs = 0.16, .has_bars = false});
        },
        {.top = 0.5}));
    pieces.push_back(piece<"own/wardrobe", Size{1.52, 0.62, 2.1}>(
        "Wardrobe", "wardrobe", "Storage",
        [](Shaper& s, const Size& size) { wardrobe(s, size, white, off_white, 3, true); }));
    pieces.push_back(piece<"own/wardrobe-oak", Size{1.02, 0.6, 2.0}>(
        "Wardrobe, oak", "wardrobe", "Storage",
        [](Shaper& s, const Size& size) { wardrobe(s, size, oak, oak, 2, false); }));
    pieces.push_back(piece<"own/bookshelf", Size{0.9, 0.3, 2.0}>(
        "Bookshelf", "bookshelf", "Storage", [](Shaper& s, const Size& size) { bookshelf(s, size, oak, 6, 1); },
        {.top = 2.0}));
    pieces.push_back(piece<"own/bookshelf-low", Size{1.2, 0.3, 0.95}>(
        "Bookshelf, low", "bookshelf", "Storage", [](Shaper& s, const Size& size) { bookshelf(s, size, walnut, 3, 2); },
        {.top = 0.95}));
    pieces.push_back(piece<"own/bookshelf-white", Size{0.6, 0.28, 1.8}>(
        "Bookshelf, white", "bookshelf", "Storage",
        [](Shaper& s, const Size& size) { bookshelf(s, size, white, 5, 3); }, {.top = 1.8}));
    pieces.push_back(piece<"own/shelf", Size{1.12, 0.39, 1.12}>(
        "Shelf of cubes", "shelf", "Storage", [](Shaper& s, const Size& size) { cube_shelf(s, size, white, 3, 3); },
        {.top = 1.12}));
    pieces.push_back(piece<"own/shelf-wall", Size{0.9, 0.22, 0.3}>(
        "Wall shelf", "wall_shelf", "Storage", [](Shaper& s, const Size& size) { wall_shelf(s, size); },
        {.elevation = 1.3}));
    pieces.push_back(piece<"own/coat-rack", Size{0.48, 0.48, 1.78}>(
        "Coat rack", "coat_rack", "Storage", [](Shaper& s, const Size& size) { coat_rack(s, size); }));
    pieces.push_back(piece<"own/umbrella-stand", Size{0.264, 0.24, 0.844}>(
        "Umbrella stand", "umbrella_stand", "Storage", [](Shaper& s, const Size&) { umbrella_stand(s); }));
    pieces.push_back(piece<"own/tv-stand", Size{1.6, 0.425, 0.48}>(
        "TV stand", "tv_stand", "Storage", [](Shaper& s, const Size& size) { tv_stand(s, size); }, {.top = 0.48}));
    pieces.push_back(piece<"own/dressing-table", Size{0.95, 0.45, 1.42}>(
        "Dressing table", "dressing_table", "Storage", [](Shaper& s, const Size& size) { dressing_table(s, size); }));
    pieces.push_back(piece<"own/shoe-cabinet", Size{0.75, 0.24, 1.05}>(
        "Shoe cabinet", "shoe_cabinet", "Storage", [](Shaper& s, const Size& size) { shoe_cabinet(s, size); },
        {.top = 1.05}));
}

}  // namespace enfilade::modeler::own
