#pragma once
// Office floors of any size, for tests and benchmarks.

#include <cstdint>

#include "plans/plan.h"

namespace enfilade::plans {

struct GenerateOptions {
    std::uint32_t rooms = 46;    ///< per building, spread evenly over its storeys; corridors counted
    std::uint32_t storeys = 1;
    double curved = 0;           ///< share of inner walls that are arcs, 0..1
    double oblique = 0;          ///< share of inner walls that are turned, 0..1
    std::uint64_t seed = 1;
};

/// A plan of rooms on both sides of corridors, with doors, windows, stairwells between storeys. Sound by
/// construction: `check` finds nothing in it. Same options, same plan, on every machine.
[[nodiscard]] Plan generate(const GenerateOptions& options);

}  // namespace enfilade::plans
