#include "tools/report/object_signs.h"

#include <algorithm>
#include <cmath>

namespace enfilade::tools {
namespace {

std::int64_t millimetres(double metres) { return std::llround(1000 * metres); }

/// The lowest floor of a storey's rooms; 0 where it has none.
double floor_of(const accel::SceneView& scene, std::uint32_t storey_index) {
    double floor = INFINITY;
    for (const accel::Cell& cell : scene.cells)
        if (cell.label == accel::Label::Room && scene.spaces[index(cell.space)].storey_index == storey_index)
            floor = std::min(floor, double{cell.z_floor});
    return std::isfinite(floor) ? floor : 0;
}

}  // namespace

SvgPath object_paths(const PlanView& view, std::uint32_t storey) {
    SvgPath path;
    const modeler::Building& building = view.building();
    const double floor = building.frame.world_z(building.storeys[storey].z_floor);
    for (const modeler::FurnishedObject& object : building.furnishing.objects) {
        if (building.spaces[object.space].storey != storey || object.position[2] - floor >= drawn_below ||
            std::max(object.size[0], object.size[1]) < least_drawn)
            continue;
        const double c = std::cos(object.angle), s = std::sin(object.angle);
        add_object_sign(path, [&](double x, double y) {
            const double u = x * object.size[0] / 2, v = y * object.size[1] / 2;
            return view.mm(object.position[0] + c * u - s * v, object.position[1] + s * u + c * v);
        });
    }
    return path;
}

SvgPath object_paths(const accel::SceneView& scene, std::uint32_t storey_index) {
    SvgPath path;
    const double floor = floor_of(scene, storey_index);
    for (const accel::PlacedObject& object : scene.objects) {
        const accel::ObjectMesh& mesh = scene.meshes[index(object.mesh)];
        if (mesh.triangle_count == 0 || scene.spaces[index(object.space)].storey_index != storey_index ||
            double{object.low[2]} - floor >= drawn_below)
            continue;
        const std::array<float, 12>& m = object.scene_from_object.rows;
        const auto corner = [&](double x, double y) {
            const double u = (mesh.low[0] + mesh.high[0]) / 2 + x * (mesh.high[0] - mesh.low[0]) / 2;
            const double v = (mesh.low[1] + mesh.high[1]) / 2 + y * (mesh.high[1] - mesh.low[1]) / 2;
            const double w = (mesh.low[2] + mesh.high[2]) / 2;
            return Mm{millimetres(m[0] * u + m[1] * v + m[2] * w + m[3]),
                      millimetres(m[4] * u + m[5] * v + m[6] * w + m[7])};
        };
        const Mm a = corner(-1, -1), b = corner(1, -1), d = corner(-1, 1);
        const double width = std::hypot(double(b.x - a.x), double(b.y - a.y));
        const double depth = std::hypot(double(d.x - a.x), double(d.y - a.y));
        if (std::max(width, depth) >= 1000 * least_drawn) add_object_sign(path, corner);
    }
    return path;
}

}  // namespace enfilade::tools
