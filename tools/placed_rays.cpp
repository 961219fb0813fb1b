#include "tools/placed_rays.h"

#include <cmath>
#include <limits>

#include "render/crossings.h"

namespace enfilade::tools {
namespace {

using render::Vec3d;

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Directions beyond this power of two, up or down, are scaled: float holds no 1e-300.
constexpr int largest_exponent = 40;

/// The same direction at a length that float holds; zero stays zero.
Vec3d scaled_for_float(Vec3d d) {
    const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    if (!(largest > 0) || !(largest < infinite)) return d;
    const int exponent = std::ilogb(largest);
    if (std::abs(exponent) <= largest_exponent) return d;
    return {std::scalbn(d.x, -exponent), std::scalbn(d.y, -exponent), std::scalbn(d.z, -exponent)};
}

bool is_ray(const PlacedRay& ray) {
    const Vec3d &o = ray.origin, &d = ray.direction;
    const bool is_finite = std::abs(o.x) <= 1e12 && std::abs(o.y) <= 1e12 && std::abs(o.z) <= 1e12 &&
                           std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z);
    return is_finite && d != Vec3d{0, 0, 0} && ray.max_distance >= 0;
}

/// Beyond the box of all cells, but for what lies under it: that is ground.
bool is_beyond(const accel::SceneView& scene, const Vec3d& p) {
    if (scene.locator_nodes.empty()) return true;
    const accel::LocatorNode& site = scene.locator_nodes[0];
    return p.x < site.low[0] || p.x > site.high[0] || p.y < site.low[1] || p.y > site.high[1] || p.z > site.high[2];
}

/// A ray whose origin no cell holds.
void place_outside_cells(const accel::SceneView& scene, PlacedRay& ray) {
    render::FirstEntry entry;
    if (!render::first_entry(scene, ray.origin, ray.direction, entry)) {
        ray.start = is_beyond(scene, ray.origin) ? Start::Nowhere : Start::Wall;
        return;
    }
    if (entry.through_sky) {
        ray.start = Start::Site;
        ray.cell = entry.cell;
        ray.advance = entry.distance;
    } else if (entry.depth <= start_tolerance) {
        ray.start = Start::Face;
        ray.cell = entry.cell;
    }
}

}  // namespace

void place_rays(const accel::SceneView& scene, const accel::PointGrid& grid, std::span<const double> numbers,
                std::size_t columns, std::vector<PlacedRay>& rays) {
    rays.clear();
    accel::CellId near = none<accel::CellId>;  ///< that holds near_origin
    Vec3d near_origin = {0, 0, 0};
    for (const double* n = numbers.data(); n != numbers.data() + numbers.size(); n += columns) {
        PlacedRay ray = {{n[0] - scene.origin[0], n[1] - scene.origin[1], n[2] - scene.origin[2]},
                         scaled_for_float({n[3], n[4], n[5]}),
                         columns > 6 ? n[6] : infinite,
                         0,
                         none<accel::CellId>,
                         Start::Refused};
        if (is_ray(ray)) {
            const bool is_same = near != none<accel::CellId> && ray.origin == near_origin;  // one source, many rays
            ray.cell = is_same ? near : grid.find({ray.origin.x, ray.origin.y, ray.origin.z}, near);
            ray.start = ray.cell != none<accel::CellId> ? Start::Cell : Start::Wall;
            if (ray.cell != none<accel::CellId>) {
                near = ray.cell;
                near_origin = ray.origin;
            } else {
                place_outside_cells(scene, ray);
            }
        }
        rays.push_back(ray);
    }
}

}  // namespace enfilade::tools
