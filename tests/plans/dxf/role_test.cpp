// What layers and blocks are, by their names.

#include "plans/dxf/role.h"

#include <gtest/gtest.h>

#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

struct Named {
    const char* name;
    Role role;
};
void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }

class RoleOfName : public ::testing::TestWithParam<Named> {};

TEST_P(RoleOfName, IsWhatTheNameSays) {
    EXPECT_STREQ(name_of(role_of_name(GetParam().name)), name_of(GetParam().role));
}

INSTANTIATE_TEST_SUITE_P(Aia, RoleOfName,
                         ::testing::Values(Named{"A-WALL", Role::Wall}, Named{"a-wall-full", Role::Wall},
                                           Named{"A-WALL-MOVE", Role::Wall}, Named{"A-WALL-PRHT", Role::LowWall},
                                           Named{"A-WALL-PATT", Role::Ignored}, Named{"A-WALL-IDEN", Role::Ignored},
                                           Named{"A-WALL-HEAD", Role::Ignored}, Named{"A-WALL-CNTR", Role::Ignored},
                                           Named{"A-DOOR", Role::Door}, Named{"A-DOOR-IDEN", Role::Ignored},
                                           Named{"A-GLAZ", Role::Window}, Named{"A-GLAZ-CURT", Role::Window},
                                           Named{"A-FLOR-STRS", Role::Stair}, Named{"A-FLOR-FIXT", Role::Furniture},
                                           Named{"A-FLOR-IDEN", Role::RoomName}, Named{"A-AREA-IDEN", Role::RoomName},
                                           Named{"A-AREA", Role::RoomName}, Named{"A-FURN", Role::Furniture},
                                           Named{"S-COLS", Role::Column}, Named{"S-GRID", Role::Ignored},
                                           Named{"S-BEAM", Role::Ignored}, Named{"A-ROOF", Role::Ignored},
                                           Named{"A-CLNG", Role::Ignored}, Named{"A-ANNO-DIMS", Role::Ignored},
                                           Named{"E-LITE", Role::Unknown}, Named{"first floor$0$A-WALL", Role::Wall},
                                           Named{"walls$0$E-LITE", Role::Unknown}));

INSTANTIATE_TEST_SUITE_P(
    English, RoleOfName,
    ::testing::Values(Named{"Walls", Role::Wall}, Named{"EXTERIOR WALLS", Role::Wall}, Named{"low wall", Role::LowWall},
                      Named{"half walls", Role::LowWall}, Named{"slow walls", Role::Wall}, Named{"Doors", Role::Door},
                      Named{"doorswindows", Role::Opening}, Named{"Doors & Windows", Role::Opening},
                      Named{"Wall openings", Role::Opening}, Named{"window jambs", Role::Opening},
                      Named{"Windows", Role::Window}, Named{"Columns", Role::Column}, Named{"Stairs", Role::Stair},
                      Named{"Room names", Role::RoomName}, Named{"room text", Role::RoomName},
                      Named{"wall text", Role::Ignored}, Named{"Dimensions", Role::Ignored},
                      Named{"Wall lamps", Role::Ignored}, Named{"wall-hatch", Role::Ignored},
                      Named{"title block", Role::Ignored}, Named{"0", Role::Unknown}, Named{"", Role::Unknown},
                      Named{"Drywall", Role::Unknown}, Named{"$", Role::Unknown}));

INSTANTIATE_TEST_SUITE_P(German, RoleOfName,
                         ::testing::Values(Named{"Wände", Role::Wall}, Named{"WÄNDE", Role::Wall},
                                           Named{"Waende", Role::Wall}, Named{"Wa\xCC\x88nde", Role::Wall},
                                           Named{"Innenwand", Role::Wall}, Named{"Trennwände", Role::Wall},
                                           Named{"Mauerwerk", Role::Wall}, Named{"Wand niedrig", Role::LowWall},
                                           Named{"Wandleuchte", Role::Ignored}, Named{"Wandschraffur", Role::Ignored},
                                           Named{"Wandschrank", Role::Furniture}, Named{"Bemaßung", Role::Ignored},
                                           Named{"Türen", Role::Door}, Named{"Innentüren", Role::Door},
                                           Named{"Haustür", Role::Door}, Named{"Struktur", Role::Unknown},
                                           Named{"Fenster", Role::Window}, Named{"Kellerfenster", Role::Window},
                                           Named{"Türen und Fenster", Role::Opening}, Named{"Öffnungen", Role::Opening},
                                           Named{"Stützen", Role::Column}, Named{"Treppen", Role::Stair},
                                           Named{"Möbel", Role::Furniture}, Named{"Raumnamen", Role::RoomName}));

