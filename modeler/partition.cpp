#include "modeler/partition.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "base/check.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr std::uint32_t no_index = UINT32_MAX;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceInfoBase = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfoBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// The pieces while diagonals are taken out: rings of half-edges, three to a triangle at first.
class Rings {
public:
    Rings(std::span<const GridPoint> points, std::span<const PolygonSide> sides) : points_(points), sides_(sides) {
        triangulate();
    }

    void merge(PartitionGoal goal) {
        std::vector<std::uint32_t> diagonals;
        for (std::uint32_t h = 0; h < twin_.size(); ++h)
            if (twin_[h] != no_index && h < twin_[h]) diagonals.push_back(h);
        std::sort(diagonals.begin(), diagonals.end(), [&](std::uint32_t g, std::uint32_t h) {
            const auto key = [&](std::uint32_t e) {  // fragile cuts go first, then long ones
                return std::tuple(!is_fragile(e), -length2(e), std::min(from_[e], to(e)), std::max(from_[e], to(e)));
            };
            return key(g) < key(h);
        });
        piece_.resize(from_.size() / 3);
        std::iota(piece_.begin(), piece_.end(), 0u);
        if (goal == PartitionGoal::Disc) {
            corners_.resize(piece_.size());
            for (std::uint32_t h = 0; h < from_.size(); ++h) corners_[h / 3].insert(from_[h]);
        }
        for (const std::uint32_t h : diagonals) {
            const std::uint32_t p = find(h / 3), q = find(twin_[h] / 3);
            if (p == q) continue;
            if (goal == PartitionGoal::Disc ? !stays_disc(p, q) : !stays_convex(h)) continue;
            remove(h, p, q, goal);
        }
    }

    [[nodiscard]] Partition collect() const {
        Partition result;
        result.first_side.push_back(0);
        std::vector<bool> seen(from_.size(), false);
        for (std::uint32_t start = 0; start < from_.size(); ++start) {
            if (seen[start] || next_[start] == no_index) continue;
            for (std::uint32_t h = start; !seen[h]; h = next_[h]) {
                seen[h] = true;
                const bool is_cut = side_[h] == no_index;
                result.sides.push_back({from_[h], to(h), is_cut ? cut_tag : sides_[side_[h]].line,
                                        is_cut ? cut_tag : sides_[side_[h]].tag});
            }
            result.first_side.push_back(std::uint32_t(result.sides.size()));
        }
        return result;
    }

private:
    [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return from_[next_[h]]; }
    [[nodiscard]] std::int64_t length2(std::uint32_t h) const {
        const GridPoint a = points_[from_[h]], b = points_[to(h)];
        const std::int64_t x = std::int64_t(b.x) - a.x, y = std::int64_t(b.y) - a.y;
        return x * x + y * y;
    }
    /// Whether a corner of the triangles beside a diagonal is so near it that rounding may lay them onto each other.
    [[nodiscard]] bool is_fragile(std::uint32_t h) const {
        const double length = std::sqrt(double(length2(h)));
        const auto height = [&](std::uint32_t side) {
            return double(orientation(points_[from_[side]], points_[to(side)], points_[from_[prev_[side]]])) / length;
        };
        return std::min(height(h), height(twin_[h])) < 2;
    }
    [[nodiscard]] std::uint32_t line(std::uint32_t h) const {
        return side_[h] == no_index ? cut_tag : sides_[side_[h]].line;
    }

    std::uint32_t find(std::uint32_t p) {
        while (piece_[p] != p) p = piece_[p] = piece_[piece_[p]];
        return p;
    }

    /// Whether side `out` goes straight on where side `in` ends.
    [[nodiscard]] bool one_line(std::uint32_t in, std::uint32_t out) const {
        return goes_straight(points_[from_[in]], points_[from_[out]], points_[to(out)], line(in), line(out));
    }
    /// The first and the last side of the straight run that a side is part of.
    [[nodiscard]] std::uint32_t run_first(std::uint32_t h) const {
        while (one_line(prev_[h], h)) h = prev_[h];
        return h;
    }
    [[nodiscard]] std::uint32_t run_last(std::uint32_t h) const {
        while (one_line(h, next_[h])) h = next_[h];
        return h;
    }
    [[nodiscard]] bool turns_left(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation(points_[a], points_[b], points_[c]) >= 0;
    }

