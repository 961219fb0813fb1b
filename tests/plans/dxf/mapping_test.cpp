// The mapping file: what it says, and what is refused with its place.

#include <gtest/gtest.h>

#include "base/error.h"
#include "plans/dxf/role.h"

namespace enfilade::plans {
namespace {

TEST(Mapping, IsReadInItsOrder) {
    const RoleRules rules = read_mapping(R"({
        // comments are allowed, as in our plans
        "blocks": [{"name": "FEN*", "is": "window", "sill": 0.6, "head": 2.2}],
        "layers": [{"name": "K1", "is": "wall"}, {"name": "Counter", "is": "low wall", "height": 1.1}]
    })",
                                         "map.json");
    ASSERT_EQ(rules.size(), 3u);
    EXPECT_EQ(rules[0].pattern, "K1");
    EXPECT_EQ(rules[0].role, Role::Wall);
    EXPECT_FALSE(rules[0].for_blocks);
    EXPECT_FALSE(rules[0].height || rules[0].sill || rules[0].head);
    EXPECT_EQ(rules[1].role, Role::LowWall);
    EXPECT_EQ(rules[1].height, 1.1);
    EXPECT_TRUE(rules[2].for_blocks);
    EXPECT_EQ(rules[2].pattern, "FEN*");
    EXPECT_EQ(rules[2].sill, 0.6);
    EXPECT_EQ(rules[2].head, 2.2);
}

TEST(Mapping, MayBeEmpty) { EXPECT_TRUE(read_mapping("{}", "map.json").empty()); }

TEST(Mapping, HasAWordForEveryRoleButUnknown) {
    for (int k = 1; k <= int(Role::RoomName); ++k) {
        const std::string word = name_of(static_cast<Role>(k));
        const RoleRules rules = read_mapping(R"({"layers": [{"name": "*", "is": ")" + word + "\"}]}", "map.json");
        EXPECT_EQ(rules.at(0).role, static_cast<Role>(k)) << word;
    }
}

struct BadMapping {
    const char* what;
    const char* text;
    const char* code;
    int line;
    int column;
    const char* says;
};
void PrintTo(const BadMapping& bad, std::ostream* out) { *out << bad.what; }

class MappingRefused : public ::testing::TestWithParam<BadMapping> {};

TEST_P(MappingRefused, WithItsPlace) {
    try {
        (void)read_mapping(GetParam().text, "map.json");
        FAIL() << "was read";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, GetParam().code) << error.what();
        EXPECT_EQ(error.file, "map.json");
        EXPECT_EQ(error.line, GetParam().line) << error.what();
        EXPECT_EQ(error.column, GetParam().column) << error.what();
        EXPECT_NE(std::string(error.what()).find(GetParam().says), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Mapping, MappingRefused,
    ::testing::Values(
        BadMapping{"no JSON", "{\"layers\": [}", "P101", 1, 13, ""},
        BadMapping{"a list", "[]", "P103", 1, 1, "drawing mapping"},
        BadMapping{"an unknown key", "{\n \"layer\": []}", "P102", 2, 2, "layers"},
        BadMapping{"an unknown key of a rule", "{\"layers\": [\n{\"name\": \"a\", \"iss\": \"wall\"}]}", "P102", 2, 15,
                   "is"},
        BadMapping{"an unknown role", "{\"layers\": [\n{\"name\": \"a\", \"is\": \"tree\"}]}", "P720", 2, 21,
                   "\"tree\""},
        BadMapping{"the role that is none", "{\"layers\": [\n{\"name\": \"a\", \"is\": \"unknown\"}]}", "P720", 2, 21,
                   "room name"},
        BadMapping{"no name", "{\"blocks\": [\n\n {\"is\": \"door\"}]}", "P104", 3, 2, "name"},
        BadMapping{"no role", "{\"layers\": [{\"name\": \"a\"}]}", "P104", 1, 13, "is"},
        BadMapping{"a rule that is a text", "{\"layers\": [\"a\"]}", "P103", 1, 13, "rule"},
        BadMapping{"rules that are no list", "{\"layers\": {\"a\": \"wall\"}}", "P103", 1, 12, "layers"},
        BadMapping{"a number for a name", "{\"layers\": [{\"name\": 1, \"is\": \"wall\"}]}", "P103", 1, 22, "name"},
        BadMapping{"a text for a height", "{\"layers\": [{\"name\": \"a\", \"is\": \"wall\", \"height\": \"1 m\"}]}",
                   "P103", 1, 51, "height"},
        BadMapping{"a sill below the floor", "{\"layers\": [{\"name\": \"a\", \"is\": \"window\", \"sill\": -1}]}",
                   "P105", 1, 51, "sill"},
        BadMapping{"a head in millimetres", "{\"layers\": [{\"name\": \"a\", \"is\": \"door\", \"head\": 2100}]}",
                   "P105", 1, 49, "head"}));

}  // namespace
}  // namespace enfilade::plans
