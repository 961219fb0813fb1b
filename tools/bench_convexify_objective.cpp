// What decides the time of a ray.

#include "tools/bench_convexify.h"

namespace enfilade::tools {

void bench_cut_objective(Bench&) {}

}  // namespace enfilade::tools
