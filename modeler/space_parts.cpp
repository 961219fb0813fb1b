#include "modeler/space_parts.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "modeler/outline.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr std::uint32_t no_index = UINT32_MAX;

[[noreturn]] void refuse() {
    throw InputError(
        "F22", "",
        "The outlines of the building cannot be put together: the pieces of a space do not close. Check the "
        "plan and mend what is reported first.");
}

/// Twice the area on the left of a ring, in grid units; sums wrap round, the result does not.
std::int64_t area2(const Building& building, const HalfEdgeRing& ring) {
    const auto point = [&](std::size_t k) { return building.points[start_of(building, ring[k])]; };
    std::uint64_t sum = 0;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k)
        sum += std::uint64_t(orientation(point(0), point(k), point(k + 1)));
    return std::int64_t(sum);
}

/// Whether direction p comes before q, counter-clockwise from the positive x axis on. Exact.
bool turns_before(GridPoint origin, GridPoint p, GridPoint q) {
    const auto lower = [&](GridPoint d) { return d.y < origin.y || (d.y == origin.y && d.x < origin.x); };
    if (lower(p) != lower(q)) return lower(q);
    return orientation(origin, p, q) > 0;
}

/// Volumes of one space between the same two levels.
class PartBuilder {
public:
    explicit PartBuilder(const Building& building)
        : building_(building), volume_of_(2 * building.edges.size(), no_index) {}

    /// Appends the parts of `volumes`, which ascend.
    void add(std::span<const std::uint32_t> volumes, std::vector<SpacePart>& parts) {
        half_edges_.clear();
        for (std::uint32_t k = 0; k < volumes.size(); ++k) {
            const Piece& piece = building_.pieces[building_.volumes[volumes[k]].piece];
            for (std::uint32_t c = 0; c < piece.corner_count; ++c) {
                const std::uint32_t h = building_.corners[piece.first_corner + c].half_edge;
                if (volume_of_[h] != no_index) refuse();
                volume_of_[h] = k;
                half_edges_.push_back(h);
            }
        }
        join(volumes.size());
        const std::size_t first = parts.size();
        for (std::uint32_t k = 0; k < volumes.size(); ++k) {
            if (sets_.find(k) == k) {
                part_of_root_[k] = std::uint32_t(parts.size());
                const Volume& volume = building_.volumes[volumes[k]];
                parts.push_back({volume.space, volume.z_low, volume.z_high, {}, {}, {}});
            }
            parts[part_of_root_[sets_.find(k)]].volumes.push_back(volumes[k]);
        }
        trace(parts);
        for (const std::uint32_t h : half_edges_) volume_of_[h] = no_index;
        for (std::size_t p = first; p < parts.size(); ++p) sort_rings(parts[p]);
    }

private:
    /// Volumes that hang together over edges are one set.
    void join(std::size_t count) {
        sets_.reset(count);
        part_of_root_.assign(count, no_index);
        for (const std::uint32_t h : half_edges_) {
            if (h % 2 == 0 && volume_of_[h ^ 1] != no_index) sets_.join(volume_of_[h], volume_of_[h ^ 1]);
        }
    }

    /// Goes along every half-edge whose twin lies outside of the part. Where several rings meet in a point, a ring
    /// goes on to the border that it sees across what is not the part: so rings touch, and visit the point once each.
    void trace(std::vector<SpacePart>& parts) {
        border_.clear();
        for (const std::uint32_t h : half_edges_)
            if (volume_of_[h ^ 1] == no_index)
                border_.push_back({sets_.find(volume_of_[h]), start_of(building_, h), h});
        std::sort(border_.begin(), border_.end());
        std::vector<std::uint8_t> used(border_.size(), 0);
        for (std::size_t k = 0; k < border_.size(); ++k) {
            if (used[k]) continue;
            HalfEdgeRing ring;
            for (std::size_t at = k; !used[at]; at = next(at, used, k)) {
                used[at] = 1;
                ring.push_back(border_[at][2]);
            }
            parts[part_of_root_[border_[k][0]]].holes.push_back(std::move(ring));
        }
    }

    /// Place in `border_` of the half-edge after the one at `at`, on a ring that began at `first`.
    [[nodiscard]] std::size_t next(std::size_t at, const std::vector<std::uint8_t>& used, std::size_t first) const {
        const auto [part, from_point, h] = border_[at];
        const std::uint32_t here = start_of(building_, h ^ 1);
        const std::array<std::uint32_t, 3> low = {part, here, 0};
        const std::size_t begin = std::size_t(std::lower_bound(border_.begin(), border_.end(), low) - border_.begin());
        const GridPoint origin = building_.points[here], from = building_.points[from_point];
        const auto end_of = [&](std::size_t k) { return building_.points[start_of(building_, border_[k][2] ^ 1)]; };
        std::size_t best = SIZE_MAX;
        for (std::size_t k = begin; k < border_.size() && border_[k][0] == part && border_[k][1] == here; ++k) {
            if (used[k] && k != first) continue;
            if (best == SIZE_MAX || is_first_after(origin, from, end_of(k), end_of(best))) best = k;
        }
        if (best == SIZE_MAX) refuse();
        return best;
    }
    /// Whether a ray that turns counter-clockwise from `from` meets `p` before `q`.
    static bool is_first_after(GridPoint origin, GridPoint from, GridPoint p, GridPoint q) {
        const bool p_wraps = !turns_before(origin, from, p), q_wraps = !turns_before(origin, from, q);
        return p_wraps != q_wraps ? q_wraps : turns_before(origin, p, q);
    }

