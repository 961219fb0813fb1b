#pragma once
// The parts of `enfilade bench convexify`.

#include "tools/bench.h"

namespace enfilade::tools {

/// How the time to cut a single room grows with its corners.
void bench_cut_growth(Bench& bench);

/// What of a way of cutting decides the time of a ray: the constants of `modeler::CutCost`.
void bench_cut_objective(Bench& bench);

}  // namespace enfilade::tools
