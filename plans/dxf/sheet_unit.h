#pragma once
// The unit of a drawing: what the file says, unless the sizes of its walls and doors say otherwise.

#include <optional>
#include <string>

#include "plans/dxf/drawing.h"
#include "plans/dxf/role.h"

namespace enfilade::plans {

struct UnitVerdict {
    Unit unit = Unit::Millimetre;
    bool overruled = false;  ///< the file says another one
    bool guessed = false;    ///< the file says none
    std::string evidence;    ///< "so its walls are 0.15 m thick, its doors 0.76 m wide ..."
};

/// Scores each unit by the thickness of wall pairs, the width of door swings, typed dimensions and the size of the
/// whole, with a start for the unit that the file declares.
[[nodiscard]] UnitVerdict sheet_unit(const Drawing& drawing, const Roles& roles);

}  // namespace enfilade::plans
