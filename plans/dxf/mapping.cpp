// The mapping file: which layers and blocks are what.

#include "plans/dxf/role.h"
#include "plans/json_fields.h"
#include "plans/limits.h"

namespace enfilade::plans {
namespace {

constexpr std::string_view file_list[] = {"layers", "blocks"};
constexpr std::string_view rule_list[] = {"name", "is", "height", "sill", "head"};
constexpr JsonKeys file_keys{"a drawing mapping", file_list};
constexpr JsonKeys rule_keys{"a rule of a drawing mapping", rule_list};

std::optional<double> optional_length(const Fields& fields, const char* key) {
    if (!fields.has(key)) return std::nullopt;
    return fields.length(key, {0, 100});
}

void read_rules(const Fields& file, const char* key, bool for_blocks, const JsonSource& source, RoleRules& rules) {
    for (const JsonValue& value : file.list(key)) {
        const Fields fields(value, rule_keys, source);
        RoleRule rule;
        rule.pattern = fields.text("name");
        rule.for_blocks = for_blocks;
        const std::string is = fields.text("is");
        const std::optional<Role> role = role_named(is);
        if (!role)
            refuse(source, "P720", fields.at("is").place,
                   "\"" + is +
                       "\" is nothing that a layer can be: write wall, low wall, wall axis, door, window, opening, "
                       "column, stair, "
                       "furniture, room name or ignored.");
        rule.role = *role;
        rule.height = optional_length(fields, "height");
        rule.sill = optional_length(fields, "sill");
        rule.head = optional_length(fields, "head");
        rules.push_back(std::move(rule));
    }
}

}  // namespace

RoleRules read_mapping(std::string_view text, const std::string& file_name) {
    const JsonValue json = parse_json(text, file_name);
    const JsonSource source{file_name, 1};
    const Fields file(json, file_keys, source);
    RoleRules rules;
    read_rules(file, "layers", false, source, rules);
    read_rules(file, "blocks", true, source, rules);
    return rules;
}

}  // namespace enfilade::plans
