// What is refused, with its line, and that it is refused soon.
#include <algorithm>
#include <chrono>
#include <functional>
#include <locale>

#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

void expect_refusal(const std::string& text, const std::string& code, int at_line, const std::string& part) {
    const InputError error = refusal(text);
    EXPECT_EQ(error.code, code) << error.what();
    EXPECT_EQ(error.line, at_line) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
}

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string insert(const std::string& name, Pairs more = {}) { return entity("INSERT", {{2, name}}) + pairs(more); }

TEST(DrawingRefusals, DwgFile) { expect_refusal("AC1032" + std::string(200, '\0'), "P700", 0, "DWG file (AC1032)"); }

TEST(DrawingRefusals, BinaryDxf) {
    expect_refusal(std::string("AutoCAD Binary DXF\r\n\x1A\0\0\0", 24), "P701", 0, "binary DXF");
}

TEST(DrawingRefusals, ZeroBytes) {
    std::string text = File{line(0, 0, 1, 1, "layer")}.text();
    text[text.find("layer") + 2] = '\0';
    expect_refusal(text, "P701", line_of(text, std::string("la\0er", 5)), "zero bytes");
}

TEST(DrawingRefusals, NoDrawing) {
    expect_refusal("", "P702", 1, "no DXF drawing");
    expect_refusal("hello\nworld\n", "P702", 1, "no DXF drawing");
    expect_refusal("0\nLINE\n 10\n1\n", "P702", 1, "no DXF drawing");
    expect_refusal("0\nEOF\n", "P702", 1, "no section");
    expect_refusal("999\nonly a comment\n", "P702", 3, "no DXF drawing");
}

TEST(DrawingRefusals, CutOff) {
    const std::string whole = File{line(0, 0, 1, 1) + line(2, 2, 3, 3)}.text();
    const int lines = static_cast<int>(std::count(whole.begin(), whole.end(), '\n'));
    std::size_t end = 0;
    for (int k = 1; k < lines; ++k) {
        end = whole.find('\n', end) + 1;
        const InputError error = refusal(whole.substr(0, end));
        EXPECT_EQ(error.code, k < 2 ? "P702" : "P703") << "after line " << k << ": " << error.what();
        EXPECT_EQ(error.line, k);
    }
    EXPECT_EQ(refusal(whole).code, "");
}

TEST(DrawingRefusals, SectionWithoutEnd) {
    const std::string text = pairs({{0, "SECTION"}, {2, "ENTITIES"}}) + line(0, 0, 1, 1) + pair(0, "EOF");
    expect_refusal(text, "P703", line_of(text, "EOF") - 1, "ENTITIES");
    const std::string two = pairs({{0, "SECTION"}, {2, "BLOCKS"}, {0, "SECTION"}, {2, "ENTITIES"}}) + pair(0, "EOF");
    expect_refusal(two, "P704", 5, "BLOCKS");
}

TEST(DrawingRefusals, PairsOutOfStep) {
    std::string text = File{line(0, 0, 1, 1)}.text();
    text.insert(text.find(" 20\n"), "stray line\n");
    expect_refusal(text, "P704", line_of(text, "stray line"), "\"stray line\"");
}

TEST(DrawingRefusals, EntitiesBetweenSections) {
    const std::string text = section("BLOCKS", "") + line(0, 0, 1, 1) + pair(0, "EOF");
    expect_refusal(text, "P704", line_of(text, "LINE") - 1, "\"LINE\"");
}

TEST(DrawingRefusals, BlockInItself) {
    const std::string text =
        File{insert("A"), block("A", insert("B")) + block("B", line(0, 0, 1, 1) + insert("a"))}.text();
    expect_refusal(text, "P706", line_of(text, "INSERT", 2) - 1, "\"A\"");
}

TEST(DrawingRefusals, CircleThatNobodyInsertsIsHarmless) {
    EXPECT_EQ(refusal(File{line(0, 0, 1, 1), block("A", insert("A"))}.text()).code, "");
}

TEST(DrawingRefusals, NestedTooDeep) {
    std::string blocks;
    for (int k = 0; k < 40; ++k)
        blocks += block(("B" + std::to_string(k)).c_str(), insert("B" + std::to_string(k + 1)));
    blocks += block("B40", line(0, 0, 1, 1));
    const InputError error = refusal(File{insert("B0"), blocks}.text());
    EXPECT_EQ(error.code, "P707") << error.what();
    EXPECT_EQ(refusal(File{insert("B9"), blocks}.text()).code, "");  // 32 deep
    EXPECT_EQ(refusal(File{insert("B8"), blocks}.text()).code, "P707");
    // Known from another place where it was not too deep.
    EXPECT_EQ(refusal(File{insert("B20") + insert("B8"), blocks}.text()).code, "P707");
}

