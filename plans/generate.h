#pragma once
// Office floors of any size, for tests and benchmarks.

#include <cstdint>

#include "plans/plan.h"

namespace enfilade::plans {

struct GenerateOptions {
    std::uint32_t rooms = 46;  ///< per building, spread evenly over its storeys; corridors and stairwells counted
    std::uint32_t storeys = 1;
    double curved = 0;   ///< share of the walls between neighbouring offices that are arcs, 0..1
    double oblique = 0;  ///< share of them that are turned, 0..1; both shares together at most 1
    std::uint64_t seed = 1;
};

/// A plan of rooms on both sides of corridors, with doors, windows, stairwells between storeys, and closed
/// courtyards from about 60 rooms a storey on. Sound by construction: `check` finds nothing in it. Same options, same
/// plan, on every machine. Throws InputError P110 where the options ask for no building (no room, fewer rooms than
/// storeys).
[[nodiscard]] Plan generate(const GenerateOptions& options);

}  // namespace enfilade::plans
