#include "plans/dxf/role.h"

#include <algorithm>
#include <array>

namespace enfilade::plans {
namespace {

struct RoleName {
    Role role;
    const char* name;
};
constexpr std::array role_names = {
    RoleName{Role::Ignored, "ignored"},    RoleName{Role::Wall, "wall"},     RoleName{Role::LowWall, "low wall"},
    RoleName{Role::Door, "door"},          RoleName{Role::Window, "window"}, RoleName{Role::Opening, "opening"},
    RoleName{Role::Column, "column"},      RoleName{Role::Stair, "stair"},   RoleName{Role::Furniture, "furniture"},
    RoleName{Role::RoomName, "room name"},
};

/// Words that decide. A name is cut into words at everything that is no letter or digit; a word matches where it begins
/// with the entry (entries of three letters and fewer: where it is the entry). Earlier rows win over later ones, so
/// what is drawn about a wall or a door (its dimension, its hatch, its tag) is not taken for the thing.
struct Word {
    const char* word;
    Role role;
};
constexpr std::array words = {
    // What is written or hatched, built-in services, the world outside.
    Word{"dim", Role::Ignored},
    Word{"dims", Role::Ignored},
    Word{"bemass", Role::Ignored},
    Word{"cota", Role::Ignored},
    Word{"cotes", Role::Ignored},
    Word{"cotation", Role::Ignored},
    Word{"hatch", Role::Ignored},
    Word{"schraff", Role::Ignored},
    Word{"patt", Role::Ignored},
    Word{"iden", Role::Ignored},
    Word{"anno", Role::Ignored},
    Word{"text", Role::Ignored},
    Word{"anntext", Role::Ignored},
    Word{"note", Role::Ignored},
    Word{"title", Role::Ignored},
    Word{"border", Role::Ignored},
    Word{"elec", Role::Ignored},
    Word{"elektr", Role::Ignored},
    Word{"light", Role::Ignored},
    Word{"plumb", Role::Ignored},
    Word{"hvac", Role::Ignored},
    Word{"grid", Role::Ignored},
    Word{"raster", Role::Ignored},
    Word{"achse", Role::Ignored},
    Word{"topo", Role::Ignored},
    Word{"plant", Role::Ignored},
    Word{"projection", Role::Ignored},
    Word{"footer", Role::Ignored},
    Word{"footing", Role::Ignored},
    Word{"stem", Role::Ignored},
    Word{"header", Role::Ignored},
    Word{"beam", Role::Ignored},
    Word{"querbalken", Role::Ignored},
    Word{"roof", Role::Ignored},
    Word{"dach", Role::Ignored},
    Word{"ceil", Role::Ignored},
    Word{"defpoints", Role::Ignored},
    Word{"viewport", Role::Ignored},
    Word{"hide", Role::Ignored},
    Word{"texture", Role::Ignored},
    // The things themselves.
    Word{"door", Role::Door},
    Word{"drs", Role::Door},
    Word{"tur", Role::Door},
    Word{"tuer", Role::Door},
    Word{"tueren", Role::Door},
    Word{"turen", Role::Door},
    Word{"porte", Role::Door},
    Word{"portes", Role::Door},
    Word{"puerta", Role::Door},
    Word{"porta", Role::Door},
    Word{"deur", Role::Door},
    Word{"drzwi", Role::Door},
    Word{"двер", Role::Door},
    Word{"门", Role::Door},
    Word{"djamb", Role::Door},
    Word{"window", Role::Window},
    Word{"glaz", Role::Window},
    Word{"glass", Role::Window},
    Word{"wind", Role::Window},
    Word{"fenster", Role::Window},
    Word{"fenetre", Role::Window},
    Word{"ventana", Role::Window},
    Word{"finestr", Role::Window},
    Word{"raam", Role::Window},
    Word{"ramen", Role::Window},
    Word{"janela", Role::Window},
    Word{"okno", Role::Window},
    Word{"okna", Role::Window},
    Word{"окн", Role::Window},
    Word{"窗", Role::Window},
    Word{"opening", Role::Opening},
    Word{"offnung", Role::Opening},
    Word{"ouverture", Role::Opening},
    Word{"apertura", Role::Opening},
    Word{"doorswindows", Role::Opening},
    Word{"doorwindow", Role::Opening},
    Word{"jamb", Role::Opening},
    Word{"column", Role::Column},
    Word{"cols", Role::Column},
    Word{"pillar", Role::Column},
    Word{"stutze", Role::Column},
    Word{"stuetze", Role::Column},
    Word{"pfeiler", Role::Column},
    Word{"poteau", Role::Column},
    Word{"pilar", Role::Column},
    Word{"pilastr", Role::Column},
    Word{"kolom", Role::Column},
    Word{"slup", Role::Column},
    Word{"колонн", Role::Column},
    Word{"柱", Role::Column},
    Word{"stair", Role::Stair},
    Word{"strs", Role::Stair},
    Word{"trepp", Role::Stair},
    Word{"escalier", Role::Stair},
    Word{"escalera", Role::Stair},
    Word{"scala", Role::Stair},
    Word{"scale", Role::Stair},
    Word{"trap", Role::Stair},
    Word{"escada", Role::Stair},
    Word{"schod", Role::Stair},
    Word{"лестн", Role::Stair},
    Word{"楼梯", Role::Stair},
    Word{"furn", Role::Furniture},
    Word{"mobel", Role::Furniture},
    Word{"moebel", Role::Furniture},
    Word{"mobilier", Role::Furniture},
    Word{"meuble", Role::Furniture},
    Word{"mueble", Role::Furniture},
    Word{"mobil", Role::Furniture},
    Word{"arredo", Role::Furniture},
    Word{"meubel", Role::Furniture},
    Word{"fixt", Role::Furniture},
    Word{"flor", Role::Furniture},
    Word{"case", Role::Furniture},
    Word{"equip", Role::Furniture},
    Word{"eqpm", Role::Furniture},
    Word{"shel", Role::Furniture},
    Word{"table", Role::Furniture},
    Word{"couch", Role::Furniture},
    Word{"sofa", Role::Furniture},
    Word{"wall", Role::Wall},
    Word{"wand", Role::Wall},
    Word{"wande", Role::Wall},
    Word{"waende", Role::Wall},
    Word{"mauer", Role::Wall},
    Word{"mur", Role::Wall},
    Word{"murs", Role::Wall},
    Word{"cloison", Role::Wall},
    Word{"muro", Role::Wall},
    Word{"muros", Role::Wall},
    Word{"muri", Role::Wall},
    Word{"pared", Role::Wall},
    Word{"paret", Role::Wall},
    Word{"tabique", Role::Wall},
    Word{"muur", Role::Wall},
    Word{"muren", Role::Wall},
    Word{"parede", Role::Wall},
    Word{"scian", Role::Wall},
    Word{"стен", Role::Wall},
    Word{"墙", Role::Wall},
    Word{"room", Role::RoomName},
    Word{"raum", Role::RoomName},
    Word{"names", Role::RoomName},
    Word{"area", Role::RoomName},
    Word{"space", Role::RoomName},
};

bool is_word_byte(char c) {
    const auto u = static_cast<unsigned char>(c);
    return u >= 0x80 || (u >= '0' && u <= '9') || (u >= 'a' && u <= 'z');
}

/// The letters of "xref-name$0$A-WALL" that the drawing's author gave: those after the last "$0$".
std::string_view own_part(std::string_view name) {
    const std::size_t bound = name.rfind('$');
    return bound == std::string_view::npos ? name : name.substr(bound + 1);
}

std::vector<std::string> words_of(std::string_view name) {
    const std::string text = folded(own_part(name));
    std::vector<std::string> result;
    std::string word;
    for (const char c : text + ' ') {
        if (is_word_byte(c)) word += c;
        else if (!word.empty()) result.push_back(std::move(word)), word.clear();
    }
    return result;
}

bool matches(const std::string& word, std::string_view entry) {
    const bool is_latin = static_cast<unsigned char>(entry[0]) < 0x80;
    return is_latin && entry.size() <= 3 ? word == entry : word.starts_with(entry);
}

bool pattern_matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, mark = 0;
    while (t < text.size()) {
        if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) ++p, ++t;
        else if (p < pattern.size() && pattern[p] == '*') star = p++, mark = t;
        else if (star != std::string_view::npos) p = star + 1, t = ++mark;
        else return false;
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

const RoleRule* rule_for(const RoleRules& rules, bool for_blocks, const std::string& name) {
    const std::string whole = folded(name), own = folded(own_part(name));
    for (const RoleRule& rule : rules)
        if (rule.for_blocks == for_blocks &&
            (pattern_matches(folded(rule.pattern), whole) || pattern_matches(folded(rule.pattern), own)))
            return &rule;
    return nullptr;
}

}  // namespace

const char* name_of(Role role) {
    for (const RoleName& entry : role_names)
        if (entry.role == role) return entry.name;
    return "unknown";
}

std::optional<Role> role_named(std::string_view name) {
    for (const RoleName& entry : role_names)
        if (entry.name == name) return entry.role;
    return std::nullopt;
}

std::string folded(std::string_view name) {
    // Latin-1 letters and the Polish ones, as their base letter; Cyrillic capitals as small letters.
    static constexpr std::string_view latin1 = "aaaaaaaceeeeiiiidnooooo*ouuuuypsaaaaaaaceeeeiiiidnooooo/ouuuuypy";
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        const auto next = static_cast<unsigned char>(i + 1 < name.size() ? name[i + 1] : 0);
        if (c >= 'A' && c <= 'Z') text += char(c - 'A' + 'a');
        else if (c == 0xC3 && next >= 0x80 && next < 0xC0) text += latin1[next - 0x80], ++i;
        else if (c == 0xC5 && (next == 0x81 || next == 0x82)) text += 'l', ++i;
        else if (c == 0xD0 && next >= 0x90 && next < 0xB0) {
            const int small = 0x430 + (next - 0x90);
            text += char(0xC0 | (small >> 6));
            text += char(0x80 | (small & 0x3F));
            ++i;
        } else text += name[i];
    }
    return text;
}

