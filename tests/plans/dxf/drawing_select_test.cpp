// Choosing parts of a drawing by layer and by box.
#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

/// Two plans side by side, on layers A-WALL and A-DOOR, with a door inserted in each.
Drawing two_plans() {
    std::string entities;
    for (const double x : {0.0, 100.0})
        entities += line(x, 0, x + 10, 0, "A-WALL") +
                    entity("INSERT", {{8, "A-DOOR"}, {2, "DOOR"}, {10, x + 2}, {20, 0}}) +
                    entity("TEXT", {{8, "A-TEXT"}, {1, x > 0 ? "upper" : "lower"}, {10, x + 5}, {20, 5}}) +
                    entity("DIMENSION", {{8, "A-DIM"}, {70, 1}, {13, x}, {23, 0}, {14, x + 10}, {24, 0}});
    return read({entities, block("LEAF", line(0, 0, 0, 1)) +
                               block("DOOR", line(0, 0, 1, 0) + entity("INSERT", {{8, "0"}, {2, "LEAF"}}))});
}

std::vector<std::string> layers_of(const Drawing& drawing) {
    std::vector<std::string> names;
    for (const Shape& shape : drawing.shapes) names.push_back(drawing.layers.at(shape.layer).name);
    return names;
}

TEST(DrawingSelect, EverythingWithoutChoice) {
    const Drawing all = two_plans();
    const Drawing same = select(all, {}, std::nullopt, "test.dxf");
    EXPECT_EQ(same.shapes.size(), 6u);
    EXPECT_EQ(same.insertions.size(), 4u);
    EXPECT_EQ(same.texts.size(), 2u);
}

TEST(DrawingSelect, LayersByName) {
    const Drawing left = select(two_plans(), {"a-wall"}, std::nullopt, "test.dxf");
    EXPECT_EQ(layers_of(left), (std::vector<std::string>{"A-WALL", "A-WALL"}));
    EXPECT_TRUE(left.insertions.empty());
    EXPECT_TRUE(left.texts.empty());
    EXPECT_TRUE(left.dimensions.empty());
    expect_strokes(left, 1, {{{100, 0}, {110, 0}, 0}}, 0);
    for (const Layer& layer : left.layers) EXPECT_EQ(layer.shape_count, layer.name == "A-WALL" ? 2u : 0u);
}

TEST(DrawingSelect, LayersByPattern) {
    EXPECT_EQ(select(two_plans(), {"*WALL", "A-TEX?"}, std::nullopt, "").texts.size(), 2u);
    EXPECT_EQ(select(two_plans(), {"A*"}, std::nullopt, "").shapes.size(), 6u);
    EXPECT_EQ(select(two_plans(), {"*-*O*R"}, std::nullopt, "").insertions.size(), 4u);
    const Drawing dollar = read_entities(line(0, 0, 1, 0, "plan$0$A-WALL") + line(0, 0, 1, 0, "W\u00E4nde"));
    EXPECT_EQ(select(dollar, {"*$0$A-WALL"}, std::nullopt, "").shapes.size(), 1u);
}

TEST(DrawingSelect, QuestionMarkIsOneLetter) {
    const Drawing drawing =
        read({line(0, 0, 1, 0, "W\u00E4nde") + line(0, 0, 1, 0, "B"), "", pairs({{9, "$ACADVER"}, {1, "AC1021"}})});
    EXPECT_EQ(select(drawing, {"W?nde"}, std::nullopt, "").shapes.size(), 1u);
    EXPECT_THROW((void)select(drawing, {"W??nde"}, std::nullopt, ""), InputError);
}

TEST(DrawingSelect, UnknownLayerNamesTheOthers) {
    try {
        (void)select(two_plans(), {"A-WALL", "S-WALL"}, std::nullopt, "test.dxf");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, "P710");
        const std::string sentence = error.what();
        EXPECT_NE(sentence.find("\"S-WALL\""), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("\"A-DOOR\""), std::string::npos) << sentence;
    }
}

TEST(DrawingSelect, BoxTakesOnePlan) {
    const Drawing left = select(two_plans(), {}, DrawingBox{120, 20, 90, -1}, "test.dxf");  // corners in any order
    EXPECT_EQ(left.shapes.size(), 3u);
    ASSERT_EQ(left.insertions.size(), 2u);
    EXPECT_EQ(left.insertions[0].parent, UINT32_MAX);
    EXPECT_EQ(left.insertions[1].parent, 0u);
    EXPECT_EQ(left.insertions[1].name, "LEAF");
    EXPECT_EQ(left.shapes.at(1).block, 0u);
    EXPECT_EQ(left.shapes.at(2).block, 1u);
    ASSERT_EQ(left.texts.size(), 1u);
    EXPECT_EQ(left.texts[0].text, "upper");
    EXPECT_EQ(left.dimensions.size(), 1u);
    EXPECT_EQ(left.bounds, (std::array<double, 4>{100, 0, 110, 1}));
}

TEST(DrawingSelect, ShapesThatCrossTheBoxStayWhole) {
    const Drawing drawing =
        read_entities(line(-5, -5, 5, 5) + line(-5, 1, 1, -5) + entity("CIRCLE", {{10, 0}, {20, 0}, {40, 10}}) +
                      entity("CIRCLE", {{10, 0}, {20, 9}, {40, 10}}));
    // The diagonal and the circle through the box cross it; the line beside it and the circle around it do not.
    const Drawing left = select(drawing, {}, DrawingBox{-1, -1.5, 1, 1}, "test.dxf");
    ASSERT_EQ(left.shapes.size(), 2u);
    expect_strokes(left, 0, {{{-5, -5}, {5, 5}, 0}}, 0);
    EXPECT_EQ(left.shapes[1].kind, ShapeKind::Circle);
    EXPECT_NEAR(strokes_of(left, 1)[0].a.y, 9, 1e-12);
}

TEST(DrawingSelect, NothingLeftTellsWhereTheDrawingIs) {
    try {
        (void)select(two_plans(), {}, DrawingBox{1000, 1000, 1001, 1001}, "test.dxf");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, "P711");
        EXPECT_NE(std::string(error.what()).find("0 to 110"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace enfilade::plans
