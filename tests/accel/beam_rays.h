#pragma once
// Rays that judge beams: whatever cell a ray enters, the beam from where it starts must have got there.

#include <set>
#include <string>

#include "accel/beam.h"
#include "tests/render/walk_paths.h"

namespace enfilade::test {

/// A ray in a cell, double precision.
struct TestRay {
    render::Vec3d origin;
    render::Vec3d direction;
    std::uint32_t cell;
};

/// The cells that a ray enters, by the walk in double precision.
inline std::vector<std::uint32_t> cells_of(const accel::SceneView& scene, const TestRay& test) {
    render::Ray<double> ray;
    if (!render::make_ray(test.origin, test.direction, ray)) return {};
    return follow(scene, ray, test.cell).path.cells;
}

/// How many of them are not among `reached`, and which was the first.
class Misses {
public:
    explicit Misses(const accel::SceneView& scene) : scene_(scene) {}

    void judge(const std::vector<accel::CellId>& reached, const TestRay& ray) {
        ++rays_;
        for (const std::uint32_t cell : cells_of(scene_, ray)) {
            entered_.insert(cell);
            if (std::ranges::binary_search(reached, accel::CellId{cell})) continue;
            if (count_++ == 0)
                first_ = "cell " + std::to_string(cell) + " from cell " + std::to_string(ray.cell) + " at " +
                         text_of(ray.origin) + " towards " + text_of(ray.direction);
        }
    }
    [[nodiscard]] std::size_t rays() const { return rays_; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] const std::string& first() const { return first_; }
    /// All cells that rays have entered since `forget_entered`.
    [[nodiscard]] const std::set<std::uint32_t>& entered() const { return entered_; }
    void forget_entered() { entered_.clear(); }

private:
    static std::string text_of(const render::Vec3d& v) {
        char text[96];
        std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
        return text;
    }
    const accel::SceneView& scene_;
    std::set<std::uint32_t> entered_;
    std::size_t rays_ = 0;
    std::size_t count_ = 0;
    std::string first_;
};

/// Every second one nearly level, as most that see far are.
inline render::Vec3d far_direction(std::mt19937_64& random) {
    render::Vec3d d = random_direction(random);
    if (random() % 2 == 0) d.z *= 0.05;
    return d;
}

}  // namespace enfilade::test