    /// Whether `in` may be followed by `out`: between the chords of straight runs, which later roundings hardly turn.
    [[nodiscard]] bool corner_is_fine(std::uint32_t in, std::uint32_t out) const {
        const std::uint32_t first = run_first(in), last = run_last(out);
        if (!one_line(in, out)) return turns_left(from_[first], from_[out], to(last));
        return turns_left(from_[run_first(prev_[first])], from_[first], to(last)) &&
               turns_left(from_[first], to(last), to(run_last(next_[last])));
    }
    [[nodiscard]] bool stays_convex(std::uint32_t h) const {
        const std::uint32_t t = twin_[h];
        return corner_is_fine(prev_[h], next_[t]) && corner_is_fine(prev_[t], next_[h]);
    }
    /// Two discs joined along one diagonal are a disc iff they share no point but its ends.
    [[nodiscard]] bool stays_disc(std::uint32_t p, std::uint32_t q) const {
        const auto& small = corners_[p].size() < corners_[q].size() ? corners_[p] : corners_[q];
        const auto& large = corners_[p].size() < corners_[q].size() ? corners_[q] : corners_[p];
        std::size_t shared = 0;
        for (const std::uint32_t corner : small) shared += large.count(corner);
        return shared == 2;
    }

    void remove(std::uint32_t h, std::uint32_t p, std::uint32_t q, PartitionGoal goal) {
        const std::uint32_t t = twin_[h];
        const auto join = [&](std::uint32_t in, std::uint32_t out) { next_[in] = out, prev_[out] = in; };
        const std::uint32_t before_h = prev_[h], after_h = next_[h], before_t = prev_[t], after_t = next_[t];
        join(before_h, after_t);
        join(before_t, after_h);
        next_[h] = next_[t] = no_index;
        if (goal == PartitionGoal::Disc) {
            if (corners_[p].size() < corners_[q].size()) std::swap(p, q);
            corners_[p].insert(corners_[q].begin(), corners_[q].end());
            corners_[q].clear();
        }
        piece_[q] = p;
    }

    void triangulate();

    std::span<const GridPoint> points_;
    std::span<const PolygonSide> sides_;
    std::vector<std::uint32_t> from_, next_, prev_, twin_, side_;  ///< [3 * triangles]
    std::vector<std::uint32_t> piece_;                             ///< [triangles] union-find
    std::vector<std::unordered_set<std::uint32_t>> corners_;       ///< [triangles] points of a piece, for the disc goal
};

void Rings::triangulate() {
    std::vector<std::uint32_t> used;
    for (const PolygonSide& side : sides_) used.push_back(side.from);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    Triangulation triangulation;
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> input;
    for (std::uint32_t k = 0; k < used.size(); ++k)
        input.emplace_back(Kernel::Point_2(points_[used[k]].x, points_[used[k]].y), k);
    triangulation.insert(input.begin(), input.end());
    std::vector<Triangulation::Vertex_handle> handle(used.size());
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
        handle[v->info()] = v;
    const auto vertex = [&](std::uint32_t point) {
        return handle[std::size_t(std::lower_bound(used.begin(), used.end(), point) - used.begin())];
    };
    for (const PolygonSide& side : sides_) triangulation.insert_constraint(vertex(side.from), vertex(side.to));

    // Inside is what lies left of a side, and whatever is reached from there without crossing one.
    for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f) f->info() = no_index;
    std::vector<Triangulation::Face_handle> inside;
    const auto enter = [&](Triangulation::Face_handle f) {
        if (f->info() != no_index || triangulation.is_infinite(f)) return;
        f->info() = std::uint32_t(inside.size());
        inside.push_back(f);
    };
    std::vector<std::pair<Triangulation::Face_handle, int>> left_of(sides_.size());
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        Triangulation::Face_handle f;
        int i = 0;
        const bool found = triangulation.is_edge(vertex(sides_[k].from), vertex(sides_[k].to), f, i);
        ENFILADE_CHECK(found);
        if (f->vertex(f->ccw(i)) != vertex(sides_[k].from)) {
            const Triangulation::Face_handle other = f->neighbor(i);
            i = triangulation.mirror_index(f, i);
            f = other;
        }
        left_of[k] = {f, i};
        enter(f);
    }
    for (std::size_t k = 0; k < inside.size(); ++k)
        for (int i = 0; i < 3; ++i)
            if (!inside[k]->is_constrained(i)) enter(inside[k]->neighbor(i));

    const std::size_t count = 3 * inside.size();
    from_.resize(count), next_.resize(count), prev_.resize(count);
    twin_.assign(count, no_index), side_.assign(count, no_index);
    for (std::uint32_t t = 0; t < inside.size(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const auto f = inside[t];
            from_[3 * t + i] = used[f->vertex(f->ccw(int(i)))->info()];
            next_[3 * t + i] = 3 * t + (i + 1) % 3;
            prev_[3 * t + i] = 3 * t + (i + 2) % 3;
            if (!f->is_constrained(int(i)))
                twin_[3 * t + i] =
                    3 * f->neighbor(int(i))->info() + std::uint32_t(triangulation.mirror_index(f, int(i)));
        }
    for (std::uint32_t k = 0; k < sides_.size(); ++k)
        if (left_of[k].first->info() != no_index)
            side_[3 * left_of[k].first->info() + std::uint32_t(left_of[k].second)] = k;
}

