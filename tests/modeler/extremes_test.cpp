// Plans at the edges of what can be drawn (docs/extremes.md): what comes out is sound, or the plan is said to be wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

using plans::OpeningKind;

/// Errors of the model: those of the plan's stages (P...) say that the plan is wrong.
std::string model_errors(const CheckReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        if (finding.severity == Severity::Error && finding.code[0] != 'P')
            text += finding.code + " " + finding.sentence + "\n";
    return text;
}

struct Built {
    Building convex;
    CheckReport report;
    [[nodiscard]] std::size_t rooms() const {
        return std::size_t(std::count_if(convex.spaces.begin(), convex.spaces.end(),
                                         [](const Space& space) { return space.label == Label::Room; }));
    }
};

Built built(const plans::Plan& plan, const BuildOptions& options = {}) {
    Built result{convexify(build(plan, options)), {}};
    result.report = check(result.convex);
    EXPECT_EQ(model_errors(result.report), "") << plan.name;
    (void)export_scene(result.convex, result.report, "{}");
    return result;
}

plans::Plan box_with_walls(const std::vector<plans::Wall>& walls) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.insert(plan.storeys[0].walls.end(), walls.begin(), walls.end());
    return plan;
}

TEST(Extremes, WallsOfAnyThickness) {
    for (const double thickness : {10.0, 1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-6})
        built(box_with_walls({testing::wall("odd", {2, 0}, {2, 3}, thickness)}));
}

TEST(Extremes, AWallThinnerThanTheGridIsNamed) {
    const Built result = built(box_with_walls({testing::wall("hair", {2, 0}, {2, 3}, 1e-6)}));
    const bool is_named =
        std::any_of(result.report.findings.begin(), result.report.findings.end(), [](const Finding& finding) {
            return std::any_of(finding.elements.begin(), finding.elements.end(),
                               [](const ElementRef& e) { return e.id == "hair"; });
        });
    EXPECT_TRUE(is_named);
}

TEST(Extremes, WallsThatMeetAtAHundredthOfADegree) {
    const double angle = 0.01 * std::numbers::pi / 180;
    built(box_with_walls(
        {testing::wall("a", {0, 1}, {4, 1}, 0.1), testing::wall("b", {0, 1}, {4, 1 + 4 * std::tan(angle)}, 0.1)}));
}

TEST(Extremes, ParallelWallsATenthOfAMillimetreApart) {
    for (const double gap : {1e-3, 1e-4, 1e-5, 1e-9})
        built(box_with_walls(
            {testing::wall("a", {2, 0}, {2, 3}, 0.1), testing::wall("b", {2.1 + gap, 0}, {2.1 + gap, 3}, 0.1)}));
}

TEST(Extremes, PointsAroundTheSnapTolerance) {
    for (const double step : {1e-9, 1e-6, 1e-4, 1e-3}) {
        // A chain in which each end is near the next one's start, the last far from the first.
        std::vector<plans::Wall> chain;
        for (int k = 0; k < 20; ++k)
            chain.push_back(testing::wall("c" + std::to_string(k), {0.2 * k + (k % 2 ? step : 0), 1.5},
                                          {0.2 * (k + 1) + (k % 3 ? step : 0), 1.5 + step}, 0.1));
        built(box_with_walls(chain));
    }
}

TEST(Extremes, ArcsOfAFewToThousandsOfFacets) {
    for (const double sagitta_mm : {200.0, 20.0, 2.0, 0.01, 0.0001}) {
        plans::Plan plan = testing::one_room();
        plans::Wall arc = testing::wall("arc", {1, 0}, {3, 0}, 0.1);
        arc.arc_extent = -std::numbers::pi;
        plan.storeys[0].walls.push_back(arc);
        BuildOptions options;
        options.arrange.sagitta_mm = sagitta_mm;
        built(plan, options);
    }
}

