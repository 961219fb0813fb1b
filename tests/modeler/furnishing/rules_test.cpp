// Rule files: what they say, and what they are refused for.
#include "modeler/furnishing/rules.h"

#include <gtest/gtest.h>

#include <map>

#include "base/error.h"
#include "modeler/furnishing/plain_words.h"

namespace enfilade::modeler {
namespace {

InputError refused(const std::string& text) {
    try {
        (void)read_rules_text(text, "rules.json");
    } catch (const InputError& error) {
        return error;
    }
    ADD_FAILURE() << "not refused: " << text;
    return {"", "", ""};
}

std::string with_object(const std::string& object) {
    return "{\"rooms\": [{\"kind\": \"office\", \"objects\": [\n" + object + "]}]}";
}

TEST(Rules, AreReadWithTheirRelations) {
    const Rules rules = read_rules_text(with_object(R"({"object": ["desk", "own/desk"], "count": [1, 3], "with": [
        {"object": "office_chair", "place": "in_front", "gap": 0.1, "needed": true}]})"),
                                        "rules.json");
    ASSERT_EQ(rules.rooms.size(), 1u);
    const ObjectRule& desk = rules.rooms[0].objects.at(0);
    EXPECT_EQ(desk.object, (std::vector<std::string>{"desk", "own/desk"}));
    EXPECT_EQ(desk.least, 1u);
    EXPECT_EQ(desk.most, 3u);
    EXPECT_EQ(desk.place, Relation::AgainstWall);
    ASSERT_EQ(desk.with.size(), 1u);
    EXPECT_EQ(desk.with[0].place, Relation::InFront);
    EXPECT_DOUBLE_EQ(desk.with[0].gap, 0.1);
    EXPECT_TRUE(desk.with[0].needed);
}

TEST(Rules, TakeWhatKindsSayUnlessTheySayOtherwise) {
    const Rules rules = read_rules_text(
        R"({"kinds": [{"kind": "desk", "front": 0.8, "score": {"window": 0.5, "gap": 1}}],
            "rooms": [{"kind": "office", "objects": [{"object": "desk"},
                                                     {"object": "desk", "front": 1.1, "score": {"window": -1}}]}]})",
        "rules.json");
    const auto& objects = rules.rooms.at(0).objects;
    EXPECT_DOUBLE_EQ(objects.at(0).clearance.front, 0.8);
    EXPECT_DOUBLE_EQ(objects.at(0).score.window, 0.5);
    EXPECT_DOUBLE_EQ(objects.at(1).clearance.front, 1.1);
    EXPECT_DOUBLE_EQ(objects.at(1).score.window, -1);
    EXPECT_DOUBLE_EQ(objects.at(1).score.gap, 1);
}

TEST(Rules, RefuseAnUnknownKeyWithItsPlaceAndTheNearestOne) {
    const InputError error = refused(with_object(R"({"object": "desk", "cuont": 2})"));
    EXPECT_EQ(error.code, "U102");
    EXPECT_EQ(error.line, 2);
    EXPECT_EQ(error.column, 20);
    EXPECT_NE(std::string(error.what()).find("did you mean \"count\""), std::string::npos) << error.what();
}

TEST(Rules, RefuseAPlanAndNameWhatARuleFileMayHave) {
    const std::string said = refused("{\"name\": \"House\", \"storeys\": []}").what();
    EXPECT_NE(said.find("not known in a rule file"), std::string::npos) << said;
    EXPECT_NE(said.find("rooms"), std::string::npos) << said;
}

TEST(Rules, RefuseAnUnknownRelationWithTheNearestOne) {
    const InputError error = refused(with_object(R"({"object": "desk", "place": "against_wal"})"));
    EXPECT_EQ(error.code, "U105");
    EXPECT_NE(std::string(error.what()).find("against_wall"), std::string::npos) << error.what();
}

