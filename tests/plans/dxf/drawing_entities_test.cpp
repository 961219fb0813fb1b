// Each kind of entity, with the strokes it must become.
#include <numbers>

#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

const double quarter_bulge = std::tan(std::numbers::pi / 8);

TEST(DrawingEntities, Line) {
    const Drawing drawing = read_entities(line(1.5, -2, 3e1, 0.25, "A-WALL"));
    ASSERT_EQ(drawing.shapes.size(), 1u);
    EXPECT_EQ(drawing.shapes[0].kind, ShapeKind::Line);
    EXPECT_EQ(drawing.layers.at(drawing.shapes[0].layer).name, "A-WALL");
    EXPECT_FALSE(drawing.shapes[0].closed);
    expect_strokes(drawing, 0, {{{1.5, -2}, {30, 0.25}, 0}}, 0);
}

TEST(DrawingEntities, LineTellsWhereItBegins) {
    const std::string text = File{line(0, 0, 1, 0) + line(0, 0, 2, 0)}.text();
    const Drawing drawing = read_drawing(text, "test.dxf");
    EXPECT_EQ(drawing.shapes.at(0).line, line_of(text, "LINE", 1) - 1);
    EXPECT_EQ(drawing.shapes.at(1).line, line_of(text, "LINE", 2) - 1);
}

TEST(DrawingEntities, ZeroLengthLineStays) { EXPECT_EQ(read_entities(line(1, 1, 1, 1)).shapes.size(), 1u); }

TEST(DrawingEntities, OpenPolylineKeepsItsBulges) {
    const Drawing drawing = read_entities(entity(
        "LWPOLYLINE",
        {{8, "0"}, {90, 3}, {70, 0}, {43, 0.1}, {10, 0}, {20, 0}, {42, 0.5}, {10, 2}, {20, 0}, {10, 2}, {20, 3}}));
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Polyline);
    EXPECT_FALSE(drawing.shapes[0].closed);
    expect_strokes(drawing, 0, {{{0, 0}, {2, 0}, 0.5}, {{2, 0}, {2, 3}, 0}}, 0);
}

TEST(DrawingEntities, ClosedPolylineReturns) {
    const Drawing drawing = read_entities(
        entity("LWPOLYLINE", {{90, 3}, {70, 1}, {10, 0}, {20, 0}, {10, 2}, {20, 0}, {10, 2}, {20, 3}, {42, -1}}));
    EXPECT_TRUE(drawing.shapes.at(0).closed);
    expect_strokes(drawing, 0, {{{0, 0}, {2, 0}, 0}, {{2, 0}, {2, 3}, 0}, {{2, 3}, {0, 0}, -1}}, 0);
}

