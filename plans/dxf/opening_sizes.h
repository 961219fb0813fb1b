#pragma once
// Sizes of doors and windows as drawings write them beside the opening: "2668", "6068 S.G.D.", "2'6 x 6'8", "90/210".

#include <optional>
#include <string_view>
#include <vector>

#include "plans/dxf/drawing.h"
#include "plans/dxf/wall_runs.h"

namespace enfilade::plans {

/// A written size, metres.
struct SizeNote {
    double width = 0;
    double height = 0;
    std::optional<OpeningKind> kind;  ///< as words beside the numbers tell: "O.H. DOOR", "XO", "Fenster"
    Point at;
    double length = 0;  ///< of the text, along x
};

/// Reads a text as width and height; nothing for all others. `feet`: four or five digits are feet and inches each
/// (2668 is 2'6" by 6'8"), as in drawings in inches.
[[nodiscard]] std::optional<SizeNote> size_note(std::string_view text, bool feet);

/// The notes among the drawing's texts, in metres.
[[nodiscard]] std::vector<SizeNote> size_notes(const Drawing& drawing, double scale);

/// Gives openings the height that is written beside them, and the kind, where no swing tells it: an opening of the
/// written width, at most 1.2 m from the text, each the nearest.
void apply_sizes(std::vector<WallRun>& runs, const std::vector<SizeNote>& notes);

}  // namespace enfilade::plans
