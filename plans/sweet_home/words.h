#pragma once
// What names and catalogue ids say about a piece, in the languages that Sweet Home 3D speaks most.

#include <string>
#include <string_view>

#include "plans/plan.h"

namespace enfilade::plans {

/// "corridor", "bathroom", "kitchen", "bedroom", "stairwell", else "room".
[[nodiscard]] std::string room_kind(std::string_view name);

/// What a door or window is called: `words` are its catalogue id and its name.
enum class OpeningWord { None, Frame, Door, Window, WindowDoor };
[[nodiscard]] OpeningWord opening_word(std::string_view words);

}  // namespace enfilade::plans
