#pragma once
// The rules by which rooms are furnished (docs/furnishing.md).

#include <filesystem>
#include <string>
#include <vector>

namespace enfilade::modeler {

/// What a kind of room is furnished with.
struct RoomRules {
    std::string kind;  ///< "bedroom", "office" ...
};

/// A rule file read. The lists are by the file's order, which is the order of placing.
struct Rules {
    std::string source;  ///< for messages
    std::vector<RoomRules> rooms;
};

/// Reads a rule file (JSON, schema docs/furnishing.schema.json). \throws InputError (codes U1...) with line and column
[[nodiscard]] Rules read_rules(const std::filesystem::path& file);

/// The rules that the program brings: homes and offices.
[[nodiscard]] const Rules& own_rules();

/// The one word for a room's kind, from the plan's kind and name ("Bedroom 2", "Schlafzimmer", "bureau" ...), among
/// those that `rules` know; empty where it is told by neither.
[[nodiscard]] std::string room_kind(const Rules& rules, const std::string& kind, const std::string& name);

}  // namespace enfilade::modeler
