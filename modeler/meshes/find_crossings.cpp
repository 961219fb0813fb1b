// The pairs of triangles that cross: candidates by boxes, then CGAL's exact predicates.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "modeler/meshes/mesh_solids.h"
#include "modeler/meshes/near_boxes.h"

namespace enfilade::modeler {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

/// Thrown out of the search where a mesh has so many crossings that nobody would read on.
struct TooMany {};

class CrossingFinder {
public:
    CrossingFinder(const Mesh& mesh, const MeshTriangles& triangles, const MeshPieces& pieces,
                   const std::vector<std::uint32_t>& place)
        : mesh_(mesh), triangles_(triangles), pieces_(pieces), place_(place), touching_(touching_distance(mesh)) {}

    void search(std::uint32_t begin, std::uint32_t end) {
        std::vector<NearBox> boxes(end - begin);
        for (std::uint32_t t = begin; t < end; ++t) {
            const auto [a, b, c] = triangles_.corners[t];
            const auto &p = mesh_.points[a], &q = mesh_.points[b], &r = mesh_.points[c];
            for (std::size_t i = 0; i < 3; ++i) {
                boxes[t - begin].low[i] = NearBox::below(std::min({p[i], q[i], r[i]}));
                boxes[t - begin].high[i] = NearBox::above(std::max({p[i], q[i], r[i]}));
            }
        }
        piercing_.clear();
        budget_ = 1000 * std::uint64_t(boxes.size()) + 10'000'000;
        NearBoxes(boxes).pairs([&](std::uint32_t a, std::uint32_t b) { judge(begin + a, begin + b); });
        keep_pairs();
    }

    void keep_pairs() {
        for (const auto& [pair, pierced] : piercing_) {
            const std::pair<std::uint32_t, std::uint32_t> pieces(std::uint32_t(pair >> 32), std::uint32_t(pair));
            found.near.push_back(pieces);
            if (pierced) found.piercing.push_back(pieces);
        }
    }

    Crossings found;

private:
    [[nodiscard]] Point point(std::uint32_t t, std::size_t k) const {
        const auto& p = mesh_.points[triangles_.corners[t][k]];
        return {p[0], p[1], p[2]};
    }

    void judge(std::uint32_t a, std::uint32_t b) {
        if (budget_-- == 0) throw TooMany();
        if (a > b) std::swap(a, b);
        const std::uint32_t f = triangles_.face[a], g = triangles_.face[b];
        if (f == g) return;
        const std::uint32_t p = pieces_.piece[f], q = pieces_.piece[g];
        if (p != q) return judge_pieces(a, b, std::min(p, q), std::max(p, q));
        if (!meets(a, b)) return;
        found.within.push_back({a, b, pierces(a, b) || pierces(b, a)});
        if (found.within.size() >= 1'000'000) throw TooMany();
    }

    /// One pair of triangles is enough for a pair of pieces.
    void judge_pieces(std::uint32_t a, std::uint32_t b, std::uint32_t p, std::uint32_t q) {
        bool& known = piercing_[std::uint64_t(p) << 32 | q];
        known = known || pierces(a, b) || pierces(b, a);
    }

    /// Triangles of one surface: anything in common beyond shared corners and sides.
    [[nodiscard]] bool meets(std::uint32_t a, std::uint32_t b) const {
        std::array<std::size_t, 3> in_a{}, in_b{};
        std::size_t shared = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                if (place_[triangles_.corners[a][i]] == place_[triangles_.corners[b][j]] && shared < 3)
                    in_a[shared] = i, in_b[shared] = j, ++shared;
        switch (shared) {
            case 0:
                return CGAL::do_intersect(Kernel::Triangle_3(point(a, 0), point(a, 1), point(a, 2)),
                                          Kernel::Triangle_3(point(b, 0), point(b, 1), point(b, 2)));
            case 1: return opposite_meets(a, in_a[0], b) || opposite_meets(b, in_b[0], a);
            case 2: return folds(a, in_a, b, in_b);
            default: return true;
        }
    }

