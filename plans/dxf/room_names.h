#pragma once
// Texts of a drawing as the names of rooms.

#include <string>
#include <vector>

#include "plans/dxf/drawing.h"
#include "plans/dxf/role.h"
#include "plans/plan.h"

namespace enfilade::plans {

/// A text that may name the place in which it stands: metres.
struct PlaceName {
    std::string text;
    Point at;
    double height = 0;
    bool certain = false;  ///< from a layer for names of rooms, or made of words for rooms
};

/// Texts that read like names: words of letters, no sizes, notes, marks or catalogue numbers. Lines that stand under
/// each other are one name. Texts on layers for names alone, where there are such.
[[nodiscard]] std::vector<PlaceName> place_names(const Drawing& drawing, const Roles& roles, double scale);

/// Texts that are not certain name rooms only where no text is. Finds the rooms of a storey (by arranging it) and gives
/// it a room polygon for each that holds a name. Several names in one room are joined by " / ". Returns how many names
/// stand in no room.
std::uint32_t name_rooms(const std::vector<PlaceName>& names, Plan& plan);

}  // namespace enfilade::plans
