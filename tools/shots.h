#pragma once
// The pictures that `render` is asked for: what each sees, and how large it is.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "accel/scene.h"
#include "tools/commands.h"
#include "tools/view.h"

namespace enfilade::tools {

/// A picture to make, and what became of it.
struct Shot {
    std::string name;  ///< in the view file; empty without one
    View view;
    std::optional<accel::CellId> cell;  ///< of the view file
    double seconds = 0;
};

/// Width and height of the files: "640x480". Throws InputError (F111).
[[nodiscard]] std::array<int, 2> parse_size(const std::string& text);

/// Rows of the files that the colour scale of --show takes: the pictures above it are so much less high.
[[nodiscard]] int scale_rows(const RenderOptions& options);

/// One by --camera or --room, or all of the file of --views; where that was made before the rooms were cut anew, a
/// warning says so. Throws InputError as `named_view`, `room_view` and `read_views`.
[[nodiscard]] std::vector<Shot> chosen_shots(const RenderOptions& options, const accel::SceneView& scene,
                                             const Console& console);

}  // namespace enfilade::tools
