#pragma once
// The smallest room on which something still fails.

#include <functional>

#include "tests/support/room.h"

namespace enfilade::testing {

/// Takes out holes, then corners, then halves coordinates, as long as `fails` holds and the room stays one whose sides
/// meet in common points only. Ends after `budget` calls of `fails`.
[[nodiscard]] Room shrink_room(Room room, const std::function<bool(const Room&)>& fails, std::uint32_t budget = 4000);

/// What cutters are promised: sides are a plane graph, the room lies once on their left, and lines are bent
/// by no more than roundings bend them.
[[nodiscard]] bool is_sound(const Room& room);

}  // namespace enfilade::testing
