#pragma once
// Whether two flat faces of a shell meet elsewhere than in what they share, exactly.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "modeler/constraints/box_pairs.h"
#include "modeler/constraints/exact3.h"

namespace enfilade::modeler {

/// A flat, simple polygon with what every question about it needs.
struct FlatFace {
    /// \pre coordinates within +-2^28. Corners on one line give a face without extent, which meets nothing.
    FlatFace(std::span<const std::uint32_t> corners, const std::vector<Point3>& points);

    [[nodiscard]] bool has(std::uint32_t vertex) const;
    /// Whether its border goes from p to q or back.
    [[nodiscard]] bool has_edge(std::uint32_t p, std::uint32_t q) const;
    [[nodiscard]] __int128 height(const Point3& p) const { return height_over(origin, normal, p); }

    std::span<const std::uint32_t> ring;  ///< vertex ids around it: equal ids are shared vertices
    std::vector<std::uint32_t> sorted;    ///< the same, ascending
    GridBox box;
    bool has_extent = false;
    Point3 origin = {};
    std::array<std::int64_t, 3> normal = {};
    std::size_t u = 0, v = 1;  ///< the axes along which it is seen best: u, v and the steepest are right-handed
};

/// A point (grid units, rounded) in which the closed polygons `a` and `b` meet other than in vertices and edges that
/// both have; nothing where they do not. Faces that lie on one another count, and a face that touches the other with
/// its mere corner. Cost: the edges within the other's box, each times the corners of the other face where it reaches
/// its plane.
[[nodiscard]] std::optional<std::array<double, 3>> meeting_point(const FlatFace& a, const FlatFace& b,
                                                                 const std::vector<Point3>& points);

}  // namespace enfilade::modeler
