// Java's .properties files.

#include "modeler/catalogue/properties.h"

#include <gtest/gtest.h>

namespace enfilade::modeler::test {
namespace {

using Properties = std::map<std::string, std::string, std::less<>>;

TEST(Properties, KeysEndAtEqualsColonOrBlank) {
    EXPECT_EQ(read_properties("a=1\nb : 2\nc 3\r\n  d\t=\t4 \re"),
              (Properties{{"a", "1"}, {"b", "2"}, {"c", "3"}, {"d", "4 "}, {"e", ""}}));
}

TEST(Properties, OnlyTheFirstSeparatorCounts) {
    EXPECT_EQ(read_properties("url=http://a=b:c\nx==1"), (Properties{{"url", "http://a=b:c"}, {"x", "=1"}}));
}

TEST(Properties, HashInAKeyIsNoComment) {
    EXPECT_EQ(read_properties("# id#1=no\n! no\nid#1=chair # a seat"), (Properties{{"id#1", "chair # a seat"}}));
}

TEST(Properties, ContinuedLinesAreJoined) {
    EXPECT_EQ(read_properties("name=one \\\n    two \\\r\n\tthree\nlast=x\\\\\nnext=y"),
              (Properties{{"name", "one two three"}, {"last", "x\\"}, {"next", "y"}}));
}

TEST(Properties, EscapesAreRead) {
    EXPECT_EQ(read_properties("a\\ key\\=\\:=\\t\\n\\q\\\\ \\u00e9\\u20AC"),
              (Properties{{"a key=:", "\t\nq\\ \xC3\xA9\xE2\x82\xAC"}}));
}

TEST(Properties, SurrogatePairsAreOneCharacterAndHalvesAreReplaced) {
    EXPECT_EQ(read_properties("a=\\uD83D\\uDECB\nb=\\uD83Dx"),
              (Properties{{"a", "\xF0\x9F\x9B\x8B"}, {"b", "\xEF\xBF\xBDx"}}));
}

TEST(Properties, TextIsUtf8OrElseLatin) {
    EXPECT_EQ(read_properties("a=\xC3\xA9"), (Properties{{"a", "\xC3\xA9"}}));
    EXPECT_EQ(read_properties("a=\xE9t\xE9"), (Properties{{"a", "\xC3\xA9t\xC3\xA9"}}));
}

TEST(Properties, HalfEscapesAndOpenEndsDoNoHarm) {
    EXPECT_EQ(read_properties("a=\\u12"), (Properties{{"a", "u12"}}));
    EXPECT_EQ(read_properties("a=b\\"), (Properties{{"a", "b"}}));
    EXPECT_EQ(read_properties("\\"), (Properties{{"", ""}}));
    EXPECT_EQ(read_properties("\xEF\xBB\xBF"), Properties{});
}

}  // namespace
}  // namespace enfilade::modeler::test
