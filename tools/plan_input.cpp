// How plan files come in: the flags that `import`, `build` and `check` share, and the list of a drawing's layers.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "plans/dxf/drawing.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/exit_code.h"

namespace enfilade::tools {

plans::DrawingBox parse_crop(const std::string& text) {
    std::array<double, 4> numbers = {};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [stop, error] = std::from_chars(at, end, numbers[k]);
        const bool separated = k == 3 ? stop == end : stop != end && *stop == ',';
        if (error != std::errc() || !separated || !std::isfinite(numbers[k]))
            throw InputError("F103", "",
                             "--crop \"" + text +
                                 "\" is no box: give the coordinates of two opposite corners, like 0,0,12000,9000.");
        at = stop + 1;
    }
    const auto [x0, y0, x1, y1] = numbers;
    return {std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
}

void need_output(const std::filesystem::path& output, const std::string& command) {
    if (output.empty())
        throw InputError("F100", "", "--output is required; \"enfilade " + command + " --help\" shows how.");
}

}  // namespace enfilade::tools
