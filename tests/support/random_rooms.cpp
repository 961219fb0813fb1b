#include "tests/support/random_rooms.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "tests/support/room_families.h"

namespace enfilade::testing {
namespace {

using plans::Random;

struct Family {
    RoomFamily family;
    void (*draw)(const Brush&);
};

constexpr double rim = 1 << 24;

const Family drawn[] = {
    {{"notched", 1}, families::notched},
    {{"letters", 2}, families::letters},
    {{"comb", 3}, families::comb},
    {{"star", 4}, families::star},
    {{"zigzag", 5}, families::zigzag},
    {{"courtyards", 6}, families::courtyards},
    {{"pinched", 7}, families::pinched},
    {{"needles", 8}, families::needles},
    {{"gaps", 9}, families::gaps},
    {{"steps", 10}, families::steps},
    {{"bent", 11}, families::bent},
    {{"collage", 12}, families::collage},
    {{"pebbles", 13}, families::pebbles},
    {{"columns", 14}, families::columns},
    {{"spirals", 15}, families::spirals},
    {{"arc_walls", 16}, families::arc_walls},
    {{"circles", 17}, families::circles},
    {{"tangents", 18}, families::tangents},
    {{"lenses", 19}, families::lenses},
    {{"clovers", 20}, families::clovers},
    {{"curved_corridors", 21}, families::curved_corridors},
    {{"shallow_arcs", 22}, families::shallow_arcs},
    {{"tiny_arcs", 23}, families::tiny_arcs},
};

Placing any_placing(double reach, Random& random) {
    Placing placing;
    const std::uint32_t kind = random.below(10);
    if (kind >= 4) placing.turn = random.uniform(0, whole_turn);
    if (kind == 4) placing.turn = std::pow(10, random.uniform(-7, -2));
    const double space = rim - reach - 1;
    if (kind % 5 == 0) placing.x = random.chance(0.5) ? space : -space, placing.y = random.chance(0.5) ? space : -space;
    else if (kind % 5 == 1) placing.x = random.uniform(-space, space), placing.y = random.uniform(-space, space);
    return placing;
}

/// Lines of other storeys through a room.
void add_scratches(RoomSketch& sketch, double reach, Random& random) {
    const std::uint32_t count = random.below(6);
    for (std::uint32_t k = 0; k < count; ++k)
        sketch.scratch({random.uniform(-reach, reach), random.uniform(-reach, reach)},
                       {random.uniform(-reach, reach), random.uniform(-reach, reach)});
}

}  // namespace

std::span<const RoomFamily> room_families() {
    static const std::vector<RoomFamily> all = [] {
        std::vector<RoomFamily> families;
        for (const Family& family : drawn) families.push_back(family.family);
        return families;
    }();
    return all;
}

Room random_room(const RoomFamily& family, std::uint64_t seed) {
    const auto found = std::find_if(std::begin(drawn), std::end(drawn),
                                    [&](const Family& one) { return one.family.number == family.number; });
    ENFILADE_CHECK(found != std::end(drawn));
    for (std::uint64_t attempt = 0;; ++attempt) {
        Random random{0x600D, family.number, seed, attempt};
        RoomSketch sketch;
        found->draw({sketch, random});
        const double reach = sketch.reach();
        const Placing placing = any_placing(reach, random);
        if (random.chance(0.25)) add_scratches(sketch, reach, random);
        if (auto room = sketch.realise(placing, random)) return *std::move(room);
    }
}

Room large_room(LargeRoom kind, std::uint32_t corners, std::uint64_t seed) {
    Random random{0x1A46E, std::uint64_t(kind), corners, seed};
    RoomSketch sketch;
    const double radius = 1000 * metre;
    switch (kind) {
        case LargeRoom::Comb: {
            Ring ring = {{0, 0}, {corners / 4 * metre, 0}};
            for (std::uint32_t k = corners / 4; k-- > 0;) {
                const double top = metre * random.uniform(2, 9), left = k * metre, right = left + metre;
                ring.push_back({right, top}), ring.push_back({left + metre / 2, top});
                ring.push_back({left + metre / 2, metre}), ring.push_back({left, metre});
            }
            sketch.paint(Paint::Room, moved(ring, {-double(corners) / 8 * metre, 0}));
            break;
        }
        case LargeRoom::Star: {
            Ring ring;
            for (std::uint32_t k = 0; k < corners; ++k) {
                const double angle = whole_turn * k / corners, r = radius * random.uniform(0.3, 1);
                ring.push_back({r * std::cos(angle), r * std::sin(angle)});
            }
            sketch.paint(Paint::Room, ring);
            break;
        }
        case LargeRoom::Spiral: sketch.paint(Paint::Room, spiral(radius, 0.5, corners / 2.0 / 100, 100)); break;
        case LargeRoom::Circle: sketch.paint(Paint::Room, circle({0, 0}, radius, corners)); break;
        case LargeRoom::Columns:
            sketch.paint(Paint::Room, box_at({0, 0}, 1.9 * radius, 1.9 * radius));
            for (std::uint32_t k = 0; k < corners / 40; ++k)
                sketch.paint(Paint::Solid,
                             circle({random.uniform(-0.9, 0.9) * radius, random.uniform(-0.9, 0.9) * radius},
                                    metre * random.uniform(0.5, 12), 40, random.uniform(0, 1)));
            break;
        case LargeRoom::CurvedCorridor:
            sketch.paint(Paint::Room, sector({0, 0}, 0.99 * radius, radius, 0, 5, corners / 2, corners / 2));
            break;
    }
    for (std::uint64_t attempt = 0;; ++attempt)
        if (auto room = sketch.realise({random.uniform(0, 1), 0, 0}, random); room && room->sides.size() > corners / 2)
            return *std::move(room);
}

}  // namespace enfilade::testing
