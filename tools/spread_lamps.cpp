#include "tools/spread_lamps.h"

#include <algorithm>
#include <array>

namespace enfilade::tools {

namespace {

using render::Vec3d;

Vec3d corner(const accel::SceneView& scene, const accel::Cell& cell, std::uint32_t i) {
    const std::uint32_t s = cell.first_section + i % cell.section_count;
    return {scene.section_x[s], scene.section_y[s], cell.z_floor};
}

/// Twice the area of the triangle that the cell's fan has between corners i and i + 1.
double fan_area(const accel::SceneView& scene, const accel::Cell& cell, std::uint32_t i) {
    const Vec3d a = corner(scene, cell, 0), b = corner(scene, cell, i), c = corner(scene, cell, i + 1);
    return std::max(0.0, (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
}

bool suits(const accel::Cell& cell, LampPlaces places) {
    return cell.label == (places == LampPlaces::Outside ? accel::Label::Exterior : accel::Label::Room);
}

/// Warm, neutral, cold.
constexpr std::array<std::array<float, 3>, 3> hues = {{{100, 82, 60}, {100, 96, 88}, {84, 94, 110}}};

accel::Light lamp_in(const accel::SceneView& scene, std::uint32_t c, LampPlaces places, std::size_t number,
                     plans::Random& random) {
    const accel::Cell& cell = scene.cells[c];
    const Vec3d place = random_place(scene, cell, 0.1, random);
    const double height = double(cell.z_ceiling) - cell.z_floor;
    const double up = places == LampPlaces::Outside
                          ? std::min(4.0, height / 2)
                          : height - std::min(places == LampPlaces::Hanging ? 0.7 : 0.1, height / 2);
    accel::Light light = {};
    light.position = {float(place.x), float(place.y), float(cell.z_floor + up)};
    light.intensity = hues[number % hues.size()];
    light.cell = static_cast<accel::CellId>(c);
    light.carrier = none<accel::ObjectId>;
    light.id = light.name = none<accel::TextId>;
    return light;
}

}  // namespace

double floor_area(const accel::SceneView& scene, const accel::Cell& cell) {
    double twice = 0;
    for (std::uint32_t i = 1; i + 1 < cell.section_count; ++i) twice += fan_area(scene, cell, i);
    return twice / 2;
}

Vec3d random_place(const accel::SceneView& scene, const accel::Cell& cell, double inset, plans::Random& random) {
    double left = random.uniform() * 2 * floor_area(scene, cell);
    std::uint32_t i = 1;
    while (i + 2 < cell.section_count && left >= fan_area(scene, cell, i)) left -= fan_area(scene, cell, i++);
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3d a = corner(scene, cell, 0), b = corner(scene, cell, i), c = corner(scene, cell, i + 1);
    const Vec3d any = a + u * (b - a) + v * (c - a);
    Vec3d middle = {0, 0, 0};
    for (std::uint32_t k = 0; k < cell.section_count; ++k)
        middle = middle + (1.0 / cell.section_count) * corner(scene, cell, k);
    const double height = double(cell.z_ceiling) - cell.z_floor;
    Vec3d place = any + inset * (middle - any);
    place.z = cell.z_floor + height * random.uniform(inset / 2, 1 - inset / 2);
    return place;
}

std::vector<accel::Light> spread_lamps(const accel::SceneView& scene, std::size_t count, LampPlaces places) {
    double all = 0;
    for (const accel::Cell& cell : scene.cells) all += suits(cell, places) ? floor_area(scene, cell) : 0;
    std::vector<accel::Light> lamps;
    double passed = 0;
    plans::Random random{8, count};
    for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
        if (!suits(scene.cells[c], places)) continue;
        passed += floor_area(scene, scene.cells[c]);
        while (lamps.size() < count && (double(lamps.size()) + 0.5) * all < passed * double(count))
            lamps.push_back(lamp_in(scene, c, places, lamps.size(), random));
    }
    return lamps;
}

accel::SceneView with_lamps(const accel::SceneView& scene, const std::vector<accel::Light>& lamps) {
    accel::SceneView lit = scene;
    lit.lights = {lamps.data(), lamps.size()};
    return lit;
}

}  // namespace enfilade::tools
