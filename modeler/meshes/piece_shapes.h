#pragma once
// Measures of closed surfaces: how much they enclose, and what lies inside of them.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modeler/meshes/mesh_solids.h"

namespace enfilade::modeler {

struct PieceShape {
    std::array<double, 3> low{}, high{};
    double volume = 0;  ///< with the first face's side as the outside; its sign says whether that is so
    double area = 0;
    std::uint32_t outward = 0;  ///< faces whose ring runs counter-clockwise seen from outside
    std::uint32_t inward = 0;
    bool whole = false;  ///< closed, and each of its faces has triangles: the numbers above mean something

    [[nodiscard]] bool has_volume() const;
};

/// The triangles of each piece, and what they measure.
class PieceShapes {
public:
    PieceShapes(const Mesh& mesh, const MeshTriangles& triangles, const MeshPieces& pieces);

    [[nodiscard]] const PieceShape& operator[](std::uint32_t piece) const { return shapes_[piece]; }
    [[nodiscard]] std::span<const std::uint32_t> triangles_of(std::uint32_t piece) const {
        return std::span(items_).subspan(first_[piece], first_[piece + 1] - first_[piece]);
    }
    /// Where a point lies; `On`: nearer to the surface than `touching_distance`.
    enum class Side : std::uint8_t { Outside, Inside, On };
    [[nodiscard]] Side side(std::uint32_t piece, const std::array<double, 3>& point) const;
    /// A ring of the face turns so that it is counter-clockwise from outside.
    [[nodiscard]] bool faces_outward(std::uint32_t face) const;

private:
    void measure(std::uint32_t piece);

    const Mesh& mesh_;
    const MeshTriangles& triangles_;
    const MeshPieces& pieces_;
    std::vector<std::uint32_t> first_, items_;
    std::vector<PieceShape> shapes_;
    double touching_;
};

}  // namespace enfilade::modeler