TEST(DrawingEntities, PolylineOfWrongCountIsReadWhole) {
    for (const int count : {-5, 0, 1, 1000, 2'000'000'000}) {
        const Drawing drawing = read_entities(
            entity("LWPOLYLINE", {{90, count}, {42, 9.0}, {10, 0}, {20, 0}, {10, 2}, {20, 0}, {10, 2}, {20, 3}}));
        expect_strokes(drawing, 0, {{{0, 0}, {2, 0}, 0}, {{2, 0}, {2, 3}, 0}}, 0);
    }
}

TEST(DrawingEntities, PolylineDoesNotInheritFromTheOneBefore) {
    const Drawing drawing =
        read_entities(entity("LWPOLYLINE", {{90, 2}, {10, 1}, {20, 1}, {42, 0.5}, {10, 2}, {20, 2}}) +
                      entity("LWPOLYLINE", {{10, 5}, {20, 5}, {10, 6}, {20, 5}}));
    expect_strokes(drawing, 1, {{{5, 5}, {6, 5}, 0}}, 0);
}

TEST(DrawingEntities, RepeatedVerticesAreOne) {
    const Drawing drawing = read_entities(
        entity("LWPOLYLINE", {{70, 1}, {10, 0}, {20, 0}, {10, 2}, {20, 0}, {10, 2}, {20, 0}, {10, 0}, {20, 0}}));
    expect_strokes(drawing, 0, {{{0, 0}, {2, 0}, 0}, {{2, 0}, {0, 0}, 0}}, 0);
}

TEST(DrawingEntities, OldPolyline) {
    const Drawing drawing =
        read_entities(entity("POLYLINE", {{8, "W"}, {66, 1}, {70, 1}, {10, 0}, {20, 0}, {30, 0}}) +
                      entity("VERTEX", {{8, "W"}, {10, 1}, {20, 1}, {42, 1}}) +
                      entity("VERTEX", {{8, "W"}, {10, 3}, {20, 1}}) + entity("SEQEND", {{8, "W"}}) + line(0, 0, 1, 1));
    ASSERT_EQ(drawing.shapes.size(), 2u);
    EXPECT_EQ(drawing.layers.at(drawing.shapes[0].layer).name, "W");
    EXPECT_TRUE(drawing.shapes[0].closed);
    expect_strokes(drawing, 0, {{{1, 1}, {3, 1}, 1}, {{3, 1}, {1, 1}, 0}}, 0);
    expect_strokes(drawing, 1, {{{0, 0}, {1, 1}, 0}}, 0);
}

TEST(DrawingEntities, FrameOfABentPolylineIsNotDrawn) {
    const Drawing drawing =
        read_entities(entity("POLYLINE", {{70, 4}}) + entity("VERTEX", {{70, 16}, {10, 9}, {20, 9}}) +
                      entity("VERTEX", {{70, 8}, {10, 1}, {20, 1}}) + entity("VERTEX", {{70, 8}, {10, 3}, {20, 1}}) +
                      entity("SEQEND", {}));
    expect_strokes(drawing, 0, {{{1, 1}, {3, 1}, 0}}, 0);
}

TEST(DrawingEntities, MeshIsLeftOutWithANote) {
    const Drawing drawing =
        read_entities(entity("POLYLINE", {{70, 16}, {71, 2}, {72, 2}}) + entity("VERTEX", {{10, 1}, {20, 1}}) +
                      entity("VERTEX", {{10, 3}, {20, 1}}) + entity("SEQEND", {}) + line(0, 0, 1, 1));
    EXPECT_EQ(drawing.shapes.size(), 1u);
    EXPECT_NE(sentence_of(drawing, "P715").find("Meshes"), std::string::npos);
}

TEST(DrawingEntities, ArcIsOneStroke) {
    const Drawing drawing = read_entities(entity("ARC", {{10, 1}, {20, 2}, {40, 2}, {50, 0}, {51, 90}}));
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Arc);
    expect_strokes(drawing, 0, {{{3, 2}, {1, 4}, quarter_bulge}});
}

TEST(DrawingEntities, ArcThroughAngleZero) {
    const Drawing drawing = read_entities(entity("ARC", {{10, 0}, {20, 0}, {40, 1}, {50, 315}, {51, 45}}));
    const double h = std::sqrt(0.5);
    expect_strokes(drawing, 0, {{{h, -h}, {h, h}, quarter_bulge}});
}

TEST(DrawingEntities, ArcBeyondHalfATurnIsTwoStrokes) {
    const Drawing drawing = read_entities(entity("ARC", {{10, 0}, {20, 0}, {40, 1}, {50, 0}, {51, 270}}));
    const double h = std::sqrt(0.5);
    const double bulge = std::tan(std::numbers::pi * 3 / 16);
    expect_strokes(drawing, 0, {{{1, 0}, {-h, h}, bulge}, {{-h, h}, {0, -1}, bulge}});
}

TEST(DrawingEntities, CircleIsTwoHalves) {
    const Drawing drawing = read_entities(entity("CIRCLE", {{10, 1}, {20, 2}, {40, 3}}));
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Circle);
    EXPECT_TRUE(drawing.shapes[0].closed);
    expect_strokes(drawing, 0, {{{4, 2}, {-2, 2}, 1}, {{-2, 2}, {4, 2}, 1}});
    EXPECT_NEAR(drawing.bounds[1], -1, 1e-12);
    EXPECT_NEAR(drawing.bounds[3], 5, 1e-12);
}

TEST(DrawingEntities, CircleWithoutRadiusIsReported) {
    const Drawing drawing = read_entities(entity("CIRCLE", {{10, 1}, {20, 2}, {40, 0}}) + line(0, 0, 1, 1));
    EXPECT_EQ(drawing.shapes.size(), 1u);
    EXPECT_NE(finding_of(drawing, "P712"), nullptr);
}

TEST(DrawingEntities, SolidGoesAround) {
    const std::string corners = pairs({{10, 0}, {20, 0}, {11, 1}, {21, 0}, {12, 0}, {22, 1}, {13, 1}, {23, 1}});
    for (const char* kind : {"SOLID", "TRACE"}) {
        const Drawing drawing = read_entities(pair(0, kind) + corners);
        EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Face);
        EXPECT_TRUE(drawing.shapes[0].closed);
        expect_strokes(drawing, 0, {{{0, 0}, {1, 0}, 0}, {{1, 0}, {1, 1}, 0}, {{1, 1}, {0, 1}, 0}, {{0, 1}, {0, 0}, 0}},
                       0);
    }
}

