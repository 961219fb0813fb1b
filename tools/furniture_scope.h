#pragma once
// Which rooms `build` furnishes: all, or what can be seen from some.

#include <optional>
#include <span>
#include <vector>

#include "modeler/building.h"
#include "modeler/lighting/lamp_rules.h"
#include "modeler/objects/scope.h"
#include "plans/plan.h"
#include "tools/commands.h"

namespace enfilade::tools {

/// A scope as people ask for it.
struct FurnitureScope {
    modeler::Scope scope;
    std::vector<std::uint32_t> rooms;   ///< of its spaces, those that are rooms: into Building::spaces, ascending
    std::vector<std::uint32_t> pieces;  ///< spaces whose pieces of the plan count: the scope's, and those from which
                                        ///< one reaches into them
    std::size_t all_rooms = 0;
    std::size_t all_spaces = 0;
    std::size_t all_cells = 0;
    std::size_t lamps = 0;
    double seconds = 0;
};

/// Whether the flags ask for less than everything.
[[nodiscard]] inline bool has_scope(const FurnishFlags& flags) { return !flags.rooms.empty() || !flags.views.empty(); }

/// The lamp rules that the flags ask for, if any. \throws InputError where their file is wrong
[[nodiscard]] std::optional<modeler::LampRules> lamp_rules_of(const FurnishFlags& flags);

/// The scope of the flags' rooms and views in a convex building. plan: cleaned, for its pieces. Covers what
/// `render` does: sun, corners, mirrors; with flags.lit the building's lamps and those that flags.lamps asks for, as
/// they hang in rooms without furniture.
/// \throws InputError as `room_by_name` (F109) and `read_views` do
[[nodiscard]] FurnitureScope furniture_scope(const FurnishFlags& flags, const modeler::Building& building,
                                             const plans::Plan& plan);

}  // namespace enfilade::tools
