// What closes rooms without a wall's two faces: glass, doors from face to face, masses.

#include "plans/dxf/pane_walls.h"

#include "plans/dxf/door_screens.h"
#include "plans/dxf/solids.h"
#include "tests/plans/dxf/wall_strokes.h"

namespace enfilade::plans {
namespace {

using namespace wall_strokes;

/// Two walls along y, 4 m apart between their faces, and what else is drawn.
Strokes between_walls(const Strokes& drawn) {
    return faces({0, 0}, {0.2, 6}) + faces({4.2, 0}, {4.4, 6}) + box({0, 0}, {0.2, 6}) + box({4.2, 0}, {4.4, 6}) +
           drawn;
}

struct Across {
    std::size_t count = 0;
    WallRun run;
};

/// The runs that go along x.
Across across(const Strokes& strokes) {
    Across found;
    std::vector<WallMass> masses;
    for (const WallRun& run : wall_runs(bodies_of(strokes), strokes, &masses))
        if (std::abs(run.end.x - run.start.x) > std::abs(run.end.y - run.start.y)) ++found.count, found.run = run;
    return found;
}

TEST(PaneWalls, LinesOfWindowsFromWallToWallAreAWallOfGlass) {
    for (const Role role : {Role::Window, Role::Opening}) {
        const Across found = across(between_walls(faces({0.2, 3}, {4.2, 3.1}, role)));
        ASSERT_EQ(found.count, 1u);
        EXPECT_NEAR(found.run.thickness, 0.1, 1e-9);
        // From axis to axis, the pane between the faces.
        EXPECT_NEAR(std::min(found.run.start.x, found.run.end.x), 0.1, 1e-9);
        EXPECT_NEAR(std::max(found.run.start.x, found.run.end.x), 4.3, 1e-9);
        ASSERT_EQ(found.run.openings.size(), 1u);
        EXPECT_EQ(found.run.openings[0].kind, OpeningKind::Window);
        EXPECT_NEAR(found.run.openings[0].u0, 0.1, 1e-9);
        EXPECT_NEAR(found.run.openings[0].u1, 4.1, 1e-9);
        EXPECT_EQ(found.run.openings[0].sill, 0.0);
    }
}

TEST(PaneWalls, SlidingPanesAreOneWall) {
    const Strokes panes = faces({0.2, 3}, {1.6, 3.05}, Role::Window) + faces({1.5, 3.05}, {2.9, 3.1}, Role::Window) +
                          faces({2.8, 3}, {4.2, 3.05}, Role::Window);
    const Across found = across(between_walls(panes));
    ASSERT_EQ(found.count, 1u);
    EXPECT_NEAR(found.run.thickness, 0.1, 1e-9);
    EXPECT_EQ(found.run.openings.size(), 1u);
}

TEST(PaneWalls, AGlassCornerHoldsItself) {
    // From the left wall to the middle, then down to a wall along x.
    const Strokes strokes = between_walls(faces({0.2, 3}, {2.1, 3.1}, Role::Window) +
                                          faces({2, 0.2}, {2.1, 3.1}, Role::Window) + faces({0.2, 0}, {4.2, 0.2}));
    std::size_t glass = 0;
    for (const WallRun& run : runs_of(strokes))
        glass += run.openings.size() == 1 && run.openings[0].kind == OpeningKind::Window;
    EXPECT_EQ(glass, 2u);
}

TEST(PaneWalls, PanesThatEndInTheAirAreNone) {
    EXPECT_EQ(across(between_walls(faces({0.2, 3}, {3, 3.1}, Role::Window))).count, 0u);
    EXPECT_EQ(across(between_walls(faces({1, 3}, {3, 3.1}, Role::Window))).count, 0u);
}

TEST(PaneWalls, LinesAlongAWallAreItsSillAndNoWall) {
    const Strokes sill = faces({0.2, 3}, {4.2, 3.2}) + faces({0.2, 3.25}, {4.2, 3.3}, Role::Window);
    EXPECT_EQ(across(between_walls(sill)).count, 1u);
}

TEST(DoorScreens, ASwingFromFaceToFaceIsADoorInAWallOfItsOwn) {
    // 0.9 m from the end of a wall to the face of another; the leaf stands open along y.
    const Strokes strokes = faces({0, 0}, {0.2, 6}) + faces({1.1, 3}, {1.3, 6}) + Strokes{stroke({1.1, 3}, {1.3, 3})} +
                            Strokes{arc({0.2, 4}, 0.9, 0, 90, Role::Door), stroke({0.2, 4}, {0.2, 4.9}, Role::Door)};
    const Across found = across(strokes);
    ASSERT_EQ(found.count, 1u);
    ASSERT_EQ(found.run.openings.size(), 1u);
    EXPECT_EQ(found.run.openings[0].kind, OpeningKind::Door);
    EXPECT_NEAR(found.run.openings[0].u1 - found.run.openings[0].u0, 0.9, 0.05);
}

TEST(DoorScreens, TwoSwingsThatMeetAreOneDoor) {
    const Strokes swings = {arc({0.2, 3}, 2, 0, 90, Role::Door), arc({4.2, 3}, 2, 90, 180, Role::Door)};
    // Leaves of 2 m are no doors: those of 1 m in a passage of 2 are.
    EXPECT_EQ(across(between_walls(swings)).count, 0u);
    const Strokes passage = faces({0, 0}, {0.2, 6}) + faces({2.2, 0}, {2.4, 6}) +
                            Strokes{arc({0.2, 3}, 1, 0, 90, Role::Door), arc({2.2, 3}, 1, 90, 180, Role::Door)};
    const Across found = across(passage);
    ASSERT_EQ(found.count, 1u);
    ASSERT_EQ(found.run.openings.size(), 1u);
    EXPECT_NEAR(found.run.openings[0].u1 - found.run.openings[0].u0, 2, 0.05);
}

/// A leaf of a folding door, 4 cm thick.
Strokes leaf(Point a, Point b) {
    const Point side = turned_left(b - a) * (0.04 / distance(a, b));
    return {stroke(a, b, Role::Door), stroke(b, b + side, Role::Door), stroke(b + side, a + side, Role::Door),
            stroke(a + side, a, Role::Door)};
}

TEST(DoorScreens, FoldingDoorsCloseACloset) {
    // Four leaves, of which two fold to each side; the closet is between the walls, 0.6 m deep.
    const Strokes strokes = between_walls(faces({0.2, 0}, {4.2, 0.2})) + leaf({0.25, 0.8}, {0.9, 1.1}) +
                            leaf({0.9, 1.1}, {1.55, 0.8}) + leaf({4.15, 0.8}, {3.5, 1.1}) +
                            leaf({3.5, 1.1}, {2.4, 0.8});
    std::size_t doors = 0;
    for (const WallRun& run : runs_of(strokes)) {
        for (const RunOpening& opening : run.openings) {
            ++doors;
            EXPECT_EQ(opening.kind, OpeningKind::Door);
            EXPECT_NEAR(run.start.y, 0.8, 0.05);
        }
    }
    EXPECT_EQ(doors, 1u);
}

TEST(DoorScreens, DoorLinesFarFromWallsAreNone) {
    const Strokes strokes = between_walls(leaf({1.5, 0.8}, {2, 1.1}) + leaf({2, 1.1}, {2.5, 0.8}));
    EXPECT_EQ(across(strokes).count, 0u);
}

std::vector<WallMass> masses_in(const Strokes& strokes) {
    std::vector<WallMass> masses;
    (void)wall_runs(bodies_of(strokes), strokes, &masses);
    return masses;
}

TEST(WallMasses, AThickPierIsSolid) {
    const std::vector<WallMass> masses = masses_in(between_walls(box({0.2, 2}, {1.4, 3.3})));
    ASSERT_EQ(masses.size(), 1u);
    EXPECT_TRUE(holds(masses[0].polygon, {0.8, 2.6}));
    EXPECT_FALSE(masses[0].height.has_value());
}

TEST(WallMasses, ALowOneIsLow) {
    const std::vector<WallMass> masses = masses_in(between_walls(box({1.2, 2}, {2.4, 3.3}, Role::LowWall)));
    ASSERT_EQ(masses.size(), 1u);
    EXPECT_EQ(masses[0].height, 1.0);
}

TEST(WallMasses, WallsAndTheirCornersAreNone) {
    // The outline of four walls around a room, drawn as two boxes.
    EXPECT_TRUE(masses_in(box({0, 0}, {2.4, 2.4}) + box({0.2, 0.2}, {2.2, 2.2})).empty());
    EXPECT_TRUE(masses_in(between_walls({})).empty());
}

TEST(WallMasses, AShaftBetweenWallsIsEmpty) {
    // Walls around 0.9 m by 0.9 m.
    EXPECT_TRUE(masses_in(box({0, 0}, {1.3, 1.3}) + box({0.2, 0.2}, {1.1, 1.1}) + box({5, 0}, {5.2, 8})).empty());
}

TEST(WallMasses, LinesThatOvershootCloseToo) {
    Strokes pier = box({1, 2}, {2.2, 3.2});
    pier[0].stroke.b.x += 0.03;
    pier[2].stroke.a.x += 0.02;
    EXPECT_EQ(masses_in(between_walls(pier)).size(), 1u);
}

TEST(WallMasses, WallsAreLedIntoThem) {
    // A wall that ends at a pier's face.
    std::vector<WallRun> runs = {{.start = {0, 0}, .end = {2, 0}, .thickness = 0.1}};
    const WallMass pier{{{2.03, -1}, {3.5, -1}, {3.5, 1}, {2.03, 1}}, {}};
    lead_into_masses(runs, {pier}, 0.06);
    EXPECT_GT(runs[0].end.x, 2.05);
    EXPECT_LT(runs[0].end.x, 2.2);
    EXPECT_EQ(runs[0].start, (Point{0, 0}));
}

}  // namespace
}  // namespace enfilade::plans
