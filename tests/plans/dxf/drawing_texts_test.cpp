// Texts: where they stand, what they say, and in which letters.
#include "plans/dxf/words.h"
#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

std::string text_after(const std::string& header, const std::string& bytes) {
    return read({entity("TEXT", {{1, bytes}, {10, 0}, {20, 0}}), "", header}).texts.at(0).text;
}

std::string version(const char* name) { return pairs({{9, "$ACADVER"}, {1, name}}); }
std::string page(const char* name) { return pairs({{9, "$DWGCODEPAGE"}, {3, name}}); }

TEST(DrawingTexts, TextStandsAtItsPoint) {
    const Drawing drawing = read_entities(entity("TEXT", {{8, "T"}, {1, "Kitchen"}, {10, 1.5}, {20, 2}, {40, 0.25}}));
    ASSERT_EQ(drawing.texts.size(), 1u);
    EXPECT_EQ(drawing.texts[0].text, "Kitchen");
    expect_point(drawing.texts[0].at, {1.5, 2}, 0);
    EXPECT_EQ(drawing.texts[0].height, 0.25);
    EXPECT_EQ(drawing.layers.at(drawing.texts[0].layer).name, "T");
    EXPECT_EQ(drawing.layers[drawing.texts[0].layer].text_count, 1u);
}

TEST(DrawingTexts, CentredTextStandsAtItsSecondPoint) {
    const Drawing drawing = read_entities(
        entity("TEXT", {{1, "A"}, {10, 1}, {20, 2}, {72, 4}, {11, 5}, {21, 6}}) +
        entity("TEXT", {{1, "B"}, {10, 1}, {20, 2}, {72, 5}, {11, 5}, {21, 6}}));  // 5: fitted between both
    expect_point(drawing.texts.at(0).at, {5, 6}, 0);
    expect_point(drawing.texts.at(1).at, {1, 2}, 0);
}

TEST(DrawingTexts, MirroredText) {
    const Drawing drawing = read_entities(entity("TEXT", {{1, "A"}, {10, 1}, {20, 2}, {230, -1}, {210, 0}, {220, 0}}));
    expect_point(drawing.texts.at(0).at, {-1, 2}, 0);
}

TEST(DrawingTexts, PercentCodes) {
    EXPECT_EQ(dxf::plain_text("%%uBath%%u 45%%d %%p0.5 %%c20 100%%% %%065 50% %%z"),
              "Bath 45\u00B0 \u00B10.5 \u230020 100% A 50% %%z");
}

TEST(DrawingTexts, FormattingOfMtextIsTakenOut) {
    EXPECT_EQ(dxf::plain_mtext(R"({\fArial|b0|i0;\H2.5x;\C1;Living\Proom} \A1;1\S1/2; \LK\l\~\\x \{y\} \pxqc;end)"),
              "Living\nroom 11/2 K \\x {y} end");
    EXPECT_EQ(dxf::plain_mtext(R"(5\S1#4;^J2\S3^8;)"), "51/4\n23/8");
    EXPECT_EQ(dxf::plain_mtext(R"(\fopen end)"), "");
    EXPECT_EQ(dxf::plain_mtext("\\"), "\\");
}

TEST(DrawingTexts, PartsOfMtextAreJoined) {
    // A font code and an escaped letter are cut in two by the parts.
    const Drawing drawing =
        read_entities(entity("MTEXT", {{10, 1}, {20, 2}, {40, 0.2}, {3, "{\\fAri"}, {3, "al;K\\U+00"}, {1, "FCche}"}}) +
                      entity("MTEXT", {{10, 1}, {20, 2}, {1, "next"}}));
    EXPECT_EQ(drawing.texts.at(0).text, "K\u00FCche");
    EXPECT_EQ(drawing.texts.at(1).text, "next");
}

TEST(DrawingTexts, LongMtextIsWhole) {
    const std::string longer = std::string(2500, 'a') + "\u00FC" + std::string(2500, 'b');
    const Drawing drawing = read({entity("MTEXT", {{1, longer}}), "", version("AC1021")});
    EXPECT_EQ(drawing.texts.at(0).text, longer);
    EXPECT_TRUE(drawing.findings.empty());
}

TEST(DrawingTexts, LongTextIsCutWithANote) {
    // 999 letters, then one of two bytes across the place of the cut.
    const Drawing drawing =
        read({entity("TEXT", {{1, std::string(999, 'a') + "\u00FC" + std::string(9000, 'b')}}), "", version("AC1021")});
    EXPECT_EQ(drawing.texts.at(0).text, std::string(999, 'a'));
    EXPECT_NE(finding_of(drawing, "P718"), nullptr);
}

TEST(DrawingTexts, OldFilesSpeakTheirCodePage) {
    EXPECT_EQ(text_after(version("AC1015") + page("ANSI_1252"),
                         "K\xFC"
                         "che \x80"),
              "K\u00FCche \u20AC");
    EXPECT_EQ(text_after(version("AC1015") + page("ANSI_1251"), "\xCA\xF3\xF5\xED\xFF"),
              "\u041A\u0443\u0445\u043D\u044F");
    EXPECT_EQ(text_after(version("AC1009") + page("dos850"),
                         "K\x81"
                         "che"),
              "K\u00FCche");
    EXPECT_EQ(text_after(version("AC1018") + page("ANSI_936"), "\xB3\xF8\xB7\xBF"), "\u53A8\u623F");
    EXPECT_EQ(text_after("",
                         "K\xFC"
                         "che"),
              "K\u00FCche");
}

