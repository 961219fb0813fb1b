#include "tools/report/cell_layers.h"

#include <gtest/gtest.h>

#include "tests/report/faulty_building.h"
#include "tests/report/path_rings.h"

namespace enfilade::tools {
namespace {

CellSide cut(Mm from, Mm to, std::uint32_t front, std::uint32_t back, double area) {
    return {from, to, front, back, SideKind::Cut, area};
}

TEST(CellLayers, APortalOfSeveralFacesHasTheirAreasTogether) {
    const CellPaths paths = cell_paths(
        {{cut({0, 0}, {0, 200}, 1, 2, 0.4), cut({0, 200}, {0, 400}, 2, 1, 0.4), cut({9, 0}, {9, 200}, 1, 3, 0.4)}, {}});
    EXPECT_EQ(paths.cuts[area_class(0.8)].text(), "m0 0v200 200");
    EXPECT_EQ(paths.cuts[area_class(0.4)].text(), "m9 0v200");
    EXPECT_TRUE(paths.nodes.empty() && paths.links.empty()) << "no middles, no graph";
}

TEST(CellLayers, TellCutsFromSeamsAndDoors) {
    EXPECT_EQ(side_kind(accel::PortalKind::Virtual, true), SideKind::Cut);
    EXPECT_EQ(side_kind(accel::PortalKind::Virtual, false), SideKind::Seam);
    EXPECT_EQ(side_kind(accel::PortalKind::Clear, false), SideKind::Clear);
    EXPECT_EQ(side_kind(accel::PortalKind::Glass, false), SideKind::Glass);
    const CellPaths paths = cell_paths({{{{0, 0}, {5, 0}, 0, 1, SideKind::Seam, 3},
                                         {{0, 1}, {5, 1}, 0, 2, SideKind::Clear, 3},
                                         {{0, 2}, {5, 2}, 0, 3, SideKind::Glass, 3},
                                         {{0, 3}, {5, 3}, 0, 0, SideKind::Leaf},
                                         {{0, 4}, {5, 4}, 0, 0, SideKind::Solid}},
                                        {}});
    EXPECT_EQ(paths.border.text(), "m0 0h5");
    EXPECT_EQ(paths.clear.text(), "m0 1h5");
    EXPECT_EQ(paths.glass.text(), "m0 2h5");
    EXPECT_EQ(paths.leaves.text(), "m0 3h5");
    EXPECT_EQ(cut_tags(paths), "");
    EXPECT_EQ(testing::PathReader(paths.cells.text()).rings().size(), 5u) << "every side borders a cell";
}

/// An L of one room has one reflex corner: one cut, whose area is known.
TEST(CellLayers, DrawTheCutOfARoomInTheColourOfItsArea) {
    plans::Plan plan = testing::one_room();
    const plans::Wall model = plan.storeys[0].walls[0];
    const std::vector<plans::Point> corners = {{0, 0}, {8, 0}, {8, 3}, {3, 3}, {3, 6}, {0, 6}};
    plan.storeys[0].walls.clear(), plan.storeys[0].openings.clear(), plan.storeys[0].rooms.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        plan.storeys[0].walls.push_back(model);
        plan.storeys[0].walls.back().id = "w" + std::to_string(k);
        plan.storeys[0].walls.back().start = corners[k];
        plan.storeys[0].walls.back().end = corners[(k + 1) % corners.size()];
    }
    const modeler::Building building = testing::cells_of(plan);
    const PlanView view(building);
    const CellPlan cells = cell_plan(view, 0);
    double area = 0;
    std::size_t cuts = 0;
    for (const CellSide& side : cells.sides)
        if (side.kind == SideKind::Cut && building.volumes[side.front].label == modeler::Label::Room)
            area += side.area_m2, ++cuts;
    EXPECT_EQ(cuts, 1u);
    // From the inner corner straight to the other wall, or along the diagonal to the far corner.
    const double height = view.building().frame.unit * (building.storeys[0].z_ceiling - building.storeys[0].z_floor);
    const double inner = 3 - model.thickness;
    EXPECT_GE(area, 0.99 * inner * height);
    EXPECT_LE(area, 1.01 * std::sqrt(2.0) * inner * height);
    EXPECT_FALSE(cell_paths(cells).cuts[area_class(area)].empty());
}

}  // namespace
}  // namespace enfilade::tools
