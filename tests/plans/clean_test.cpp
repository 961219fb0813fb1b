#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "plans/generate.h"
#include "plans/layout.h"
#include "tests/plans/clean_support.h"
#include "tests/support/random_plan.h"

namespace enfilade::plans {
namespace {

using testing::add_box;
using testing::codes_of;
using testing::findings_of;
using testing::one_room;
using testing::opening;
using testing::opening_of;
using testing::plan_of;
using testing::storey;
using testing::two_storeys;
using testing::wall;
using testing::wall_of;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Random walls, and the faults that people draw: ends that nearly meet, slopes, twins, levels at one height.
Plan any_dirty_plan() {
    Plan plan = testing::any_plan();
    const auto shift = [] { return *rc::gen::inRange(-60, 61) / 1000.0; };
    for (Storey& level : plan.storeys) {
        if (*rc::gen::inRange(0, 3) == 0) level.elevation += *rc::gen::element(-2.0, -2.5, -2.75, 0.5);
        std::vector<Wall> more;
        for (std::size_t w = 0; w < level.walls.size(); ++w) {
            Wall& here = level.walls[w];
            const Wall& other = level.walls[std::size_t(*rc::gen::inRange(0, int(level.walls.size())))];
            switch (*rc::gen::inRange(0, 8)) {
                case 0: here.height_at_end = *rc::gen::element(0.0, 1.0, 3.0); break;
                case 1: here.start = {other.end.x + shift(), other.end.y + shift()}; break;
                case 2: here.end = {other.start.x + shift(), other.start.y + shift()}; break;
                case 3:
                    here.end = {(other.start.x + other.end.x) / 2 + shift(),
                                (other.start.y + other.end.y) / 2 + shift()};
                    break;
                case 4:
                    more.push_back(other);
                    more.back().id += "twin" + std::to_string(w);
                    more.back().thickness *= *rc::gen::element(1.0, 0.5);
                    if (*rc::gen::inRange(0, 2) == 0) {
                        std::swap(more.back().start, more.back().end);
                        more.back().arc_extent *= -1;
                    }
                    break;
                case 5: here.thickness = *rc::gen::element(0.0, -0.1, 0.2); break;
                default: break;
            }
        }
        level.walls.insert(level.walls.end(), more.begin(), more.end());
        for (Opening& hole : level.openings)
            if (*rc::gen::inRange(0, 4) == 0) hole.offset += *rc::gen::inRange(-20, 20) / 10.0;
        for (Room& room : level.rooms)
            if (*rc::gen::inRange(0, 4) == 0) room.polygon.push_back(room.polygon.front());
    }
    return plan;
}

template <class Element>
void shuffle(std::vector<Element>& elements, std::mt19937& random) {
    std::shuffle(elements.begin(), elements.end(), random);
}

void shuffle(Plan& plan, unsigned seed) {
    std::mt19937 random(seed);
    shuffle(plan.storeys, random);
    for (Storey& level : plan.storeys) {
        shuffle(level.walls, random);
        shuffle(level.openings, random);
        shuffle(level.rooms, random);
    }
}

template <class Element>
void by_id(std::vector<Element>& elements) {
    std::sort(elements.begin(), elements.end(), [](const Element& l, const Element& r) { return l.id < r.id; });
}

/// The text of a plan whose elements are listed by id.
std::string sorted_text(Plan plan) {
    for (Storey& level : plan.storeys) {
        by_id(level.walls);
        by_id(level.openings);
        by_id(level.rooms);
        by_id(level.columns);
        by_id(level.stairs);
        by_id(level.shafts);
    }
    return write_json(plan);
}

RC_GTEST_PROP(Clean, ChangesNothingTheSecondTime, ()) {
    const Plan once = clean(any_dirty_plan());
    const Plan twice = clean(once);
    RC_ASSERT(write_json(twice) == write_json(once));
}

RC_GTEST_PROP(Clean, ChangesNothingInAPlanThatItCleanedBeforeItWasWritten, ()) {
    const std::string text = write_json(clean(any_dirty_plan()));
    RC_ASSERT(write_json(clean(read_json(text, "plan.json"))) == text);
}

RC_GTEST_PROP(Clean, LeavesPlansThatCanBeLaidOut, ()) {
    const Plan plan = clean(any_dirty_plan());
    if (plan.storeys.empty()) return;
    const Layout layout = arrange(plan);
    // What is smaller than the grid is gone before: no wall vanishes later.
    for (const Finding& finding : layout.findings) RC_ASSERT(finding.code != "P302");
}

RC_GTEST_PROP(Clean, DoesNotDependOnTheOrderOfElements, ()) {
    const Plan plan = any_dirty_plan();
    Plan shuffled = plan;
    shuffle(shuffled, *rc::gen::arbitrary<unsigned>());
    RC_ASSERT(sorted_text(clean(shuffled)) == sorted_text(clean(plan)));
}

RC_GTEST_PROP(Clean, LeavesEveryOpeningInsideItsWall, ()) {
    const Plan plan = clean(any_dirty_plan());
    for (const Storey& level : plan.storeys)
        for (const Opening& hole : level.openings) {
            const Wall* host = wall_of(plan, hole.wall);
            RC_ASSERT(host != nullptr);
            const double chord = std::hypot(host->end.x - host->start.x, host->end.y - host->start.y);
            const double turn = std::abs(host->arc_extent);
            const double length = turn < 1e-9 ? chord : chord / (2 * std::sin(turn / 2)) * turn;
            RC_ASSERT(hole.width > 0);
            RC_ASSERT(hole.offset - hole.width / 2 > -1e-3);
            RC_ASSERT(hole.offset + hole.width / 2 < length + 1e-3);
            RC_ASSERT(hole.sill >= 0);
            RC_ASSERT(hole.head > hole.sill);
            RC_ASSERT(hole.head <= std::max(host->height_at_start, host->height_at_end) + 1e-3);
        }
}

RC_GTEST_PROP(Clean, LeavesLevelWallsWithSizes, ()) {
    const Plan plan = clean(any_dirty_plan());
    for (const Storey& level : plan.storeys)
        for (const Wall& w : level.walls) {
            RC_ASSERT(w.thickness > 0);
            RC_ASSERT(std::max(w.height_at_start, w.height_at_end) > 0);
            RC_ASSERT(std::abs(w.height_at_start - w.height_at_end) <= 0.01);
        }
}

TEST(Clean, FindsNothingInSoundPlans) {
    for (const Plan& plan : {one_room(), testing::two_rooms(), testing::ring_room(), two_storeys(),
                             generate({.rooms = 200, .storeys = 3, .curved = 0.3, .oblique = 0.3})}) {
        const Plan cleaned = clean(plan);
        EXPECT_EQ(codes_of(cleaned), "") << plan.name;
        EXPECT_EQ(write_json(cleaned), write_json(plan)) << plan.name;
    }
}

TEST(Clean, TakesLittleTimeForFiveThousandRooms) {
    const Plan plan = generate({.rooms = 5000, .curved = 0.2, .oblique = 0.2});
    const auto from = std::chrono::steady_clock::now();
    const Plan cleaned = clean(plan);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
    EXPECT_EQ(codes_of(cleaned), "");
    EXPECT_LT(took.count(), 1.0);  // 0.02 s where it was measured: what is quadratic takes many times a second
}

TEST(CleanStoreys, AreSortedByElevation) {
    Plan plan = two_storeys();
    std::swap(plan.storeys[0], plan.storeys[1]);
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "");
    EXPECT_EQ(cleaned.storeys[0].id, "ground");
    EXPECT_EQ(cleaned.storeys[1].id, "upper");
}

TEST(CleanStoreys, AtOneElevationAreMergedAndTheirCommonWallsKeptOnce) {
    Plan plan = one_room();
    Storey second = storey("second", 0);
    add_box(second, "2", 4, 3);
    second.walls.push_back(wall("2m", {2, 0}, {2, 3}, 0.125));
    second.openings.push_back(opening("door 2", OpeningKind::Door, "2n", 1, 0.75, 0, 2));
    plan.storeys.push_back(second);
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P201 P214 P214 P214 P214");
    ASSERT_EQ(cleaned.storeys.size(), 1u);
    EXPECT_EQ(cleaned.storeys[0].walls.size(), 5u);
    ASSERT_EQ(cleaned.storeys[0].openings.size(), 2u);
    // Both storeys have the same walls; the second, with one more, is the one that stays.
    EXPECT_EQ(cleaned.storeys[0].id, "second");
    EXPECT_EQ(opening_of(cleaned, "door")->wall, "2s");
    EXPECT_EQ(opening_of(cleaned, "door 2")->wall, "2n");
}

TEST(CleanStoreys, MergingKeepsTheTopsOfWalls) {
    Plan plan = one_room();
    Storey wing = storey("wing", 0.5);
    wing.walls.push_back(wall("far", {10, 0}, {14, 0}));
    plan.storeys.push_back(wing);
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P201");
    EXPECT_DOUBLE_EQ(cleaned.findings[0].moved_mm, 500);
    EXPECT_DOUBLE_EQ(wall_of(cleaned, "far")->height_at_end, 3.0);
    EXPECT_DOUBLE_EQ(cleaned.storeys[0].height, 3.0);
}

TEST(CleanStoreys, FalseCeilingsStayUnderTheFloorAbove) {
    Plan plan = two_storeys();
    Storey ceiling = storey("ceiling", 2.5);
    ceiling.height = 0.1;
    add_box(ceiling, "c", 2, 2);
    for (Wall& w : ceiling.walls) w.height_at_start = w.height_at_end = 0.1;
    ceiling.rooms.push_back({.id = "cr", .polygon = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
    ceiling.lights.push_back({.id = "lamp", .position = {1, 1}});
    plan.storeys.push_back(ceiling);
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P201");
    ASSERT_EQ(cleaned.storeys.size(), 2u);
    EXPECT_EQ(cleaned.storeys[1].id, "upper");
    EXPECT_EQ(cleaned.storeys[1].elevation, 2.75);
    EXPECT_EQ(cleaned.storeys[1].walls.size(), 5u);
    EXPECT_TRUE(cleaned.storeys[1].rooms.empty());
    EXPECT_EQ(cleaned.storeys[1].lights.size(), 1u);
}

TEST(CleanStoreys, TheGroundStaysWithItsStorey) {
    Plan plan = two_storeys();
    Storey sunk = storey("sunk", -0.5);
    add_box(sunk, "k", 20, 20);
    sunk.walls.push_back(wall("km", {10, 0}, {10, 20}));
    plan.storeys.push_back(sunk);
    const Plan cleaned = clean(plan);
    ASSERT_EQ(cleaned.storeys.size(), 2u);
    // The first storey at or above 0 is now the upper one: the ground must not rise to it.
    EXPECT_EQ(cleaned.ground_level, std::optional(-0.5));
}

TEST(CleanStoreys, WithoutWallsAndRoomsAreDroppedButTheirLampsKept) {
    Plan plan = two_storeys();
    Storey attic = storey("attic", 5.5);
    attic.lights.push_back({.id = "lamp", .position = {1, 1}, .elevation = 0.5});
    plan.storeys.push_back(attic);
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P202");
    EXPECT_EQ(cleaned.findings[0].severity, Severity::Note);
    ASSERT_EQ(cleaned.storeys.size(), 2u);
    ASSERT_EQ(cleaned.storeys[1].lights.size(), 1u);
    EXPECT_DOUBLE_EQ(cleaned.storeys[1].lights[0].elevation, 3.25);
}

TEST(CleanStoreys, WithoutAnElevationAreErrors) {
    Plan plan = two_storeys();
    plan.storeys[0].elevation = not_a_number;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P200");
    EXPECT_TRUE(has_errors(cleaned.findings));
    EXPECT_EQ(cleaned.storeys.size(), 1u);
}

TEST(CleanStoreys, WithoutHeightTakeTheRoomUpToTheNext) {
    Plan plan = two_storeys();
    plan.storeys[0].height = 0;
    plan.storeys[1].height = not_a_number;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P203 P203");
    EXPECT_DOUBLE_EQ(cleaned.storeys[0].height, 2.5);
    EXPECT_DOUBLE_EQ(cleaned.storeys[1].height, 2.5);
}

TEST(CleanStoreys, OfNothingLeaveAnEmptyPlan) {
    EXPECT_TRUE(clean(Plan{}).storeys.empty());
    Plan plan;
    plan.storeys.push_back(storey("empty"));
    EXPECT_TRUE(clean(plan).storeys.empty());
}

TEST(CleanWalls, WithoutUsableNumbersAreErrors) {
    Plan plan = one_room();
    plan.storeys[0].walls[1].end.x = not_a_number;
    plan.storeys[0].walls[2].thickness = -1;
    plan.storeys[0].walls[3].height_at_end = -1;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P210 P210 P210");
    ASSERT_EQ(cleaned.storeys[0].walls.size(), 1u);
    for (const Finding& finding : cleaned.findings) EXPECT_EQ(finding.severity, Severity::Error);
}

TEST(CleanWalls, AlmostRoundArcsOfEndlessRadiusAreErrors) {
    Plan plan = one_room();
    plan.storeys[0].walls[1].arc_extent = std::nextafter(2 * 3.14159265358979323846, 0.0);
    const Plan cleaned = clean(plan);
    EXPECT_EQ(findings_of(cleaned, "P210").size(), 1u);
    EXPECT_EQ(wall_of(cleaned, "e"), nullptr);
}

TEST(CleanWalls, ShorterThanACentimetreAreDroppedAndTheirNeighboursMeet) {
    Plan plan = plan_of({wall("a", {0, 0}, {4, 0}), wall("b", {4, 0}, {4.009, 0}), wall("c", {4.009, 0}, {4.009, 3})});
    const Plan cleaned = clean(plan);
    EXPECT_EQ(findings_of(cleaned, "P211").size(), 1u);
    EXPECT_EQ(wall_of(cleaned, "b"), nullptr);
    EXPECT_EQ(wall_of(cleaned, "a")->end, wall_of(cleaned, "c")->start);
}

TEST(CleanWalls, WithoutThicknessGetACentimetre) {
    Plan plan = one_room();
    plan.storeys[0].walls.push_back(wall("line", {2, 0}, {2, 3}, 0));
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P212");
    EXPECT_DOUBLE_EQ(wall_of(cleaned, "line")->thickness, 0.01);
}

TEST(CleanWalls, WithoutHeightAreDropped) {
    Plan plan = one_room();
    plan.storeys[0].walls.push_back(wall("flat", {2, 0}, {2, 3}, 0.125, 0));
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P213");
    EXPECT_EQ(wall_of(cleaned, "flat"), nullptr);
}

TEST(CleanWalls, DrawnTwiceAreKeptOnceAndTheOpeningsTurnedRound) {
    Plan plan = plan_of({wall("a", {0, 0}, {4, 0}), wall("b", {4, 0.0005}, {0, 0.0005})});
    plan.storeys[0].walls[1].left_colour = Colour{1, 0, 0};
    plan.storeys[0].openings.push_back(opening("door", OpeningKind::Door, "b", 1, 0.75, 0, 2));
    plan.storeys[0].openings[0].depth_left = 0.1;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P214");
    ASSERT_EQ(cleaned.storeys[0].walls.size(), 1u);
    EXPECT_EQ(wall_of(cleaned, "a")->right_colour, (std::optional<Colour>{{1, 0, 0}}));
    EXPECT_EQ(opening_of(cleaned, "door")->wall, "a");
    EXPECT_DOUBLE_EQ(opening_of(cleaned, "door")->offset, 3);
    EXPECT_DOUBLE_EQ(opening_of(cleaned, "door")->depth_right, 0.1);
}

TEST(CleanWalls, OfWhichNeitherCoversTheOtherAreBothKept) {
    const Plan plan = plan_of({wall("low", {0, 0}, {4, 0}, 0.5, 1), wall("high", {0, 0}, {4, 0}, 0.1, 2.5)});
    EXPECT_EQ(codes_of(clean(plan)), "");
}

TEST(CleanWalls, ArcsOverTheSameChordAreDifferentWalls) {
    Plan plan = plan_of({wall("left", {0, 0}, {4, 0}), wall("right", {0, 0}, {4, 0}), wall("line", {0, 0}, {4, 0})});
    plan.storeys[0].walls[0].arc_extent = 1;
    plan.storeys[0].walls[1].arc_extent = -1;
    EXPECT_EQ(clean(plan).storeys[0].walls.size(), 3u);
}

TEST(CleanWalls, HigherThanTheirStoreyAreNotedOnceForTheStorey) {
    Plan plan = one_room();
    plan.storeys[0].walls[0].height_at_start = plan.storeys[0].walls[0].height_at_end = 3;
    plan.storeys[0].walls[1].height_at_start = plan.storeys[0].walls[1].height_at_end = 4;
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P218");
    EXPECT_EQ(cleaned.findings[0].severity, Severity::Note);
    EXPECT_NE(cleaned.findings[0].sentence.find("2 walls"), std::string::npos);
    EXPECT_EQ(cleaned.findings[0].elements[0].id, "e");
    EXPECT_EQ(wall_of(cleaned, "e")->height_at_start, 4);
}

TEST(CleanSlopes, BecomeStepsOfTheSameVolume) {
    Plan plan = plan_of({wall("roof", {0, 0}, {4, 0})});
    plan.storeys[0].walls[0].height_at_start = 0.5;
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P217");
    ASSERT_EQ(cleaned.storeys[0].walls.size(), 8u);  // 2 m in steps of 0.25 m
    double area = 0;
    for (std::size_t k = 0; k < 8; ++k) {
        const Wall& piece = cleaned.storeys[0].walls[k];
        EXPECT_EQ(piece.id, "roof/" + std::to_string(k + 1));
        EXPECT_DOUBLE_EQ(piece.height_at_start, 0.625 + 0.25 * double(k));
        EXPECT_DOUBLE_EQ(piece.height_at_end, piece.height_at_start);
        if (k > 0) {
            EXPECT_EQ(piece.start, cleaned.storeys[0].walls[k - 1].end);
        }
        area += piece.height_at_start * (piece.end.x - piece.start.x);
    }
    EXPECT_NEAR(area, 4 * 1.5, 1e-12);
    EXPECT_NEAR(cleaned.findings[0].moved_mm, 125, 1e-9);
}

TEST(CleanSlopes, ToTheFloorAreSlopesToo) {
    Plan plan = plan_of({wall("ramp", {0, 0}, {4, 0})});
    plan.storeys[0].walls[0].height_at_end = 0;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P217");
    EXPECT_EQ(cleaned.storeys[0].walls.size(), 10u);
}

TEST(CleanSlopes, OfAnArcFollowIt) {
    Plan plan = plan_of({wall("arc", {0, 0}, {4, 0})});
    plan.storeys[0].walls[0].arc_extent = 3.14159265358979;
    plan.storeys[0].walls[0].height_at_end = 2;
    const Plan cleaned = clean(plan);
    ASSERT_EQ(cleaned.storeys[0].walls.size(), 2u);
    const Wall& first = cleaned.storeys[0].walls[0];
    EXPECT_NEAR(first.end.x, 2, 1e-6);
    EXPECT_NEAR(first.end.y, -2, 1e-6);
    EXPECT_NEAR(first.arc_extent, 3.14159265358979 / 2, 1e-12);
}

TEST(CleanSlopes, AreCutBesideOpeningsNotThroughThem) {
    Plan plan = plan_of({wall("roof", {0, 0}, {4, 0})});
    plan.storeys[0].walls[0].height_at_start = 1.5;
    plan.storeys[0].openings.push_back(opening("door", OpeningKind::Door, "roof", 3, 0.9, 0, 1.5));
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P217");
    const Opening& door = *opening_of(cleaned, "door");
    EXPECT_DOUBLE_EQ(door.width, 0.9);
    const Wall& host = *wall_of(cleaned, door.wall);
    EXPECT_NEAR(host.start.x + door.offset, 3, 1e-12);
}

TEST(CleanSlopes, FindFreeNamesForTheirSteps) {
    Plan plan = plan_of({wall("roof", {0, 0}, {4, 0}), wall("roof/1", {0, 5}, {4, 5})});
    plan.storeys[0].walls[0].height_at_end = 2;
    const Plan cleaned = clean(plan);
    EXPECT_EQ(cleaned.storeys[0].walls.size(), 3u);
    EXPECT_EQ(wall_of(cleaned, "roof/1")->start.y, 5);
    EXPECT_NE(wall_of(cleaned, "roof/1+"), nullptr);
}

TEST(CleanRooms, LoseRepeatedCorners) {
    Plan plan = one_room();
    plan.storeys[0].rooms.push_back({.id = "r", .polygon = {{0, 0}, {0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}}});
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P230");
    EXPECT_NE(cleaned.findings[0].sentence.find("2 polygon corners"), std::string::npos);
    EXPECT_EQ(cleaned.storeys[0].rooms[0].polygon, (std::vector<Point>{{0, 0}, {4, 0}, {4, 3}, {0, 3}}));
}

TEST(CleanRooms, WithoutAreaAreDropped) {
    Plan plan = one_room();
    plan.storeys[0].rooms.push_back({.id = "line", .polygon = {{0, 0}, {4, 0}, {2, 0}}});
    plan.storeys[0].shafts.push_back({"point", "", {{1, 1}}});
    plan.storeys[0].columns.push_back({"nothing", "", {}, 0});
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P231 P231 P231");
    EXPECT_TRUE(cleaned.storeys[0].rooms.empty());
}

TEST(CleanRooms, ThatCrossThemselvesAreReportedWhereTheyDo) {
    Plan plan = one_room();
    plan.storeys[0].rooms.push_back({.id = "eight", .polygon = {{0, 0}, {4, 3}, {4, 0}, {0, 3}}});
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P232");
    ASSERT_TRUE(cleaned.findings[0].point);
    EXPECT_NEAR((*cleaned.findings[0].point)[0], 2, 1e-12);
    EXPECT_NEAR((*cleaned.findings[0].point)[1], 1.5, 1e-12);
    EXPECT_EQ(cleaned.storeys[0].rooms.size(), 1u);
}

TEST(CleanRooms, WithoutFiniteCornersAreErrors) {
    Plan plan = one_room();
    plan.storeys[0].rooms.push_back({.id = "r", .polygon = {{0, 0}, {not_a_number, 0}, {4, 3}}});
    plan.storeys[0].lights.push_back({.id = "lamp", .position = {not_a_number, 0}});
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P233 P240");
    EXPECT_TRUE(has_errors(cleaned.findings));
}

TEST(CleanRooms, LampsOfNoPowerThatThereIsAreErrors) {
    Plan plan = one_room();
    auto& lights = plan.storeys[0].lights;
    lights.push_back({.id = "negative", .position = {1, 1}, .power_lumen = -1});
    lights.push_back({.id = "infinite", .position = {1, 1}, .power_lumen = 1e30});
    lights.push_back({.id = "no-number", .position = {1, 1}, .power_lumen = not_a_number});
    lights.push_back({.id = "no-colour", .position = {1, 1}, .colour = {1, 2, -1}});
    lights.push_back({.id = "dark", .position = {1, 1}, .power_lumen = 0});
    const Plan cleaned = clean(plan);
    EXPECT_EQ(codes_of(cleaned), "P240 P240 P240 P240");
    ASSERT_EQ(cleaned.storeys[0].lights.size(), 1u) << "that of no power stays: check names it";
    EXPECT_EQ(cleaned.storeys[0].lights[0].id, "dark");
}

TEST(Clean, SaysOfEachRepairWhereItIs) {
    Plan plan = one_room();
    plan.storeys[0].elevation = 1.25;
    plan.storeys[0].walls[0].end.x = 3.97;
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P215");
    const Finding& finding = cleaned.findings[0];
    EXPECT_EQ(finding.storey, "ground");
    EXPECT_EQ(finding.elements[0].id, "s");
    EXPECT_EQ(finding.elements[1].id, "e");
    ASSERT_TRUE(finding.point);
    EXPECT_EQ((*finding.point)[2], 1.25);
    EXPECT_NEAR(finding.moved_mm, 30, 1e-9);
    EXPECT_FALSE(finding.hint.empty());
}

}  // namespace
}  // namespace enfilade::plans
