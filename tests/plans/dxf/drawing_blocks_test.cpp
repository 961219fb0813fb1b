// Insertions carried out: where the entities of a block come to lie.
#include <numbers>

#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

const double quarter_bulge = std::tan(std::numbers::pi / 8);

std::string door() {
    return block("DOOR",
                 line(1, 1, 2, 1) + entity("ARC", {{8, "A-DOOR"}, {10, 1}, {20, 1}, {40, 1}, {50, 0}, {51, 90}}), 1, 1);
}

std::string insert(const char* name, Pairs more, const char* on_layer = "0") {
    return entity("INSERT", {{8, on_layer}, {2, name}}) + pairs(more);
}

TEST(DrawingBlocks, BasePointComesToTheInsertion) {
    const Drawing drawing = read({insert("DOOR", {{10, 10}, {20, 20}}), door()});
    ASSERT_EQ(drawing.shapes.size(), 2u);
    expect_strokes(drawing, 0, {{{10, 20}, {11, 20}, 0}});
    expect_strokes(drawing, 1, {{{11, 20}, {10, 21}, quarter_bulge}});
    ASSERT_EQ(drawing.insertions.size(), 1u);
    EXPECT_EQ(drawing.insertions[0].name, "DOOR");
    EXPECT_EQ(drawing.insertions[0].at, (Point{10, 20}));
    EXPECT_EQ(drawing.shapes[0].block, 0u);
}

TEST(DrawingBlocks, NamesIgnoreCase) { EXPECT_EQ(read({insert("door", {{10, 1}}), door()}).shapes.size(), 2u); }

TEST(DrawingBlocks, TurnedAndScaled) {
    const Drawing drawing = read({insert("DOOR", {{10, 10}, {20, 20}, {41, 2}, {42, 2}, {43, 2}, {50, 90}}), door()});
    expect_strokes(drawing, 0, {{{10, 20}, {10, 22}, 0}});
    expect_strokes(drawing, 1, {{{10, 22}, {8, 20}, quarter_bulge}});
    expect_point(drawing.insertions[0].x_axis, {0, 2});
    expect_point(drawing.insertions[0].y_axis, {-2, 0});
}

TEST(DrawingBlocks, NegativeScaleMirrors) {
    const Drawing drawing = read({insert("DOOR", {{10, 10}, {20, 20}, {41, -1}}), door()});
    expect_strokes(drawing, 0, {{{10, 20}, {9, 20}, 0}});
    expect_strokes(drawing, 1, {{{9, 20}, {10, 21}, -quarter_bulge}});
    const Insertion& at = drawing.insertions[0];
    EXPECT_LT(at.x_axis.x * at.y_axis.y - at.x_axis.y * at.y_axis.x, 0);
}

TEST(DrawingBlocks, ExtrusionMirrors) {
    // In the mirrored plane x points left; the turn of 90 degrees is made there.
    const Drawing drawing =
        read({insert("DOOR", {{10, 10}, {20, 20}, {50, 90}, {210, 0}, {220, 0}, {230, -1}}), door()});
    expect_strokes(drawing, 0, {{{-10, 20}, {-10, 21}, 0}});
    expect_strokes(drawing, 1, {{{-10, 21}, {-9, 20}, -quarter_bulge}});
    expect_point(drawing.insertions[0].at, {-10, 20});
}

TEST(DrawingBlocks, UnevenScaleMakesArcsEllipses) {
    const Drawing drawing = read({insert("DOOR", {{10, 0}, {20, 0}, {41, 4}, {42, 2}}), door()});
    ASSERT_EQ(drawing.shapes.size(), 2u);
    EXPECT_EQ(drawing.shapes[1].kind, ShapeKind::Ellipse);
    const std::vector<Stroke> chain = strokes_of(drawing, 1);
    EXPECT_GT(chain.size(), 10u);
    expect_point(chain.front().a, {4, 0});
    expect_point(chain.back().b, {0, 2});
    for (const Stroke& s : chain) {
        EXPECT_NEAR(s.b.x * s.b.x / 16 + s.b.y * s.b.y / 4, 1, 1e-12);
        EXPECT_EQ(s.bulge, 0);
    }
}