TEST(DrawingTexts, NewFilesSpeakUtf8) {
    EXPECT_EQ(text_after(version("AC1021") + page("ANSI_1252"), "K\u00FCche"), "K\u00FCche");
    EXPECT_EQ(text_after(version("AC1032"),
                         "K\xFC"
                         "che"),
              "K\uFFFD"
              "che");
}

TEST(DrawingTexts, EscapedLetters) {
    EXPECT_EQ(text_after(version("AC1015"), "K\\U+00FCche \\U+D83D\\U+DEAA \\U+12 \\M+1B3F8"),
              "K\u00FCche \U0001F6AA \\U+12 \uFFFD");
}

TEST(DrawingTexts, NamesAreDecodedToo) {
    const Drawing drawing = read({line(0, 0, 1, 0, "W\xE4nde") + entity("INSERT", {{2, "T\xDCR"}}),
                                  block("T\xDCR", line(0, 0, 1, 0)), version("AC1015") + page("ANSI_1252")});
    EXPECT_EQ(drawing.layers.at(drawing.shapes.at(0).layer).name, "W\u00E4nde");
    EXPECT_EQ(drawing.insertions.at(0).name, "T\u00DCR");
}

TEST(DrawingTexts, CodePagesGoByManyNames) {
    for (const char* name : {"ISO8859-1", "iso_8859-1", "ascii", "ANSI_1252", "Cp1252"})
        EXPECT_EQ(text_after(version("AC1015") + page(name),
                             "K\xFC"
                             "che"),
                  "K\u00FCche")
            << name;
    EXPECT_EQ(text_after(version("AC1015") + page("mac-roman"),
                         "K\x9F"
                         "che"),
              "K\u00FCche");
    dxf::Words words;
    for (const char* name : {"", "UTF-7", "ISO-2022-CN-EXT", "CP", "CP1252//TRANSLIT", "../x"})
        EXPECT_FALSE(words.set_code_page(name)) << name;
}

TEST(DrawingTexts, UnknownCodePageIsReported) {
    const Drawing drawing = read({entity("TEXT", {{1,
                                                   "K\xFC"
                                                   "che"}}),
                                  "", version("AC1015") + page("KLINGON")});
    EXPECT_EQ(drawing.texts.at(0).text, "K\u00FCche");
    EXPECT_NE(sentence_of(drawing, "P719").find("KLINGON"), std::string::npos);
}

TEST(DrawingTexts, EmptyOnesAreNone) {
    EXPECT_TRUE(read_entities(entity("TEXT", {{1, "  "}}) + entity("MTEXT", {{1, "{\\H2;}"}})).texts.empty());
}

TEST(DrawingTexts, SentencesCutBetweenLetters) {
    EXPECT_EQ(dxf::shortened("abc", 3), "abc");
    EXPECT_EQ(dxf::shortened("abcd", 3), "abc...");
    EXPECT_EQ(dxf::shortened("ab\u00FC", 3), "ab...");
    EXPECT_EQ(dxf::shortened("a\u00FCd", 3), "a\u00FC...");
}

TEST(DrawingTexts, LinearDimensionMeasuresAlongItsAngle) {
    const Drawing drawing =
        read_entities(entity("DIMENSION", {{8, "D"}, {70, 32}, {1, ""}, {13, 0}, {23, 0}, {14, 3}, {24, 4}, {50, 0}}) +
                      entity("DIMENSION", {{70, 32}, {1, "<>"}, {13, 0}, {23, 0}, {14, 3}, {24, 4}, {50, 90}}) +
                      entity("DIMENSION", {{70, 33}, {1, "58'-0\""}, {13, 0}, {23, 0}, {14, 3}, {24, 4}}));
    ASSERT_EQ(drawing.dimensions.size(), 3u);
    EXPECT_NEAR(drawing.dimensions[0].length, 3, 1e-12);
    EXPECT_NEAR(drawing.dimensions[1].length, 4, 1e-12);
    EXPECT_NEAR(drawing.dimensions[2].length, 5, 1e-12);
    EXPECT_EQ(drawing.dimensions[0].text, "");
    EXPECT_EQ(drawing.dimensions[1].text, "");
    EXPECT_EQ(drawing.dimensions[2].text, "58'-0\"");
    expect_point(drawing.dimensions[0].b, {3, 4}, 0);
    EXPECT_EQ(drawing.layers.at(drawing.dimensions[0].layer).name, "D");
}

TEST(DrawingTexts, DimensionTellsWhatItsPictureShows) {
    const std::string picture = block("*D7", line(0, 0, 5, 0) + entity("MTEXT", {{1, "{\\H1;12'-6\"}"}}));
    const Drawing drawing =
        read({entity("DIMENSION", {{2, "*D7"}, {3, "STANDARD"}, {70, 33}, {13, 0}, {23, 0}, {14, 150}, {24, 0}}) +
                  entity("DIMENSION", {{3, "*D7"}, {70, 33}, {13, 0}, {23, 0}, {14, 150}, {24, 0}}),
              picture});
    EXPECT_EQ(drawing.dimensions.at(0).written, "12'-6\"");
    EXPECT_EQ(drawing.dimensions.at(0).text, "");
    EXPECT_EQ(drawing.dimensions.at(1).written, "");
    EXPECT_TRUE(drawing.shapes.empty());
}

TEST(DrawingTexts, OtherDimensionsAreNone) {
    EXPECT_TRUE(read_entities(entity("DIMENSION", {{70, 4}, {15, 1}, {25, 1}})).dimensions.empty());
}

}  // namespace
}  // namespace enfilade::plans
