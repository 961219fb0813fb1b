#include "modeler/catalogue/own/books.h"

#include <algorithm>
#include <iterator>

namespace enfilade::modeler::own {
namespace {

const Paint& any_cover(plans::Random& random) {
    return book_covers[random.below(static_cast<std::uint32_t>(std::size(book_covers)))];
}

/// Ribs and a label on the spine.
void dress_spine(Shaper& s, const Size& size, const Paint& cover) {
    if (s.detail() < 2) return;
    const Paint& label = cover.colour[0] > 0.3f ? book_covers[6] : book_covers[5];
    const double w = size.width;
    block(s, {0.15 * w, -0.0024, 0.68 * size.height}, {0.85 * w, 0.0015, 0.8 * size.height}, label, 0.0006);
    if (s.detail() < 3) return;
    for (const double z : {0.12, 0.9}) {
        block(s, {0.1 * w, -0.0027, z * size.height - 0.0015}, {0.9 * w, 0.0015, z * size.height + 0.0015}, cover,
              0.0007);
    }
}

}  // namespace

void book(Shaper& s, Size size, const Paint& cover) {
    const double w = size.width, d = size.depth, h = size.height, board = std::min(0.0028, 0.16 * w), inset = 0.004;
    const double edge = s.detail() > 1 ? 0.0008 : 0;
    block(s, {0, 0.002, 0}, {board, d, h}, cover, edge);
    block(s, {w - board, 0.002, 0}, {w, d, h}, cover, edge);
    // The spine, round.
    const int steps = s.fine(2);
    Ring outline;
    for (int k = 0; k <= steps; ++k) {
        const double angle = pi * k / steps;
        outline.push_back({w / 2 - w / 2 * std::cos(angle), 0.003 - 0.005 * std::sin(angle), 0});
    }
    plate(s, outline, 0, h, cover);
    const int sheets = s.detail() < 3 ? 1 : std::max(3, static_cast<int>(w / 0.003));
    const double from = board, span = w - 2 * board;
    for (int k = 0; k < sheets; ++k) {
        const double a = from + span * k / sheets, b = from + span * (k + (sheets == 1 ? 1.0 : 0.94)) / sheets;
        block(s, {a, 0.003, inset}, {b, d - inset - 0.0006 * (k % 2), h - inset - 0.0004 * (k % 3)}, paper, 0);
    }
    dress_spine(s, size, cover);
}

void book_row(Shaper& s, Vec from, double to_x, double most_height, double depth, plans::Random& random) {
    double x = from.x;
    const double end = to_x - random.uniform(0, 0.35) * (to_x - from.x);
    double height = 0, book_depth = 0, thickness = 0;
    const Paint* cover = nullptr;
    int left_of_set = 0;
    while (true) {
        if (left_of_set == 0) {  // alone, or several alike
            left_of_set = random.chance(0.25) ? 2 + static_cast<int>(random.below(4)) : 1;
            height = most_height * random.uniform(0.62, 0.97), book_depth = depth * random.uniform(0.7, 0.98);
            thickness = random.uniform(0.016, 0.045), cover = &any_cover(random);
        }
        --left_of_set;
        if (x + thickness > end) break;
        const auto scope = s.inside(move(x, from.y + random.uniform(0, 0.012), from.z));
        book(s, {thickness, book_depth, height}, *cover);
        x += thickness + 0.0012;
    }
    const double rest = to_x - x;
    if (rest > 0.17) {
        const auto scope = s.inside(move(x + 0.02 + (rest - 0.19) * random.uniform(), from.y, from.z));
        const auto placed = s.inside(move(0.08, depth / 2, 0));
        book_stack(s, 2 + static_cast<int>(random.below(3)), {0.15, depth * 0.9, 0.03}, random);
    } else if (rest > 0.09) {  // one that leans on the last
        const double lean = 11, tall = 0.75 * most_height;
        const auto scope = s.inside(move(x + tall * std::sin(degrees(lean)) + 0.002, from.y, from.z) * turn_y(-lean));
        book(s, {0.022, 0.8 * depth, tall}, any_cover(random));
    }
}

void book_stack(Shaper& s, int count, Size most, plans::Random& random) {
    double z = 0;
    for (int k = 0; k < count; ++k) {
        const Size size{most.height * random.uniform(0.6, 1), most.depth * random.uniform(0.78, 1),
                        most.width * random.uniform(0.85, 1)};
        // It lies: its thickness goes up, its height to the side.
        const auto scope = s.inside(move(0, 0, z) * turn_z(random.uniform(-7, 7)) * turn_y(90) *
                                    move(-size.width, -size.depth / 2, -size.height / 2));
        book(s, size, any_cover(random));
        z += size.width + 0.0005;
    }
}

}  // namespace enfilade::modeler::own