INSTANTIATE_TEST_SUITE_P(
    Romance, RoleOfName,
    ::testing::Values(Named{"MURS", Role::Wall}, Named{"Cloisons", Role::Wall}, Named{"Portes", Role::Door},
                      Named{"Fenêtres", Role::Window}, Named{"Escalier", Role::Stair},
                      Named{"Mobilier", Role::Furniture}, Named{"Cotes", Role::Ignored}, Named{"Muros", Role::Wall},
                      Named{"Planta baja - muros", Role::Wall}, Named{"plants", Role::Ignored},
                      Named{"muro bajo", Role::LowWall}, Named{"Puertas", Role::Door}, Named{"Ventanas", Role::Window},
                      Named{"Pilares", Role::Column}, Named{"Muri", Role::Wall}, Named{"Muretto", Role::LowWall},
                      Named{"Porte", Role::Door}, Named{"Finestre", Role::Window}, Named{"Scale", Role::Stair},
                      Named{"Quote", Role::Ignored}, Named{"Paredes", Role::Wall}, Named{"Janelas", Role::Window}));

INSTANTIATE_TEST_SUITE_P(
    OtherLanguages, RoleOfName,
    ::testing::Values(Named{"Muren", Role::Wall}, Named{"binnenmuur", Role::Wall}, Named{"Buitendeuren", Role::Door},
                      Named{"Ramen", Role::Window}, Named{"Ściany", Role::Wall}, Named{"ŚCIANY", Role::Wall},
                      Named{"Słupy", Role::Column}, Named{"Drzwi", Role::Door}, Named{"Okna", Role::Window},
                      Named{"Stěny", Role::Wall}, Named{"Dveře", Role::Door}, Named{"Väggar", Role::Wall},
                      Named{"Dörrar", Role::Door}, Named{"Fönster", Role::Window}, Named{"Vegger", Role::Wall},
                      Named{"Dør", Role::Door}, Named{"Duvarlar", Role::Wall}, Named{"Kapı", Role::Door},
                      Named{"СТЕНЫ", Role::Wall}, Named{"Наружные стены", Role::Wall}, Named{"Двери", Role::Door},
                      Named{"Окна", Role::Window}, Named{"Размеры", Role::Ignored}, Named{"墙体", Role::Wall},
                      Named{"外墙", Role::Wall}, Named{"墙体填充", Role::Ignored}, Named{"门窗", Role::Opening},
                      Named{"窗", Role::Window}, Named{"楼梯", Role::Stair}, Named{"家具", Role::Furniture},
                      Named{"内壁", Role::Wall}, Named{"ドア", Role::Door}));

TEST(Folded, IsSmallAndPlain) {
    EXPECT_EQ(folded("WÄNDE"), "wande");
    EXPECT_EQ(folded("Ściana Żółta"), "sciana zolta");
    EXPECT_EQ(folded("Fene\xCC\x82tre"), "fenetre");
    EXPECT_EQ(folded("Стены"), "стены");
    EXPECT_EQ(folded("ЯМА"), "яма");
    EXPECT_EQ(folded("墙\xC3"), "墙\xC3");  // a letter cut off stays
}

/// A line on layer "0" of a block, which stands on the layer in a drawing.
Role role_in_block(const char* block_name, const char* layer, const RoleRules& rules = {}) {
    const Drawing drawing = read(
        File{entity("INSERT", {{8, layer}, {2, block_name}, {10, 0}, {20, 0}}), block(block_name, line(0, 0, 1, 0))});
    return assign_roles(drawing, rules).of(drawing, drawing.shapes.at(0));
}

TEST(AssignRoles, TakesBlocksByTheirName) {
    EXPECT_EQ(role_in_block("Door 900", "A-WALL"), Role::Door);
    EXPECT_EQ(role_in_block("Sofa", "0"), Role::Furniture);
}

