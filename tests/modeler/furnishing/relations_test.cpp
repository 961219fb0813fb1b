// Each relation of a rule: where the pieces stand that it places.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "modeler/furnishing/candidates.h"
#include "tests/modeler/furnishing/furnished_room.h"

namespace enfilade::testing {
namespace {

using modeler::Beyond;
using modeler::RoomLayout;
using modeler::RoomPiece;
using modeler::RoomShape;

constexpr double unit = 1.0 / 8192;
constexpr double pi = std::numbers::pi;

std::vector<modeler::CatalogueEntry> entries() {
    std::vector<modeler::CatalogueEntry> list = {entry("bed", 0.9, 2, 0.5),
                                                 entry("bedside_table", 0.4, 0.4, 0.5),
                                                 entry("table_lamp", 0.2, 0.2, 0.4),
                                                 entry("picture", 0.8, 0.03, 0.6),
                                                 entry("table", 1.6, 0.8, 0.75),
                                                 entry("chair", 0.45, 0.5, 0.9),
                                                 entry("wardrobe", 1.2, 0.6, 2.0),
                                                 entry("tv_stand", 1.2, 0.4, 0.5),
                                                 entry("sofa", 1.9, 0.9, 0.8),
                                                 entry("ceiling_lamp", 0.4, 0.4, 0.3),
                                                 entry("rug", 3, 2, 0.01),
                                                 entry("coffee_table", 1, 0.6, 0.4),
                                                 entry("unit", 0.6, 0.6, 0.9),
                                                 entry("desk", 1.2, 0.6, 0.75),
                                                 entry("round_table", 1.1, 1.1, 0.75)};
    return list;
}

std::string rules(const std::string& objects) {
    return "{\"temperature\": 0.05, \"rooms\": [{\"kind\": \"test\", \"objects\": [" + objects + "]}]}";
}

plans::Point metres(const RoomPiece& piece) { return piece.pose.at * unit; }
/// How far the middle of its back is from the nearest side of a 5 m x 4 m room.
double back_gap(const RoomPiece& piece, double width, double depth) {
    const plans::Point back = metres(piece) - piece.pose.front() * (piece.size[1] / 2);
    return std::min({back.x, back.y, width - back.x, depth - back.y});
}

TEST(AgainstWall, HasItsBackToTheWallAndLooksIntoTheRoom) {
    const RoomShape room = room_of(rectangle(5, 4), {{0, 0.1, 0.28}});
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const RoomLayout layout = furnished(room, rules(R"({"object": "wardrobe"})"), entries(), seed);
        ASSERT_EQ(layout.pieces.size(), 1u);
        EXPECT_LT(std::abs(back_gap(layout.pieces[0], 5, 4)), 0.002);
        EXPECT_EQ(faults(room, checked(room, layout)), "");
    }
}

TEST(AgainstWall, TurnsWithObliqueWalls) {
    const double c = std::cos(0.37), s = std::sin(0.37);
    std::vector<plans::Point> corners = rectangle(5, 4);
    for (plans::Point& p : corners) p = {c * p.x - s * p.y + 3, s * p.x + c * p.y - 7};
    const RoomShape room = room_of(corners);
    const RoomLayout layout = furnished(room, rules(R"({"object": "wardrobe", "count": 3})"), entries());
    ASSERT_EQ(layout.pieces.size(), 3u);
    for (const RoomPiece& piece : layout.pieces) EXPECT_NEAR(std::remainder(piece.pose.angle - 0.37, pi / 2), 0, 1e-3);
    EXPECT_EQ(faults(room, checked(room, layout)), "");
}

TEST(AgainstWall, TouchesACurvedWallWithItsBackCorners) {
    std::vector<plans::Point> circle;
    for (int k = 0; k < 90; ++k) circle.push_back({3 * std::cos(2 * pi * k / 90), 3 * std::sin(2 * pi * k / 90)});
    const RoomShape room = room_of(circle);
    const RoomLayout layout = furnished(room, rules(R"({"object": "wardrobe", "count": 4})"), entries());
    ASSERT_EQ(layout.pieces.size(), 4u);
    EXPECT_EQ(faults(room, checked(room, layout)), "");
    for (const RoomPiece& piece : layout.pieces) {
        const plans::Point back = metres(piece) - piece.pose.front() * 0.3, along = piece.pose.along() * 0.6;
        EXPECT_NEAR(plans::norm(back + along), 3, 0.02);
        EXPECT_NEAR(plans::norm(back - along), 3, 0.02);
    }
}

TEST(AgainstWall, HangsWhatItsCatalogueHangsThere) {
    std::vector<modeler::CatalogueEntry> basins = {entry("wash_basin", 0.6, 0.5, 0.5)};
    basins[0].elevation = 0.46;
    const RoomShape room = room_of(rectangle(3, 3));
    const auto height = [&](const std::string& object) {
        const RoomLayout layout = furnished(room, rules(object), basins);
        EXPECT_EQ(layout.pieces.size(), 1u);
        EXPECT_LT(std::abs(back_gap(layout.pieces.at(0), 3, 3)), 0.002);
        return layout.pieces.at(0).z_low * unit;
    };
    EXPECT_NEAR(height(R"({"object": "wash_basin"})"), 0.46, 0.001);
    EXPECT_NEAR(height(R"({"object": "wash_basin", "elevation": 0.3})"), 0.3, 0.001);
}

TEST(NearWindow, StandsBesideTheWindow) {
    const RoomShape room = room_of(rectangle(8, 4), {{2, 0.1, 0.25, Beyond::Window, 0.9, 2}});
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const RoomLayout layout =
            furnished(room, rules(R"({"object": "desk", "place": "near_window"})"), entries(), seed);
        ASSERT_EQ(layout.pieces.size(), 1u);
        EXPECT_LT(plans::distance(metres(layout.pieces[0]), {7.2, 4}, {6, 4}), 1.2 + 0.9);
    }
}

