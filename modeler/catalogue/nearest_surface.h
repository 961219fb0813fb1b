#pragma once
// How far points are from a mesh.

#include <array>
#include <cstdint>
#include <vector>

#include "modeler/catalogue/object_mesh.h"

namespace enfilade::modeler {

/// A tree of boxes over the triangles of a mesh, which must outlive it. Triangles without area count as the segment or
/// point that they are.
class NearestSurface {
public:
    explicit NearestSurface(const ObjectMesh& mesh);

    /// The square of the distance from `p` to the surface, or `limit` where that is no smaller.
    [[nodiscard]] double distance_squared(const std::array<double, 3>& p, double limit) const;

private:
    struct Node {
        std::array<float, 3> low;
        std::array<float, 3> high;
        std::uint32_t first;  ///< of its triangles, or its left child (the right one follows)
        std::uint32_t count;  ///< 0: not a leaf
    };
    void split(std::uint32_t node, std::uint32_t first, std::uint32_t count,
               const std::vector<std::array<float, 3>>& centres);
    [[nodiscard]] double to_triangle(std::uint32_t triangle, const std::array<double, 3>& p) const;

    const ObjectMesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// The largest distance, metres, from a vertex of `reduced`, the middle of one of its sides or of a triangle to
/// `whole`, and from a vertex of `whole` to `reduced`: a sampled two-sided Hausdorff distance, from below.
[[nodiscard]] double surface_distance(const ObjectMesh& whole, const ObjectMesh& reduced);

}  // namespace enfilade::modeler