TEST(AssignRoles, TakesNoBlockForAWallByItsName) {
    EXPECT_EQ(role_in_block("wall light fitting", "0"), Role::Ignored);
    EXPECT_EQ(role_in_block("wall socket", "0"), Role::Unknown);
    EXPECT_EQ(role_in_block("wall socket", "A-WALL"), Role::Wall);
    EXPECT_EQ(role_in_block("room", "A-DOOR"), Role::Door);
}

TEST(AssignRoles, TheInnermostBlockThatSaysSomethingDecides) {
    const std::string insert = entity("INSERT", {{8, "0"}, {2, "part"}, {10, 0}, {20, 0}});
    const Drawing drawing = read(File{entity("INSERT", {{8, "A-WALL"}, {2, "window 2"}, {10, 0}, {20, 0}}),
                                      block("part", line(0, 0, 1, 0)) + block("window 2", insert)});
    const Roles roles = assign_roles(drawing, {});
    EXPECT_EQ(roles.of(drawing, drawing.shapes.at(0)), Role::Window);
}

RoleRule rule(const char* pattern, Role role, bool for_blocks = false) {
    RoleRule result;
    result.pattern = pattern;
    result.role = role;
    result.for_blocks = for_blocks;
    return result;
}

Role role_of_layer(const char* layer, const RoleRules& rules) {
    Drawing drawing;
    drawing.layers.push_back({layer});
    return assign_roles(drawing, rules).layer.at(0);
}

TEST(AssignRoles, RulesOverruleNames) {
    EXPECT_EQ(role_of_layer("A-WALL", {rule("A-WALL", Role::Ignored)}), Role::Ignored);
    EXPECT_EQ(role_of_layer("xyz", {rule("x?z", Role::Wall)}), Role::Wall);
    EXPECT_EQ(role_of_layer("A-WALL", {rule("A-DOOR", Role::Ignored)}), Role::Wall);
}

TEST(AssignRoles, TheFirstRuleThatMatchesDecides) {
    EXPECT_EQ(role_of_layer("plan 7", {rule("plan*", Role::Door), rule("*", Role::Wall)}), Role::Door);
    EXPECT_EQ(role_of_layer("other", {rule("plan*", Role::Door), rule("*", Role::Wall)}), Role::Wall);
}

TEST(AssignRoles, PatternsHeedNeitherCaseNorAccentsNorThePrefixOfAReference) {
    EXPECT_EQ(role_of_layer("TRAGWERK ALT", {rule("tragwerk*", Role::Wall)}), Role::Wall);
    EXPECT_EQ(role_of_layer("FAÇADE", {rule("facade", Role::Wall)}), Role::Wall);
    EXPECT_EQ(role_of_layer("house$0$xyz", {rule("xyz", Role::Wall)}), Role::Wall);
    EXPECT_EQ(role_of_layer("house$0$xyz", {rule("house*", Role::Wall)}), Role::Wall);
    EXPECT_EQ(role_of_layer("xyz-2", {rule("xyz", Role::Wall)}), Role::Unknown);
}

TEST(AssignRoles, AQuestionMarkIsOneLetterOfAnyAlphabet) {
    EXPECT_EQ(role_of_layer("线一", {rule("线?", Role::Stair)}), Role::Stair);
    EXPECT_EQ(role_of_layer("线一二", {rule("线?", Role::Stair)}), Role::Unknown);
    EXPECT_EQ(role_of_layer("线一二", {rule("?*二", Role::Stair)}), Role::Stair);
}

TEST(AssignRoles, RulesForBlocksAreNotForLayers) {
    const RoleRules rules = {rule("thing", Role::Wall, true)};
    EXPECT_EQ(role_of_layer("thing", rules), Role::Unknown);
    EXPECT_EQ(role_in_block("thing", "A-DOOR", rules), Role::Wall);
    EXPECT_EQ(role_in_block("thing", "A-DOOR", {rule("thing", Role::Wall)}), Role::Door);
}

TEST(AssignRoles, ARuleMayMakeABlockAWall) {
    EXPECT_EQ(role_in_block("wall socket", "0", {rule("wall*", Role::Wall, true)}), Role::Wall);
}

}  // namespace
}  // namespace enfilade::plans
