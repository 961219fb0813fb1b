// Rooms of every family of the cutters' tests, with doors and windows at random, furnished and verified.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "modeler/furnishing/walkways.h"
#include "tests/modeler/furnishing/furnished_room.h"
#include "tests/support/random_rooms.h"

namespace enfilade::testing {
namespace {

using modeler::Beyond;

/// The sides as rings. Some become doors, openings and windows.
modeler::RoomShape shape_of(const Room& from, plans::Random& random) {
    modeler::RoomShape room;
    room.id = "random";
    room.space = 3;
    const double unit = room.frame.unit;
    room.z_ceiling = std::int32_t(2.6 / unit);
    std::multimap<std::uint32_t, std::uint32_t> leaving;
    for (std::uint32_t k = 0; k < from.sides.size(); ++k) leaving.emplace(from.sides[k].from, k);
    double twice = 0;
    std::uint32_t space = 100;
    while (!leaving.empty()) {
        room.rings.emplace_back();
        auto next = leaving.begin();
        while (next != leaving.end()) {
            const modeler::PolygonSide side = from.sides[next->second];
            leaving.erase(next);
            modeler::RoomSide made;
            made.a = from.points[side.from];
            made.b = from.points[side.to];
            made.wall_top = room.z_ceiling;
            const double length = std::hypot(double(made.b.x) - made.a.x, double(made.b.y) - made.a.y) * unit;
            const double choice = random.uniform();
            if (length > 0.65 && length < 3 && choice < 0.35) {
                made.beyond = choice < 0.25 ? Beyond::Door : Beyond::Opening;
                made.z_high = std::int32_t(2.1 / unit);
            } else if (length > 0.5 && length < 3 && choice > 0.7) {
                made.beyond = Beyond::Window;
                made.z_low = std::int32_t(0.9 / unit);
                made.z_high = std::int32_t(2.2 / unit);
            }
            if (made.beyond != Beyond::Wall) {
                made.space = space++;
                made.wall_top = made.z_low;
            }
            twice += double(made.a.x) * made.b.y - double(made.a.y) * made.b.x;
            room.rings.back().push_back(made);
            next = leaving.find(side.to);
        }
    }
    room.area_m2 = twice / 2 * unit * unit;
    std::vector<modeler::OutlineSide> outline;
    for (const auto& ring : room.rings)
        for (const auto& side : ring)
            outline.push_back({double(side.a.x), double(side.a.y), double(side.b.x), double(side.b.y)});
    const auto middle = modeler::label_point(std::move(outline));
    room.middle = {middle[0], middle[1]};
    modeler::complete(room);
    return room;
}

TEST(FurnishedRandomRooms, KeepEveryGuarantee) {
    constexpr std::uint64_t rooms_each = 44;  // 23 families: 1012 rooms
    const modeler::Rules& rules = modeler::own_rules();
    const modeler::EntryLists entries(own_entries());
    std::size_t rooms = 0, gates = 0, placed = 0, requested = 0;
    double seconds = 0, slowest = 0;
    for (const RoomFamily& family : room_families())
        for (std::uint64_t seed = 0; seed < rooms_each; ++seed) {
            plans::Random random{seed, family.number, 6};
            const modeler::RoomShape room = shape_of(random_room(family, seed), random);
            const auto& kind = rules.rooms[random.below(std::uint32_t(rules.rooms.size()))];
            const auto start = std::chrono::steady_clock::now();
            const modeler::RoomLayout layout = modeler::furnish_room(room, kind, rules.temperature, entries, {}, seed);
            const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            seconds += took;
            slowest = std::max(slowest, took);
            ASSERT_EQ(faults(room, checked(room, layout)), "") << family.name << " " << seed << " as " << kind.kind;
            ++rooms;
            gates += room.gates.size();
            placed += layout.pieces.size();
            requested += layout.requested;
        }
    RecordProperty("rooms", int(rooms));
    std::printf(
        "[ figures ] %zu rooms, %zu gates: %zu of %zu pieces placed (%.1f %%), %.2f ms a room, %.3f ms a piece, "
        "slowest room %.0f ms\n",
        rooms, gates, placed, requested, 100.0 * double(placed) / double(requested), 1e3 * seconds / double(rooms),
        1e3 * seconds / double(placed), 1e3 * slowest);
    EXPECT_GE(rooms, 1000u);
    EXPECT_GT(gates, rooms / 2) << "too few doors to say anything of them";
    EXPECT_GT(placed, 2 * rooms);
}

}  // namespace
}  // namespace enfilade::testing
