// What a user of the libraries writes: from a plan to rays, by the installed package alone.

#include <cstdio>

#include "accel/locate.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "render/trace_rays.h"

int main(int argument_count, char** arguments) {
    using namespace enfilade;
    if (argument_count != 2) return 2;
    const plans::Plan plan = plans::read(arguments[1]);
    const modeler::Building building = modeler::convexify(modeler::build(plan));
    const modeler::CheckReport report = modeler::check(building);
    const accel::Scene scene = modeler::export_scene(building, report, "{}");
    const accel::SceneView& view = scene.view();

    // From the middle of every cell straight down: the ray ends at a floor, or there is a leak.
    for (std::size_t c = 0; c < view.cells.size(); ++c) {
        const accel::Cell& cell = view.cells[c];
        render::RayQuery ray{{0, 0, (double(cell.z_floor) + cell.z_ceiling) / 2}, {0, 0, -1}, accel::CellId(c)};
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            ray.origin.x += double(view.section_x[s]) / cell.section_count;
            ray.origin.y += double(view.section_y[s]) / cell.section_count;
        }
        if (render::trace_ray(view, ray).status != render::WalkStatus::Hit) return 1;
    }
    std::printf("%zu cells, %s\n", view.cells.size(), report.sound() ? "sound" : "not sound");
}
