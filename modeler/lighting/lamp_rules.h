#pragma once
// The rules by which rooms get lamps (docs/light.md, "Where lamps come from").

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::modeler {

/// How rooms of a kind are lit: lamps under their ceiling.
struct RoomLight {
    std::string kind;      ///< "office", "corridor" ... as furniture rules call it (`room_kind`); "default": all others
    double lux = 150;      ///< maintained on the floor, with all that walls send back; 0: no lamps
    double area = 15;      ///< square metres a lamp, about
    double drop = 0.1;     ///< metres under the ceiling
    double kelvin = 3000;  ///< colour temperature
    double radius = 0.05;  ///< metres, of the sphere that shines
};

/// How a piece of furniture shines that is a lamp.
struct PieceLight {
    std::string kind;    ///< of its catalogue entry: "floor_lamp" ...
    double lumen = 800;  ///< of pieces that light a whole room: at least
    double kelvin = 2700;
    double radius = 0.03;
    double height = 0.8;  ///< where nothing of its mesh is lamp glass: so much of its height above its bottom
    bool lights_room =
        false;  ///< it is the ceiling lamp of its room: it has what the room asks for, and no other comes
};

/// Lamps in the open air.
struct OutdoorLight {
    double spacing = 0;       ///< metres between lamps of a square grid over the site; 0: none
    std::uint32_t count = 0;  ///< exactly so many, on as wide a grid as has them; 0: as `spacing` says
    double elevation = 4;     ///< metres over the ground
    double lumen = 4000;      ///< of each of them
    double kelvin = 3000;
    double radius = 0.1;
    double entrance_lumen = 800;  ///< of a lamp over each door that leads into the open; 0: none
};

struct LampRules {
    std::string source;        ///< for messages
    double utilisation = 0.5;  ///< share of the flux of a room's lamps that arrives on its floor
    std::uint32_t count = 0;   ///< exactly so many lamps under ceilings, by area; 0: as many as rooms ask for
    bool replace = false;      ///< the plan's own lamps go; else rooms that have some keep to them
    std::vector<RoomLight> rooms;
    std::vector<PieceLight> pieces;  ///< not with `count`
    OutdoorLight outdoor;

    /// That of the kind, else that of "default"; nothing where there is neither, or no light is asked for.
    [[nodiscard]] const RoomLight* room(std::string_view kind) const;
    [[nodiscard]] const PieceLight* piece(std::string_view kind) const;
};

/// What the program brings: lux by kinds of rooms after EN 12464-1 (offices, schools) and as usual in homes.
[[nodiscard]] const LampRules& own_lamp_rules();

/// Reads a rule file (JSON, schema docs/lamps.schema.json). What it does not tell is as in our own rules; lists replace
/// ours. \throws InputError (codes U1...) with line and column
[[nodiscard]] LampRules read_lamp_rules(const std::filesystem::path& file);
/// The same from a text; `file_name` is for messages.
[[nodiscard]] LampRules read_lamp_rules_text(std::string_view text, const std::string& file_name);

/// Linear RGB of a black body, the largest of its numbers 1. kelvin: 1667 to 25000 (Kim et al. 2002: the Planckian
/// locus by cubic polynomials, 1e-3 in x and y; IEC 61966-2-1 primaries)
[[nodiscard]] std::array<float, 3> colour_of_kelvin(double kelvin);

}  // namespace enfilade::modeler