    /// The one ring that runs counter-clockwise is the outer one; each begins at its lowest half-edge.
    void sort_rings(SpacePart& part) const {
        for (HalfEdgeRing& ring : part.holes)
            std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
        std::sort(part.holes.begin(), part.holes.end());
        const auto is_outer = [&](const HalfEdgeRing& ring) { return area2(building_, ring) > 0; };
        if (std::count_if(part.holes.begin(), part.holes.end(), is_outer) != 1) refuse();
        const auto outer = std::find_if(part.holes.begin(), part.holes.end(), is_outer);
        part.outer = std::move(*outer);
        part.holes.erase(outer);
    }

    const Building& building_;
    std::vector<std::uint32_t> volume_of_;   ///< [half-edge] into the volumes at hand
    std::vector<std::uint32_t> half_edges_;  ///< of the volumes at hand
    DisjointSets sets_;                      ///< of volumes
    std::vector<std::uint32_t> part_of_root_;
    std::vector<std::array<std::uint32_t, 3>> border_;  ///< root, starting point, half-edge; sorted
};

/// Squared distance of p from the segment a - b, in grid units.
double squared_distance(GridPoint p, GridPoint a, GridPoint b) {
    const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
    const double px = double(p.x) - a.x, py = double(p.y) - a.y;
    const double length = dx * dx + dy * dy;
    const double t = length > 0 ? std::clamp((px * dx + py * dy) / length, 0.0, 1.0) : 0;
    return (px - t * dx) * (px - t * dx) + (py - t * dy) * (py - t * dy);
}

/// Snap rounding moves a point of a line by half a unit on each axis, twice at most: bends up to here are its doing.
constexpr double squared_rounding = 4;

/// Marks the points of ring[from ... to] (indices modulo its size) that a line through the marked ones misses by more
/// than rounding does (Douglas and Peucker 1973).
void mark_bends(std::span<const GridPoint> ring, std::size_t from, std::size_t to, std::vector<std::uint8_t>& kept) {
    std::vector<std::array<std::size_t, 2>> open = {{from, to}};
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        double furthest = squared_rounding;
        std::size_t at = SIZE_MAX;
        for (std::size_t k = a + 1; k < b; ++k) {
            const double d = squared_distance(ring[k % ring.size()], ring[a % ring.size()], ring[b % ring.size()]);
            if (d > furthest) furthest = d, at = k;
        }
        if (at == SIZE_MAX) continue;
        kept[at % ring.size()] = 1;
        open.push_back({a, at});
        open.push_back({at, b});
    }
}

}  // namespace

std::vector<SpacePart> space_parts(const Building& building) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].label != Label::Outside) order.push_back(v);
    const auto levels = [&](std::uint32_t v) {
        const Volume& volume = building.volumes[v];
        return std::tuple(volume.space, volume.z_low, volume.z_high);
    };
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return levels(a) < levels(b); });
    PartBuilder builder(building);
    std::vector<SpacePart> parts;
    for (std::size_t k = 0; k < order.size();) {
        std::size_t end = k + 1;
        while (end < order.size() && levels(order[end]) == levels(order[k])) ++end;
        builder.add(std::span(order).subspan(k, end - k), parts);
        k = end;
    }
    std::stable_sort(parts.begin(), parts.end(), [](const SpacePart& a, const SpacePart& b) {
        return std::tuple(a.space, a.z_low, a.volumes.front()) < std::tuple(b.space, b.z_low, b.volumes.front());
    });
    return parts;
}

std::vector<std::uint32_t> drawn_corners(const Building& building, const HalfEdgeRing& ring) {
    std::vector<GridPoint> points;
    for (const std::uint32_t h : ring) points.push_back(building.points[start_of(building, h)]);
    const std::size_t n = points.size();
    // Two points that are corners whatever lies between: an end of the ring, and the one furthest from it.
    const std::size_t first = std::size_t(std::min_element(points.begin(), points.end()) - points.begin());
    std::size_t second = first;
    double furthest = 0;
    for (std::size_t k = 0; k < n; ++k)
        if (const double d = squared_distance(points[k], points[first], points[first]); d > furthest)
            furthest = d, second = k;
    std::vector<std::uint8_t> kept(n, 0);
    kept[first] = kept[second] = 1;
    mark_bends(points, first, second < first ? second + n : second, kept);
    mark_bends(points, second, first < second ? first + n : first, kept);
    std::vector<std::uint32_t> corners;
    for (std::size_t k = 0; k < n; ++k)
        if (kept[k]) corners.push_back(start_of(building, ring[k]));
    // The end of the ring may itself be a bend of rounding's.
    if (corners.size() > 3) {
        const std::uint32_t end = start_of(building, ring[first]);
        const std::size_t k = std::size_t(std::find(corners.begin(), corners.end(), end) - corners.begin());
        const auto at = [&](std::size_t i) { return building.points[corners[i % corners.size()]]; };
        if (squared_distance(at(k), at(k + corners.size() - 1), at(k + 1)) <= squared_rounding)
            corners.erase(corners.begin() + std::ptrdiff_t(k));
    }
    return corners.size() < 3 ? corners_of(building, ring) : corners;
}

double area_m2(const Building& building, const SpacePart& part) {
    std::int64_t sum = area2(building, part.outer);
    for (const HalfEdgeRing& hole : part.holes) sum += area2(building, hole);
    return double(sum) / 2 * building.frame.unit * building.frame.unit;
}

}  // namespace enfilade::modeler
