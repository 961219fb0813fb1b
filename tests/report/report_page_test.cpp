#include "tools/report_page.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "plans/read.h"
#include "plans/utf8.h"
#include "tests/report/faulty_building.h"

namespace enfilade::tools {
namespace {

using nlohmann::json;

bool has(const std::string& page, const std::string& part) { return page.find(part) != std::string::npos; }

std::size_t count(const std::string& page, const std::string& part) {
    std::size_t number = 0;
    for (std::size_t at = page.find(part); at != std::string::npos; at = page.find(part, at + 1)) ++number;
    return number;
}

json data_of(const std::string& page) {
    const std::string open = "<script type=\"application/json\" id=\"data\">";
    const std::size_t from = page.find(open) + open.size();
    return json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(ReportPage, SaysTheVerdict) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    modeler::CheckReport sound;
    sound.codes_checked = {"T1"};
    EXPECT_TRUE(has(report_page({"a.json", ""}, sound, &building), "<title>two storeys: sound</title>"));
    EXPECT_TRUE(has(report_page({"a.json", ""}, testing::mixed_report(), &building), ">Not sound</p>"));
    EXPECT_TRUE(has(report_page({"a.enf", "differs at cells"}, sound, &building), ">Not sound</p>"));
    const std::string certified = report_page({"a.enf", "certified"}, sound, &building);
    EXPECT_TRUE(has(certified, ">Sound</p>"));
    EXPECT_TRUE(has(certified, "<strong>certified</strong>"));
}

TEST(ReportPage, CountsWhatThereIs) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    const std::string page = report_page({"a.json", ""}, testing::mixed_report(), &building);
    for (const char* part : {"<dd>2</dd><dt>storeys</dt>", "<dd>3</dd><dt>rooms</dt>", "<dd>3</dd><dt>doors</dt>",
                             "<dd>0</dd><dt>windows</dt>"})
        EXPECT_TRUE(has(page, part)) << part;
    EXPECT_TRUE(has(page, "1 error</span>"));
    EXPECT_TRUE(has(page, "2 warnings</span>"));
    EXPECT_TRUE(has(page, "1 note</span>"));
    EXPECT_TRUE(has(page, "href=\"#code-T7\""));
    EXPECT_TRUE(has(page, "<tr id=\"code-T7\">"));
    EXPECT_TRUE(has(page, "<tr id=\"code-T1\">")) << "checked, nothing found";
}

TEST(ReportPage, PinsFindingsWhereTheyAre) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    const std::string page = report_page({"a.json", ""}, testing::mixed_report(), &building);
    const json data = data_of(page);
    ASSERT_EQ(data["findings"].size(), 4u);
    const json& error = data["findings"][0];
    EXPECT_EQ(error["n"], 1);
    EXPECT_EQ(error["code"], "T7");
    EXPECT_EQ(error["severity"], "error");
    EXPECT_EQ(error["storey"], 0);
    EXPECT_EQ(error["elements"], json::array({"ge"}));
    const double x = data["origin"][0].get<double>() + error["at"][0].get<double>();
    const double y = data["origin"][1].get<double>() - error["at"][1].get<double>();
    EXPECT_NEAR(x, 8, 1e-3);
    EXPECT_NEAR(y, 3, 1e-3);
    EXPECT_EQ(data["findings"][1]["storey"], 1) << "by its height";
    EXPECT_EQ(count(page, "<g class=\"pin "), 3u);
    EXPECT_TRUE(has(page, "class=\"pin error\" id=\"pin-1\""));
    EXPECT_TRUE(has(page, "moved 12.5 mm"));
}

TEST(ReportPage, ListsFindingsWithoutAPlaceToo) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    const std::string page = report_page({"a.json", ""}, testing::mixed_report(), &building);
    EXPECT_EQ(count(page, "<li class=\"finding "), 4u);
    const json data = data_of(page);
    EXPECT_TRUE(data["findings"][3]["at"].is_null());
    EXPECT_TRUE(data["findings"][3]["storey"].is_null());
}

