#include "tools/report/scene_plan.h"

#include <gtest/gtest.h>

#include "modeler/check.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "tests/report/faulty_building.h"
#include "tools/cut_summary.h"
#include "tools/report/cut_sheet.h"

namespace enfilade::tools {
namespace {

accel::Scene scene_of(const plans::Plan& plan) {
    const modeler::Building building = testing::cells_of(plan);
    return modeler::export_scene(building, modeler::check(building), "{}");
}
plans::Plan curved_room() { return plans::read(ENFILADE_SOURCE_DIR "/plans/examples/curved-room.json"); }

double area_m2(const std::vector<std::vector<Mm>>& rings) {
    double twice = 0;
    for (const std::vector<Mm>& ring : rings)
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Mm a = ring[k], b = ring[(k + 1) % ring.size()];
            twice += double(a.x) * double(b.y) - double(a.y) * double(b.x);
        }
    return twice / 2e6;
}

double exterior_m2(const accel::SceneView& scene, float level) {
    double twice = 0;
    for (const accel::Cell& cell : scene.cells) {
        if (cell.label != accel::Label::Exterior || level < cell.z_floor || level >= cell.z_ceiling) continue;
        for (std::uint32_t k = 0; k < cell.section_count; ++k) {
            const std::uint32_t a = cell.first_section + k, b = cell.first_section + (k + 1) % cell.section_count;
            twice += double(scene.section_x[a]) * double(scene.section_y[b]) -
                     double(scene.section_x[b]) * double(scene.section_y[a]);
        }
    }
    return twice / 2;
}

TEST(ScenePlan, RoomsAreAsLargeAsTheSceneSays) {
    const accel::Scene scene = scene_of(curved_room());
    const ScenePlan plan = scene_plan(scene.view(), scene_storeys(scene.view()).at(0).level);
    std::size_t rooms = 0;
    for (const SpaceOutline& space : plan.spaces) {
        if (space.label != accel::Label::Room) continue;
        ++rooms;
        EXPECT_EQ(space.rings.size(), 2u) << "a room around a column";
        EXPECT_NEAR(area_m2(space.rings), scene.view().spaces[index(space.space)].area_m2, 0.02);
    }
    EXPECT_EQ(rooms, 1u);
}

/// Walls are what is left of the site: nothing is drawn twice, and nothing is missing.
TEST(ScenePlan, WallsRoomsAndExteriorFillTheSite) {
    for (const plans::Plan& input : {curved_room(), testing::two_rooms(), testing::two_storeys()}) {
        const accel::Scene scene = scene_of(input);
        const accel::SceneView& view = scene.view();
        float low_x = 1e9f, high_x = -1e9f, low_y = 1e9f, high_y = -1e9f;
        for (std::size_t s = 0; s < view.section_count(); ++s) {
            low_x = std::min(low_x, view.section_x[s]), high_x = std::max(high_x, view.section_x[s]);
            low_y = std::min(low_y, view.section_y[s]), high_y = std::max(high_y, view.section_y[s]);
        }
        for (const SceneStorey& storey : scene_storeys(view)) {
            const ScenePlan plan = scene_plan(view, storey.level);
            double sum = area_m2(plan.solid) + exterior_m2(view, storey.level);
            EXPECT_GT(area_m2(plan.solid), 1);
            for (const SpaceOutline& space : plan.spaces) sum += area_m2(space.rings);
            EXPECT_NEAR(sum, double(high_x - low_x) * double(high_y - low_y), 0.05) << storey.name;
            EXPECT_FALSE(plan.is_underground);
        }
    }
}

TEST(ScenePlan, DrawsTheSameCutsAsTheBuilding) {
    const modeler::Building building = testing::cells_of(curved_room());
    const accel::Scene scene = modeler::export_scene(building, modeler::check(building), "{}");
    const ScenePlan plan = scene_plan(scene.view(), scene_storeys(scene.view()).at(0).level);
    const auto areas = [](const CellPlan& cells, SideKind kind) {
        double sum = 0;
        for (const CellSide& side : cells.sides)
            if (side.kind == kind) sum += side.area_m2;
        return sum;
    };
    const CellPlan expected = cell_plan(PlanView(building), 0);
    EXPECT_NEAR(areas(plan.inside, SideKind::Cut) + areas(plan.outside, SideKind::Cut), areas(expected, SideKind::Cut),
                1e-3);
    EXPECT_NEAR(areas(plan.inside, SideKind::Glass), areas(expected, SideKind::Glass), 1e-3);
    EXPECT_NEAR(areas(plan.inside, SideKind::Clear), areas(expected, SideKind::Clear), 1e-3);
    EXPECT_GT(areas(plan.inside, SideKind::Cut), 1);
}

TEST(ScenePlan, ABasementHasNoExterior) {
    plans::Plan plan = testing::two_storeys();
    plan.ground_level = plan.storeys[1].elevation;
    const accel::Scene scene = scene_of(plan);
    const std::vector<SceneStorey> storeys = scene_storeys(scene.view());
    ASSERT_EQ(storeys.size(), 2u);
    EXPECT_TRUE(scene_plan(scene.view(), storeys[0].level).is_underground);
    EXPECT_FALSE(scene_plan(scene.view(), storeys[1].level).is_underground);
}

TEST(CutSummary, AWholeRoomHasNoCutsAndCostsOneVisit) {
    const accel::Scene scene = scene_of(testing::two_rooms());
    const modeler::CutCost cost{.visit = 1, .section = 0, .face = 0};
    const std::vector<SpaceCuts> spaces = cuts_per_space(scene.view(), cost);
    std::size_t rooms = 0;
    for (std::size_t s = 0; s < spaces.size(); ++s) {
        if (scene.view().spaces[s].label != accel::Label::Room || spaces[s].cells != 1) continue;
        ++rooms;
        EXPECT_EQ(spaces[s].cut_area_m2, 0);
        EXPECT_NEAR(spaces[s].sah_sum, 1, 1e-9) << "whoever crosses the room visits its one cell";
        EXPECT_GE(spaces[s].sections, 4u);
        EXPECT_GE(spaces[s].faces, spaces[s].sections);
    }
    EXPECT_GT(rooms, 0u);
}

TEST(CutSummary, CutsAreAsLargeAsTheDrawingShows) {
    const accel::Scene scene = scene_of(curved_room());
    const accel::SceneView& view = scene.view();
    const std::vector<SpaceCuts> spaces = cuts_per_space(view);
    const ScenePlan plan = scene_plan(view, scene_storeys(view).at(0).level);
    double drawn = 0, told = 0;
    std::size_t cells = 0;
    for (const CellSide& side : plan.inside.sides)
        if (side.kind == SideKind::Cut && view.cells[side.front].label == accel::Label::Room) drawn += side.area_m2;
    for (std::size_t s = 0; s < spaces.size(); ++s) {
        cells += spaces[s].cells;
        if (view.spaces[s].label != accel::Label::Room) continue;
        told += spaces[s].cut_area_m2;
        EXPECT_GT(spaces[s].sah_sum, 1);
    }
    EXPECT_EQ(cells, view.cells.size());
    EXPECT_NEAR(drawn, told, 1e-3);
    EXPECT_GE(virtual_area(view), told);
}

TEST(CutSheet, NeedsNothingAroundIt) {
    const accel::Scene scene = scene_of(testing::two_storeys());
    const std::string svg = cut_sheet("a <b>", storey_panels(scene.view(), scene_storeys(scene.view())));
    EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_NE(svg.find("<title>a &lt;b&gt;</title>"), std::string::npos);
    for (const char* foreign : {"href", "var(", "@import", "<script"}) EXPECT_EQ(svg.find(foreign), std::string::npos);
    for (std::size_t k = 0; k < area_classes.size(); ++k)
        EXPECT_NE(svg.find("swatch a" + std::to_string(k) + "\""), std::string::npos) << "the legend has every class";
}

TEST(CutSheet, IsSoundWithoutPanels) { EXPECT_TRUE(cut_sheet("nothing", {}).ends_with("</svg>\n")); }

}  // namespace
}  // namespace enfilade::tools
