// The order, the limits and the doors of beams.

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "accel/assemble.h"
#include "accel/beam.h"
#include "accel/graph.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

struct Seen {
    CellId cell, from;
    PortalId portal;
    std::uint32_t depth, number, parent;
    bool is_widened;
    friend bool operator==(const Seen&, const Seen&) = default;
};

std::vector<Seen> walk(BeamWalker& walker, const BeamSource& source) {
    std::vector<Seen> steps;
    walker.start(source);
    while (const BeamStep* s = walker.next())
        steps.push_back({s->cell, s->from, s->portal, s->depth, s->number, s->parent, s->is_widened});
    return steps;
}

class BeamWalk : public testing::Test {
protected:
    Scene scene = assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2}));
    const SceneView& view = scene.view();

    [[nodiscard]] CellId first_of(Label label) const {
        for (std::uint32_t c = 0; c < view.cells.size(); ++c)
            if (view.cells[c].label == label) return CellId{c};
        return none<CellId>;
    }
};

TEST_F(BeamWalk, StepsFormATreeOfPortals) {
    BeamWalker walker(view);
    for (std::uint32_t c = 0; c < view.cells.size(); c += 7) {
        const std::vector<Seen> steps = walk(walker, source_of_cell(view, CellId{c}));
        ASSERT_FALSE(steps.empty());
        EXPECT_EQ(steps[0], (Seen{CellId{c}, none<CellId>, none<PortalId>, 0, 0, 0, false}));
        for (std::uint32_t n = 1; n < steps.size(); ++n) {
            EXPECT_EQ(steps[n].number, n);
            ASSERT_LT(steps[n].parent, n);
            const Seen& parent = steps[steps[n].parent];
            EXPECT_EQ(steps[n].from, parent.cell);
            EXPECT_EQ(steps[n].depth, parent.depth + 1);
            const Portal& portal = view.portals[index(steps[n].portal)];
            EXPECT_EQ(std::minmax(steps[n].from, steps[n].cell), std::minmax(portal.front, portal.back));
        }
    }
}

TEST_F(BeamWalk, IsTheSameFromAFreshWalkerAndAUsedOne) {
    BeamWalker used(view);
    for (std::uint32_t c = 0; c < view.cells.size(); c += 5) {
        BeamWalker fresh(view);
        const BeamSource source = source_of_cell(view, CellId{c});
        EXPECT_EQ(walk(used, source), walk(fresh, source));
    }
}

TEST_F(BeamWalk, GoesNoFurtherWhereItIsPruned) {
    BeamWalker walker(view);
    const CellId room = first_of(Label::Room);
    walker.start(source_of_cell(view, room));
    std::size_t behind_doors = 0, others = 0;
    while (const BeamStep* step = walker.next()) {
        if (view.cells[index(step->cell)].label == Label::Door) walker.prune();
        if (step->depth > 0 && view.cells[index(step->from)].label == Label::Door) ++behind_doors;
        ++others;
    }
    EXPECT_EQ(behind_doors, 0u);
    EXPECT_GT(others, 2u);
}

TEST_F(BeamWalk, StopsAtGlassAndClosedPortalsAndTheDepthAskedFor) {
    const BeamSource source = source_of_cell(view, first_of(Label::Room));
    const auto has = [&](const std::vector<CellId>& cells, Label label) {
        return std::ranges::any_of(cells, [&](CellId c) { return view.cells[index(c)].label == label; });
    };
    const auto panes = [&](const BeamOptions& options) {
        BeamWalker walker(view, options);
        return std::ranges::count_if(walk(walker, source), [&](const Seen& step) {
            return step.depth > 0 && view.portals[index(step.portal)].kind() == PortalKind::Glass;
        });
    };
    EXPECT_GT(panes({}), 0);
    EXPECT_EQ(panes({.through_glass = false}), 0);
    EXPECT_TRUE(has(reachable_cells(view, source, {.through_glass = false}), Label::Door));

    std::vector<std::uint8_t> closed(view.portals.size(), 0);
    for (std::size_t p = 0; p < closed.size(); ++p)
        closed[p] = view.cells[index(view.portals[p].front)].label == Label::Door ||
                    view.cells[index(view.portals[p].back)].label == Label::Door;
    EXPECT_FALSE(has(reachable_cells(view, source, {.closed = closed}), Label::Door));
    EXPECT_TRUE(has(reachable_cells(view, source, {.closed = closed}), Label::Exterior));

    EXPECT_EQ(reachable_cells(view, source, {.max_depth = 0}), std::vector<CellId>{source.cell});
    const CellGraph graph = cell_graph(view);
    const std::size_t c = index(source.cell);
    EXPECT_EQ(reachable_cells(view, source, {.max_depth = 1}).size(), 1u + graph.offsets[c + 1] - graph.offsets[c]);
}

