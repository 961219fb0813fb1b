#include "tools/report/html_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace enfilade::tools {
namespace {

TEST(HtmlText, MarksAreEscaped) {
    EXPECT_EQ(escaped("<b a=\"1\" b='2'> & </b>"), "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt; &amp; &lt;/b&gt;");
}

TEST(HtmlText, NamesInAnyScriptStayAsTheyAre) {
    for (const char* name : {"Küche", "مطبخ", "客厅", "🛋 lounge"}) EXPECT_EQ(escaped(name), name);
}

TEST(HtmlText, WhatIsNoTextIsReplaced) {
    EXPECT_EQ(escaped("a\xC3(\x01"), "a\xEF\xBF\xBD(\xEF\xBF\xBD");
    EXPECT_EQ(escaped(std::string("a\0b", 3)),
              "a\xEF\xBF\xBD"
              "b");
}

TEST(HtmlText, JsonCannotEndItsScript) {
    const nlohmann::ordered_json json = {{"name", "</script><!--"}};
    const std::string text = script_json(json);
    EXPECT_EQ(text.find('<'), std::string::npos) << text;
    EXPECT_EQ(nlohmann::ordered_json::parse(text), json);
}

TEST(HtmlText, AreasHaveThreeDigits) {
    EXPECT_EQ(area_text(0.316), "0.32 m²");
    EXPECT_EQ(area_text(12.36), "12.4 m²");
    EXPECT_EQ(area_text(512.6), "513 m²");
    EXPECT_EQ(area_text(12345.6), "12,346 m²");
}

}  // namespace
}  // namespace enfilade::tools
