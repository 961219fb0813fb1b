#pragma once
// A FloorspaceJS file as it is written: stories of vertices, edges, faces and spaces, references resolved, in metres.
// Schema: NREL/floorspace.js, schema/geometry_schema.json (versions 0.3 to 0.8).

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plans/plan.h"
#include "plans/unit.h"

namespace enfilade::plans {

inline constexpr std::uint32_t no_floor_item = UINT32_MAX;

struct FloorVertex {
    std::string id;
    Point at;
};

struct FloorEdge {
    std::string id;
    std::array<std::uint32_t, 2> ends{};  ///< into FloorStory::vertices
};

/// One use of an edge by a face; forward: from the edge's first vertex to its second.
struct FloorSide {
    std::uint32_t edge = 0;
    bool forward = true;
};

struct FloorFace {
    std::string id;
    std::vector<FloorSide> sides;
};

struct FloorSpace {
    std::string id;
    std::string name;
    std::string type_name;               ///< of its space type, empty without one
    std::uint32_t face = no_floor_item;  ///< into FloorStory::faces
    bool own_heights = false;            ///< overrides a height of its story, or has a floor offset
    bool open_to_below = false;
};

/// Doors and windows: what is placed, and how.
enum class FloorFill : std::uint8_t { Single, Repeating, Ratio, Door, Unknown };

struct FloorDefinition {
    std::string id;
    std::string name;
    FloorFill fill = FloorFill::Unknown;
    std::optional<double> ratio;  ///< of glass to wall
    std::optional<double> sill;
    std::optional<double> spacing;
    std::optional<double> height;
    std::optional<double> width;
};

/// A door, a window or a row of windows on an edge.
struct FloorAperture {
    std::string id;
    std::string name;
    bool door = false;
    std::uint32_t definition = no_floor_item;  ///< into FloorFile::doors or ::windows
    std::uint32_t edge = no_floor_item;        ///< into FloorStory::edges
    std::string definition_id;
    std::string edge_id;
    std::vector<double> alphas;  ///< shares of the edge from its first vertex, of the middles; empty: not given
    bool alpha_list = false;     ///< given as a list: all windows of a row
};

struct FloorStory {
    std::string id;
    std::string name;
    int line = 0;  ///< of the file
    int column = 0;
    double plenum_below = 0;
    double height = 0;  ///< floor to ceiling; 0: not given
    double plenum_above = 0;
    double multiplier = 1;
    std::vector<FloorVertex> vertices;
    std::vector<FloorEdge> edges;
    std::vector<FloorFace> faces;
    std::vector<FloorSpace> spaces;
    std::vector<std::uint32_t> shading_faces;
    std::vector<FloorAperture> apertures;
    std::size_t shadings = 0;
    std::size_t roofed_spaces = 0;
};

struct FloorFile {
    bool unit_named = true;   ///< false: the file names none, and none was asked for: metres
    double floor_offset = 0;  ///< of the first story's base above the ground
    double north_axis = 0;    ///< degrees
    double ground_slope = 0;
    std::vector<FloorStory> stories;
    std::vector<FloorDefinition> windows;
    std::vector<FloorDefinition> doors;
};

/// Throws InputError with line and column: P101 (no JSON), P103-P105 (kind, missing, range), P750-P753.
[[nodiscard]] FloorFile parse_floor_file(std::string_view text, const std::string& file_name, std::optional<Unit> unit);

}  // namespace enfilade::plans
