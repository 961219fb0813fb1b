// Sizes that drawings write beside their doors and windows.

#include "plans/dxf/opening_sizes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace enfilade::plans {
namespace {

struct Written {
    const char* text;
    double width;
    double height;
    std::optional<OpeningKind> kind = {};
};

TEST(SizeNote, ReadsWhatPeopleWrite) {
    for (const Written& w :
         {Written{"2668", 0.762, 2.0320}, Written{"16070 O.H. DOOR", 4.8768, 2.1336, OpeningKind::Door},
          Written{"6068 S.G.D.", 1.8288, 2.0320, OpeningKind::Door},
          Written{"5050 XO", 1.524, 1.524, OpeningKind::Window}, Written{"2'6X6'8", 0.762, 2.0320},
          Written{"2'-6\" x 6'-8\"", 0.762, 2.0320}, Written{"36\" x 80\"", 0.9144, 2.0320},
          Written{"2#5'0X6'8 BI FOLD", 1.524, 2.0320, OpeningKind::Door}, Written{"90/210", 0.9, 2.1},
          Written{"0.90 x 2.10", 0.9, 2.1}, Written{"0,90/2,10", 0.9, 2.1}, Written{"1200x1400", 1.2, 1.4},
          Written{" 80 / 200 ", 0.8, 2}}) {
        SCOPED_TRACE(w.text);
        const auto note = size_note(w.text, true);
        ASSERT_TRUE(note.has_value());
        EXPECT_NEAR(note->width, w.width, 1e-9);
        EXPECT_NEAR(note->height, w.height, 1e-9);
        EXPECT_EQ(note->kind, w.kind);
    }
}

TEST(SizeNote, LeavesOtherTextsAlone) {
    for (const char* text : {"", "R", "Bedroom 2", "13'8 x 14'", "04810", "2668A", "5' x 8'1 of room and more", "1/2",
                             "99999", "0000", "2025/01/12 revised by the office", "12.5 m2", "x", "'", "3'"})
        EXPECT_FALSE(size_note(text, true).has_value()) << text;
}

TEST(SizeNote, DigitsAloneAreFeetInDrawingsInFeetOnly) {
    EXPECT_TRUE(size_note("2668", true).has_value());
    EXPECT_FALSE(size_note("2668", false).has_value());
    EXPECT_TRUE(size_note("90/210", false).has_value());
}

/// A wall of 10 m along x with openings [from, to].
WallRun wall_with(std::initializer_list<std::pair<double, double>> openings) {
    WallRun run{.start = {0, 0}, .end = {10, 0}, .thickness = 0.2};
    for (const auto& [from, to] : openings) run.openings.push_back({.u0 = from, .u1 = to});
    return run;
}

SizeNote note(double width, double height, Point at, std::optional<OpeningKind> kind = {}) {
    return {width, height, kind, at, 0};
}

TEST(ApplySizes, GiveTheNearestOpeningOfThatWidthItsHeightAndKind) {
    std::vector<WallRun> runs = {wall_with({{1, 1.9}, {4, 4.9}, {6, 8}})};
    apply_sizes(runs, {note(0.9, 2.0, {4.4, -0.5}), note(2.0, 1.2, {6.5, 0.6})});
    const auto& openings = runs[0].openings;
    EXPECT_EQ(openings[0].kind, OpeningKind::Opening);
    EXPECT_EQ(openings[1].kind, OpeningKind::Door);
    EXPECT_NEAR(openings[1].head.value(), 2.0, 1e-9);
    EXPECT_NEAR(openings[1].sill.value(), 0, 1e-9);
    EXPECT_EQ(openings[2].kind, OpeningKind::Window);
    EXPECT_NEAR(openings[2].head.value(), 2.1, 1e-9);
    EXPECT_NEAR(openings[2].sill.value(), 0.9, 1e-9);
}

TEST(ApplySizes, AnotherWidthOrAFarTextChangesNothing) {
    std::vector<WallRun> runs = {wall_with({{1, 1.9}})};
    apply_sizes(runs, {note(1.2, 2.0, {1.4, 0.3}), note(0.9, 2.0, {1.4, 1.5})});
    EXPECT_EQ(runs[0].openings[0].kind, OpeningKind::Opening);
    EXPECT_FALSE(runs[0].openings[0].head.has_value());
}

TEST(ApplySizes, ASwingIsADoorWhateverIsWritten) {
    std::vector<WallRun> runs = {wall_with({{1, 1.9}})};
    runs[0].openings[0].kind = OpeningKind::Door;
    runs[0].openings[0].swings = true;
    apply_sizes(runs, {note(0.9, 1.2, {1.4, 0.3})});
    EXPECT_EQ(runs[0].openings[0].kind, OpeningKind::Door);
}

TEST(ApplySizes, AMappingsHeightsStay) {
    std::vector<WallRun> runs = {wall_with({{1, 1.9}})};
    runs[0].openings[0].sill = 0.5;
    runs[0].openings[0].head = 2.5;
    apply_sizes(runs, {note(0.9, 1.2, {1.4, 0.3})});
    EXPECT_NEAR(runs[0].openings[0].sill.value(), 0.5, 1e-9);
    EXPECT_NEAR(runs[0].openings[0].head.value(), 2.5, 1e-9);
}

TEST(ApplySizes, WordsDecideBeforeTheHeight) {
    std::vector<WallRun> runs = {wall_with({{1, 3}})};
    apply_sizes(runs, {note(2.0, 2.1, {2, 0.3}, OpeningKind::Window)});
    EXPECT_EQ(runs[0].openings[0].kind, OpeningKind::Window);
    EXPECT_NEAR(runs[0].openings[0].sill.value(), 0, 1e-9);
}

}  // namespace
}  // namespace enfilade::plans
