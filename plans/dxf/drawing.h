#pragma once
// A DXF drawing as flat geometry: what is on the sheet, before anybody asks what it means. Coordinates and lengths in
// the drawing's own units, angles in radians counter-clockwise, y up.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "plans/plan.h"
#include "plans/read.h"
#include "plans/unit.h"

namespace enfilade::plans {

/// A straight line, or an arc of circle when `bulge` (tangent of a quarter of the swept angle, counter-clockwise
/// positive) is not 0.
struct Stroke {
    Point a;
    Point b;
    double bulge = 0;
};

enum class ShapeKind : std::uint8_t { Line, Polyline, Arc, Circle, Ellipse, Spline, Face };

/// One entity of the drawing, with all insertions carried out. Strokes join end to start.
struct Shape {
    ShapeKind kind = ShapeKind::Line;
    std::uint32_t layer = 0;           ///< into Drawing::layers (of what stands on "0" in a block: the insertion's)
    std::uint32_t block = UINT32_MAX;  ///< into Drawing::insertions: the innermost one; none: in model space itself
    bool closed = false;
    std::uint32_t first_stroke = 0;  ///< into Drawing::strokes
    std::uint32_t stroke_count = 0;
    int line = 0;  ///< of the file, where it begins; 0: unknown
    /// Its layer is neither off nor frozen, and no insertion around it stands on a frozen layer.
    bool visible = true;
};

/// A block set into the drawing. `x_axis`, `y_axis`: images of the block's unit vectors (their lengths are the scale;
/// a negative determinant is a mirror image); `at`: image of the block's base point.
struct Insertion {
    std::string name;  ///< of the block
    std::uint32_t layer = 0;
    std::uint32_t parent = UINT32_MAX;  ///< the insertion in whose block this one stands
    Point at;
    Point x_axis = {1, 0};
    Point y_axis = {0, 1};
    std::vector<std::string> attributes;  ///< texts of its ATTRIBs
};

struct DrawingText {
    std::string text;  ///< UTF-8, formatting codes taken out
    Point at;
    double height = 0;
    std::uint32_t layer = 0;
    bool visible = true;  ///< as `Shape::visible`
};

/// A linear dimension: what the drawing measures, and what is written beside it where that was typed by hand.
struct Dimension {
    double length = 0;
    std::string text;  ///< empty: the program writes the measured length
    Point a;
    Point b;
    std::uint32_t layer = 0;
    std::string written;  ///< what the picture of it shows, typed or not ("58'-0\""); empty: the file has no picture
};

struct Layer {
    std::string name;
    bool visible = true;            ///< neither off nor frozen
    std::uint32_t shape_count = 0;  ///< insertions carried out
    std::uint32_t text_count = 0;
};

struct Drawing {
    std::vector<Layer> layers;  ///< in the order of the file
    std::vector<Shape> shapes;
    std::vector<Stroke> strokes;
    std::vector<Insertion> insertions;
    std::vector<DrawingText> texts;
    std::vector<Dimension> dimensions;
    std::optional<Unit> declared_unit;  ///< $INSUNITS; nothing where it is 0 or absent
    int linear_format = 2;              ///< $LUNITS: 2 decimal, 3 engineering, 4 architectural (feet and inches)
    bool metric = true;                 ///< $MEASUREMENT
    std::array<double, 4> bounds = {0, 0, 0, 0};  ///< x0, y0, x1, y1 of all strokes
    std::vector<Finding> findings;  ///< what was left out or doubtful (P7..): paper space, 3D, unknown entities
};

/// Limits of `read_drawing`: files that ask for more are refused (hostile nesting of blocks, endless arrays).
struct DrawingLimits {
    std::uint32_t strokes = 5'000'000;
    std::uint32_t depth = 32;  ///< of insertions in blocks
};

/// Reads model space: LINE, LWPOLYLINE and POLYLINE with bulges, ARC, CIRCLE, ELLIPSE and SPLINE (as arcs, else as
/// straight strokes that stay within 1e-4 of the curve's own size of it), SOLID, TEXT, MTEXT, DIMENSION, INSERT carried
/// out with scale, rotation, mirror image (extrusion 0, 0, -1) and arrays. Throws InputError with the line where the
/// file is no drawing, is cut off, nests its blocks in a circle, or asks for more than `limits`.
[[nodiscard]] Drawing read_drawing(std::string_view bytes, const std::string& file_name,
                                   const DrawingLimits& limits = {});

/// What is left of a drawing by layer names (* and ? match) and box: shapes with a stroke in it; empty: all.
/// Throws InputError where a name matches no layer (the layers are named), or nothing is left.
[[nodiscard]] Drawing select(const Drawing& drawing, const std::vector<std::string>& layers,
                             const std::optional<DrawingBox>& crop, const std::string& file_name);

}  // namespace enfilade::plans