TEST(ReportPage, NamesOfStrangersStayText) {
    plans::Plan plan = testing::two_rooms();
    const std::string evil = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'&";
    plan.name = evil;
    plan.storeys[0].name = evil;
    plan.storeys[0].rooms.push_back({"a\"b", evil, evil, {{0.2, 0.2}, {1.8, 0.2}, {1.8, 2.8}, {0.2, 2.8}}});
    modeler::CheckReport report = testing::mixed_report();
    report.findings[2].sentence = report.findings[2].hint = evil;
    report.findings[2].elements = {{evil, "a\"b", evil}};
    const modeler::Building building = testing::cells_of(plan);
    const std::string page = report_page({evil, ""}, report, &building);
    EXPECT_EQ(count(page, "<script"), 2u);
    EXPECT_EQ(count(page, "</script>"), 2u);
    EXPECT_EQ(count(page, "<img"), 0u);
    EXPECT_TRUE(has(page, "data-el=\"a&quot;b\""));
    EXPECT_TRUE(has(page, "&lt;/script&gt;&lt;script&gt;alert(1)"));
}

TEST(ReportPage, BytesThatAreNoTextAreReplaced) {
    modeler::CheckReport report = testing::mixed_report();
    report.findings[0].sentence = "broken \xFF\xFE name";
    const std::string page = report_page({"caf\xE9.json", ""}, report, nullptr);
    EXPECT_EQ(plans::to_utf8(page), page);
    EXPECT_TRUE(has(page, "caf\xEF\xBF\xBD.json"));
}

TEST(ReportPage, AsksForNothingFromElsewhere) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    const std::string page = report_page({"a.json", ""}, testing::mixed_report(), &building);
    for (const char* part : {"http:", "https:", "url(", "@import", " src=", "//cdn"})
        EXPECT_FALSE(has(page, part)) << part;
    EXPECT_TRUE(has(page, "default-src 'none'"));
}

TEST(ReportPage, IsTheSameEveryTime) {
    const auto write = [] {
        const modeler::Building building = testing::cells_of(testing::two_storeys());
        return report_page({"a.json", ""}, testing::mixed_report(), &building);
    };
    EXPECT_EQ(write(), write());
}

TEST(ReportPage, AStrippedSceneHasFindingsAlone) {
    const std::string page = report_page({"a.enf", "uncertified: no model group"}, {}, nullptr);
    EXPECT_TRUE(has(page, ">Not checked</p>"));
    EXPECT_FALSE(has(page, "class=\"drawing"));
    EXPECT_TRUE(has(page, "The scene holds no model"));
}

TEST(ReportPage, ADamagedModelIsReportedAllTheSame) {
    modeler::Building building = testing::cells_of(testing::two_rooms());
    building.corners[0].half_edge = building.corners[1].half_edge;
    const std::string page = report_page({"a.enf", ""}, testing::mixed_report(), &building);
    EXPECT_FALSE(has(page, "class=\"drawing"));
    EXPECT_TRUE(has(page, "the pieces of a space do not close"));
    EXPECT_EQ(count(page, "<li class=\"finding "), 4u);
}

TEST(ReportPage, TooManyCellsAreLeftOutAndThatIsSaid) {
    const modeler::Building building = testing::cells_of(testing::two_rooms());
    const std::string all = report_page({"a.json", ""}, {}, &building);
    const std::string few = report_page({"a.json", ""}, {}, &building, {.cell_bytes = 10});
    EXPECT_TRUE(has(all, "data-layer=\"cells\""));
    EXPECT_TRUE(has(all, "class=\"cell\""));
    EXPECT_FALSE(has(few, "data-layer=\"cells\""));
    EXPECT_FALSE(has(few, "class=\"cell\""));
    EXPECT_TRUE(has(few, "too many to draw"));
}

TEST(ReportPage, OfAnOfficeIsSmall) {
    const plans::Plan plan = plans::read(ENFILADE_SOURCE_DIR "/plans/examples/office-135.json");
    const modeler::Building building = testing::cells_of(plan);
    const std::string page = report_page({"office-135.json", ""}, modeler::check(building), &building);
    EXPECT_LT(page.size(), 600'000u);
    EXPECT_EQ(count(page, "class=\"room "), 135u + 1) << "its rooms and its courtyard";
}

}  // namespace
}  // namespace enfilade::tools