TEST(Middle, TakesTheCentreWhereThatCounts) {
    const RoomShape room = room_of(rectangle(6, 5));
    const RoomLayout layout =
        furnished(room, rules(R"({"object": "table", "place": "middle", "score": {"centre": 5}})"), entries());
    ASSERT_EQ(layout.pieces.size(), 1u);
    EXPECT_LT(plans::distance(metres(layout.pieces[0]), {3, 2.5}), 0.8);
}

TEST(Around, SetsChairsOnAllSidesThatFaceTheTable) {
    const RoomShape room = room_of(rectangle(6, 5));
    for (const char* table : {"table", "round_table"}) {
        const RoomLayout layout =
            furnished(room,
                      rules(std::string(R"({"object": ")") + table +
                            R"(", "place": "middle", "with": [{"object": "chair", "count": 6, "place": "around"}]})"),
                      entries());
        ASSERT_EQ(layout.pieces.size(), 7u) << table;
        const plans::Point at = metres(layout.pieces[0]);
        for (std::size_t k = 1; k < 7; ++k) {
            const RoomPiece& chair = layout.pieces[k];
            const plans::Point to = at - metres(chair);
            // It looks at the table: straight on its side, or at its middle.
            EXPECT_GT(plans::dot(to, chair.pose.front()), 0.4) << table;
            EXPECT_LT(plans::norm(to), 1.5) << table;
        }
        EXPECT_EQ(faults(room, checked(room, layout)), "") << table;
    }
}

TEST(Beside, LinesUpTheBacksOnBothSides) {
    const RoomShape room = room_of(rectangle(5, 4));
    const RoomLayout layout = furnished(room, rules(R"({"object": "bed", "score": {"wall_middle": 3}, "with": [
                 {"object": "bedside_table", "count": 2, "place": "beside", "needed": true}]})"),
                                        entries());
    ASSERT_EQ(layout.pieces.size(), 3u);
    EXPECT_LT(std::abs(back_gap(layout.pieces[1], 5, 4)), 0.002);
    EXPECT_LT(std::abs(back_gap(layout.pieces[2], 5, 4)), 0.002);
    const double way = plans::distance(metres(layout.pieces[1]), metres(layout.pieces[2]));
    EXPECT_NEAR(way, 0.9 + 0.4 + 0.06, 0.01);
}

