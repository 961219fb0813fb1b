#pragma once
// The names of rooms, as a layer of a drawing.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "tools/report/svg_path.h"

namespace enfilade::tools {

struct RoomNote {
    std::string name;
    std::string measure;  ///< a smaller line under the name
    std::string count;    ///< takes the measure's place (class "count") where a page shows cells; empty: none
};

/// Names by font size: pages hide small ones from afar.
class NameLayer {
public:
    /// Arguments as of `fit_label`: a name that finds no place is left out.
    void add(const std::vector<std::vector<Mm>>& rings, Mm at, const RoomNote& note,
             std::span<const MmBox> obstacles = {});
    /// A `<g class="layer layer-names">` whose outer unit is the metre.
    [[nodiscard]] std::string text() const;

private:
    std::map<int, std::string> by_size_;
};

}  // namespace enfilade::tools