TEST(Rules, RefuseWhatContradictsItself) {
    EXPECT_EQ(refused("{\"rooms\": [").code, "U101");
    EXPECT_EQ(refused("[]").code, "U103");
    EXPECT_EQ(refused("{}").code, "U104");
    EXPECT_EQ(refused(with_object(R"({"count": 2})")).code, "U104");
    EXPECT_EQ(refused(with_object(R"({"object": []})")).code, "U105");
    EXPECT_EQ(refused(with_object(R"({"object": "desk", "count": [3, 1]})")).code, "U105");
    EXPECT_EQ(refused(with_object(R"({"object": "desk", "count": 1.5})")).code, "U105");
    EXPECT_EQ(refused(with_object(R"({"object": "desk", "probability": 1.5})")).code, "U105");
    EXPECT_EQ(refused(with_object(R"({"object": "cup", "place": "on_top"})")).code, "U105");
    EXPECT_EQ(refused(with_object(R"({"object": "desk", "needed": true})")).code, "U105");
    EXPECT_EQ(refused(with_object(R"({"object": "desk", "with": [{"object": "lamp", "place": "ceiling"}]})")).code,
              "U105");
    EXPECT_EQ(refused(R"({"rooms": [{"kind": "a"}, {"kind": "a"}]})").code, "U105");
}

TEST(Rules, RefuseEndlessNesting) {
    std::string object = R"({"object": "box"})";
    for (int k = 0; k < 9; ++k) object = R"({"object": "box", "with": [)" + object + "]}";
    EXPECT_EQ(refused(with_object(object)).code, "U105");
}

TEST(OwnRules, NameEveryRoomOnce) {
    const Rules& rules = own_rules();
    EXPECT_GE(rules.rooms.size(), 20u);
    EXPECT_NE(rules.find("default"), nullptr);
    EXPECT_EQ(rules.find("no such room"), nullptr);
    std::map<std::string, std::string> owner;
    for (const RoomRules& room : rules.rooms)
        for (const std::string& name : room.names) {
            const auto [at, fresh] = owner.emplace(plain_words(name), room.kind);
            EXPECT_TRUE(fresh || at->second == room.kind) << name << " is a " << room.kind << " and a " << at->second;
        }
}

TEST(RoomKind, IsToldByNamesInManyLanguages) {
    const Rules& rules = own_rules();
    const auto kind = [&](const std::string& name) { return room_kind(rules, "room", name); };
    EXPECT_EQ(kind("Bedroom 2"), "bedroom");
    EXPECT_EQ(kind("Schlafzimmer"), "bedroom");
    EXPECT_EQ(kind("Chambre d'enfant"), "child");
    EXPECT_EQ(kind("KÜCHE"), "kitchen");
    EXPECT_EQ(kind("Salle à manger"), "dining");
    EXPECT_EQ(kind("Büro 1.07"), "office");
    EXPECT_EQ(kind("Meeting room 0.012"), "meeting");
    EXPECT_EQ(kind("主卧室"), "bedroom");
    EXPECT_EQ(kind("厨房"), "kitchen");
    EXPECT_EQ(kind("Спальня"), "bedroom");
    EXPECT_EQ(kind("R2D2"), "");
    EXPECT_EQ(kind(""), "");
}

TEST(RoomKind, IsToldByTheNameBeforeTheKind) {
    const Rules& rules = own_rules();
    EXPECT_EQ(room_kind(rules, "bathroom", "WC"), "toilet");
    EXPECT_EQ(room_kind(rules, "storage", "Larder"), "storage");
    EXPECT_EQ(room_kind(rules, "bedroom", "Child's room"), "child");
    EXPECT_EQ(room_kind(rules, "living", "Garden room"), "living");
    EXPECT_EQ(room_kind(rules, "office", "0.17"), "office");
    EXPECT_EQ(room_kind(rules, "meeting", ""), "meeting");
}

TEST(PlainWords, DropWhatMakesNoDifference) {
    EXPECT_EQ(plain_words("  Büro_2-Süd "), "buro sud");
    EXPECT_EQ(plain_words("Łazienka"), "lazienka");
    EXPECT_EQ(plain_words("Child\xE2\x80\x99s room"), "childs room");
    EXPECT_EQ(plain_words("\xFF\xFE"), "");
    EXPECT_TRUE(holds_words("main bedroom", "bedroom"));
    EXPECT_FALSE(holds_words("barroom", "bar"));
}

}  // namespace
}  // namespace enfilade::modeler
