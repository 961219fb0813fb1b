#pragma once
// The keys of lamp rules, object by object. docs/lamps.schema.json says the same; a test compares the two.

#include <array>

#include "plans/json_keys.h"

namespace enfilade::modeler::keys {

inline constexpr std::string_view lamp_rules_list[] = {"format_version", "utilisation", "count",  "replace",
                                                       "rooms",          "pieces",      "outdoor"};
inline constexpr std::string_view room_light_list[] = {"kind", "lux", "area", "drop", "kelvin", "radius"};
inline constexpr std::string_view piece_light_list[] = {"kind", "lumen", "kelvin", "radius", "height", "lights_room"};
inline constexpr std::string_view outdoor_list[] = {"spacing", "count",  "elevation",     "lumen",
                                                    "kelvin",  "radius", "entrance_lumen"};

inline constexpr plans::JsonKeys lamp_rules{"lamp rule file", lamp_rules_list};
inline constexpr plans::JsonKeys room_light{"room", room_light_list};
inline constexpr plans::JsonKeys piece_light{"piece", piece_light_list};
inline constexpr plans::JsonKeys outdoor{"outdoor", outdoor_list};

inline constexpr std::array all_of_lamps{lamp_rules, room_light, piece_light, outdoor};

}  // namespace enfilade::modeler::keys
