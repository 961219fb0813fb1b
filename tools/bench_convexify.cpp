// The ways to cut rooms into cells.

#include "tools/bench_convexify.h"

namespace enfilade::tools {

void bench_convexify(Bench& bench) {
    const OneCore one_core;
    bench_cut_growth(bench);
    bench_cut_objective(bench);
}

}  // namespace enfilade::tools
