#pragma once
// Whether segments meet elsewhere than in common ends, decided by integers alone.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "plans/noding.h"

namespace enfilade::testing {

/// Two segments that share more than one common end: that cross, touch, overlap or are equal. None: the segments are
/// a plane graph. A sweep over x, with nothing of the code under test in it. \pre |coordinates| <= 2^29
[[nodiscard]] std::optional<std::array<std::size_t, 2>> first_crossing(std::span<const plans::Segment> segments);

}  // namespace enfilade::testing
