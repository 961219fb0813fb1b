#pragma once
// Polygons of a mesh file as triangles.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modeler/catalogue/raw_mesh.h"
#include "modeler/meshes/mesh.h"

namespace enfilade::modeler {

/// Cuts one polygon into (corners - 2) triangles, whatever its shape: ears are cut off in the plane where the polygon
/// has most area; where there is no ear (crossing sides, no area) the rest becomes a fan. Triangles turn as the polygon
/// does. Corners that follow each other at one place make triangles without area: none is left out.
/// Cost: quadratic in the corners, but for convex polygons; more than 2000 corners become a fan.
class FaceTriangles {
public:
    /// Calls visit(a, b, c) with places in `corners`.
    template <class Visit>
    void cut(std::span<const std::array<double, 3>> corners, const Visit& visit) {
        if (corners.size() == 3) return visit(0u, 1u, 2u);
        find_triangles(corners);
        for (const auto& [a, b, c] : triangles_) visit(a, b, c);
    }

private:
    void find_triangles(std::span<const std::array<double, 3>> corners);
    [[nodiscard]] bool is_ear(std::size_t before, std::size_t at, std::size_t after) const;

    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::array<double, 2>> flat_;
    std::vector<std::uint32_t> left_;
};

/// The faces of a mesh file as triangles; those with a corner that is absent or no number are dropped and counted, and
/// the materials that it names are listed by their first use, without colours.
[[nodiscard]] RawMesh triangulated(const Mesh& mesh);

}  // namespace enfilade::modeler
