// The hard guarantees: layouts that break one are found out, rooms that invite it are furnished without.
#include <gtest/gtest.h>

#include <chrono>

#include "modeler/furnishing/walkways.h"
#include "tests/modeler/furnishing/furnished_room.h"

namespace enfilade::testing {
namespace {

using modeler::Beyond;
using modeler::CheckedPiece;
using modeler::FurnishingFault;
using modeler::RoomLayout;
using modeler::RoomShape;

/// A piece over a rectangle of metres.
CheckedPiece box(const std::string& id, double x0, double y0, double x1, double y1, double z0 = 0, double z1 = 0.8) {
    const auto g = [](double v) { return std::int32_t(std::lround(v * 8192)); };
    return {id, {{g(x0), g(y0)}, {g(x1), g(y0)}, {g(x1), g(y1)}, {g(x0), g(y1)}}, g(z0), g(z1), true, ""};
}

std::vector<FurnishingFault> kinds(const RoomShape& room, const std::vector<CheckedPiece>& pieces) {
    std::vector<FurnishingFault> found;
    for (const auto& violation : modeler::verify_room(room, pieces)) found.push_back(violation.fault);
    return found;
}
using Faults = std::vector<FurnishingFault>;

/// 5 m x 4 m, doors of 0.9 m in the west and east walls, a window in the north one.
RoomShape passage_room() {
    return room_of(rectangle(5, 4), {{1, 0.1, 0.325}, {3, 0.1, 0.325}, {2, 0.3, 0.6, Beyond::Window, 0.9, 2.1}});
}

TEST(Verifier, AcceptsWhatStandsWell) {
    EXPECT_EQ(kinds(passage_room(), {box("a", 1, 0, 2, 0.6), box("b", 2, 0, 3, 0.6)}), Faults{});
}

TEST(Verifier, FindsOverlaps) {
    EXPECT_EQ(kinds(passage_room(), {box("a", 1, 0, 2, 0.6), box("b", 1.99, 0, 3, 0.6)}),
              Faults{FurnishingFault::Overlap});
}

TEST(Verifier, AllowsWhatHangsOverOrStandsOnAPiece) {
    CheckedPiece lamp = box("lamp", 1.2, 0.1, 1.4, 0.3, 0.7, 1.1);
    EXPECT_EQ(kinds(passage_room(), {box("a", 1, 0, 2, 0.6), box("picture", 1, 0, 2, 0.05, 1.2, 1.6)}), Faults{});
    EXPECT_EQ(kinds(passage_room(), {box("a", 1, 0, 2, 0.6), lamp}), Faults{FurnishingFault::Overlap});
    lamp.stands_on = "a";
    EXPECT_EQ(kinds(passage_room(), {box("a", 1, 0, 2, 0.6), lamp}), Faults{});
}

TEST(Verifier, FindsWhatLeavesItsRoom) {
    EXPECT_EQ(kinds(passage_room(), {box("a", 1, -0.01, 2, 0.6)}), Faults{FurnishingFault::Outside});
    EXPECT_EQ(kinds(passage_room(), {box("a", 1, 0, 2, 0.6, 0, 2.6)}), Faults{FurnishingFault::Outside});
    RoomShape room = room_of(rectangle(5, 4));
    // A column of 0.5 m in the middle: its ring runs clockwise.
    const RoomShape column = room_of({{2.25, 1.75}, {2.25, 2.25}, {2.75, 2.25}, {2.75, 1.75}});
    room.rings.push_back(column.rings[0]);
    modeler::complete(room);
    EXPECT_EQ(kinds(room, {box("a", 2, 1.5, 3, 2.5)}), Faults{FurnishingFault::Outside});
    EXPECT_EQ(kinds(room, {box("a", 1, 1.5, 2.25, 2.5)}), Faults{});
}

TEST(Verifier, FindsWhatStandsInTheWayOfALeafOnEitherJamb) {
    // The east door lies between y = 0.4 and 1.3: leaves of 0.9 m around (5, 0.4) and (5, 1.3).
    EXPECT_EQ(kinds(passage_room(), {box("a", 4.2, 0.4, 4.3, 0.6)}), Faults{FurnishingFault::DoorBlocked});
    EXPECT_EQ(kinds(passage_room(), {box("a", 4.2, 1.1, 4.3, 1.3)}), Faults{FurnishingFault::DoorBlocked});
    EXPECT_EQ(kinds(passage_room(), {box("a", 4.2, 0.4, 4.3, 0.6, 0, 0.02)}), Faults{});
}

TEST(Verifier, FindsWhatStandsHighBeforeAWindow) {
    EXPECT_EQ(kinds(passage_room(), {box("a", 2.2, 3.6, 3, 4, 0, 1.2)}), Faults{FurnishingFault::WindowBlocked});
    EXPECT_EQ(kinds(passage_room(), {box("a", 2.2, 3.6, 3, 4, 0, 0.85)}), Faults{});
}

TEST(Verifier, FindsClosedWays) {
    // A wall of furniture from south to north, but for a gap of `free` metres.
    const auto barrier = [](double free) { return std::vector{box("a", 2.3, 0, 2.7, 4 - free)}; };
    EXPECT_EQ(kinds(passage_room(), barrier(0.5)), Faults{FurnishingFault::Unreachable});
    EXPECT_EQ(kinds(passage_room(), barrier(0.59)), Faults{FurnishingFault::Unreachable});
    EXPECT_EQ(kinds(passage_room(), barrier(0.65)), Faults{});
    std::vector<CheckedPiece> high = {box("shelf", 2.3, 0, 2.7, 4, 1.6, 2)};
    high[0].z_low = std::int32_t(8192 * 2.12);
    high[0].z_high = std::int32_t(8192 * 2.3);
    EXPECT_EQ(kinds(passage_room(), high), Faults{});
}

TEST(Verifier, AsksForNoWayThatWasNotThereBefore) {
    CheckedPiece built_in = box("wall of shelves", 2.3, 0, 2.7, 4);
    built_in.by_rule = false;
    EXPECT_EQ(kinds(passage_room(), {built_in, box("a", 1.5, 0, 2.2, 0.6)}), Faults{});
}

TEST(Walkways, ProveWaysOfOneWalkersWidth) {
    // Corridors of a width between two rooms: the disc of 0.3 m passes from 0.62 m on, proven by the fine lattice.
    const auto two_rooms = [](double width) {
        const double low = 1.5 - width / 2, high = 1.5 + width / 2;
        return room_of(
            {{0, 0}, {3, 0}, {3, low}, {5, low}, {5, 0}, {8, 0}, {8, 3}, {5, 3}, {5, high}, {3, high}, {3, 3}, {0, 3}},
            {{11, 0.3, 0.6}, {5, 0.3, 0.6, Beyond::Door}, {6, 0.3, 0.6}});
    };
    const auto ways = [&](double width, const std::vector<modeler::Ring>& obstacles) {
        RoomShape room = two_rooms(width);
        modeler::Walkways walkways(room, {});
        for (const modeler::Ring& ring : obstacles) walkways.put(ring, 1);
        return walkways.all_open();
    };
    const modeler::Ring plug = box("", 3.9, 1.4, 4.1, 1.6).footprint;
    EXPECT_FALSE(ways(1.0, {plug}));
    EXPECT_FALSE(ways(0.64, {plug}));
    EXPECT_TRUE(ways(1.0, {}));
    // Too narrow before: nothing to keep open.
    EXPECT_TRUE(ways(0.58, {plug}));
}

std::string shelves(int count) {
    return R"({"rooms": [{"kind": "test", "objects": [{"object": "bookshelf", "count": )" + std::to_string(count) +
           R"(, "front": 0.4}, {"object": "dining_table", "count": 4, "place": "middle"}]}]})";
}

TEST(Guarantees, HoldInARoomThatIsAskedToBeFilled) {
    const std::vector<modeler::CatalogueEntry> entries = {entry("bookshelf", 0.8, 0.3, 2),
                                                          entry("dining_table", 1.6, 0.9, 0.75)};
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const RoomLayout layout = furnished(passage_room(), shelves(40), entries, seed);
        EXPECT_EQ(faults(passage_room(), checked(passage_room(), layout)), "") << seed;
        EXPECT_GT(layout.pieces.size(), 5u);
        EXPECT_LT(layout.pieces.size(), 44u);
        EXPECT_EQ(layout.requested, 44u);
        EXPECT_FALSE(layout.no_place.empty());
    }
}

TEST(Guarantees, KeepClearOfWhatStandsThereAlready) {
    const RoomShape room = passage_room();
    const CheckedPiece there = box("there", 0, 2, 2, 4);
    std::vector<modeler::StandingPiece> standing = {{there.footprint, there.z_low, there.z_high, "bookshelf"}};
    const modeler::Rules rules = modeler::read_rules_text(shelves(8), "rules");
    const std::vector<modeler::CatalogueEntry> entries = {entry("bookshelf", 0.8, 0.3, 2),
                                                          entry("dining_table", 1.6, 0.9, 0.75)};
    const RoomLayout layout =
        modeler::furnish_room(room, rules.rooms[0], 0.2, modeler::EntryLists(entries), standing, 3);
    std::vector<CheckedPiece> pieces = checked(room, layout);
    pieces.push_back(there);
    pieces.back().by_rule = false;
    EXPECT_EQ(faults(room, pieces), "");
    EXPECT_EQ(layout.requested, 11u) << "the bookshelf that is there counts";
}

class Extremes : public ::testing::Test {
protected:
    /// Own rules for living rooms, timed.
    static RoomLayout furnish(const RoomShape& room) {
        const modeler::EntryLists entries(own_entries());
        const auto start = std::chrono::steady_clock::now();
        const modeler::RoomLayout layout =
            modeler::furnish_room(room, *modeler::own_rules().find("living"), 0.15, entries, {}, 1);
        const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        EXPECT_LT(took, 2.0) << "counted tries end quickly, on a busy machine too";
        EXPECT_EQ(faults(room, checked(room, layout)), "");
        return layout;
    }
};

TEST_F(Extremes, CupboardSmallerThanAnyPiece) {
    const RoomLayout layout = furnish(room_of(rectangle(0.08, 0.07)));
    EXPECT_EQ(layout.pieces.size(), 0u);
    EXPECT_GT(layout.requested, 5u);
    EXPECT_FALSE(layout.no_place.empty());
}

TEST_F(Extremes, RoomAllDoors) {
    std::vector<Hole> holes;
    for (std::size_t side = 0; side < 4; ++side)
        for (int k = 0; k < 3; ++k) holes.push_back({side, 0.02 + k * 0.33, 0.31 + k * 0.33});
    const RoomLayout layout = furnish(room_of(rectangle(3, 3), holes));
    EXPECT_EQ(find(layout, "bookshelf"), nullptr);
}

TEST_F(Extremes, RoundRoom) {
    std::vector<plans::Point> circle;
    for (int k = 0; k < 120; ++k)
        circle.push_back({2.6 * std::cos(k * 0.0523598775598), 2.6 * std::sin(k * 0.0523598775598)});
    EXPECT_GT(furnish(room_of(circle)).pieces.size(), 6u);
}

TEST_F(Extremes, NoFreeWall) {
    std::vector<Hole> holes;
    for (std::size_t side = 0; side < 4; ++side) holes.push_back({side, 0, 1, Beyond::Window, 0, 2.4});
    const RoomLayout layout = furnish(room_of(rectangle(4, 4), holes));
    EXPECT_EQ(find(layout, "bookshelf"), nullptr);
    EXPECT_NE(find(layout, "ceiling_lamp"), nullptr);
}

TEST_F(Extremes, NeedleAndSliver) {
    EXPECT_EQ(furnish(room_of({{0, 0}, {12, 0}, {12, 0.002}})).pieces.size(), 0u);
    (void)furnish(room_of(rectangle(40, 0.3)));
}

TEST_F(Extremes, LowCeiling) {
    const RoomLayout layout = furnish(room_of(rectangle(5, 4), {{0, 0.1, 0.3}}, 0.3));
    for (const modeler::RoomPiece& piece : layout.pieces) EXPECT_LE(piece.size[2], 0.3);
}

TEST_F(Extremes, TenThousandCorners) {
    std::vector<plans::Point> star;
    for (int k = 0; k < 10000; ++k) {
        const double r = k % 2 == 0 ? 12 : 11.6, a = k * 0.00062831853;
        star.push_back({r * std::cos(a), r * std::sin(a)});
    }
    EXPECT_GT(furnish(room_of(star)).pieces.size(), 3u);
}

TEST(Guarantees, HoldFarFromTheOrigin) {
    RoomShape room = passage_room();
    room.frame.origin_x = 512345.5;
    room.frame.origin_y = 5412345.25;
    const RoomLayout layout = furnished(room, shelves(6), {entry("bookshelf", 0.8, 0.3, 2)}, 4);
    EXPECT_GE(layout.pieces.size(), 4u);
    EXPECT_EQ(faults(room, checked(room, layout)), "");
}

TEST(FurnishRoom, NamesWhatOfAGroupFoundNoPlace) {
    const RoomLayout layout = furnished(
        room_of(rectangle(1.25, 2.2)),
        R"({"rooms": [{"kind": "test", "objects": [{"object": "bed", "with": [{"object": "bedside_table"}]}]}]})",
        {entry("bed", 0.9, 2, 0.5), entry("bedside_table", 0.4, 0.4, 0.5)});
    EXPECT_EQ(layout.pieces.size(), 1u);
    EXPECT_EQ(layout.requested, 2u);
    EXPECT_EQ(layout.no_place, std::vector<std::string>{"bedside_table"});
}

TEST(FurnishRoom, IsTheSameForTheSameSeedAndAnotherForAnother) {
    const modeler::EntryLists entries(own_entries());
    const auto layout = [&](std::uint64_t seed) {
        const RoomLayout made =
            modeler::furnish_room(passage_room(), *modeler::own_rules().find("office"), 0.2, entries, {}, seed);
        std::string text;
        for (const auto& piece : made.pieces)
            text += piece.entry->id + " " + std::to_string(piece.pose.at.x) + " " + std::to_string(piece.pose.at.y) +
                    " " + std::to_string(piece.pose.angle) + "\n";
        return text;
    };
    EXPECT_EQ(layout(5), layout(5));
    EXPECT_NE(layout(5), layout(6));
}

}  // namespace
}  // namespace enfilade::testing
