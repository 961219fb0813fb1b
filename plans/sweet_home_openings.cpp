// Which wall a door stands in.
#include <algorithm>
#include <cmath>

#include "plans/sweet_home_bodies.h"
#include "plans/sweet_home_parts.h"
#include "plans/vector2.h"

namespace enfilade::plans {

void bind_openings(Storey& storey, std::vector<PlacedOpening> placed, Home& home) {
    std::vector<WallBody> bodies(storey.walls.begin(), storey.walls.end());
    for (PlacedOpening& door : placed) {
        const PlanRectangle box{door.middle, {std::cos(door.angle), std::sin(door.angle)}, door.width, door.depth};
        double best = 1e-6;
        std::size_t host = bodies.size();
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            if (!bodies[k].usable) continue;
            const double area = bodies[k].overlap(box);
            if (area > best && std::abs(dot(bodies[k].along(bodies[k].axis.nearest(door.middle)), box.along)) > 0.9) {
                best = area;
                host = k;
            }
        }
        if (host == bodies.size()) {
            home.report(finding_at(storey, "P172", Severity::Error,
                                   "The door \"" + door.opening.name + "\" at " + place_text(door.middle) +
                                       " stands in no wall; it is left out.",
                                   "Move it into a wall in Sweet Home 3D.",
                                   {"opening", door.opening.id, door.opening.name}, door.middle));
            continue;
        }
        door.opening.wall = storey.walls[host].id;
        door.opening.offset = bodies[host].offset_of(door.wall_middle);
        storey.openings.push_back(std::move(door.opening));
    }
}

}  // namespace enfilade::plans