TEST(DrawingRefusals, LongChainOfBlocksDoesNotExhaustTheStack) {
    std::string blocks;
    for (int k = 0; k < 20'000; ++k)
        blocks += block(("B" + std::to_string(k)).c_str(), insert("B" + std::to_string(k + 1)));
    EXPECT_EQ(refusal(File{insert("B0"), blocks}.text()).code, "P707");
}

TEST(DrawingRefusals, EndlessArray) {
    const std::string array = insert("A", {{70, 1'000'000'000}, {71, 1'000'000'000}});
    const std::string text = File{line(0, 0, 1, 1) + array, block("A", line(0, 0, 1, 1))}.text();
    EXPECT_LT(seconds_of([&] { expect_refusal(text, "P708", line_of(text, "INSERT") - 1, "5000000"); }), 0.5);
    // Blocks without a line take memory as well.
    EXPECT_EQ(refusal(File{array, block("A", "")}.text()).code, "P708");
}

TEST(DrawingRefusals, BlocksThatMultiply) {
    std::string blocks = block("B0", line(0, 0, 1, 1));
    for (int k = 1; k < 30; ++k) {
        std::string ten;
        for (int copy = 0; copy < 10; ++copy) ten += insert("B" + std::to_string(k - 1));
        blocks += block(("B" + std::to_string(k)).c_str(), ten);
    }
    const std::string text = File{insert("B29"), blocks}.text();
    EXPECT_LT(seconds_of([&] { EXPECT_EQ(refusal(text).code, "P708"); }), 0.5);
}

TEST(DrawingRefusals, LongTextsInManyCopies) {
    const std::string text =
        File{insert("A", {{70, 1'000'000}}), block("A", entity("MTEXT", {{1, std::string(100'000, 'x')}}))}.text();
    EXPECT_LT(seconds_of([&] { EXPECT_EQ(refusal(text).code, "P708"); }), 0.5);
}

TEST(DrawingRefusals, MoreEntitiesThanTheLimit) {
    DrawingLimits limits;
    limits.strokes = 100;
    std::string lines;
    std::string vertices;
    for (int k = 0; k < 101; ++k) lines += line(0, 0, 1, k);
    for (int k = 0; k < 101; ++k) vertices += pairs({{10, k}, {20, 0}});
    for (const std::string& text : {File{lines}.text(), File{line(0, 0, 1, 1), block("B", lines)}.text(),
                                    File{entity("LWPOLYLINE", {}) + vertices}.text()}) {
        const InputError error = refusal(text, limits);
        EXPECT_EQ(error.code, "P708") << error.what();
        EXPECT_GT(error.line, 0);
    }
}

TEST(DrawingRefusals, EntityOfEndlessValues) {
    DrawingLimits limits;
    limits.strokes = 100;
    std::string values;
    for (int k = 0; k < 1000; ++k) values += pair(40, k);
    const std::string text = File{entity("SPLINE", {}) + values}.text();
    const InputError error = refusal(text, limits);
    EXPECT_EQ(error.code, "P708");
    EXPECT_EQ(error.line, line_of(text, "500") - 1);
}

TEST(DrawingRefusals, CurvesOfMoreStrokesThanTheLimit) {
    DrawingLimits limits;
    limits.strokes = 1000;
    const std::string text =
        File{insert("A", {{41, 2}, {70, 100}}), block("A", entity("CIRCLE", {{10, 0}, {20, 0}, {40, 1}}))}.text();
    EXPECT_EQ(refusal(text, limits).code, "P708");
    EXPECT_EQ(refusal(text).code, "");
}

TEST(DrawingRefusals, NumbersThatAreNoneAreLeftOutWithTheirLine) {
    for (const char* number : {"nan", "-inf", "1e308", "1e999", "1e14", "abc", "", "1.#QNAN", "1.5x", "0x10"}) {
        const std::string text =
            File{line(0, 0, 1, 1) + entity("LINE", {{10, number}, {20, 0}, {11, 1}, {21, 1}})}.text();
        const Drawing drawing = read_drawing(text, "test.dxf");
        EXPECT_EQ(drawing.shapes.size(), 1u) << number;
        const Finding* const finding = finding_of(drawing, "P712");
        ASSERT_NE(finding, nullptr) << number;
        EXPECT_EQ(finding->severity, Severity::Error);
        const std::string place = "line " + std::to_string(line_of(text, "LINE", 2) - 1);
        EXPECT_NE(finding->sentence.find(place), std::string::npos) << finding->sentence;
    }
}

TEST(DrawingRefusals, VertexThatIsNoneTakesItsPolylineAlong) {
    const std::string broken = entity("POLYLINE", {{70, 0}}) + entity("VERTEX", {{10, 0}, {20, 0}}) +
                               entity("VERTEX", {{10, "nan"}, {20, 0}}) + entity("VERTEX", {{10, 2}, {20, 0}}) +
                               entity("SEQEND", {});
    const Drawing drawing = read_entities(broken + line(0, 0, 1, 1));
    EXPECT_EQ(drawing.shapes.size(), 1u);
    EXPECT_NE(finding_of(drawing, "P712"), nullptr);
}

TEST(DrawingRefusals, ScaleBeyondNumbersIsLeftOut) {
    const Drawing drawing = read({insert("A", {{41, 1e12}}) + insert("A", {{10, 1e13}, {41, 10}}) + line(0, 0, 1, 1),
                                  block("A", line(0, 0, 1000, 1))});
    EXPECT_EQ(drawing.shapes.size(), 1u);
    EXPECT_NE(finding_of(drawing, "P712"), nullptr);
}

TEST(DrawingRefusals, NumbersAsPeopleWriteThem) {
    const Drawing drawing = read_entities(entity("LINE", {{10, "  1.50 "}, {20, "+2"}, {11, ".5"}, {21, "3."}}) +
                                          entity("LINE", {{10, "1,5"}, {20, "1E2"}, {11, "-1e-400"}, {21, "0001"}}));
    expect_strokes(drawing, 0, {{{1.5, 2}, {0.5, 3}, 0}}, 0);
    expect_strokes(drawing, 1, {{{1.5, 100}, {0, 1}, 0}}, 0);
}

class CommaPoint : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(DrawingRefusals, NumbersDoNotFollowTheLocale) {
    const std::string text = File{line(1.5, -2.25e-3, 1234567.125, 1e-7)}.text();
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
    const Drawing drawing = read_drawing(text, "test.dxf");
    std::locale::global(before);
    expect_strokes(drawing, 0, {{{1.5, -2.25e-3}, {1234567.125, 1e-7}, 0}}, 0);
}

TEST(DrawingRefusals, LongLines) {
    const std::string longest(3'000'000, 'x');
    const std::string text = File{
        entity("LINE", {{8, longest}, {10, 0}, {20, 0}, {11, 1}, {21, 1}}) +
        entity("LINE", {{6, longest}, {10, 0}, {20, 0}, {11, 2}, {21, 1}}) + entity("HATCH", {{1, longest}}) +
        entity("LINE",
               {{10, longest}})}.text();
    EXPECT_LT(seconds_of([&] {
                  const Drawing drawing = read_drawing(text, "test.dxf");
                  EXPECT_EQ(drawing.shapes.size(), 2u);
                  EXPECT_NE(finding_of(drawing, "P718"), nullptr);
              }),
              0.5);
    EXPECT_EQ(refusal(longest).code, "P702");
}

TEST(DrawingRefusals, LineEndsOfBothKinds) {
    const std::string text = File{line(0, 0, 1, 1, "A")}.text();
    std::string windows = "999\r\nmade by hand\r\n";
    for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const Drawing drawing = read_drawing(windows + "\r\n\x1A", "test.dxf");
    EXPECT_EQ(drawing.layers.at(drawing.shapes.at(0).layer).name, "A");
    EXPECT_EQ(drawing.shapes[0].line, 7);
    EXPECT_EQ(read_drawing("\xEF\xBB\xBF" + text, "test.dxf").shapes.size(), 1u);
    EXPECT_EQ(read_drawing(text.substr(0, text.size() - 1), "test.dxf").shapes.size(), 1u);
}

TEST(DrawingRefusals, NothingIsPrinted) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    (void)read({line(0, 0, 1, 1) + entity("LWPOLYLINE", {{90, 1'000'000'000}, {42, 1}, {10, "x"}}) +
                    entity("HATCH", {{10, 1}}) + entity("SPLINE", {{71, -3}, {72, -1}, {73, 1'000'000'000}, {40, 1}}) +
                    entity("LEADER", {{76, -1}, {10, 1}}),
                block("", line(0, 0, 1, 1)), pairs({{9, "$ACADVER"}, {1, ""}, {9, "$INSUNITS"}, {70, "x"}})});
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(DrawingRefusals, LargeFilesTakeLinearTime) {
    const auto many = [](int count) {
        std::string entities;
        for (int k = 0; k < count; ++k) entities += line(k, 0, k + 0.5, 1, "A-WALL");
        return File{std::move(entities)}.text();
    };
    const std::string small = many(5'000);
    const std::string large = many(50'000);
    const double short_time = seconds_of([&] { EXPECT_EQ(read_drawing(small, "test.dxf").shapes.size(), 5'000u); });
    const double long_time = seconds_of([&] { EXPECT_EQ(read_drawing(large, "test.dxf").shapes.size(), 50'000u); });
    EXPECT_LT(long_time, 40 * short_time + 0.2);
}

}  // namespace
}  // namespace enfilade::plans
