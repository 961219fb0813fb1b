#include "tests/support/trying_cameras.h"

#include <array>
#include <cmath>
#include <map>
#include <random>

#include "accel/locate.h"
#include "tests/render/walk_paths.h"
#include "tests/support/rounded_to_float.h"

namespace enfilade::test {
namespace {

using render::Vec3d;

class CameraMaker {
public:
    CameraMaker(const accel::SceneView& scene, std::uint64_t seed) : scene_(scene), random_(seed) {}

    std::vector<TryingCamera> make(int rounds) {
        for (int round = 0; round < rounds; ++round) {
            in_every_kind_of_cell();
            for (int i = 0; i < 2; ++i) {
                on_borders();
                along_walls();
            }
            straight_and_level();
            with_all_fields_of_view();
            with_odd_sizes();
            at_vertices();
        }
        return std::move(cameras_);
    }

private:
    struct Side {
        Vec3d p, q;
        const accel::Cell* cell;
    };

    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    std::uint32_t any_cell() { return static_cast<std::uint32_t>(random_() % scene_.cells.size()); }
    Vec3d inside(std::uint32_t cell) { return random_point(scene_, cell, random_); }

    Side any_side(std::uint32_t c) {
        const accel::Cell& cell = scene_.cells[c];
        const auto i = static_cast<std::uint32_t>(random_() % cell.section_count);
        const std::uint32_t p = cell.first_section + i, q = cell.first_section + (i + 1) % cell.section_count;
        const double z = 0.5 * (double{cell.z_floor} + double{cell.z_ceiling});
        return {{scene_.section_x[p], scene_.section_y[p], z}, {scene_.section_x[q], scene_.section_y[q], z}, &cell};
    }

    void add(const std::string& name, Vec3d eye, Vec3d view, double fov, bool on_border, int width = 97,
             int height = 61) {
        eye = rounded_to_float(eye);
        if (!accel::locate(scene_, {eye.x, eye.y, eye.z})) return;
        render::Camera camera;
        camera.eye = eye;
        camera.target = eye + view;
        if (view.x == 0 && view.y == 0) camera.up = {0, 1, 0};
        camera.fov_deg = fov;
        camera.width = width;
        camera.height = height;
        cameras_.push_back({name, camera, on_border});
    }

    void in_every_kind_of_cell() {
        std::map<accel::Label, std::vector<std::uint32_t>> cells;
        for (std::uint32_t c = 0; c < scene_.cells.size(); ++c) cells[scene_.cells[c].label].push_back(c);
        for (const auto& [label, of_label] : cells)
            for (int i = 0; i < 2; ++i) {
                Vec3d view = random_direction(random_);
                if (i == 0) view.z *= 0.2;
                add(std::string("in ") + accel::name_of(label), inside(of_label[random_() % of_label.size()]), view,
                    uniform(40, 110), false);
            }
    }

    void on_borders() {
        const Side side = any_side(any_cell());
        const Vec3d view = random_direction(random_);
        const double low = side.cell->z_floor, high = side.cell->z_ceiling;
        const Vec3d between = side.p + uniform(0.2, 0.8) * (side.q - side.p);
        add("on a side", between, view, 90, true);
        add("on a vertical line", side.p, view, 90, true);
        add("at a corner", {side.p.x, side.p.y, low}, view, 90, true);
        add("at an upper corner", {side.p.x, side.p.y, high}, view, 90, true);
        add("on an edge of the floor", {between.x, between.y, low}, view, 90, true);
        Vec3d on_floor = inside(any_cell());
        const std::uint32_t c =
            static_cast<std::uint32_t>(index(*accel::locate(scene_, {on_floor.x, on_floor.y, on_floor.z})));
        on_floor.z = scene_.cells[c].z_floor;
        add("on a floor plane", on_floor, view, 90, true);
        on_floor.z = scene_.cells[c].z_ceiling;
        add("on a ceiling plane", on_floor, view, 90, true);
    }

    void along_walls() {
        const Side side = any_side(any_cell());
        const Vec3d along = side.q - side.p;
        const Vec3d inwards = normalized(Vec3d{-along.y, along.x, 0});
        const Vec3d p = side.p + uniform(0.1, 0.4) * along;
        add("along a wall, a unit away", p + scene_.unit * inwards, along, 60, true);
        add("along a wall, 1 cm away", p + 0.01 * inwards, along, 60, false);
        add("along a wall, backwards", p + 0.01 * inwards, -along, 60, false);
    }

