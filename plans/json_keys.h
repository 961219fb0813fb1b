#pragma once
// The keys of our own format, object by object. docs/plan.schema.json says the same; a test compares the two.

#include <array>
#include <span>
#include <string_view>

namespace enfilade::plans {

/// The name of an object as sentences and the schema use it, and the keys it may have.
struct JsonKeys {
    std::string_view object;
    std::span<const std::string_view> keys;
};

namespace keys {

inline constexpr std::string_view plan_list[] = {"format_version", "units",   "name",    "ground_level",
                                                 "site_margin",    "storeys", "findings"};
inline constexpr std::string_view storey_list[] = {"id",     "name",     "elevation", "height",  "slab_thickness",
                                                   "walls",  "openings", "rooms",     "columns", "stairs",
                                                   "shafts", "lights",   "furniture"};
inline constexpr std::string_view wall_list[] = {
    "id",           "name",         "start",           "end",           "arc_extent",  "arc_extent_deg",
    "thickness",    "height",       "height_at_start", "height_at_end", "left_colour", "right_colour",
    "left_texture", "right_texture"};
inline constexpr std::string_view opening_list[] = {"id",         "name",           "kind",       "wall",
                                                    "offset",     "width",          "sill",       "head",
                                                    "open_angle", "open_angle_deg", "depth_left", "depth_right"};
inline constexpr std::string_view room_list[] = {"id",           "name",           "kind",          "polygon",
                                                 "floor_colour", "ceiling_colour", "floor_texture", "ceiling_texture"};
inline constexpr std::string_view texture_list[] = {"picture", "width", "height", "angle", "angle_deg", "offset"};
inline constexpr std::string_view column_list[] = {"id", "name", "polygon", "circle", "height"};
inline constexpr std::string_view circle_list[] = {"centre", "radius", "sides"};
inline constexpr std::string_view stair_list[] = {"id", "name", "polygon"};
inline constexpr std::string_view shaft_list[] = {"id", "name", "polygon", "circle"};
inline constexpr std::string_view light_list[] = {
    "id", "name", "position", "elevation", "colour", "power_lumen", "intensity_candela", "radius", "furniture"};
inline constexpr std::string_view furniture_list[] = {
    "id",         "name",  "model",     "position", "elevation", "angle",     "angle_deg",
    "width",      "depth", "height",    "mirrored", "colour",    "catalogue", "model_rotation",
    "model_size", "pitch", "pitch_deg", "roll",     "roll_deg",  "materials"};
inline constexpr std::string_view material_list[] = {"name", "colour"};
inline constexpr std::string_view finding_list[] = {"code",  "severity", "sentence", "hint",
                                                    "point", "storey",   "elements", "moved_mm"};
inline constexpr std::string_view element_list[] = {"kind", "id", "name"};

inline constexpr JsonKeys plan{"plan", plan_list};
inline constexpr JsonKeys storey{"storey", storey_list};
inline constexpr JsonKeys wall{"wall", wall_list};
inline constexpr JsonKeys opening{"opening", opening_list};
inline constexpr JsonKeys room{"room", room_list};
inline constexpr JsonKeys texture{"texture", texture_list};
inline constexpr JsonKeys column{"column", column_list};
inline constexpr JsonKeys circle{"circle", circle_list};
inline constexpr JsonKeys stair{"stair", stair_list};
inline constexpr JsonKeys shaft{"shaft", shaft_list};
inline constexpr JsonKeys light{"light", light_list};
inline constexpr JsonKeys furniture{"furniture", furniture_list};
inline constexpr JsonKeys material{"material", material_list};
inline constexpr JsonKeys finding{"finding", finding_list};
inline constexpr JsonKeys element{"element", element_list};

inline constexpr std::array all{plan,  storey, wall,  opening,   room,     column,  circle,
                                stair, shaft,  light, furniture, material, finding, element};

}  // namespace keys
}  // namespace enfilade::plans
