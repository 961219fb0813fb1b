#pragma once
// What a room sees: which rooms, through how many doors and windows, and how much of its view each fills.

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "accel/scene.h"

namespace enfilade::tools {

/// The room of this name or id, the first of several. Throws InputError (F109) with the nearest name where there is
/// none.
[[nodiscard]] accel::SpaceId room_by_name(const accel::SceneView& scene, const std::string& room);

/// A space that some line of sight from the room gets to. None that one gets to is left out; of those listed, few are
/// not seen after all (accel/README.md, "Beams").
struct VisibleSpace {
    accel::SpaceId space = {};
    std::size_t cells_seen = 0;
    std::size_t cells = 0;
    std::uint32_t openings = 0;  ///< doors, windows and holes in walls crossed on the way, at least
    double view_share = 0;  ///< of lines of sight, spread evenly over the room's volume and all directions: how many
                            ///< get there
};

struct RoomSight {
    accel::SpaceId room = {};
    std::vector<VisibleSpace> spaces;  ///< by share, the largest first; without the room itself
    std::size_t cells_seen = 0;        ///< of all spaces, the room's own included
    std::size_t sample_count = 0;      ///< lines of sight that were drawn for the shares
};

/// Beams for what is seen, random lines of sight (the same each time) for the shares.
[[nodiscard]] RoomSight visible_from(const accel::SceneView& scene, accel::SpaceId room);

/// A table of rooms and the outdoors.
[[nodiscard]] std::string sight_text(const accel::SceneView& scene, const RoomSight& sight);
/// The object `visible_from` of docs/info.schema.json.
[[nodiscard]] nlohmann::ordered_json sight_json(const accel::SceneView& scene, const RoomSight& sight);

}  // namespace enfilade::tools
