// The DOT text of a scene's graph.

#include "modeler/exports/dot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "modeler/exports/graphml.h"
#include "modeler/exports/xml_text.h"
#include "tests/modeler/exports/exports_fixture.h"

namespace enfilade::test {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
    return found;
}

TEST(Dot, DrawsEachPlaceOfTwoRoomsOnce) {
    const BuiltPlan two = built(testing::two_rooms());
    const std::string dot = modeler::to_dot(two.scene.view());
    // Exterior, two rooms, two doors, a window; the window's pane and both sides of both doors.
    EXPECT_EQ(count(dot, "pos="), 6u);
    EXPECT_EQ(count(dot, " -- "), 6u);
    EXPECT_EQ(count(dot, "style=dashed"), 1u);
    EXPECT_EQ(count(dot, "m²\""), 2u);
}

TEST(Dot, DrawsEachCellAndPortalAtCellLevel) {
    const BuiltPlan ring = built(testing::ring_room());
    const std::string dot = modeler::to_dot(ring.scene.view(), modeler::GraphLevel::Cells);
    EXPECT_EQ(count(dot, "pos="), ring.scene.view().cells.size());
    EXPECT_EQ(count(dot, " -- "), ring.scene.view().portals.size());
    EXPECT_GT(count(dot, "style=dotted"), 3u);
}

TEST(Dot, StoreysAreClusters) {
    const std::string dot = modeler::to_dot(built(testing::two_storeys()).scene.view());
    EXPECT_EQ(count(dot, "subgraph cluster_"), 2u);
    EXPECT_EQ(std::count(dot.begin(), dot.end(), '{'), std::count(dot.begin(), dot.end(), '}'));
}

TEST(Dot, IsTheSameEachTime) {
    const plans::Plan plan = testing::two_storeys();
    EXPECT_EQ(modeler::to_dot(built(plan).scene.view()), modeler::to_dot(built(plan).scene.view()));
}

plans::Plan room_with_a_nasty_name() {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].rooms.push_back({"room", nasty_name, "room", {{1, 1}, {3, 1}, {3, 2}}, {}, {}});
    return plan;
}

TEST(Dot, EscapesNames) {
    const std::string dot = modeler::to_dot(built(room_with_a_nasty_name()).scene.view());
    EXPECT_NE(dot.find("a\\\"b\\\\c<d>&e'f\\ngh"), std::string::npos) << dot;
    EXPECT_EQ(dot.find('\x01'), std::string::npos);
}

TEST(GraphMl, EscapesNames) {
    const std::string xml = modeler::to_graphml(built(room_with_a_nasty_name()).scene.view());
    EXPECT_NE(xml.find("a&quot;b\\c&lt;d&gt;&amp;e'f&#10;ghi"), std::string::npos);
}

TEST(XmlText, ReplacesWhatIsNoUtf8AndDropsWhatIsNoXml) {
    EXPECT_EQ(modeler::xml_text("a\xFF"
                                "b\xC3"
                                "c\x02"
                                "d\xEF\xBF\xBE"
                                "e"),
              "a\xEF\xBF\xBD"
              "b\xEF\xBF\xBD"
              "cde");
    EXPECT_EQ(modeler::xml_text("\xEF\xBC\x81\t"), "\xEF\xBC\x81&#9;");
}

}  // namespace
}  // namespace enfilade::test