/// One ring that visits no point twice, or empty.
std::vector<std::uint32_t> simple_ring(std::span<const PolygonSide> sides) {
    std::unordered_map<std::uint32_t, std::uint32_t> leaving;
    leaving.reserve(sides.size());
    for (std::uint32_t k = 0; k < sides.size(); ++k)
        if (!leaving.emplace(sides[k].from, k).second) return {};
    std::vector<std::uint32_t> ring;
    std::uint32_t k = 0;
    do {
        ring.push_back(k);
        const auto follow = leaving.find(sides[k].to);
        if (follow == leaving.end()) return {};
        k = follow->second;
    } while (k != 0 && ring.size() <= sides.size());
    return ring.size() == sides.size() ? ring : std::vector<std::uint32_t>{};
}

/// Whether no corner between different lines turns right.
bool is_convex(std::span<const GridPoint> points, std::span<const PolygonSide> sides,
               const std::vector<std::uint32_t>& ring) {
    std::vector<RingCorner> corners;
    for (const std::uint32_t k : ring) corners.push_back({points[sides[k].from], sides[k].line});
    return !reflex_corner(corners);
}

}  // namespace

std::optional<std::size_t> reflex_corner(std::span<const RingCorner> ring) {
    const std::size_t n = ring.size();
    const auto at = [&](std::size_t k) -> const RingCorner& { return ring[k % n]; };
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < n; ++k)
        if (!goes_straight(at(k + n - 1).point, at(k).point, at(k + 1).point, at(k + n - 1).line, at(k).line))
            ends.push_back(k);
    if (ends.size() < 3) return std::nullopt;  // a sliver as wide as the grid, all of it on two lines
    for (std::size_t e = 0; e < ends.size(); ++e) {
        const std::size_t k = ends[e], before = ends[(e + ends.size() - 1) % ends.size()],
                          after = ends[(e + 1) % ends.size()];
        if (orientation(at(before).point, at(k).point, at(after).point) < 0 &&
            orientation(at(k + n - 1).point, at(k).point, at(k + 1).point) < 0)
            return k;
    }
    return std::nullopt;
}

Partition partition(std::span<const GridPoint> points, std::span<const PolygonSide> sides, PartitionGoal goal) {
    const std::vector<std::uint32_t> ring = simple_ring(sides);
    if (!ring.empty() && (goal == PartitionGoal::Disc || is_convex(points, sides, ring))) {
        Partition result;
        for (const std::uint32_t k : ring) result.sides.push_back(sides[k]);
        result.first_side = {0, std::uint32_t(ring.size())};
        return result;
    }
    Rings rings(points, sides);
    rings.merge(goal);
    return rings.collect();
}

}  // namespace enfilade::modeler
