// What it costs to prove a model sound: every constraint, on buildings of growing size.

#include <string>

#include "gmap/validate.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "plans/generate.h"
#include "tools/bench.h"

namespace enfilade::tools {

void bench_check(Bench& bench) {
    const OneCore one_core;
    std::vector<std::uint32_t> sizes = {135, 500, 1000};
    if (!bench.quick()) sizes.insert(sizes.end(), {2000, 5000, 10000});

    std::vector<std::array<double, 2>> points;
    for (const std::uint32_t rooms : sizes) {
        const modeler::Building building = modeler::convexify(modeler::build(plans::generate({.rooms = rooms})));
        const std::string scene = std::to_string(rooms) + " rooms";
        const int runs = rooms <= 200 ? 7 : rooms <= 1000 ? 3 : 1;
        const double seconds = median_seconds(runs, [&] { (void)modeler::check(building); });
        const double topology = median_seconds(runs, [&] { (void)gmap::validate(building.map); });
        BenchRow row{.row = "all constraints", .scene = scene, .value = seconds, .unit = "s"};
        if (rooms == 135) row.goal = value_at_most(0.05);
        if (rooms == 5000) row.goal = value_at_most(3);
        bench.add(row);
        bench.add({.row = "of these, T1 to T7", .scene = scene, .value = topology, .unit = "s"});
        // Smaller maps lie in the caches: they say nothing of how the time grows.
        if (rooms >= 500) points.push_back({double(rooms), seconds});
    }
    bench.add({.row = "exponent of growth",
               .scene = "500-" + std::to_string(sizes.back()) + " rooms",
               .value = growth_exponent(points),
               .unit = "1",
               .goal = value_at_most(1.1)});
}

}  // namespace enfilade::tools
