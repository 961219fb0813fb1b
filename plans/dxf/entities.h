#pragma once
// What a DXF file holds, as written: blocks of entities in their own coordinates, nothing inserted yet.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "plans/dxf/transform.h"
#include "plans/unit.h"

namespace enfilade::plans::dxf {

/// Coordinates and sizes beyond this belong to no drawing: 1e7 m are 1e10 mm.
inline constexpr double largest_number = 1e13;

/// In the entity's plane, except LINE, whose ends are given in the block's space.
struct LineEntity {
    P3 a;
    P3 b;
};

struct PathVertex {
    P3 at;
    double bulge = 0;
};

/// LWPOLYLINE and POLYLINE. `in_space`: a 3D polyline, not drawn in a plane of its own.
struct PathEntity {
    std::vector<PathVertex> vertices;
    bool closed = false;
    bool in_space = false;
    double elevation = 0;  ///< of all vertices, unless in space
};

/// ARC, counter-clockwise in its plane, and CIRCLE. Angles in radians.
struct ArcEntity {
    P3 centre;
    double radius = 0;
    double start = 0;
    double end = 0;
    bool full = false;
};

/// In the block's space; the minor axis is normal x major, times `ratio`. Parameters in radians.
struct EllipseEntity {
    P3 centre;
    P3 major;
    double ratio = 1;
    double start = 0;
    double end = 0;
};

/// In the block's space. Without control points the curve goes through `fit`.
struct SplineEntity {
    unsigned degree = 3;
    bool closed = false;
    std::vector<P3> control;
    std::vector<double> weights;  ///< one for each control point
    std::vector<double> knots;
    std::vector<P3> fit;
    P3 start_tangent;  ///< of `fit`; without length: none
    P3 end_tangent;
};

/// SOLID and TRACE (in their plane, corners 3 and 4 crossed) and 3DFACE (in space, corners in turn).
struct FaceEntity {
    std::array<P3, 4> corners;
    bool in_space = false;
};

struct TextEntity {
    std::string text;
    P3 at;
    double height = 0;
    bool in_space = false;  ///< MTEXT gives its place in space
};

/// Measured between `a` and `b` in space, along `direction` (in the entity's plane) where that has a length.
struct DimensionEntity {
    P3 a;
    P3 b;
    P3 direction;
    std::string text;
    std::string picture;  ///< key of the block that draws it
};

struct InsertEntity {
    std::string block;  ///< its key
    std::string name;   ///< of the block, decoded
    P3 at;
    P3 scale = {1, 1, 1};
    double angle = 0;  ///< radians
    std::int64_t columns = 1;
    std::int64_t rows = 1;
    double column_step = 0;
    double row_step = 0;
    std::vector<std::string> attributes;
};

using Shape3 = std::variant<LineEntity, PathEntity, ArcEntity, EllipseEntity, SplineEntity, FaceEntity, TextEntity,
                            DimensionEntity, InsertEntity>;

struct Entity {
    Shape3 shape;
    std::uint32_t layer = 0;  ///< into Contents::layers
    int line = 0;
    P3 normal = {0, 0, 1};
};

struct Block {
    std::string name;
    std::string key;  ///< its folded name as in the file, undecoded
    P3 base;
    std::vector<Entity> entities;
};

struct LayerEntry {
    std::string name;
    bool frozen = false;
    bool off = false;
};

/// How often something was left out or changed on the way, and where first.
struct Tally {
    std::uint64_t count = 0;
    int first_line = 0;
    void add(int line) {
        if (count++ == 0) first_line = line;
    }
};

/// What of a block cannot be shown, for the findings.
struct LeftOut {
    std::map<std::string, Tally> unknown_kinds;
    Tally paper_space;
    Tally invisible;
    Tally broken;  ///< numbers that are none, or beyond `largest_number`
    Tally meshes;
    Tally cut_texts;
};

/// The whole file. Names are UTF-8; those of blocks are keyed by `folded`, for DXF names ignore case.
struct Contents {
    std::vector<LayerEntry> layers;
    std::map<std::string, std::uint32_t> layer_index;
    std::vector<Block> blocks;
    std::map<std::string, std::size_t> block_index;
    Block model;
    std::map<std::string, LeftOut> left_out;  ///< by folded name of the block; "": of model space
    std::optional<Unit> unit;
    int linear_format = 2;
    bool metric = true;
    int unit_code = 0;      ///< $INSUNITS as written
    std::string code_page;  ///< $DWGCODEPAGE where nothing here knows it
};

/// The name with the letters A to Z made small.
[[nodiscard]] inline std::string folded(std::string name) {
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return name;
}

}  // namespace enfilade::plans::dxf