TEST(Extremes, ArcsOfOneCentimetreToTenKilometres) {
    for (const double radius : {0.01, 0.1, 10.0, 1e3, 1e4}) {
        plans::Plan plan = testing::one_room();
        const double chord = std::min(2.0, radius);
        plans::Wall arc = testing::wall("arc", {1, 1.5}, {1 + chord, 1.5}, std::min(0.1, radius / 4));
        arc.arc_extent = 2 * std::asin(chord / 2 / radius);
        plan.storeys[0].walls.push_back(arc);
        built(plan);
    }
}

TEST(Extremes, ARoundRoom) {
    plans::Plan plan;
    plan.name = "round";
    plan.storeys.push_back(testing::storey("ground"));
    for (int k = 0; k < 4; ++k) {
        const auto at = [](int q) {
            return plans::Point{4 * std::cos(q * std::numbers::pi / 2), 4 * std::sin(q * std::numbers::pi / 2)};
        };
        plans::Wall quarter = testing::wall("q" + std::to_string(k), at(k), at(k + 1));
        quarter.arc_extent = std::numbers::pi / 2;
        plan.storeys[0].walls.push_back(quarter);
    }
    EXPECT_EQ(built(plan).rooms(), 1u);
}

TEST(Extremes, NestedCourtyards) {
    plans::Plan plan;
    plan.name = "nested";
    plan.storeys.push_back(testing::storey("ground"));
    for (int ring = 0; ring < 5; ++ring) {
        const double half = 12 - 2 * ring;
        const std::vector<plans::Point> corner = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
        for (std::size_t k = 0; k < 4; ++k)
            plan.storeys[0].walls.push_back(
                testing::wall("r" + std::to_string(ring) + "w" + std::to_string(k), corner[k], corner[(k + 1) % 4]));
        if (ring % 2 == 1)
            plan.storeys[0].rooms.push_back({"court" + std::to_string(ring),
                                             "Court",
                                             "courtyard",
                                             {{-half + 0.2, -half + 0.2},
                                              {half - 0.2, -half + 0.2},
                                              {half - 0.2, half - 0.2},
                                              {-half + 0.2, half - 0.2}}});
    }
    built(plan);
}

TEST(Extremes, AColumnThatTouchesTheWallInAPoint) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].columns.push_back({"c", "", {{1, 0.125}, {1.5, 0.625}, {1, 1.125}, {0.5, 0.625}}, 0});
    built(plan);
}

TEST(Extremes, DoorsAtCornersSideBySideAsHighAndAsWideAsTheWall) {
    const std::vector<std::vector<plans::Opening>> cases = {
        {testing::opening("corner", OpeningKind::Door, "s", 0.45, 0.9, 0, 2)},
        {testing::opening("a", OpeningKind::Door, "s", 1, 1, 0, 2),
         testing::opening("b", OpeningKind::Door, "s", 2, 1, 0, 2)},
        {testing::opening("high", OpeningKind::Door, "s", 2, 1, 0, 2.5)},
        {testing::opening("wide", OpeningKind::Window, "s", 2, 9, 0, 2)},
        {testing::opening("whole", OpeningKind::Opening, "s", 2, 4, 0, 2.5)},
        {testing::opening("sliver", OpeningKind::Window, "s", 2, 1, 1, 1.0001)},
    };
    for (const auto& openings : cases) {
        plans::Plan plan = testing::one_room();
        plan.storeys[0].openings = openings;
        built(plan);
    }
}

TEST(Extremes, StoreysShiftedByAHair) {
    for (const double shift : {1e-9, 1e-5, 1e-4, 1e-3, 0.05}) {
        plans::Plan plan = testing::two_storeys();
        for (plans::Wall& wall : plan.storeys[1].walls)
            wall.start.x += shift, wall.end.x += shift, wall.start.y -= shift, wall.end.y -= shift;
        built(plan);
    }
}