TEST(DrawingEntities, SolidOfThreeCornersIsATriangle) {
    const Drawing drawing = read_entities(entity("SOLID", {{10, 1}, {20, 1}, {11, 2}, {21, 1}, {12, 1}, {22, 2}}));
    expect_strokes(drawing, 0, {{{1, 1}, {2, 1}, 0}, {{2, 1}, {1, 2}, 0}, {{1, 2}, {1, 1}, 0}}, 0);
}

TEST(DrawingEntities, FaceInSpaceIsSeenFromAbove) {
    const Drawing drawing = read_entities(entity(
        "3DFACE",
        {{10, 0}, {20, 0}, {30, 5}, {11, 1}, {21, 0}, {31, 5}, {12, 1}, {22, 1}, {32, 6}, {13, 0}, {23, 1}, {33, 6}}));
    expect_strokes(drawing, 0, {{{0, 0}, {1, 0}, 0}, {{1, 0}, {1, 1}, 0}, {{1, 1}, {0, 1}, 0}, {{0, 1}, {0, 0}, 0}}, 0);
    EXPECT_NE(finding_of(drawing, "P714"), nullptr);
}

TEST(DrawingEntities, HeightIsProjectedWithANote) {
    const Drawing drawing = read_entities(entity("LINE", {{10, 0}, {20, 0}, {30, 2.5}, {11, 1}, {21, 0}, {31, 2.5}}));
    expect_strokes(drawing, 0, {{{0, 0}, {1, 0}, 0}}, 0);
    EXPECT_NE(finding_of(drawing, "P714"), nullptr);
    EXPECT_EQ(finding_of(read_entities(line(0, 0, 1, 1)), "P714"), nullptr);
}

TEST(DrawingEntities, MirroredArcTurnsTheOtherWay) {
    const Drawing drawing =
        read_entities(entity("ARC", {{10, 1}, {20, 2}, {40, 2}, {50, 0}, {51, 90}, {210, 0}, {220, 0}, {230, -1}}));
    expect_strokes(drawing, 0, {{{-3, 2}, {-1, 4}, -quarter_bulge}});
}

TEST(DrawingEntities, MirroredPolyline) {
    const Drawing drawing = read_entities(
        entity("LWPOLYLINE", {{38, 0}, {10, 1}, {20, 0}, {42, 0.5}, {10, 2}, {20, 0}, {210, 0}, {220, 0}, {230, -1}}));
    expect_strokes(drawing, 0, {{{-1, 0}, {-2, 0}, -0.5}});
}

TEST(DrawingEntities, LineIgnoresItsExtrusion) {
    const Drawing drawing =
        read_entities(entity("LINE", {{10, 1}, {20, 2}, {11, 3}, {21, 4}, {210, 0}, {220, 0}, {230, -1}}));
    expect_strokes(drawing, 0, {{{1, 2}, {3, 4}, 0}}, 0);
}

TEST(DrawingEntities, TiltedCircleIsAnEllipse) {
    // Its plane is turned by 60 degrees about x, so it is half as deep as wide.
    const double s = std::sin(std::numbers::pi / 3);
    const Drawing drawing =
        read_entities(entity("CIRCLE", {{10, 0}, {20, 0}, {40, 2}, {210, 0}, {220, -s}, {230, 0.5}}));
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Ellipse);
    EXPECT_NEAR(drawing.bounds[2], 2, 1e-9);
    EXPECT_NEAR(drawing.bounds[3], 1, 1e-9);
    EXPECT_NE(finding_of(drawing, "P714"), nullptr);
}

TEST(DrawingEntities, UnknownKindsAreCountedByName) {
    const Drawing drawing = read_entities(entity("HATCH", {{10, 0}, {20, 0}}) + entity("WIPEOUT", {{10, 0}}) +
                                          entity("HATCH", {{10, 0}, {20, 0}}) + line(0, 0, 1, 1));
    EXPECT_EQ(sentence_of(drawing, "P715"), "Entities that make no lines left out: 2 HATCH, 1 WIPEOUT.");
}

TEST(DrawingEntities, PaperSpaceIsCounted) {
    const Drawing drawing = read_entities(entity("LINE", {{67, 1}, {10, 0}, {20, 0}, {11, 1}, {21, 1}}) +
                                          entity("VIEWPORT", {{67, 1}}) + line(0, 0, 1, 1));
    EXPECT_EQ(drawing.shapes.size(), 1u);
    EXPECT_EQ(sentence_of(drawing, "P713"), "2 entities of paper space (title blocks, views) left out.");
}

TEST(DrawingEntities, BlocksDrawnInPaperSpaceAreInserted) {
    const Drawing drawing = read({entity("INSERT", {{2, "B"}}), block("B", entity("LINE", {{67, 1}, {11, 1}}))});
    EXPECT_EQ(drawing.shapes.size(), 1u);
}

