#pragma once
// Files of cameras: a tour through a building, saved once and looked at again (docs/views.schema.json).

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "accel/scene.h"
#include "render/camera.h"

namespace enfilade::tools {

/// A camera, and the cell of a scene from which it sees.
struct SavedView {
    std::string name;
    render::Camera camera;  ///< in the frame of the scene; square, 1024 pixels a side, until somebody says otherwise
    accel::CellId cell;     ///< holds the eye as float has it
};

struct ViewFile {
    std::vector<SavedView> views;  ///< in the order of the file; at least one, no name twice
    /// Views whose file names another cell than the one that holds their eye: the scene was cut anew since.
    std::vector<std::string> relocated;

    /// One sentence about those; empty where there are none.
    [[nodiscard]] std::string warning(const std::filesystem::path& path) const;
};

/// Reads a view file and places its cameras in `scene`: the file's eyes and targets are in the frame of the plan. The
/// cell that the file names is checked (accel::contains), and looked for only where it is not, or no longer, the right
/// one. Cost: linear in the file.
/// \throws IoError where the file cannot be read; InputError with line and column where it is no view file (P101 to
/// P105), holds no view or a name twice (F134), or a camera that is none or stands in no cell (F135)
[[nodiscard]] ViewFile read_views(const std::filesystem::path& path, const accel::SceneView& scene);

/// The same from the text of a file called `name`.
[[nodiscard]] ViewFile parse_views(std::string_view text, const std::string& name, const accel::SceneView& scene);

/// The text of a view file, a view a line, lengths rounded to 0.1 mm and angles to 0.01 degrees.
[[nodiscard]] std::string view_file_text(std::span<const SavedView> views, const accel::SceneView& scene);

/// The view as such a file will hold it: rounded, and in the cell that holds the rounded eye.
/// \throws InputError (F135) where none does
[[nodiscard]] SavedView as_saved(const SavedView& view, const accel::SceneView& scene);

}  // namespace enfilade::tools