TEST_F(BeamWalk, WidensInsteadOfDroppingWhenItIsLimited) {
    std::size_t widened = 0;
    for (std::uint32_t c = 0; c < view.cells.size(); c += 3) {
        const BeamSource source = source_of_cell(view, CellId{c});
        const std::vector<CellId> exact = reachable_cells(view, source, {.max_beams = 0});
        for (const std::uint32_t limit : {1u, 2u, 8u}) {
            const std::vector<CellId> cells = reachable_cells(view, source, {.max_beams = limit});
            EXPECT_TRUE(std::ranges::includes(cells, exact));
        }
        BeamWalker walker(view, {.max_beams = 1});
        std::map<std::tuple<PortalId, CellId>, std::size_t> count;
        for (const Seen& step : walk(walker, source)) {
            widened += step.is_widened;
            EXPECT_LE((++count[{step.portal, step.from}]), 5u) << "one as it is, and four widened ones";
        }
    }
    EXPECT_GT(widened, 100u);
}

TEST_F(BeamWalk, GoesUpAndDownStairsButNotThroughSlabs) {
    const auto storey = [&](CellId c) { return view.cells[index(c)].z_floor < 2.5f ? 0 : 1; };
    std::size_t stairs = 0;
    for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
        if (view.cells[c].label != Label::Stair || storey(CellId{c}) != 0) continue;
        ++stairs;
        const float x = view.section_x[view.cells[c].first_section] + 0.5f;
        const float y = view.section_y[view.cells[c].first_section] + 0.5f;
        const auto up = source_at(view, {double{x}, double{y}, double{view.cells[c].z_floor}});
        ASSERT_TRUE(up);
        EXPECT_TRUE(std::ranges::any_of(reachable_cells(view, *up), [&](CellId r) { return storey(r) == 1; }));
    }
    EXPECT_GT(stairs, 0u);
    std::vector<std::uint8_t> no_stairs_or_windows(view.portals.size(), 0);
    for (std::size_t p = 0; p < view.portals.size(); ++p)
        for (const CellId c : {view.portals[p].front, view.portals[p].back})
            if (const Label l = view.cells[index(c)].label; l == Label::Stair || l == Label::Window)
                no_stairs_or_windows[p] = 1;
    for (std::uint32_t c = 0; c < view.cells.size(); ++c)
        if (view.cells[c].label == Label::Room) {
            for (const CellId r :
                 reachable_cells(view, source_of_cell(view, CellId{c}), {.closed = no_stairs_or_windows}))
                EXPECT_EQ(storey(r), storey(CellId{c}));
        }
}

TEST(BeamCorridor, OfTenThousandDoorsIsSeenThrough) {
    const Scene scene = assemble(test::synthetic_corridor(10000));
    const SceneView& view = scene.view();
    const double west = view.locator_nodes[0].low[0];
    const auto point = source_at(view, {west + 0.125, 0, 1});
    ASSERT_TRUE(point);
    BeamWalker walker(view);
    walker.start(*point);
    std::uint32_t deepest = 0;
    std::size_t steps = 0;
    while (const BeamStep* step = walker.next()) {
        deepest = std::max(deepest, step->depth);
        ++steps;
    }
    EXPECT_EQ(deepest + 1, view.cells.size());
    EXPECT_EQ(steps, view.cells.size());
    EXPECT_EQ(reachable_cells(view, source_of_cell(view, point->cell)).size(), view.cells.size());
    EXPECT_EQ(reachable_cells(view, source_of_cell(view, CellId{10000})).size(), view.cells.size());
}

TEST(BeamCorridor, IsLeftWhereTheDoorsHideIt) {
    // Rooms 0.3 m long and 2 m wide, walls of 0.1 m, doors 1 m wide: from (0.125, -0.9) all that gets through the
    // first door passes the edge at (0.3, -0.5).
    const Scene scene = assemble(test::synthetic_corridor(50));
    const SceneView& view = scene.view();
    const double west = view.locator_nodes[0].low[0];
    const auto corner = source_at(view, {west + 0.125, -0.9, 1});
    ASSERT_TRUE(corner);
    // Door k (from 1) opens at x = 0.4 k - 0.1 .. 0.4 k, |y| < 0.5: the slope past (0.3, -0.5) is 0.4 / 0.175 at least,
    // so y = 0.5 at x = 0.125 + 1.4 / 2.29 = 0.74: behind the beginning of the second door (0.7), before its end (0.8).
    const std::vector<CellId> cells = reachable_cells(view, *corner);
    EXPECT_EQ(cells.size(), 4u) << "two rooms and two doors";
}

TEST(BeamSources, ArePointsOnTheGridOrSmallBoxes) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    const SceneView& view = scene.view();
    const auto exact = source_at(view, {1, 1.5, 1});
    ASSERT_TRUE(exact);
    EXPECT_EQ(exact->corners.size(), 1u);
    EXPECT_EQ(exact->z_low, exact->z_high);
    const auto between = source_at(view, {1 + view.unit / 3, 1.5, 1});
    ASSERT_TRUE(between);
    EXPECT_EQ(between->corners.size(), 2u);
    EXPECT_FALSE(source_at(view, {-1000, 0, 0}));
}

}  // namespace
}  // namespace enfilade::accel
