#pragma once
// The cells that sunlight crosses on its way to a place.

#include <cstdint>
#include <vector>

#include "accel/beam.h"

namespace enfilade::modeler {

/// Follows all rays of one direction at once: seen along it, a place and the portals in its way are convex polygons,
/// and what gets through is what they have in common.
class SunPaths {
public:
    /// sun: towards it, of any length but 0. margin: metres by which rays may pass beside a portal's edge
    SunPaths(const accel::SceneView& scene, const std::array<double, 3>& sun, double margin);

    /// Sets `is_crossed` for every cell that a ray from the region crosses, if it comes to the sky: others are dark
    /// whatever stands in their way. is_crossed: [cell]
    void mark(const accel::BeamSource& region, std::vector<char>& is_crossed);

private:
    /// A place on the plane across the light.
    struct Spot {
        double u, v;
        friend bool operator==(const Spot&, const Spot&) = default;
    };
    using Polygon = std::vector<Spot>;  ///< convex, counter-clockwise; one or two corners where it has no area

    [[nodiscard]] Spot seen_at(double x, double y, double z) const;
    [[nodiscard]] static Polygon hull(Polygon spots);
    [[nodiscard]] Polygon common(const Polygon& light, const Polygon& gate) const;
    /// Whether any of the light that comes into the cell gets to the sky.
    bool follow(std::uint32_t cell, const Polygon& light);
    bool follow_side(std::uint32_t cell, std::uint32_t section, std::uint32_t next, const Polygon& light);
    bool follow_level(std::uint32_t cell, accel::Target target, double z, const Polygon& light);
    bool pass(accel::Target target, const Polygon& light);

    accel::SceneView scene_;
    std::array<double, 3> sun_;  ///< of length 1
    std::array<double, 3> u_, v_;
    double margin_;
    std::vector<char>* is_crossed_ = nullptr;
    std::vector<char> is_on_path_;  ///< [cell]
};

}  // namespace enfilade::modeler
