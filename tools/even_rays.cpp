#include "tools/even_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "accel/locate.h"

namespace enfilade::tools {

using render::Vec3d;

namespace {

/// To what float holds, so that every scene is asked for the same ray.
Vec3d rounded(Vec3d v) { return render::vec_cast<double>(render::vec_cast<float>(v)); }

/// Triangles of the cells' floors, by the volume that stands over them.
class EvenPlaces {
public:
    explicit EvenPlaces(const accel::SceneView& scene) : scene_(scene) {
        const bool has_room = std::any_of(scene.cells.begin(), scene.cells.end(),
                                          [](const accel::Cell& cell) { return cell.label == accel::Label::Room; });
        for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
            const accel::Cell& cell = scene.cells[c];
            if (has_room && cell.label != accel::Label::Room) continue;
            for (std::uint32_t s = cell.first_section + 1; s + 1 < cell.first_section + cell.section_count; ++s) {
                total_ += std::max(0.0, area(cell.first_section, s) * (double(cell.z_ceiling) - cell.z_floor));
                triangles_.push_back({total_, c, s});
            }
        }
    }

    [[nodiscard]] Vec3d at(double share, double u, double v, double w) const {
        const auto found = std::lower_bound(triangles_.begin(), triangles_.end(), share * total_,
                                            [](const Triangle& triangle, double sum) { return triangle.sum < sum; });
        const Triangle& triangle = found == triangles_.end() ? triangles_.back() : *found;
        const accel::Cell& cell = scene_.cells[triangle.cell];
        const Vec3d a = corner(cell.first_section), b = corner(triangle.section), c = corner(triangle.section + 1);
        const double r = std::sqrt(u);
        Vec3d place = (1 - r) * a + (r * (1 - v)) * b + (r * v) * c;
        place.z = cell.z_floor + w * (double(cell.z_ceiling) - cell.z_floor);
        return place;
    }

private:
    struct Triangle {
        double sum;  ///< of the volumes up to and with this one
        std::uint32_t cell, section;
    };
    [[nodiscard]] Vec3d corner(std::uint32_t s) const { return {scene_.section_x[s], scene_.section_y[s], 0}; }
    [[nodiscard]] double area(std::uint32_t first, std::uint32_t s) const {
        const Vec3d a = corner(first), b = corner(s), c = corner(s + 1);
        return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }

    const accel::SceneView& scene_;
    std::vector<Triangle> triangles_;
    double total_ = 0;
};

}  // namespace

std::vector<render::RayQuery> even_rays(const accel::SceneView& scene, std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&random] { return double(random() >> 11) * 0x1p-53; };
    const EvenPlaces places(scene);
    std::vector<render::RayQuery> rays;
    rays.reserve(count);
    while (rays.size() < count) {
        const double share = uniform(), u = uniform(), v = uniform(), w = uniform();
        const Vec3d origin = rounded(places.at(share, u, v, w));
        const double z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform();
        const double r = std::sqrt(1 - z * z);
        const Vec3d direction = rounded({r * std::cos(angle), r * std::sin(angle), z});
        if (const auto cell = accel::locate(scene, {origin.x, origin.y, origin.z}))
            rays.push_back({origin, direction, *cell});
    }
    return rays;
}

std::vector<std::vector<render::RayQuery>> rays_in_all(std::span<const accel::SceneView* const> scenes,
                                                       std::span<const render::RayQuery> rays) {
    std::vector<std::vector<render::RayQuery>> found(scenes.size());
    std::vector<accel::CellId> cells(scenes.size());
    for (const render::RayQuery& ray : rays) {
        bool in_all = true;
        for (std::size_t k = 0; k < scenes.size() && in_all; ++k) {
            const auto cell = accel::locate(*scenes[k], {ray.origin.x, ray.origin.y, ray.origin.z});
            in_all = cell.has_value();
            if (in_all) cells[k] = *cell;
        }
        for (std::size_t k = 0; k < scenes.size() && in_all; ++k) {
            found[k].push_back(ray);
            found[k].back().cell = cells[k];
        }
    }
    return found;
}

}  // namespace enfilade::tools
