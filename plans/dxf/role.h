#pragma once
// What the layers and blocks of a drawing stand for.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plans/dxf/drawing.h"

namespace enfilade::plans {

enum class Role : std::uint8_t {
    Unknown,
    Ignored,
    Wall,
    LowWall,   ///< a wall lower than the storey
    WallAxis,  ///< walls drawn as single lines along their middle; no name says so, a mapping may
    Door,
    Window,
    Opening,  ///< doors, windows or holes: their shape tells which
    Column,
    Stair,
    Furniture,
    RoomName,
};

/// As the mapping file writes it: "wall", "low wall", "door", ...
[[nodiscard]] const char* name_of(Role role);
[[nodiscard]] std::optional<Role> role_named(std::string_view name);

/// One line of a mapping file. Heights in metres, above the floor.
struct RoleRule {
    std::string pattern;  ///< * and ? match, case and accents do not matter
    bool for_blocks = false;
    Role role = Role::Unknown;
    std::optional<double> height;
    std::optional<double> sill;
    std::optional<double> head;
};
using RoleRules = std::vector<RoleRule>;

/// Reads a mapping file (docs/drawing-mapping.schema.json). Throws InputError with line and column.
[[nodiscard]] RoleRules read_mapping(std::string_view text, const std::string& file_name);

/// What a name of a layer or block says by itself: AIA names with any prefix of a referenced drawing, and common words
/// of several languages. Unknown where it says nothing.
[[nodiscard]] Role role_of_name(std::string_view name);

/// Lower case without accents (Latin letters; others stay), for comparing names. UTF-8.
[[nodiscard]] std::string folded(std::string_view name);

struct Roles {
    std::vector<Role> layer;                  ///< [layers]
    std::vector<const RoleRule*> layer_rule;  ///< [layers] the rule that decided, or null
    std::vector<Role> insertion;              ///< [insertions] of the block's name; Unknown: the layer decides
    std::vector<const RoleRule*> insertion_rule;

    /// What a shape is: by the innermost insertion around it whose block says something, else by its layer.
    [[nodiscard]] Role of(const Drawing& drawing, const Shape& shape) const;
    [[nodiscard]] const RoleRule* rule_of(const Drawing& drawing, const Shape& shape) const;
};

/// Rules first, in their order; then names.
[[nodiscard]] Roles assign_roles(const Drawing& drawing, const RoleRules& rules);

}  // namespace enfilade::plans
