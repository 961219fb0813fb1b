#include "modeler/catalogue/manifold.h"

#include <algorithm>

#include "base/disjoint_sets.h"

namespace enfilade::modeler {
namespace {

/// A side of a triangle, from the lower to the higher of its vertices.
struct Side {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
    std::uint32_t corner;  ///< where it begins in its triangle
    bool upward;           ///< it runs from low to high

    [[nodiscard]] bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
    friend bool operator<(const Side& a, const Side& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        if (a.upward != b.upward) return a.upward;
        return a.triangle < b.triangle;
    }
};

std::vector<Side> sorted_sides(const ObjectMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k];
            const std::uint32_t b = mesh.triangles[t][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
        }
    std::sort(sides.begin(), sides.end());
    return sides;
}

}  // namespace

std::string why_no_manifold(const ObjectMesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles)
        if (a == b || b == c || c == a) return "a triangle has two corners at one place";
    const std::vector<Side> sides = sorted_sides(mesh);
    DisjointSets corners(mesh.triangles.size() * 3);  // those of one vertex that are joined by edges
    const auto corner = [&](const Side& side, bool at_end) {
        return side.triangle * 3 + (side.corner + (at_end ? 1 : 0)) % 3;
    };
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
        const Side& side = sides[k];
        const Side& next = sides[k + 1];
        if (!side.same_edge(next)) continue;
        if (k + 2 < sides.size() && side.same_edge(sides[k + 2])) return "an edge belongs to three triangles or more";
        if (side.upward == next.upward) return "two triangles run along their edge the same way";
        corners.join(corner(side, false), corner(next, true));
        corners.join(corner(side, true), corner(next, false));
    }
    std::vector<std::uint32_t> fan(mesh.vertices.size(), UINT32_MAX);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            std::uint32_t& first = fan[mesh.triangles[t][k]];
            const std::uint32_t here = corners.find(t * 3 + k);
            if (first == UINT32_MAX) first = here;
            else if (first != here) return "sheets meet at a vertex and share no edge there";
        }
    return {};
}

}  // namespace enfilade::modeler