TEST(InFront, FacesWhatItStandsBefore) {
    const RoomShape room = room_of(rectangle(5, 4));
    const RoomLayout layout = furnished(
        room, rules(R"({"object": "desk", "with": [{"object": "chair", "place": "in_front", "needed": true}]})"),
        entries());
    ASSERT_EQ(layout.pieces.size(), 2u);
    const plans::Point look = layout.pieces[1].pose.front();
    EXPECT_NEAR(plans::dot(look, layout.pieces[0].pose.front()), -1, 1e-9);
    EXPECT_GT(plans::dot(metres(layout.pieces[0]) - metres(layout.pieces[1]), look), 0.5);
}

TEST(OnTop, StandsOnTheTopAndWithinIt) {
    const RoomShape room = room_of(rectangle(5, 4));
    const RoomLayout layout = furnished(
        room, rules(R"({"object": "desk", "with": [{"object": "table_lamp", "count": 3, "place": "on_top"}]})"),
        entries());
    ASSERT_EQ(layout.pieces.size(), 4u);
    for (std::size_t k = 1; k < 4; ++k) {
        const RoomPiece& lamp = layout.pieces[k];
        EXPECT_EQ(lamp.carrier, 0u);
        EXPECT_NEAR(lamp.z_low * unit, 0.75, 2 * unit);
        const plans::Point d = metres(lamp) - metres(layout.pieces[0]);
        EXPECT_LE(std::abs(plans::dot(d, layout.pieces[0].pose.along())) + 0.1, 0.6);
        EXPECT_LE(std::abs(plans::dot(d, layout.pieces[0].pose.front())) + 0.1, 0.3);
    }
    EXPECT_EQ(faults(room, checked(room, layout)), "");
}

TEST(Under, LiesFlatAndCarriesThePiece) {
    const RoomShape room = room_of(rectangle(6, 5));
    const RoomLayout layout = furnished(room, rules(R"({"object": "coffee_table", "place": "middle", "with": [
                 {"object": "table_lamp", "place": "on_top"}, {"object": "rug", "place": "under"}]})"),
                                        entries());
    ASSERT_EQ(layout.pieces.size(), 3u);
    const RoomPiece& table = layout.pieces[0];
    const RoomPiece* rug = find(layout, "rug");
    const RoomPiece* lamp = find(layout, "table_lamp");
    ASSERT_NE(rug, nullptr);
    ASSERT_NE(lamp, nullptr);
    EXPECT_EQ(rug->z_low, 0);
    EXPECT_NEAR(table.z_low * unit, 0.01, 2 * unit);
    EXPECT_NEAR(lamp->z_low * unit, 0.41, 3 * unit);
    EXPECT_EQ(&layout.pieces[table.carrier], rug);
    EXPECT_EQ(faults(room, checked(room, layout)), "");
}

TEST(Above, HangsOnTheWallOverThePiece) {
    const RoomShape room = room_of(rectangle(5, 4));
    const RoomLayout layout = furnished(
        room, rules(R"({"object": "bed", "with": [{"object": "picture", "place": "above", "gap": 0.5}]})"), entries());
    ASSERT_EQ(layout.pieces.size(), 2u);
    EXPECT_NEAR(layout.pieces[1].z_low * unit, 1.0, 3 * unit);
    EXPECT_LT(std::abs(back_gap(layout.pieces[1], 5, 4)), 0.003);
    EXPECT_EQ(faults(room, checked(room, layout)), "");
}

TEST(Opposite, FacesFromADistance) {
    const RoomShape room = room_of(rectangle(5, 4));
    const RoomLayout layout = furnished(room, rules(R"({"object": "tv_stand", "with": [
                 {"object": "sofa", "place": "opposite", "gap": 1.5, "most_gap": 3.5, "needed": true}]})"),
                                        entries());
    ASSERT_EQ(layout.pieces.size(), 2u);
    const RoomPiece &stand = layout.pieces[0], &sofa = layout.pieces[1];
    EXPECT_NEAR(plans::dot(stand.pose.front(), sofa.pose.front()), -1, 1e-9);
    const double way = plans::dot(metres(sofa) - metres(stand), stand.pose.front()) - 0.2 - 0.45;
    EXPECT_GE(way, 1.49);
    EXPECT_LE(way, 3.6);
}

