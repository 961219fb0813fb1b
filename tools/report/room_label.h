#pragma once
// Names written into rooms, as large as there is room.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "tools/report/svg_path.h"

namespace enfilade::tools {

/// Lines of text around a point, level or turned a quarter to the left.
struct RoomLabel {
    Mm at;
    int size = 0;  ///< millimetres of the font
    bool upright = false;
    std::vector<std::string> lines;  ///< the name's; the area, where it has room, is one more line of a smaller font
    bool with_area = false;
};

/// Size 0 where the name would be smaller than 9 cm: nobody could read it.
/// `rings`: outer ring and holes of the room; `at`: a point inside, away from the border; `obstacles`: what the label
/// keeps off where it can without becoming small.
[[nodiscard]] RoomLabel fit_label(const std::vector<std::vector<Mm>>& rings, Mm at, const std::string& name,
                                  const std::string& area, std::span<const MmBox> obstacles = {});

}  // namespace enfilade::tools
