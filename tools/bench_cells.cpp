// Tracers through the cells of empty buildings, against Embree on the same rays in the same run; and whether all see
// the same faces, and the oracle too.

#include "tools/bench_cells.h"

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "tools/examples.h"

namespace enfilade::tools {

namespace {

accel::Scene scene_of(const plans::Plan& plan) {
    const modeler::Building building = modeler::convexify(modeler::build(plan));
    return modeler::export_scene(building, modeler::check(building), "{}");
}

void bench_rays(Bench& bench, const TracedBuilding& building) {
    bench_primary(bench, building);
    bench_bounces(bench, building);
    bench_shadows(bench, building);
}

}  // namespace

TracedBuilding office_floor(std::uint32_t rooms) {
    return {grouped(rooms) + " rooms", scene_of(plans::generate({.rooms = rooms}))};
}

TracedBuilding example_building(Bench& bench, const std::string& name, std::uint32_t rooms) {
    const ExamplePlan example = example_plan(bench, name, rooms);
    return {example.name, scene_of(example.plan)};
}

void bench_cells(Bench& bench) {
    if (!bench.quick()) {
        bench_rays(bench, example_building(bench, "townhouse", 9));
        bench_rays(bench, example_building(bench, "office-46", 46));
    }
    const TracedBuilding example = example_building(bench, "office-135", 135);
    bench_rays(bench, example);
    bench_agreement(bench, example);
    if (!bench.quick()) bench_rays(bench, office_floor(1000));
    const TracedBuilding small = office_floor(135), large = office_floor(bench.quick() ? 1'000 : 10'000);
    if (!bench.quick()) bench_rays(bench, large);
    bench_growth(bench, small, large);
}

}  // namespace enfilade::tools
