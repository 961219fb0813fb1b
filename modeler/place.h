#pragma once
// Where a volume or a face is, in words that a person knows from the plan.

#include <cstdint>
#include <string>

#include "base/finding.h"
#include "modeler/building.h"

namespace enfilade::modeler {

/// The space's name, else its id, in quotes, after what it is: `room "Kitchen"`.
[[nodiscard]] std::string title(const Space& space);

/// Puts point, storey and element of a volume into a finding; elements add up, the first point stays.
void place_at_volume(const Building& building, std::uint32_t volume, Finding& finding);
void place_at_face(const Building& building, std::uint32_t face, Finding& finding);
void place_at_space(const Building& building, std::uint32_t space, Finding& finding);  ///< its element, and no point
void place_at_vertex(const Building& building, std::uint32_t vertex, Finding& finding);

}  // namespace enfilade::modeler