Role role_of_name(std::string_view name) {
    const std::vector<std::string> parts = words_of(name);
    for (const Word& entry : words)
        for (const std::string& word : parts) {
            if (!matches(word, entry.word)) continue;
            if (entry.role != Role::Wall) {
                // One layer for doors and windows: the shapes tell them apart.
                const bool door_and_window =
                    (entry.role == Role::Door || entry.role == Role::Window) &&
                    std::any_of(parts.begin(), parts.end(), [&](const std::string& other) {
                        return std::any_of(words.begin(), words.end(), [&](const Word& w) {
                            return (w.role == Role::Door || w.role == Role::Window || w.role == Role::Opening) &&
                                   w.role != entry.role && matches(other, w.word);
                        });
                    });
                return door_and_window ? Role::Opening : entry.role;
            }
            const bool low = std::any_of(parts.begin(), parts.end(), [](const std::string& other) {
                return other == "low" || other == "half" || other == "prht" || other == "parapet" ||
                       other == "brustung" || other == "niedrig" || other == "bajo" || other == "bas";
            });
            return low ? Role::LowWall : Role::Wall;
        }
    return Role::Unknown;
}

Role Roles::of(const Drawing& drawing, const Shape& shape) const {
    for (std::uint32_t k = shape.block; k != UINT32_MAX; k = drawing.insertions[k].parent)
        if (insertion[k] != Role::Unknown) return insertion[k];
    return layer[shape.layer];
}

const RoleRule* Roles::rule_of(const Drawing& drawing, const Shape& shape) const {
    for (std::uint32_t k = shape.block; k != UINT32_MAX; k = drawing.insertions[k].parent)
        if (insertion[k] != Role::Unknown) return insertion_rule[k];
    return layer_rule[shape.layer];
}

Roles assign_roles(const Drawing& drawing, const RoleRules& rules) {
    Roles roles;
    for (const Layer& layer : drawing.layers) {
        roles.layer_rule.push_back(rule_for(rules, false, layer.name));
        roles.layer.push_back(roles.layer_rule.back() ? roles.layer_rule.back()->role : role_of_name(layer.name));
    }
    for (const Insertion& insertion : drawing.insertions) {
        const RoleRule* rule = rule_for(rules, true, insertion.name);
        Role role = rule ? rule->role : role_of_name(insertion.name);
        // A block called "wall lamp" is no wall, and texts in blocks name no rooms.
        if (!rule && (role == Role::Wall || role == Role::LowWall || role == Role::RoomName)) role = Role::Unknown;
        roles.insertion_rule.push_back(rule);
        roles.insertion.push_back(role);
    }
    return roles;
}

}  // namespace enfilade::plans
