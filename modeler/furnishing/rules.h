#pragma once
// The rules by which rooms are furnished (docs/furnishing.md).

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::modeler {

/// Where an object of a rule stands. The first six choose a place in the room; the others are relative to the object
/// whose rule holds them (`ObjectRule::with`).
enum class Relation : std::uint8_t {
    AgainstWall,  ///< its back to a wall, straight, oblique or curved
    NearWindow,   ///< as AgainstWall, within reach of a window
    Middle,       ///< free in the room
    Rows,         ///< places of one grid along the room's longest wall
    OnWall,       ///< hung on a wall, at its elevation
    Ceiling,      ///< hung from the ceiling
    Beside,       ///< left and right of it, backs in line
    InFront,      ///< before it
    Around,       ///< on all its sides, facing it
    OnTop,        ///< on it
    Under,        ///< flat on the floor, and it stands on that
    Above,        ///< hung on the wall over it
    Opposite,     ///< facing it from some distance
    InRow         ///< beside it, then beside each other, along the same wall
};
[[nodiscard]] std::string_view name_of(Relation relation);

/// Metres of floor that stay free around an object (of other objects, not of other free floor).
struct Clearance {
    double front = 0;
    double behind = 0;
    double sides = 0;     ///< on both sides
    double one_side = 0;  ///< on at least one of them
};

/// How much each part of the score of a place counts; each part is in [0, 1], negative weights repel.
struct ScoreWeights {
    double corner = 0;       ///< its side touches a wall, or another piece
    double window = 0;       ///< a window is near
    double door = 0;         ///< a door is near
    double wall_middle = 0;  ///< in the middle of its wall
    double centre = 0;       ///< in the middle of the room
    double open_front = 0;   ///< free floor before it
    double near = 0;         ///< the kind that `near` names is near
    double facing = 0;       ///< it looks at the kind that `facing` names
    double gap = 0;          ///< beside it no gap is left that is too narrow for use
};

/// What the rules say of an object, wherever it stands.
struct KindRule {
    std::string kind;
    Clearance clearance;
    ScoreWeights score;
};

/// One request. Lengths in metres.
struct ObjectRule {
    std::vector<std::string> object;  ///< kinds, or ids of catalogue entries: the first that finds a place
    Relation place = Relation::AgainstWall;
    std::uint32_t least = 1;  ///< how many: drawn from [least, most]
    std::uint32_t most = 1;
    double per_area = 0;     ///< square metres of room for each; bounded by least and most; 0: not by area
    double probability = 1;  ///< of there being any
    double least_area = 0;   ///< square metres of the rooms that are meant
    double most_area = 1e9;
    double gap = 0;                ///< to the wall, to the object beside or before it
    double most_gap = 0;           ///< Opposite: up to this distance
    double elevation = -1;         ///< of its bottom above the floor; below 0: as its catalogue entry says
    bool turned = false;           ///< its front to the wall, or away from what it relates to
    bool needed = false;           ///< of `with`: without half of them the object does not come either
    std::string near;              ///< a kind whose neighbourhood counts in the score
    std::string facing;            ///< a kind that it looks at
    std::string unless;            ///< a kind: where such a piece stands already, nothing is asked for
    Clearance clearance;           ///< of the rule, else of the kind
    ScoreWeights score;            ///< of the rule, else of the kind
    std::vector<ObjectRule> with;  ///< what comes with each of them, in this order
};

/// What a kind of room is furnished with.
struct RoomRules {
    std::string kind;                 ///< "bedroom", "office" ...
    std::vector<std::string> names;   ///< what plans call it, in any language
    std::vector<ObjectRule> objects;  ///< in the order of placing; none: the room stays empty
};

/// A rule file read. The lists are by the file's order, which is the order of placing.
struct Rules {
    std::string source;        ///< for messages
    double temperature = 0.2;  ///< of the draw: 0 takes the best place, large values any
    std::vector<KindRule> kinds;
    std::vector<RoomRules> rooms;
    [[nodiscard]] const RoomRules* find(std::string_view kind) const;
};

/// Reads a rule file (JSON, schema docs/furnishing.schema.json). \throws InputError (codes U1...) with line and column
[[nodiscard]] Rules read_rules(const std::filesystem::path& file);
/// The same from a text; `file_name` is for messages.
[[nodiscard]] Rules read_rules_text(std::string_view text, const std::string& file_name);

/// The rules that the program brings: homes and offices.
[[nodiscard]] const Rules& own_rules();

/// The one word for a room's kind, from the plan's kind and name ("Bedroom 2", "Schlafzimmer", "bureau" ...), among
/// those that `rules` know; empty where it is told by neither. The name counts before the kind: a bathroom called "WC"
/// is a toilet. Upper and lower case, accents, digits and punctuation make no difference.
[[nodiscard]] std::string room_kind(const Rules& rules, const std::string& kind, const std::string& name);

}  // namespace enfilade::modeler