TEST(DrawingBlocks, UnevenScaleBendsPolylines) {
    const std::string half =
        block("B", entity("LWPOLYLINE", {{10, -1}, {20, 0}, {42, -1}, {10, 1}, {20, 0}, {10, 1}, {20, -1}}));
    const Drawing drawing = read({insert("B", {{41, 3}}), half});
    const std::vector<Stroke> chain = strokes_of(drawing, 0);
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Polyline);
    expect_point(chain.front().a, {-3, 0});
    expect_point(chain.back().b, {3, -1});
    double highest = 0;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        EXPECT_NEAR(chain[k].b.x * chain[k].b.x / 9 + chain[k].b.y * chain[k].b.y, 1, 1e-12);
        highest = std::max(highest, chain[k].b.y);
    }
    EXPECT_NEAR(highest, 1, 1e-3);
}

TEST(DrawingBlocks, ArraysStepAlongTheTurnedAxes) {
    const Drawing drawing =
        read({insert("P", {{10, 1}, {20, 2}, {41, 5}, {50, 90}, {70, 3}, {71, 2}, {44, 10}, {45, 100}}),
              block("P", line(0, 0, 1, 0))});
    ASSERT_EQ(drawing.insertions.size(), 6u);
    ASSERT_EQ(drawing.shapes.size(), 6u);
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) {
            const Point at = {1.0 - 100 * row, 2.0 + 10 * column};
            const std::size_t k = static_cast<std::size_t>(3 * row + column);
            expect_strokes(drawing, k, {{at, {at.x, at.y + 5}, 0}});
            expect_point(drawing.insertions[k].at, at);
        }
}

TEST(DrawingBlocks, NestedOnesCompose) {
    const std::string wing = block("WING", insert("DOOR", {{10, 5}, {20, 0}, {50, 90}}, "A-WING"));
    const Drawing drawing = read({insert("WING", {{10, 100}, {20, 0}, {42, -1}}), wing + door()});
    ASSERT_EQ(drawing.insertions.size(), 2u);
    EXPECT_EQ(drawing.insertions[0].parent, UINT32_MAX);
    EXPECT_EQ(drawing.insertions[1].parent, 0u);
    EXPECT_EQ(drawing.insertions[1].name, "DOOR");
    EXPECT_EQ(drawing.shapes.at(0).block, 1u);
    expect_strokes(drawing, 0, {{{105, 0}, {105, -1}, 0}});
    expect_strokes(drawing, 1, {{{105, -1}, {104, 0}, -quarter_bulge}});
}

TEST(DrawingBlocks, LayerZeroTakesThatOfTheInsertion) {
    const std::string wing = block("WING", insert("DOOR", {}, "0") + insert("DOOR", {}, "INNER"));
    const Drawing drawing = read({insert("WING", {}, "OUTER") + line(0, 0, 1, 0), wing + door()});
    std::vector<std::string> names;
    for (const Shape& shape : drawing.shapes) names.push_back(drawing.layers.at(shape.layer).name);
    EXPECT_EQ(names, (std::vector<std::string>{"OUTER", "A-DOOR", "INNER", "A-DOOR", "0"}));
    EXPECT_EQ(drawing.layers.at(drawing.insertions.at(1).layer).name, "OUTER");
    EXPECT_EQ(drawing.layers.at(drawing.insertions.at(2).layer).name, "INNER");
}

TEST(DrawingBlocks, FrozenInsertionsHideWhatStandsInThem) {
    const std::string inside = line(0, 0, 1, 0, "shown") + line(0, 0, 2, 0) + entity("TEXT", {{8, "shown"}, {1, "A"}});
    const std::string blocks = block("B", inside) + block("OUTER", insert("B", {}, "shown"));
    const auto shown = [&](const char* on_layer, const char* name) {
        const Drawing drawing = read({insert(name, {}, on_layer), blocks, "",
                                      layer("0") + layer("shown") + layer("frozen", 1) + layer("off", 0, -1)});
        return std::vector<bool>{drawing.shapes.at(0).visible, drawing.shapes.at(1).visible,
                                 drawing.texts.at(0).visible};
    };
    EXPECT_EQ(shown("shown", "B"), (std::vector<bool>{true, true, true}));
    EXPECT_EQ(shown("frozen", "B"), (std::vector<bool>{false, false, false}));
    EXPECT_EQ(shown("frozen", "OUTER"), (std::vector<bool>{false, false, false}));
    EXPECT_EQ(shown("off", "B"), (std::vector<bool>{true, false, true}));  // hides only what takes its layer
}

