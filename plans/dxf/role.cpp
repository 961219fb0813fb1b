#include "plans/dxf/role.h"

#include <algorithm>
#include <array>

#include "plans/dxf/role_words.h"

namespace enfilade::plans {
namespace {

struct RoleName {
    Role role;
    const char* name;
};
constexpr std::array role_names = {
    RoleName{Role::Ignored, "ignored"},     RoleName{Role::Wall, "wall"},          RoleName{Role::LowWall, "low wall"},
    RoleName{Role::WallAxis, "wall axis"},  RoleName{Role::Door, "door"},          RoleName{Role::Window, "window"},
    RoleName{Role::Opening, "opening"},     RoleName{Role::Column, "column"},      RoleName{Role::Stair, "stair"},
    RoleName{Role::Furniture, "furniture"}, RoleName{Role::RoomName, "room name"},
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

bool any_stands_for(std::span<const std::string_view> entries, const std::vector<std::string>& names) {
    return std::any_of(entries.begin(), entries.end(), [&](std::string_view entry) {
        return std::any_of(names.begin(), names.end(),
                           [&](const std::string& word) { return dxf::stands_for(entry, word); });
    });
}

/// How many bytes the letter takes that begins at `at`. UTF-8.
std::size_t letter_size(std::string_view text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) ++end;
    return end - at;
}

bool pattern_matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, mark = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') star = p++, mark = t;
        else if (p < pattern.size() && pattern[p] == '?') ++p, t += letter_size(text, t);
        else if (p < pattern.size() && pattern[p] == text[t]) ++p, ++t;
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
    // Latin letters as their base letter (U+00C0 on, U+0100 on), Cyrillic capitals as small letters.
    static constexpr std::string_view latin1 = "aaaaaaaceeeeiiiidnooooo*ouuuuypsaaaaaaaceeeeiiiidnooooo/ouuuuypy";
    static constexpr std::string_view extended =
        "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllll"
        "nnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
    static_assert(latin1.size() == 64 && extended.size() == 128);
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        const auto next = static_cast<unsigned char>(i + 1 < name.size() ? name[i + 1] : 0);
        const bool follows = next >= 0x80 && next < 0xC0;
        if (c >= 'A' && c <= 'Z') text += char(c - 'A' + 'a');
        else if (c == 0xC3 && follows) text += latin1[next - 0x80], ++i;
        else if ((c == 0xC4 || c == 0xC5) && follows) text += extended[(c - 0xC4u) * 64u + next - 0x80u], ++i;
        else if ((c == 0xCC && follows) || (c == 0xCD && follows && next < 0xB0)) ++i;  // an accent by itself
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
    const auto row = std::find_if(dxf::role_words().begin(), dxf::role_words().end(),
                                  [&](const dxf::RoleWords& r) { return any_stands_for(r.words, parts); });
    if (row == dxf::role_words().end()) return Role::Unknown;
    const auto says = [&](Role role) {
        return std::any_of(dxf::role_words().begin(), dxf::role_words().end(),
                           [&](const dxf::RoleWords& r) { return r.role == role && any_stands_for(r.words, parts); });
    };
    if (row->role == Role::Ignored && any_stands_for(dxf::writing_words(), parts) &&
        any_stands_for(dxf::place_words(), parts))
        return Role::RoomName;
    // One layer for doors and windows: the shapes tell them apart.
    if (row->role == Role::Door && (says(Role::Window) || says(Role::Opening))) return Role::Opening;
    if (row->role == Role::Window && says(Role::Opening)) return Role::Opening;
    if (row->role == Role::Wall && any_stands_for(dxf::low_words(), parts)) return Role::LowWall;
    return row->role;
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