TEST(Extremes, StairsThroughThreeStoreys) {
    plans::Plan plan = testing::two_storeys();
    plans::Storey top = plan.storeys[1];
    top.id = top.name = "top";
    top.elevation = 5.5;
    for (plans::Wall& wall : top.walls) wall.id += "t";
    for (plans::Opening& opening : top.openings) opening.id += "t", opening.wall += "t";
    plan.storeys[1].stairs.push_back({"stair 2", "", {{0.5, 0.5}, {1.5, 0.5}, {1.5, 3.5}, {0.5, 3.5}}});
    plan.storeys.push_back(top);
    const Built result = built(plan);
    int stairs = 0;
    for (const Volume& volume : result.convex.volumes) stairs += volume.label == Label::Stair;
    EXPECT_EQ(stairs, 4) << "two storeys, two slabs";
}

TEST(Extremes, LevelsAtOneElevation) {
    plans::Plan plan = testing::two_storeys();
    plan.storeys[1].elevation = 0;
    built(plan);
}

TEST(Extremes, TheOrderInTheFileDoesNotMatter) {
    plans::Plan shuffled = testing::two_storeys();
    std::mt19937 random(7);
    for (plans::Storey& storey : shuffled.storeys) {
        std::shuffle(storey.walls.begin(), storey.walls.end(), random);
        std::shuffle(storey.openings.begin(), storey.openings.end(), random);
    }
    const Building a = build(testing::two_storeys()), b = build(shuffled);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.map.arrays().alpha, b.map.arrays().alpha);
}

TEST(Extremes, RebuiltAHundredTimesFromItsOwnExportItIsTheSame) {
    plans::Plan plan = testing::two_storeys();
    const Building first = build(plan);
    Building last = first;
    for (int k = 0; k < 100; ++k) {
        plan = plans::read_json(last.plan_json, "again");
        last = build(plan);
    }
    EXPECT_EQ(last.plan_json, first.plan_json);
    EXPECT_EQ(last.vertices, first.vertices);
    EXPECT_EQ(last.map.arrays().alpha, first.map.arrays().alpha);
}

TEST(Extremes, UnitsOfTheFileDoNotMatter) {
    const std::string metres =
        R"({"name":"u","units":"m","storeys":[{"id":"g","name":"g","elevation":0,"height":2.5,"walls":[
        {"id":"a","start":[0,0],"end":[4,0],"thickness":0.25},{"id":"b","start":[4,0],"end":[4,3],"thickness":0.25},
        {"id":"c","start":[4,3],"end":[0,3],"thickness":0.25},{"id":"d","start":[0,3],"end":[0,0],"thickness":0.25}]}]})";
    const std::string millimetres =
        R"({"name":"u","units":"mm","storeys":[{"id":"g","name":"g","elevation":0,"height":2500,"walls":[
        {"id":"a","start":[0,0],"end":[4000,0],"thickness":250},{"id":"b","start":[4000,0],"end":[4000,3000],"thickness":250},
        {"id":"c","start":[4000,3000],"end":[0,3000],"thickness":250},{"id":"d","start":[0,3000],"end":[0,0],"thickness":250}]}]})";
    EXPECT_EQ(build(plans::read_json(metres, "m")).vertices, build(plans::read_json(millimetres, "mm")).vertices);
}

TEST(Extremes, AnEnfiladeOfAThousandRoomsIsSeenThrough) {
    plans::Plan plan;
    plan.name = "enfilade";
    plans::Storey ground = testing::storey("ground");
    const int rooms = 1000;
    ground.walls.push_back(testing::wall("s", {0, 0}, {4.0 * rooms, 0}));
    ground.walls.push_back(testing::wall("n", {0, 4}, {4.0 * rooms, 4}));
    for (int k = 0; k <= rooms; ++k) {
        const std::string id = "w" + std::to_string(k);
        ground.walls.push_back(testing::wall(id, {4.0 * k, 0}, {4.0 * k, 4}));
        if (k > 0 && k < rooms)
            ground.openings.push_back(testing::opening("d" + std::to_string(k), OpeningKind::Door, id, 2, 1, 0, 2));
    }
    plan.storeys.push_back(ground);
    EXPECT_EQ(built(plan).rooms(), std::size_t(rooms));
}

}  // namespace
}  // namespace enfilade::modeler
