#pragma once
// Plans from files: one entry, the reader chosen by content, then by extension.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plans/plan.h"
#include "plans/unit.h"

namespace enfilade::plans {

/// A rectangle of a drawing, in the drawing's own coordinates.
struct DrawingBox {
    double x0 = 0;
    double y0 = 0;
    double x1 = 0;
    double y1 = 0;
};

/// What the file does not say, or says wrongly.
struct ReadOptions {
    std::optional<Unit> unit;         ///< drawings and FloorspaceJS: overrules the unit of the file
    std::vector<std::string> layers;  ///< drawings: only these layers, by name; * and ? match; empty: all
    std::optional<DrawingBox> crop;   ///< drawings: only what lies in this box
    std::filesystem::path mapping;    ///< drawings: JSON from layers and block names to roles; empty: the default
    double wall_thickness = 0.1;      ///< metres, of walls that the file draws as single lines
    double storey_height = 2.5;       ///< metres, where the file has none (drawings always)
};

/// Reads a plan in any known format (native JSON, Sweet Home 3D, FloorspaceJS JSON, DXF), chosen by content.
/// Throws InputError with the place, IoError where the file cannot be read.
[[nodiscard]] Plan read(const std::filesystem::path& file, const ReadOptions& options = {});

/// Our own JSON: schema in docs/plan.schema.json, comments allowed, unknown keys refused.
[[nodiscard]] Plan read_json(std::string_view text, const std::string& file_name);
[[nodiscard]] std::string write_json(const Plan& plan);

/// A Sweet Home 3D home: zip with Home.xml (lengths in centimetres, y down).
[[nodiscard]] Plan read_sweet_home(std::span<const std::byte> bytes, const std::string& file_name);

/// A FloorspaceJS floor plan (JSON of storeys, spaces, shared edges, windows, doors). Edges have no thickness there:
/// walls get `ReadOptions::wall_thickness`.
[[nodiscard]] Plan read_floorspace(std::string_view text, const std::string& file_name,
                                   const ReadOptions& options = {});

/// A DXF drawing: one storey, from its walls, doors and windows as layers, blocks and shapes tell them.
[[nodiscard]] Plan read_dxf(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

/// Sizes in metres.
struct CleanOptions {
    double join_gap = 0.05;  ///< wall ends this close to another wall's end or face are brought to it; 0: none
    double step = 0.25;      ///< sloped wall tops are cut into steps of at most this height, greater than 0
};

/// Repairs what can be repaired and says so in `findings` (docs/findings.md, P2..): storeys out of order or too close,
/// wall ends that nearly meet, walls drawn twice, sloped tops, openings beyond their wall, elements without extent.
/// What cannot be used is left out with an error. Idempotent; the order of elements does not matter.
/// \pre ids are unique within the plan
[[nodiscard]] Plan clean(Plan plan, const CleanOptions& options = {});

}  // namespace enfilade::plans