TEST(DrawingEntities, ManyUnknownKindsAreCountedTogether) {
    std::string entities;
    for (int k = 0; k < 1000; ++k) entities += pair(0, "KIND" + std::to_string(k));
    const std::string sentence = sentence_of(read_entities(entities), "P715");
    EXPECT_LT(sentence.size(), 2000u);
    EXPECT_NE(sentence.find("900 of other kinds"), std::string::npos) << sentence;
}

TEST(DrawingEntities, InvisibleOnesAreLeftOut) {
    const Drawing drawing =
        read_entities(entity("POLYLINE", {{60, 1}}) + entity("VERTEX", {{10, 0}, {20, 0}}) +
                      entity("VERTEX", {{10, 1}, {20, 0}}) + entity("SEQEND", {}) + line(0, 0, 1, 1));
    EXPECT_EQ(drawing.shapes.size(), 1u);
    EXPECT_NE(finding_of(drawing, "P716"), nullptr);
}

TEST(DrawingEntities, ForeignDataIsPassedOver) {
    // Groups of other programs, extended data and embedded objects repeat codes with another meaning.
    const Drawing drawing = read_entities(entity("LINE", {{102, "{OTHER"},
                                                          {8, "X"},
                                                          {10, 77},
                                                          {102, "}"},
                                                          {8, "A"},
                                                          {10, 1},
                                                          {20, 2},
                                                          {11, 3},
                                                          {21, 4},
                                                          {1001, "APP"},
                                                          {1010, 99},
                                                          {1040, 5},
                                                          {101, "Embedded Object"},
                                                          {10, 55}}));
    EXPECT_EQ(drawing.layers.at(drawing.shapes.at(0).layer).name, "A");
    expect_strokes(drawing, 0, {{{1, 2}, {3, 4}, 0}}, 0);
}

TEST(DrawingEntities, LayersKeepOrderAndState) {
    const Drawing drawing = read(
        {line(0, 0, 1, 0, "xref-Bishop$0$A-WALL") + line(0, 0, 1, 0, "frozen") + line(0, 0, 1, 0, "FROZEN") +
             line(0, 0, 1, 0, "untold"),
         "", "",
         layer("0") + layer("frozen", 1) + layer("off", 0, -3) + layer("locked", 4) + layer("xref-Bishop$0$A-WALL")});
    ASSERT_EQ(drawing.layers.size(), 6u);
    const std::vector<std::string> names = {"0", "frozen", "off", "locked", "xref-Bishop$0$A-WALL", "untold"};
    const std::vector<bool> visible = {true, false, false, true, true, true};
    for (std::size_t k = 0; k < names.size(); ++k) {
        EXPECT_EQ(drawing.layers[k].name, names[k]);
        EXPECT_EQ(drawing.layers[k].visible, visible[k]) << names[k];
    }
    EXPECT_EQ(drawing.layers[1].shape_count, 2u);
    EXPECT_EQ(drawing.layers[4].shape_count, 1u);
}

TEST(DrawingEntities, HeaderTellsUnits) {
    const Drawing drawing = read({line(0, 0, 1, 0), "",
                                  pairs({{9, "$INSUNITS"},
                                         {70, 1},
                                         {9, "$LUNITS"},
                                         {70, 4},
                                         {9, "$MEASUREMENT"},
                                         {70, 0},
                                         {9, "$EXTMIN"},
                                         {10, 1},
                                         {20, 1}})});
    EXPECT_EQ(drawing.declared_unit, Unit::Inch);
    EXPECT_EQ(drawing.linear_format, 4);
    EXPECT_FALSE(drawing.metric);
}

TEST(DrawingEntities, UnitOfNoBuildingIsReported) {
    const Drawing drawing = read({line(0, 0, 1, 0), "", pairs({{9, "$INSUNITS"}, {70, 19}})});
    EXPECT_EQ(drawing.declared_unit, std::nullopt);
    EXPECT_NE(sentence_of(drawing, "P709").find("19"), std::string::npos);
}

TEST(DrawingEntities, WithoutHeaderNothingIsDeclared) {
    const Drawing drawing = read_entities(line(0, 0, 1, 0));
    EXPECT_EQ(drawing.declared_unit, std::nullopt);
    EXPECT_EQ(drawing.linear_format, 2);
    EXPECT_TRUE(drawing.metric);
    const Drawing unitless = read({line(0, 0, 1, 0), "", pairs({{9, "$INSUNITS"}, {70, 0}})});
    EXPECT_EQ(unitless.declared_unit, std::nullopt);
}

}  // namespace
}  // namespace enfilade::plans