TEST(DrawingBlocks, MissingOneIsReportedWithItsLine) {
    const File file = {line(0, 0, 1, 1) + insert("NOWHERE", {})};
    const Drawing drawing = read(file);
    EXPECT_EQ(drawing.shapes.size(), 1u);
    const std::string sentence = sentence_of(drawing, "P717");
    EXPECT_NE(sentence.find("\"NOWHERE\""), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("line " + std::to_string(line_of(file.text(), "INSERT") - 1)), std::string::npos)
        << sentence;
}

TEST(DrawingBlocks, FirstBlockOfANameStands) {
    const Drawing drawing =
        read({insert("B", {}), block("B", line(0, 0, 1, 0)) + block("b", line(0, 0, 2, 0) + line(0, 0, 3, 0))});
    ASSERT_EQ(drawing.shapes.size(), 1u);
    expect_strokes(drawing, 0, {{{0, 0}, {1, 0}, 0}});
}

TEST(DrawingBlocks, NamelessOnesAreNotDrawnAnywhere) {
    const std::string nameless = entity("BLOCK", {{10, 0}}) + line(7, 7, 8, 8) + entity("ENDBLK", {});
    const Drawing drawing =
        read({line(0, 0, 1, 0) + entity("INSERT", {{10, 0}}), nameless + block("B", line(0, 0, 2, 0))});
    EXPECT_EQ(drawing.shapes.size(), 1u);
}

TEST(DrawingBlocks, BlocksThatNobodyInsertsSayNothing) {
    const Drawing drawing = read({line(0, 0, 1, 0), block("D", entity("HATCH", {}) + entity("LINE", {{10, "oops"}}))});
    EXPECT_TRUE(drawing.findings.empty());
}

TEST(DrawingBlocks, AttributesBelongToTheirInsertion) {
    const std::string tags = entity("INSERT", {{2, "DOOR"}, {66, 1}}) + entity("ATTRIB", {{1, "D01"}, {2, "NO"}}) +
                             entity("ATTRIB", {{1, "0.90"}, {2, "WIDTH"}}) + entity("SEQEND", {}) +
                             entity("INSERT", {{2, "DOOR"}});
    const std::string tagged = block("T", entity("ATTDEF", {{1, "?"}, {2, "NO"}}));
    const Drawing drawing = read({tags + entity("INSERT", {{2, "T"}}), door() + tagged});
    ASSERT_EQ(drawing.insertions.size(), 3u);
    EXPECT_EQ(drawing.insertions[0].attributes, (std::vector<std::string>{"D01", "0.90"}));
    EXPECT_TRUE(drawing.insertions[1].attributes.empty());
    EXPECT_TRUE(drawing.texts.empty());
    EXPECT_TRUE(drawing.findings.empty());
}

TEST(DrawingBlocks, TextsAndDimensionsAreInsertedToo) {
    const std::string note = block("N", entity("TEXT", {{1, "Bath"}, {10, 1}, {20, 0}, {40, 0.5}}) +
                                            entity("DIMENSION", {{70, 1}, {13, 0}, {23, 0}, {14, 3}, {24, 4}}));
    const Drawing drawing = read({insert("N", {{10, 10}, {20, 0}, {41, 2}, {42, 2}, {50, 90}}), note});
    expect_point(drawing.texts.at(0).at, {10, 2});
    EXPECT_NEAR(drawing.texts[0].height, 1, 1e-12);
    EXPECT_NEAR(drawing.dimensions.at(0).length, 10, 1e-12);
}

}  // namespace
}  // namespace enfilade::plans
