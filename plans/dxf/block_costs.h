#pragma once
// What the insertions of a file ask for, counted block by block, however often each is inserted.

#include <string>
#include <vector>

#include "plans/dxf/drawing.h"
#include "plans/dxf/entities.h"

namespace enfilade::plans::dxf {

/// The blocks that model space needs, by index; `missing` names the others that are asked for.
struct BlockUse {
    std::vector<bool> used;
    std::map<std::string, Tally> missing;
};

/// Throws InputError, with the line of the insertion, where blocks stand in themselves, are nested deeper than
/// `limits.depth`, or would make more than `limits.strokes` strokes, texts and insertions together.
[[nodiscard]] BlockUse check_costs(const Contents& contents, const DrawingLimits& limits, const std::string& file_name);

}  // namespace enfilade::plans::dxf
