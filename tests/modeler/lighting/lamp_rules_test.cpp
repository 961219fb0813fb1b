#include "modeler/lighting/lamp_rules.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "modeler/furnishing/rules.h"

namespace enfilade::modeler {
namespace {

std::string code_of(const std::string& text) {
    try {
        (void)read_lamp_rules_text(text, "lamps.json");
    } catch (const InputError& error) {
        EXPECT_EQ(error.file, "lamps.json");
        EXPECT_GT(error.line, 0) << text;
        return error.code;
    }
    return "";
}

TEST(LampRules, OursKnowEveryKindOfRoomThatFurnitureRulesKnow) {
    for (const RoomRules& room : own_rules().rooms) {
        const auto& ours = own_lamp_rules().rooms;
        EXPECT_TRUE(std::ranges::find(ours, room.kind, &RoomLight::kind) != ours.end()) << room.kind;
    }
}

TEST(LampRules, RoomsOfUnknownKindTakeTheDefault) {
    const LampRules& rules = own_lamp_rules();
    ASSERT_NE(rules.room("office"), nullptr);
    EXPECT_EQ(rules.room("office")->lux, 500);
    ASSERT_NE(rules.room("observatory"), nullptr);
    EXPECT_EQ(rules.room("observatory")->kind, "default");
    EXPECT_EQ(rules.room("void"), nullptr) << "no light is asked for";
}

TEST(LampRules, AFileReplacesWhatItTells) {
    const LampRules rules = read_lamp_rules_text(R"({
        "rooms": [{"kind": "office", "lux": 300, "area": 9, "drop": 0.2, "kelvin": 6500, "radius": 0}],
        "outdoor": {"spacing": 7.5, "entrance_lumen": 0}, "count": 55, "replace": true})",
                                                 "lamps.json");
    ASSERT_NE(rules.room("office"), nullptr);
    EXPECT_EQ(rules.room("office")->lux, 300);
    EXPECT_EQ(rules.room("office")->area, 9);
    EXPECT_EQ(rules.room("office")->radius, 0);
    EXPECT_EQ(rules.room("kitchen"), nullptr) << "the list replaces ours, and has no default";
    EXPECT_NE(rules.piece("floor_lamp"), nullptr) << "not told: as ours";
    EXPECT_EQ(rules.outdoor.spacing, 7.5);
    EXPECT_EQ(rules.outdoor.entrance_lumen, 0);
    EXPECT_EQ(rules.count, 55u);
    EXPECT_TRUE(rules.replace);
}

TEST(LampRules, RefusesWhatIsWrongWithItsPlace) {
    EXPECT_EQ(code_of("{"), "U101");
    EXPECT_EQ(code_of(R"({"romos": []})"), "U102");
    EXPECT_EQ(code_of(R"({"rooms": [{"kind": 5}]})"), "U103");
    EXPECT_EQ(code_of(R"({"rooms": [{"lux": 5}]})"), "U104");
    EXPECT_EQ(code_of(R"({"rooms": [{"kind": "office", "lux": -5}]})"), "U105");
    EXPECT_EQ(code_of(R"({"rooms": [{"kind": "office", "kelvin": 12}]})"), "U105");
    EXPECT_EQ(code_of(R"({"rooms": [{"kind": "office"}, {"kind": "office"}]})"), "U105");
    EXPECT_EQ(code_of(R"({"utilisation": 0})"), "U105");
    EXPECT_EQ(code_of(R"({"count": 2.5})"), "U105");
    EXPECT_EQ(code_of(R"({"outdoor": {"spacing": -1}})"), "U105");
    EXPECT_EQ(code_of(R"({"format_version": 2})"), "U105");
    EXPECT_THROW((void)read_lamp_rules("/nowhere/lamps.json"), IoError);
}

TEST(ColourOfKelvin, IsThatOfABlackBody) {
    const auto daylight = colour_of_kelvin(6504);
    for (const float c : daylight)
        EXPECT_NEAR(c, 1, 0.07) << "near the white of sRGB: daylight, a little off the black body of 6504 K";
    const auto bulb = colour_of_kelvin(2700);  // x 0.4599, y 0.4106 on the locus
    EXPECT_EQ(bulb[0], 1);
    EXPECT_NEAR(bulb[1], 0.415, 0.01);
    EXPECT_NEAR(bulb[2], 0.10, 0.01);
    const auto sky = colour_of_kelvin(12000);
    EXPECT_EQ(sky[2], 1);
    EXPECT_LT(sky[0], sky[1]);
    for (double t = 1700; t < 24000; t += 100) {
        const auto a = colour_of_kelvin(t), b = colour_of_kelvin(t + 100);
        EXPECT_LE(b[0] * a[2], b[2] * a[0] * 1.001) << t << " K: hotter is bluer";
    }
}

}  // namespace
}  // namespace enfilade::modeler
