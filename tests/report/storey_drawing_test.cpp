#include "tools/report/storey_drawing.h"

#include <gtest/gtest.h>

#include "tests/report/faulty_building.h"
#include "tests/report/path_rings.h"
#include "tools/report/plan_symbols.h"
#include "tools/report/room_graph.h"
#include "tools/report/wall_outline.h"

namespace enfilade::tools {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t number = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
    return number;
}

TEST(StoreyDrawing, WallsAreOneOutlineOfTheirArea) {
    const modeler::Building building = testing::cells_of(testing::two_rooms());
    const PlanView view(building);
    // 1.1 m above the floor: both doors and the window are cut out.
    const double walls = 4.25 * 3.25 - 3.75 * 2.75 + 0.125 * 2.75 - 1 * 0.25 - 0.75 * 0.125 - 1 * 0.25;
    EXPECT_NEAR(testing::path_area(wall_outlines(view, 0).cut.text()), walls, 0.01);
    EXPECT_TRUE(wall_outlines(view, 0).low.empty()) << "a window's sill is no low wall";
}

TEST(StoreyDrawing, AFenceIsALowWall) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("fence", {10, 0}, {14, 0}, 0.25, 1));
    const modeler::Building building = testing::cells_of(plan);
    EXPECT_NEAR(testing::path_area(wall_outlines(PlanView(building), 0).low.text()), 4 * 0.25, 0.01);
}

TEST(StoreyDrawing, ADoorOpensIntoTheRoomAroundItsNearerJamb) {
    const modeler::Building building = testing::cells_of(testing::one_room());
    const PlanView view(building);
    const DoorPaths doors = door_paths(view, find_passages(view), 0);
    const auto leaves = testing::PathReader(doors.leaves.text()).rings();
    ASSERT_EQ(leaves.size(), 1u);
    // The wall runs along y = 0, 0.25 m thick, the door from x = 0.5 to 1.5 of it: open it stands in the room.
    EXPECT_EQ(leaves[0], (std::vector<Mm>{view.mm(0.5, 0.125), view.mm(0.5, 1.125)}));
    const auto swings = testing::PathReader(doors.swings.text()).rings();
    ASSERT_EQ(swings.size(), 1u);
    EXPECT_EQ(swings[0], (std::vector<Mm>{view.mm(1.5, 0.125), view.mm(0.5, 1.125)}));
}

TEST(StoreyDrawing, AShutDoorHasNoSwing) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].openings[0].open_angle = 0;
    const modeler::Building building = testing::cells_of(plan);
    const PlanView view(building);
    const DoorPaths doors = door_paths(view, find_passages(view), 0);
    EXPECT_FALSE(doors.leaves.empty());
    EXPECT_TRUE(doors.swings.empty());
}

TEST(StoreyDrawing, AWindowIsTwoLines) {
    const modeler::Building building = testing::cells_of(testing::two_rooms());
    EXPECT_EQ(testing::PathReader(window_paths(PlanView(building), 0).text()).rings().size(), 2u);
}

TEST(StoreyDrawing, AStairHasTreadsAndAnArrow) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    const PlanView view(building);
    EXPECT_EQ(testing::PathReader(stair_paths(view, 0).treads.text()).rings().size(), 14u)
        << "15 steps of 20 cm on 3 m";
    EXPECT_FALSE(stair_paths(view, 0).arrows.empty());
    EXPECT_TRUE(stair_paths(view, 1).treads.empty());
}

TEST(StoreyDrawing, HasARoomForEachAndOutlinesOfTheBlamed) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    const PlanView view(building);
    const Passages passages = find_passages(view);
    const std::string upper = storey_drawing(view, passages, 1, nullptr, {"um"});
    EXPECT_EQ(count(upper, "class=\"room "), 2u);
    EXPECT_EQ(count(upper, "class=\"mark\" data-el=\"um\""), 1u);
    EXPECT_EQ(count(upper, "layer-cells"), 0u);
    EXPECT_EQ(count(upper, "class=\"well\""), 1u) << "the stair comes up here";
}

TEST(StoreyDrawing, CellsAndPortalsAreLayers) {
    const modeler::Building building = testing::cells_of(testing::two_rooms());
    const PlanView view(building);
    const CellPaths cells = cell_paths(cell_plan(view, 0));
    EXPECT_FALSE(cells.clear.empty());
    EXPECT_FALSE(cells.glass.empty());
    EXPECT_FALSE(cells.links.empty());
    const std::string drawing = storey_drawing(view, find_passages(view), 0, &cells, {});
    for (const char* layer : {"grid", "rooms", "stairs", "furniture", "walls", "windows", "doors", "marks", "cells",
                              "portals", "cuts", "graph", "names"})
        EXPECT_EQ(count(drawing, std::string("layer layer-") + layer + "\""), 1u) << layer;
}

TEST(StoreyDrawing, FarFromTheOriginIsDrawnAsHere) {
    plans::Plan far = testing::two_rooms();
    for (plans::Wall& wall : far.storeys[0].walls) wall.start.x += 1e6, wall.end.x += 1e6;
    const modeler::Building here = testing::cells_of(testing::two_rooms()), there = testing::cells_of(far);
    const PlanView here_view(here), there_view(there);
    EXPECT_EQ(storey_drawing(here_view, find_passages(here_view), 0, nullptr, {}),
              storey_drawing(there_view, find_passages(there_view), 0, nullptr, {}));
}

TEST(RoomGraph, HasANodeForEachRoomAndALinkForEachDoor) {
    const modeler::Building building = testing::cells_of(testing::two_rooms());
    const PlanView view(building);
    const Passages passages = find_passages(view);
    const std::string graph = room_graph(view, passages, 0);
    EXPECT_EQ(count(graph, "class=\"gnode "), 2u);
    EXPECT_EQ(count(graph, "class=\"glink door\""), 2u);
    EXPECT_EQ(room_graph_caption(view, passages, 0), "2 rooms, 2 links; 2 doors from outside at most.");
}

TEST(RoomGraph, NamesRoomsThatNobodyCanReach) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].openings.clear();
    plan.storeys[0].rooms.push_back({"cell", "Cell <1>", "room", {{0.2, 0.2}, {3.8, 0.2}, {3.8, 2.8}, {0.2, 2.8}}});
    const modeler::Building building = testing::cells_of(plan);
    const PlanView view(building);
    EXPECT_NE(room_graph_caption(view, find_passages(view), 0).find("No way leads to</strong> Cell &lt;1&gt;"),
              std::string::npos);
}

}  // namespace
}  // namespace enfilade::tools
