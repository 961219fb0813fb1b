#pragma once
// The keys of rule files, object by object. docs/furnishing.schema.json says the same; a test compares the two.

#include <array>

#include "plans/json_keys.h"

namespace enfilade::modeler::keys {

inline constexpr std::string_view rules_list[] = {"format_version", "temperature", "kinds", "rooms"};
inline constexpr std::string_view kind_list[] = {"kind", "front", "behind", "sides", "one_side", "score"};
inline constexpr std::string_view room_list[] = {"kind", "names", "objects"};
inline constexpr std::string_view object_list[] = {
    "object", "place",     "count",  "per_area", "probability", "least_area", "most_area",
    "gap",    "most_gap",  "turned", "needed",   "near",        "facing",     "unless",
    "front",  "elevation", "behind", "sides",    "one_side",    "score",      "with"};
inline constexpr std::string_view score_list[] = {"corner",     "window", "door",   "wall_middle", "centre",
                                                  "open_front", "near",   "facing", "gap"};

inline constexpr plans::JsonKeys rules{"rule file", rules_list};
inline constexpr plans::JsonKeys kind{"kind", kind_list};
inline constexpr plans::JsonKeys room{"room", room_list};
inline constexpr plans::JsonKeys object{"object", object_list};
inline constexpr plans::JsonKeys score{"score", score_list};

inline constexpr std::array all{rules, kind, room, object, score};

}  // namespace enfilade::modeler::keys
