// What `bench convexify` counts and fits, on buildings where the answer is known otherwise.

#include <gtest/gtest.h>

#include "modeler/build.h"
#include "plans/generate.h"
#include "tools/convexifiers.h"
#include "tools/counting_walk.h"
#include "tools/cut_building.h"
#include "tools/even_rays.h"
#include "tools/least_squares.h"
#include "tools/real_plans.h"
#include "tools/room_shapes.h"

namespace enfilade::tools {
namespace {

modeler::Building curved_floor() { return modeler::build(plans::generate({.rooms = 20, .curved = 0.5})); }

TEST(CutFigures, TheSurfaceThatIsCutDoesNotDependOnTheCuts) {
    const modeler::Building whole = curved_floor();
    const CutFigures a = cut_building(whole, {.convexifier = modeler::Convexifier::HertelMehlhorn}).figures;
    for (const NamedConvexifier& method : named_convexifiers) {
        const CutFigures b = cut_building(whole, {.convexifier = method.convexifier}).figures;
        // Points of cuts are rounded to the grid.
        EXPECT_NEAR(a.parent_surface, b.parent_surface, 1e-5 * a.parent_surface) << method.name;
        EXPECT_GE(b.cell_surface, b.parent_surface);
        EXPECT_LE(b.cell_surface, b.parent_surface + 2 * b.portal_area * (1 + 1e-9));
        EXPECT_EQ(b.rooms, 20u);
    }
}

TEST(CutFigures, TheSumIsTheExpectedNumberOfVisitsWhereNothingElseCosts) {
    const CutFigures figures = cut_building(curved_floor(), {}).figures;
    EXPECT_DOUBLE_EQ(figures.sah_sum({1, 0, 0}), figures.cell_surface / figures.parent_surface);
    EXPECT_NEAR(figures.sah_sum({1, 0.5, 0}) - figures.sah_sum({1, 0, 0}),
                0.5 * figures.section_surface / figures.parent_surface, 1e-9);
}

TEST(CountingWalk, VisitsTheCellsThatTheTracerVisits) {
    const CutBuilding cut = cut_building(curved_floor(), {});
    const std::vector<render::RayQuery> rays = even_rays(cut.scene.view(), 2000, 3);
    std::vector<render::RayHit> hits(rays.size());
    render::RayStats stats;
    render::trace_rays(cut.scene.view(), rays, hits, render::Precision::Float, &stats);
    WalkCount count;
    for (const render::RayQuery& ray : rays) count = count + counted_walk(cut.scene.view(), ray, cut.parents);
    EXPECT_EQ(count.visits, stats.cells);
    EXPECT_LT(count.wholes, count.visits);
    EXPECT_GE(count.wholes, rays.size());
    EXPECT_GE(count.sections, 3 * count.visits);
    EXPECT_GE(count.faces, count.sections);
    EXPECT_LE(count.eights, count.sections);
    EXPECT_EQ(narrow_walks(cut.scene.view(), rays), rays.size());
}

TEST(EvenRays, SeeTheSameHoweverRoomsAreCut) {
    const modeler::Building whole = curved_floor();
    const CutBuilding a = cut_building(whole, {.convexifier = modeler::Convexifier::HertelMehlhorn});
    const CutBuilding b = cut_building(whole, {.convexifier = modeler::Convexifier::Sah});
    const SameRays rays({&a.scene.view(), &b.scene.view()}, 20'000, 2, 16);
    EXPECT_GT(rays.ray_count(), 19'900u);
    EXPECT_EQ(rays.pixel_count(), 2u * 16 * 16);
    EXPECT_EQ(rays.agreement(1, 0).leaks, 0u);
    EXPECT_LE(rays.agreement(1, 0).differ, 2u) << "edges are rounded within half a grid unit";
}

modeler::RingCorner corner(std::int32_t x, std::int32_t y, std::uint32_t line) { return {{x, y}, line}; }

TEST(RoomPieces, CountsCornersThatTurnRightBetweenLines) {
    const std::vector<modeler::RingCorner> square = {corner(0, 0, 0), corner(9, 0, 1), corner(9, 9, 2),
                                                     corner(0, 9, 3)};
    EXPECT_EQ(reflex_corners(square).count, 0u);
    const std::vector<modeler::RingCorner> cross = {
        corner(3, 0, 0), corner(6, 0, 1), corner(6, 3, 2), corner(9, 3, 3), corner(9, 6, 4),  corner(6, 6, 5),
        corner(6, 9, 6), corner(3, 9, 7), corner(3, 6, 8), corner(0, 6, 9), corner(0, 3, 10), corner(3, 3, 11)};
    EXPECT_EQ(reflex_corners(cross).count, 4u);
    EXPECT_EQ(reflex_corners(cross).longest, 1u);
    // The lower side bends by a rounding, and is one line.
    const std::vector<modeler::RingCorner> bent = {corner(0, 0, 0), corner(50, 1, 0), corner(99, 0, 1),
                                                   corner(99, 99, 2), corner(0, 99, 3)};
    EXPECT_EQ(reflex_corners(bent).count, 0u);
}

TEST(RoomPieces, KnowsTheChainOfACurvedWall) {
    // The lower wall bulges into the room: five corners that turn right one after the other.
    std::vector<modeler::RingCorner> room = {corner(0, 0, 0),   corner(10, 40, 1), corner(30, 70, 2), corner(50, 80, 3),
                                             corner(70, 70, 4), corner(90, 40, 5), corner(100, 0, 6)};
    room.insert(room.end(), {corner(100, 200, 7), corner(0, 200, 8)});
    EXPECT_EQ(reflex_corners(room).count, 5u);
    EXPECT_EQ(reflex_corners(room).longest, 5u);
}

TEST(RoomPieces, AreNeverFewerThanCornersNeed) {
    const modeler::Building whole = curved_floor();
    for (const NamedConvexifier& method : named_convexifiers) {
        const RoomPieces rooms = cut_building(whole, {.convexifier = method.convexifier}).rooms;
        EXPECT_GE(rooms.rooms, 10u) << method.name;
        EXPECT_GT(rooms.reflex, 0u);
        EXPECT_GE(rooms.pieces, rooms.enough) << method.name;
    }
    const RoomPieces plain = cut_building(modeler::build(plans::generate({.rooms = 12})),
                                          {.convexifier = modeler::Convexifier::HertelMehlhorn})
                                 .rooms;
    EXPECT_EQ(plain.reflex, 0u);
    EXPECT_EQ(plain.pieces, plain.rooms);
}

TEST(RoomShapes, AreSimpleRings) {
    for (const RoomShape shape : {RoomShape::Comb, RoomShape::Star, RoomShape::Arcs})
        for (const std::uint32_t corners : {100u, 1000u, 10'000u}) {
            const ShapedRoom room = shaped_room(shape, corners);
            EXPECT_NEAR(double(room.points.size()), corners, 0.3 * corners) << name_of(shape);
            EXPECT_EQ(modeler::simple_ring(room.sides).size(), room.points.size());
            EXPECT_GT(modeler::area2(room.points, room.sides), 0);
            for (const plans::GridPoint p : room.points) EXPECT_LT(std::max(std::abs(p.x), std::abs(p.y)), 1 << 24);
        }
}

TEST(LeastSquares, FindsTheConstants) {
    std::vector<Measurement> measurements;
    for (int i = 0; i < 40; ++i) {
        const double visits = 1 + i % 7, sections = 3 * visits + i % 5;
        measurements.push_back({{1, visits, sections}, 40 + 17 * visits + 0.5 * sections, 1});
    }
    const Fit fit = fit_constants(measurements);
    EXPECT_NEAR(fit.constants[0], 40, 1e-6);
    EXPECT_NEAR(fit.constants[1], 17, 1e-6);
    EXPECT_NEAR(fit.constants[2], 0.5, 1e-6);
    EXPECT_LT(fit.median_residual, 1e-9);
}

TEST(LeastSquares, HoldsAtZeroWhatWouldBeNegative) {
    std::vector<Measurement> measurements;
    for (int i = 0; i < 40; ++i) {
        const double visits = 1 + i % 7, sections = 3 * visits + i % 5;
        measurements.push_back({{visits, sections}, 17 * visits - 0.5 * sections, 1});
    }
    const Fit fit = fit_constants(measurements);
    EXPECT_GT(fit.constants[0], 10);
    EXPECT_EQ(fit.constants[1], 0);
    EXPECT_EQ(fit.standard_errors[1], 0);
}

TEST(LeastSquares, CorrelatesWhatGrowsTogether) {
    const std::vector<double> a = {1, 2, 3, 4}, b = {10, 20, 30, 40}, c = {4, 3, 2, 1}, flat = {5, 5, 5, 5};
    EXPECT_NEAR(correlation(a, b), 1, 1e-12);
    EXPECT_NEAR(correlation(a, c), -1, 1e-12);
    EXPECT_EQ(correlation(a, flat), 0);
}

TEST(RealPlanList, IsEmptyWhereTheFolderIsNotThere) { EXPECT_TRUE(real_plans("no/such/folder").empty()); }

TEST(RealPlanList, KnowsWhatDrawingsDoNotSay) {
    const std::vector<RealPlan> plans = real_plans(ENFILADE_SOURCE_DIR "/../shared/data");
    if (plans.empty()) GTEST_SKIP() << "no real plans beside this checkout (../shared/data)";
    EXPECT_GE(plans.size(), 20u);
    for (const RealPlan& plan : plans)
        if (plan.name == "ConstructIQ_house_plan.dxf") {
            EXPECT_TRUE(plan.options.crop.has_value());
        }
}

}  // namespace
}  // namespace enfilade::tools
