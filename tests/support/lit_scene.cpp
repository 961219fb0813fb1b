#include "tests/support/lit_scene.h"

#include <cmath>
#include <optional>
#include <random>

#include "accel/locate.h"

namespace enfilade::test {
namespace {

using render::Vec3d;
using render::Vec3f;

/// Numbers in [0, 1), the same everywhere.
class Draws {
public:
    explicit Draws(std::uint64_t seed) : random_(seed) {}
    double next() { return static_cast<double>(random_() >> 40) * 0x1p-24; }
    std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(next() * static_cast<double>(count)); }

private:
    std::mt19937_64 random_;
};

/// A point of the cell's plan: a mixture of its corners.
Vec3d point_in(const accel::SceneView& view, const accel::Cell& cell, Draws& draws) {
    double x = 0, y = 0, sum = 0;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        const double share = 0.001 + draws.next() * draws.next();
        x += share * double{view.section_x[s]};
        y += share * double{view.section_y[s]};
        sum += share;
    }
    return {x / sum, y / sum, 0};
}

bool is_outdoors(const accel::Cell& cell) { return cell.label == accel::Label::Exterior; }

}  // namespace

void LitScene::add_lamp(Vec3d position, Vec3f candela, accel::ObjectId carrier) {
    accel::Light light = {};
    light.position = {static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)};
    light.intensity = {candela.x, candela.y, candela.z};
    const auto& p = light.position;
    light.cell = accel::locate(scene_.view(), {p[0], p[1], p[2]}).value_or(none<accel::CellId>);
    light.carrier = carrier;
    lights_.push_back(light);
}

void LitScene::add_random_lamps(int count, std::uint64_t seed, bool indoors) {
    const accel::SceneView& bare = scene_.view();
    Draws draws(seed);
    for (int i = 0; i < count;) {
        const accel::Cell& cell = bare.cells[draws.below(bare.cells.size())];
        if (indoors && is_outdoors(cell)) continue;
        const double height = double{cell.z_ceiling} - double{cell.z_floor};
        Vec3d at = point_in(bare, cell, draws);
        at.z = i % 9 == 7   ? double{cell.z_floor}
               : i % 9 == 8 ? double{cell.z_ceiling}
                            : double{cell.z_ceiling} - draws.next() * height;
        const auto part = [&] { return static_cast<float>(20 + 100 * draws.next()); };
        const float r = part(), g = part(), b = part();
        add_lamp(at, {r, g, b});
        ++i;
    }
}

accel::SceneView LitScene::view() const {
    accel::SceneView view = scene_.view();
    view.lights = {lights_.data(), lights_.size()};
    return view;
}

std::vector<OpenPlace> open_places(const accel::SceneView& view, int count, std::uint64_t seed) {
    Draws draws(seed);
    std::vector<OpenPlace> places;
    while (places.size() < static_cast<std::size_t>(count)) {
        const std::uint32_t c = draws.below(view.cells.size());
        const accel::Cell& cell = view.cells[c];
        // Most of them where lamps are; the exterior is large.
        if (is_outdoors(cell) && draws.next() < 0.7) continue;
        Vec3d at = point_in(view, cell, draws);
        const double height = double{cell.z_ceiling} - double{cell.z_floor};
        at.z = double{cell.z_floor} + draws.next() * height;
        Vec3f normal = {0, 0, 0};
        const std::uint32_t kind = draws.below(4);
        if (kind == 1 && cell.floor.is_portal()) continue;
        if (kind == 1) {
            at.z = double{cell.z_floor};
            normal = {0, 0, 1};
        }
        if (kind >= 2) {
            const std::uint32_t s = draws.below(cell.section_count), first = cell.first_section;
            const std::uint32_t i = first + s, j = first + (s + 1) % cell.section_count;
            const double u = draws.next(), px = view.section_x[i], py = view.section_y[i];
            const double ex = view.section_x[j] - px, ey = view.section_y[j] - py;
            const double metres = std::hypot(ex, ey);
            if (!(metres > 1e-3)) continue;
            at.x = px + u * ex;
            at.y = py + u * ey;
            normal = {static_cast<float>(-ey / metres), static_cast<float>(ex / metres), 0};
        }
        places.push_back({{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)}, normal, c});
    }
    return places;
}

}  // namespace enfilade::test
