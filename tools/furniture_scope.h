#pragma once
// Which rooms `build` furnishes: all, or what can be seen from some.

#include <span>
#include <vector>

#include "modeler/building.h"
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

/// The scope of the flags' rooms and views in a convex building. plan: cleaned, for its lamps and pieces. Covers what
/// `render` does: sun, corners, mirrors; with flags.lit the plan's lamps, too.
/// \throws InputError as `room_by_name` (F109) and `read_views` do
[[nodiscard]] FurnitureScope furniture_scope(const FurnishFlags& flags, const modeler::Building& building,
                                             const plans::Plan& plan);

}  // namespace enfilade::tools
