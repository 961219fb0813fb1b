// The sheet of docs/dxf.md gives what the page says.

#include <gtest/gtest.h>

#include "plans/dxf/drawing.h"
#include "tests/plans/dxf/sheet_of_plan.h"

namespace enfilade::plans {
namespace {

const std::filesystem::path folder = std::filesystem::path(ENFILADE_SOURCE_DIR) / "plans/examples/drawings";

std::vector<std::string> names_of_rooms(const Plan& plan) {
    std::vector<std::string> names;
    for (const Room& room : plan.storeys.at(0).rooms) names.push_back(room.name);
    std::sort(names.begin(), names.end());
    return names;
}

using Names = std::vector<std::string>;

TEST(TwoStoreysOnOneSheet, AreReadBoxByBox) {
    ReadOptions options{.mapping = folder / "two-storeys-mapping.json"};
    options.crop = DrawingBox{-100, -100, 1100, 900};
    const Plan ground = read(folder / "two-storeys.dxf", options);
    EXPECT_EQ(names_of_rooms(ground), (Names{"Diele", "Küche", "Wohnen"}));
    EXPECT_EQ(dxf_text::contents_of(ground), (dxf_text::Contents{3, 3, 4, 0}));
    options.crop = DrawingBox{1400, -100, 2600, 900};
    const Plan upper = read(folder / "two-storeys.dxf", options);
    EXPECT_EQ(names_of_rooms(upper), (Names{"Bad", "Kind 1", "Schlafen"}));
    EXPECT_EQ(dxf_text::contents_of(upper), (dxf_text::Contents{3, 2, 4, 0}));
    for (const Opening& opening : upper.storeys[0].openings)
        EXPECT_EQ(opening.sill, opening.kind == OpeningKind::Window ? 0.6 : 0);
}

TEST(TwoStoreysOnOneSheet, AreOneRoomEachWithoutTheMapping) {
    const Plan both = read(folder / "two-storeys.dxf");
    EXPECT_EQ(dxf_text::contents_of(both).rooms, 2u);
}

using namespace dxf_text;

/// A room of 6 m x 4 m in millimetres, its walls of 0.2 m, and what else is drawn.
std::string room_with(const std::string& more, const std::string& layers = {}) {
    const auto rectangle = [](double x0, double y0, double x1, double y1) {
        return line(x0, y0, x1, y0, "A-WALL") + line(x1, y0, x1, y1, "A-WALL") + line(x1, y1, x0, y1, "A-WALL") +
               line(x0, y1, x0, y0, "A-WALL");
    };
    return File{rectangle(0, 0, 6000, 4000) + rectangle(200, 200, 5800, 3800) + more,
                {},
                pairs({{9, "$INSUNITS"}, {70, 4}}),
                layers}
        .text();
}

std::string text_at(double x, double y, const char* written, const char* layer = "0") {
    return entity("TEXT", {{8, layer}, {10, x}, {20, y}, {40, 100}, {1, written}});
}

TEST(DrawingPage, SaysHowHighThingsAre) {
    const std::string low = line(200, 2000, 2000, 2000, "A-WALL-PRHT") + line(200, 2100, 2000, 2100, "A-WALL-PRHT");
    const std::string door = entity("ARC", {{8, "A-DOOR"}, {10, 3000}, {20, 200}, {40, 900}, {50, 0}, {51, 90}});
    const std::string window = line(3000, 3950, 4000, 3950, "A-GLAZ") + line(3000, 3850, 4000, 3850, "A-GLAZ");
    const Plan plan = read_dxf(room_with(low + door + window), "room.dxf");
    const Storey& storey = plan.storeys.at(0);
    EXPECT_EQ(storey.height, 2.5);
    ASSERT_EQ(storey.openings.size(), 2u);
    for (const Opening& opening : storey.openings) {
        EXPECT_EQ(opening.sill, opening.kind == OpeningKind::Window ? 0.9 : 0);
        EXPECT_EQ(opening.head, 2.1);
        EXPECT_NEAR(opening.width, opening.kind == OpeningKind::Window ? 1.0 : 0.9, 1e-9);
    }
    EXPECT_EQ(std::count_if(storey.walls.begin(), storey.walls.end(),
                            [](const Wall& wall) { return wall.height_at_start == 1.0; }),
              1);
}

TEST(DrawingPage, TakesClosedShapesOfColumnLayersForColumns) {
    const auto square = [](double x, double side, const char* layer) {
        return entity("LWPOLYLINE", {{8, layer},
                                     {90, 4},
                                     {70, 1},
                                     {10, x},
                                     {20, 1500},
                                     {10, x},
                                     {20, 1500 + side},
                                     {10, x + side},
                                     {20, 1500 + side},
                                     {10, x + side},
                                     {20, 1500}});
    };
    const std::string drawn = square(1000, 300, "S-COLS") + square(2000, 5, "S-COLS") + square(3000, 300, "A-FURN") +
                              line(4000, 1500, 4500, 1500, "S-COLS");
    const Plan plan = read_dxf(room_with(drawn), "room.dxf");
    ASSERT_EQ(plan.storeys.at(0).columns.size(), 1u);
    const std::vector<Point>& corners = plan.storeys[0].columns[0].polygon;
    EXPECT_EQ(corners.size(), 4u);
    for (const Point corner : corners) EXPECT_NEAR(std::abs(corner.x - 1.15), 0.15, 1e-9);
}

TEST(DrawingPage, ReadsFrozenLayersWhereTheyAreNamed) {
    const std::string frozen = room_with("", layer("A-WALL", 1));
    EXPECT_THROW((void)read_dxf(frozen, "room.dxf"), InputError);
    EXPECT_EQ(contents_of(read_dxf(frozen, "room.dxf", {.layers = {"A-WALL"}})).rooms, 1u);
}

TEST(DrawingPage, NamesRoomsByTextsOfLetters) {
    const auto name_of_room = [](const std::string& texts) {
        const std::vector<std::string> names = names_of_rooms(read_dxf(room_with(texts), "room.dxf"));
        return names.empty() ? "" : names.at(0);
    };
    EXPECT_EQ(name_of_room(text_at(2000, 2000, "Atelier")), "Atelier");
    EXPECT_EQ(name_of_room(text_at(2000, 2000, "WC")), "WC");
    EXPECT_EQ(name_of_room(text_at(2000, 2000, "UP")), "");
    EXPECT_EQ(name_of_room(text_at(2000, 2000, "see note on sheet seven")), "");
    EXPECT_EQ(name_of_room(text_at(2000, 2000, "13'8 x 14'")), "");
    EXPECT_EQ(name_of_room(text_at(2000, 2000, "Kitchen") + text_at(4000, 1000, "Dishwasher")), "Kitchen");
    EXPECT_EQ(name_of_room(text_at(2000, 2000, "Master") + text_at(2000, 1850, "bedroom")), "Master bedroom");
    EXPECT_EQ(name_of_room(text_at(2000, 3000, "Kitchen") + text_at(4000, 1000, "Dining")), "Kitchen / Dining");
    EXPECT_EQ(name_of_room(text_at(2000, 3000, "Kitchen") + text_at(4000, 1000, "Atelier", "A-AREA")), "Atelier");
}

}  // namespace
}  // namespace enfilade::plans
