#pragma once
// The 2D plan that every reader produces and every later stage starts from.
// Metres, radians, right-handed, z up. Element ids are unique within a plan.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"

namespace enfilade::plans {

struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// Linear RGB, each 0..1.
using Colour = std::array<float, 3>;

/// A picture that covers a surface, repeated: on walls upright from the foot of their start, on floors from the origin
/// of the plan.
struct SurfaceTexture {
    std::string picture;  ///< a PNG or JPEG: an entry of the plan's archive, or a file beside the plan or below
    double width = 1;     ///< metres of one repeat
    double height = 1;
    double angle = 0;     ///< counter-clockwise as one looks at the surface
    double offset_x = 0;  ///< how far it is moved: to the right, in repeats
    double offset_y = 0;  ///< upward
    friend bool operator==(const SurfaceTexture&, const SurfaceTexture&) = default;
};

/// A wall by its axis: a segment, or an arc of circle when `arc_extent` is not 0.
struct Wall {
    std::string id;
    std::string name;
    Point start;
    Point end;
    double arc_extent = 0;  ///< signed angle swept from start to end, counter-clockwise positive, |.| < 2 pi
    double thickness = 0.1;
    double height_at_start = 2.5;  ///< above the storey's floor
    double height_at_end = 2.5;
    std::optional<Colour> left_colour;  ///< left of start -> end
    std::optional<Colour> right_colour;
    std::optional<SurfaceTexture> left_texture;  ///< instead of the colour, where its picture can be had
    std::optional<SurfaceTexture> right_texture;
};

enum class OpeningKind { Door, Window, Opening };

/// A hole through its host wall, from face to face.
struct Opening {
    std::string id;
    std::string name;
    OpeningKind kind = OpeningKind::Door;
    std::string wall;                        ///< id of the host wall, of the same storey
    double offset = 0;                       ///< along the wall's axis, from its start to the middle of the opening
    double width = 0.9;                      ///< along the axis
    double sill = 0;                         ///< above the storey's floor
    double head = 2.1;                       ///< above the storey's floor
    double open_angle = 1.5707963267948966;  ///< doors: 0 is closed
    /// Where other walls lie against the host, the hole goes on by these lengths beyond its left and right face.
    double depth_left = 0;
    double depth_right = 0;
};

/// A name for a place: rooms are found from the walls, and named by these polygons.
struct Room {
    std::string id;
    std::string name;
    std::string kind = "room";  ///< "room", "corridor", "bathroom", ...; "courtyard" and "terrace" are open to the sky
    std::vector<Point> polygon;
    std::optional<Colour> floor_colour;
    std::optional<Colour> ceiling_colour;
    std::optional<SurfaceTexture> floor_texture;
    std::optional<SurfaceTexture> ceiling_texture;
};

/// A solid prism inside a storey.
struct Column {
    std::string id;
    std::string name;
    std::vector<Point> polygon;
    double height = 0;  ///< 0: up to the ceiling
};

/// A flight from its storey to the next one up; its footprint is open through the slab between them.
struct Stair {
    std::string id;
    std::string name;
    std::vector<Point> polygon;
};

/// A hole through the slab above its storey without steps (lift, duct, void).
struct Shaft {
    std::string id;
    std::string name;
    std::vector<Point> polygon;
};

struct Light {
    std::string id;
    std::string name;
    Point position;
    double elevation = 2.3;  ///< above the storey's floor
    Colour colour = {1, 1, 1};
    double power_lumen = 800;
    double radius = 0;      ///< of the sphere that shines; 0: a point
    std::string furniture;  ///< id of the piece that carries it; empty: none
};

/// A material of a piece's mesh that has another colour in this piece.
struct FurnitureMaterial {
    std::string name;
    Colour colour = {0.8f, 0.8f, 0.8f};
    friend bool operator==(const FurnitureMaterial&, const FurnitureMaterial&) = default;
};

/// A piece of furniture as placed by the plan; `model` names its mesh inside the plan file, or a catalogue entry.
/// Its mesh (z up, front towards -y) is turned by `model_rotation`, scaled to the box `model_size`, mirrored, tilted by
/// `pitch` or else by `roll`, turned by `angle`; its box is then width x depth x height, about the piece's own axes.
struct Furniture {
    std::string id;
    std::string name;
    std::string model;
    Point position;  ///< middle of its box
    double elevation = 0;
    double angle = 0;
    double width = 1;
    double depth = 1;
    double height = 1;
    bool mirrored = false;
    std::optional<Colour> colour;
    std::string catalogue;                                ///< a catalogue entry to take where `model` is not to be had
    std::optional<std::array<double, 9>> model_rotation;  ///< rows
    std::optional<std::array<double, 3>> model_size;      ///< width, depth, height before tilting; none: not tilted
    double pitch = 0;                                     ///< about its x axis: positive lowers the back
    double roll = 0;                                      ///< about its y axis: positive lowers the right
    std::vector<FurnitureMaterial> materials;
};

struct Storey {
    std::string id;
    std::string name;
    double elevation = 0;         ///< of its floor
    double height = 2.5;          ///< floor to ceiling
    double slab_thickness = 0.2;  ///< of the slab under its floor
    std::vector<Wall> walls;
    std::vector<Opening> openings;
    std::vector<Room> rooms;
    std::vector<Column> columns;
    std::vector<Stair> stairs;
    std::vector<Shaft> shafts;
    std::vector<Light> lights;
    std::vector<Furniture> furniture;
};

struct Plan {
    std::string name;
    std::optional<double> ground_level;  ///< default: the lowest storey at or above 0, else the highest storey's floor
    std::optional<double> site_margin;   ///< default: max(5 m, height of the building)
    std::vector<Storey> storeys;         ///< by ascending elevation once `clean` has run
    std::vector<Finding> findings;       ///< what reading and cleaning repaired or could not use
};

}  // namespace enfilade::plans
