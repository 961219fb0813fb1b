#pragma once
// What light does not pass: walls, slabs and ground as prisms, for those who ask what lies behind a face. A scene's
// trace group holds none of them; its model group does (modeler/solids.h).

#include <array>
#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/ray.h"

namespace enfilade::render {

/// A solid over a simple polygon, concave or not, between two heights; metres, scene frame.
struct SolidPrism {
    std::uint32_t first_corner = 0;  ///< into the corners given with it
    std::uint32_t corner_count = 0;  ///< counter-clockwise, closed by the first one
    double z_low = 0;
    double z_high = 0;
    accel::Label label = accel::Label::Wall;
    accel::SpaceId space = none<accel::SpaceId>;  ///< the wall or slab it belongs to, of the scene's spaces
};

/// Where a line runs through one of them, in units of the ray's (scaled) direction.
struct SolidStretch {
    double enter, leave;
    std::uint32_t prism;
};

/// Disjoint solids, to be asked by rays. Read by any number of threads at once.
class Solids {
public:
    Solids() = default;
    /// \pre shares of `corners` are within it, coordinates are finite
    Solids(std::vector<SolidPrism> prisms, std::vector<std::array<double, 2>> corners);

    [[nodiscard]] const std::vector<SolidPrism>& prisms() const { return prisms_; }

    /// Whether the point lies in the box around all of them.
    [[nodiscard]] bool are_around(const Vec3d& point) const;

    /// What the ray meets of them between its parameters `from` and `to`, in order. Empties `found` first.
    void along(const Ray<double>& ray, double from, double to, std::vector<SolidStretch>& found) const;

private:
    struct Node {
        std::array<double, 3> low, high;
        std::uint32_t skip;          ///< the next node where this one is missed; depth-first order
        std::uint32_t first, count;  ///< of order_; 0 in inner nodes
    };
    void build(std::uint32_t begin, std::uint32_t end);
    void add_stretches(const Ray<double>& ray, std::uint32_t prism, double from, double to,
                       std::vector<SolidStretch>& found) const;
    [[nodiscard]] bool stands_over(const SolidPrism& prism, double x, double y) const;

    std::vector<SolidPrism> prisms_;
    std::vector<std::array<double, 2>> corners_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace enfilade::render