    void straight_and_level() {
        for (const Vec3d view : {Vec3d{1, 0, 0}, Vec3d{-1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, -1, 0}, Vec3d{0, 0, 1},
                                 Vec3d{0, 0, -1}, Vec3d{1, 1, 0}}) {
            add("along an axis", inside(any_cell()), view, 75, false);
            add("along an axis, from the grid", centre_on_grid(any_cell()), view, 90, false, 65, 65);
        }
    }

    Vec3d centre_on_grid(std::uint32_t cell) {
        const Vec3d p = centre_of(scene_, cell);
        const auto on_grid = [&](double v) { return std::floor(v / scene_.unit) * scene_.unit; };
        return {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
    }

    void with_all_fields_of_view() {
        for (const double fov : {1.0, 5.0, 30.0, 120.0, 150.0, 170.0})
            add("with a field of view of " + std::to_string(int(fov)), inside(any_cell()), level_view(), fov, false);
    }

    Vec3d level_view() {
        const double angle = uniform(0, 6.28);
        return {std::cos(angle), std::sin(angle), uniform(-0.3, 0.3)};
    }

    void with_odd_sizes() {
        constexpr std::array<std::array<int, 2>, 10> sizes = {
            {{1, 1}, {3, 5}, {2, 1}, {1, 64}, {17, 1000}, {1000, 17}, {63, 65}, {129, 31}, {8, 8}, {256, 16}}};
        for (const auto& [width, height] : sizes)
            add(std::to_string(width) + " x " + std::to_string(height) + " pixels", inside(any_cell()), level_view(),
                75, false, width, height);
    }

    void at_vertices() {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t c = any_cell();
            const Side side = any_side(c);
            const Vec3d eye = centre_on_grid(c);
            const Vec3d vertex = {side.p.x, side.p.y,
                                  i == 0   ? side.p.z
                                  : i == 1 ? side.cell->z_floor
                                           : side.cell->z_ceiling};
            if (!(length(vertex - eye) > 0)) continue;
            if (vertex.x == eye.x && vertex.y == eye.y) continue;
            add("straight at a vertex", eye, vertex - eye, 5, false, 33, 33);
        }
    }

    const accel::SceneView& scene_;
    std::mt19937_64 random_;
    std::vector<TryingCamera> cameras_;
};

}  // namespace

std::vector<TryingCamera> trying_cameras(const accel::SceneView& scene, std::uint64_t seed, int rounds) {
    return CameraMaker(scene, seed).make(rounds);
}

std::vector<AlignedFrame> aligned_frames(const accel::SceneView& scene, std::uint32_t c, int level) {
    std::vector<AlignedFrame> frames;
    const accel::Cell& cell = scene.cells[c];
    const Vec3d centre = centre_of(scene, c);
    const auto on_grid = [&](double v) { return std::floor(v / scene.unit) * scene.unit; };
    const Vec3d eye = {on_grid(centre.x), on_grid(centre.y), on_grid(centre.z)};
    if (!accel::contains(scene, static_cast<accel::CellId>(c), {eye.x, eye.y, eye.z})) return frames;
    const double step = std::ldexp(1.0, -level);
    for (std::uint32_t i = 0; i < cell.section_count; ++i) {
        const std::uint32_t a = cell.first_section + i, b = cell.first_section + (i + 1) % cell.section_count;
        const Vec3d p = {scene.section_x[a], scene.section_y[a], cell.z_floor};
        const Vec3d du = step * Vec3d{double{scene.section_x[b]} - p.x, double{scene.section_y[b]} - p.y, 0};
        const Vec3d dv = step * Vec3d{0, 0, double{cell.z_ceiling} - double{cell.z_floor}};
        const Vec3d corner = p - eye - 0.5 * du - 0.5 * dv;
        const int pixels = (1 << level) + 1;
        frames.push_back({{render::vec_cast<float>(eye), render::vec_cast<float>(corner), render::vec_cast<float>(du),
                           render::vec_cast<float>(dv)},
                          static_cast<accel::CellId>(c),
                          pixels,
                          pixels});
    }
    return frames;
}

}  // namespace enfilade::test