TEST(InRow, GoesOnAlongTheWall) {
    const RoomShape room = room_of(rectangle(6, 4));
    const RoomLayout layout = furnished(
        room,
        rules(
            R"({"object": "unit", "score": {"wall_middle": 5}, "with": [{"object": "unit", "count": 4, "place": "in_row"}]})"),
        entries());
    ASSERT_EQ(layout.pieces.size(), 5u);
    std::vector<double> along;
    for (const RoomPiece& piece : layout.pieces) {
        EXPECT_LT(std::abs(back_gap(piece, 6, 4)), 0.002);
        along.push_back(plans::dot(metres(piece), layout.pieces[0].pose.along()));
    }
    std::sort(along.begin(), along.end());
    for (std::size_t k = 1; k < along.size(); ++k) EXPECT_NEAR(along[k] - along[k - 1], 0.6, 0.002);
}

TEST(Rows, StandInLine) {
    const RoomShape room = room_of(rectangle(9, 7), {{0, 0.1, 0.2}});
    const RoomLayout layout =
        furnished(room, rules(R"({"object": "desk", "count": 9, "place": "rows", "gap": 1.4, "with": [
                 {"object": "chair", "place": "in_front", "needed": true}]})"),
                  entries());
    EXPECT_EQ(layout.pieces.size(), 18u);
    for (const RoomPiece& piece : layout.pieces) EXPECT_NEAR(std::remainder(piece.pose.angle, pi), 0, 1e-9);
    EXPECT_EQ(faults(room, checked(room, layout)), "");
}

TEST(Ceiling, HangsEvenlyUnderIt) {
    const RoomShape room = room_of(rectangle(9, 3));
    const RoomLayout layout =
        furnished(room, rules(R"({"object": "ceiling_lamp", "count": 3, "place": "ceiling"})"), entries());
    ASSERT_EQ(layout.pieces.size(), 3u);
    std::vector<double> xs;
    for (const RoomPiece& lamp : layout.pieces) {
        EXPECT_NEAR(lamp.z_low * unit + 0.3, 2.49, 0.002);
        xs.push_back(metres(lamp).x);
    }
    std::sort(xs.begin(), xs.end());
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(xs[k], 1.5 + 3 * double(k), 0.4);
}

TEST(Ceiling, HangsTheFlattestLampWherePeopleWouldRunIntoOthers) {
    const RoomShape low = room_of(rectangle(4, 3)), high = room_of(rectangle(4, 3), {}, 3.2);
    const std::vector<modeler::CatalogueEntry> lamps = {
        entry("ceiling_lamp", 0.3, 0.3, 0.8), entry("ceiling_lamp", 0.5, 0.5, 0.1), entry("table", 3, 2, 0.7)};
    const auto hung = [&](const RoomShape& room, const std::string& before) {
        std::size_t long_ones = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const std::string asked = rules(before + R"({"object": "ceiling_lamp", "place": "ceiling"})");
            long_ones += furnished(room, asked, lamps, seed).pieces.back().size[2] > 0.5;
        }
        return long_ones;
    };
    EXPECT_EQ(hung(low, ""), 0u);
    EXPECT_GT(hung(high, ""), 0u);
    EXPECT_GT(hung(low, R"({"object": "table", "place": "middle"}, )"), 0u);
}

TEST(OnWall, HangsAtEyeLevelAndNotOverWindows) {
    const RoomShape room =
        room_of(rectangle(3, 3),
                {{0, 0.05, 0.95, Beyond::Window, 0.9, 2.2}, {1, 0.05, 0.95, Beyond::Window, 0.9, 2.2}, {2, 0.2, 0.6}});
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const RoomLayout layout =
            furnished(room, rules(R"({"object": "picture", "place": "on_wall"})"), entries(), seed);
        ASSERT_EQ(layout.pieces.size(), 1u);
        EXPECT_NEAR(layout.pieces[0].z_low * unit + 0.3, 1.55, 0.01);
        EXPECT_EQ(faults(room, checked(room, layout)), "");
    }
}

TEST(Unless, AsksForNothingWhereItStands) {
    const RoomShape room = room_of(rectangle(5, 4));
    const RoomLayout layout = furnished(
        room, rules(R"({"object": "sofa"}, {"object": "sofa", "unless": "sofa"}, {"object": "bed", "unless": "desk"})"),
        entries());
    EXPECT_EQ(layout.pieces.size(), 2u);
    EXPECT_EQ(layout.requested, 2u);
}

}  // namespace
}  // namespace enfilade::testing