    /// The side across from corner k meets the other triangle.
    [[nodiscard]] bool opposite_meets(std::uint32_t t, std::size_t k, std::uint32_t other) const {
        return CGAL::do_intersect(Kernel::Segment_3(point(t, (k + 1) % 3), point(t, (k + 2) % 3)),
                                  Kernel::Triangle_3(point(other, 0), point(other, 1), point(other, 2)));
    }

    /// Triangles with a common side overlap where both lie in one plane and on the same side of it.
    [[nodiscard]] bool folds(std::uint32_t a, const std::array<std::size_t, 3>& in_a, std::uint32_t b,
                             const std::array<std::size_t, 3>& in_b) const {
        const Point p = point(a, in_a[0]), q = point(a, in_a[1]);
        const Point r = point(a, 3 - in_a[0] - in_a[1]), s = point(b, 3 - in_b[0] - in_b[1]);
        return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }

    /// A side of `a` goes through the inside of `b`: touching is not enough.
    [[nodiscard]] bool pierces(std::uint32_t a, std::uint32_t b) const {
        const Point u = point(b, 0), v = point(b, 1), w = point(b, 2);
        std::array<CGAL::Orientation, 3> side;
        for (std::size_t k = 0; k < 3; ++k) side[k] = CGAL::orientation(u, v, w, point(a, k));
        for (std::size_t k = 0; k < 3; ++k) {
            if (side[k] * side[(k + 1) % 3] >= 0) continue;
            const Point p = point(a, k), q = point(a, (k + 1) % 3);
            const CGAL::Orientation first = CGAL::orientation(p, q, u, v);
            if (first != CGAL::ZERO && first == CGAL::orientation(p, q, v, w) &&
                first == CGAL::orientation(p, q, w, u) && is_deep(p, q, {u, v, w}))
                return true;
        }
        return false;
    }

    /// The segment, which goes through the triangle, reaches beyond its plane and passes its sides by more than
    /// rounding.
    [[nodiscard]] bool is_deep(const Point& p, const Point& q, const std::array<Point, 3>& corner) const {
        const auto normal = CGAL::cross_product(corner[1] - corner[0], corner[2] - corner[0]);
        const double size = std::sqrt(normal.squared_length());
        if (size == 0) return false;
        const double above = std::abs((p - corner[0]) * normal) / size,
                     below = std::abs((q - corner[0]) * normal) / size;
        if (std::min(above, below) <= touching_) return false;
        const Point x = p + (q - p) * (above / (above + below));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto along = corner[(k + 1) % 3] - corner[k];
            const double apart =
                std::sqrt(CGAL::cross_product(along, x - corner[k]).squared_length() / along.squared_length());
            if (apart <= touching_) return false;
        }
        return true;
    }

    const Mesh& mesh_;
    const MeshTriangles& triangles_;
    const MeshPieces& pieces_;
    const std::vector<std::uint32_t>& place_;
    double touching_;
    std::uint64_t budget_ = 0;
    std::unordered_map<std::uint64_t, bool> piercing_;  ///< [pair of pieces that come near each other]
};

}  // namespace

double touching_distance(const Mesh& mesh) {
    double largest = 0;
    for (const auto& p : mesh.points)
        for (const double x : p) largest = std::max(largest, std::abs(x));
    return 1e-12 * largest;
}

Crossings find_crossings(const Mesh& mesh, const MeshTriangles& triangles, const MeshPieces& pieces,
                         const std::vector<std::uint32_t>& place) {
    CrossingFinder finder(mesh, triangles, pieces, place);
    const auto group_of = [&](std::uint32_t t) { return pieces.pieces[pieces.piece[triangles.face[t]]].group; };
    const auto count = static_cast<std::uint32_t>(triangles.face.size());
    for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
        while (end < count && group_of(end) == group_of(begin)) ++end;
        try {
            finder.search(begin, end);
        } catch (const TooMany&) {
            finder.keep_pairs();
            finder.found.complete = false;
        }
    }
    Crossings found = std::move(finder.found);
    std::sort(found.within.begin(), found.within.end(),
              [](const Crossing& x, const Crossing& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
    std::sort(found.piercing.begin(), found.piercing.end());
    std::sort(found.near.begin(), found.near.end());
    return found;
}

}  // namespace enfilade::modeler
