#include "accel/graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "accel/assemble.h"
#include "accel/stats.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

TEST(CellGraph, HasEachPortalFromBothSides) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .storeys = 2}));
    const CellGraph graph = cell_graph(scene.view());
    ASSERT_EQ(graph.links.size(), 2 * scene.view().portals.size());
    for (std::uint32_t c = 0; c + 1 < graph.offsets.size(); ++c)
        for (std::uint32_t l = graph.offsets[c]; l < graph.offsets[c + 1]; ++l) {
            const Portal& portal = scene.view().portals[index(graph.links[l].portal)];
            const auto self = static_cast<CellId>(c);
            EXPECT_TRUE(portal.front == self || portal.back == self);
            EXPECT_EQ(graph.links[l].to, portal.front == self ? portal.back : portal.front);
        }
}

TEST(CellGraph, IsOneComponentWithDoorsAndOneMoreForEachClosedRoom) {
    const Scene open = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2}));
    EXPECT_EQ(std::ranges::max(components(cell_graph(open.view()))), 0u);
    const Scene closed = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .doors = false}));
    EXPECT_EQ(std::ranges::max(components(cell_graph(closed.view()))), 7u);  // 6 rooms, a corridor, the exterior
}

TEST(SpaceGraph, LinksEachDoorToItsRoomAndItsCorridor) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2}));
    const SceneView& view = scene.view();
    std::vector<std::set<SpaceId>> neighbours(view.spaces.size());
    for (const SpaceLink& link : space_graph(view)) {
        EXPECT_LT(link.a, link.b);
        neighbours[index(link.a)].insert(link.b);
        neighbours[index(link.b)].insert(link.a);
    }
    for (std::size_t s = 0; s < view.spaces.size(); ++s) {
        if (view.spaces[s].label == Label::Door || view.spaces[s].label == Label::Window) {
            EXPECT_EQ(neighbours[s].size(), 2u);
        }
    }
}

TEST(SceneStats, CountsCellsOfRooms) {
    const SceneStats s = stats(assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2})));
    EXPECT_EQ(s.rooms, 7u);
    EXPECT_EQ(s.room_cells, 7u);
    EXPECT_DOUBLE_EQ(s.cells_per_room(), 1);
    EXPECT_EQ(s.portals_of_kind[static_cast<int>(PortalKind::Glass)], 6u);
    EXPECT_EQ(s.portals_of_kind[0] + s.portals_of_kind[1] + s.portals_of_kind[2], s.portals);
}

}  // namespace
}  // namespace enfilade::accel
