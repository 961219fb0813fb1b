#include "modeler/constraints/face_meeting.h"

#include <algorithm>
#include <cstdlib>

#include "modeler/constraints/face_rings.h"

namespace enfilade::modeler {
namespace {

using Place = std::array<double, 3>;
using Int128 = __int128;

/// A point of a plane to be found in a polygon: the one where the segment ab crosses the plane, or the middle of ab
/// (equal heights on both sides), which may be one and the same point.
struct Probe {
    Point3 a, b;
    Int128 from_a = 1;  ///< distance of a from the point, in the same measure as
    Int128 from_b = 1;  ///< that of b; their sum is positive

    /// Sign of (coordinate of the point - value).
    [[nodiscard]] int compare(std::size_t axis, std::int32_t value) const {
        return sign_of(from_b * (std::int64_t(a[axis]) - value) + from_a * (std::int64_t(b[axis]) - value));
    }
    /// Twice the area of (p, q, r), seen along the third axis.
    static std::int64_t area(const Point3& p, const Point3& q, const Point3& r, const FlatFace& face) {
        return (std::int64_t(q[face.u]) - p[face.u]) * (std::int64_t(r[face.v]) - p[face.v]) -
               (std::int64_t(q[face.v]) - p[face.v]) * (std::int64_t(r[face.u]) - p[face.u]);
    }
    /// Sign of the area of (p, q, point), seen along the third axis. A product of 128 bits would not hold it where the
    /// point is a crossing: there the line ab is seen passing the edge pq in space, which is the same.
    [[nodiscard]] int side(const Point3& p, const Point3& q, const FlatFace& face) const {
        if (from_a == from_b) return sign_of(Int128(area(p, q, a, face)) + area(p, q, b, face));
        // The volume of (p, q, point, b) has the sign of the area where b lies above the plane, seen along its normal.
        const int volume = side_of(p, q, a, b);
        const int up = sign_of(face.height(b));
        const int axis = face.normal[3 - face.u - face.v] > 0 ? 1 : -1;
        return volume * up * axis;
    }
    [[nodiscard]] Place place() const {
        const double total = double(from_a) + double(from_b);
        Place p;
        for (std::size_t i = 0; i < 3; ++i) p[i] = (double(from_b) * a[i] + double(from_a) * b[i]) / total;
        return p;
    }
};

enum class Where { Outside, Border, Inside };

/// By counting the edges that a ray along u crosses.
Where locate(const Probe& probe, const FlatFace& face, const std::vector<Point3>& points) {
    bool inside = false;
    const Point3* p = &points[face.ring.back()];
    int p_above = -probe.compare(face.v, (*p)[face.v]);
    for (const std::uint32_t vertex : face.ring) {
        const Point3* q = &points[vertex];
        const int q_above = -probe.compare(face.v, (*q)[face.v]);
        if (p_above * q_above <= 0) {
            const int side = probe.side(*p, *q, face);
            if (side == 0) {
                const int p_right = -probe.compare(face.u, (*p)[face.u]);
                const int q_right = -probe.compare(face.u, (*q)[face.u]);
                if (p_right * q_right <= 0) return Where::Border;
            }
            // Each edge counts with its lower end, not with its upper one.
            if ((p_above > 0) != (q_above > 0) && side != 0 && (side > 0) == (q_above > 0)) inside = !inside;
        }
        p = q;
        p_above = q_above;
    }
    return inside ? Where::Inside : Where::Outside;
}

class Meeting {
public:
    Meeting(const FlatFace& a, const FlatFace& b, const std::vector<Point3>& points)
        : faces_{&a, &b}, points_(points) {}

    [[nodiscard]] std::optional<Place> find() const {
        if (!faces_[0]->has_extent || !faces_[1]->has_extent) return std::nullopt;
        for (std::size_t k = 0; k < 2; ++k)
            if (const auto place = edges_meet(k)) return place;
        return is_coplanar() ? lie_on_each_other() : cross_between_shared();
    }

private:
    static Place place_of(const Point3& p) { return {double(p[0]), double(p[1]), double(p[2])}; }
    [[nodiscard]] Where locate_in(std::size_t k, const Probe& probe) const {
        return locate(probe, *faces_[k], points_);
    }
    [[nodiscard]] bool is_coplanar() const {
        const auto& ring = faces_[0]->ring;
        return std::all_of(ring.begin(), ring.end(),
                           [&](std::uint32_t v) { return faces_[1]->height(points_[v]) == 0; });
    }

    /// Edges of face k against the other face: crossings, corners in it, edges in its plane.
    [[nodiscard]] std::optional<Place> edges_meet(std::size_t k) const {
        const auto& ring = faces_[k]->ring;
        const FlatFace& other = *faces_[1 - k];
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::size_t j = i + 1 < ring.size() ? i + 1 : 0;
            const Point3 &p = points_[ring[i]], &q = points_[ring[j]];
            GridBox box;
            box.add(p), box.add(q);
            if (!box.touches(other.box)) continue;
            const Int128 h = other.height(p), next = other.height(q);
            if (h == 0 && !other.has(ring[i]) && locate_in(1 - k, {p, p}) != Where::Outside) return place_of(p);
            if ((h < 0 && next > 0) || (h > 0 && next < 0)) {
                const Probe crossing{p, q, h < 0 ? -h : h, next < 0 ? -next : next};
                if (locate_in(1 - k, crossing) != Where::Outside) return crossing.place();
            } else if (h == 0 && next == 0 && !(other.has(ring[i]) && other.has_edge(ring[i], ring[j]))) {
                if (const auto place = edge_crosses(other, ring[i], ring[j])) return place;
            }
        }
        return std::nullopt;
    }

    /// An edge in the plane of a face that does not have it: does it cross an edge there, or run inside?
    [[nodiscard]] std::optional<Place> edge_crosses(const FlatFace& face, std::uint32_t i, std::uint32_t j) const {
        const Point3 &p = points_[i], &q = points_[j];
        for (std::size_t n = 0; n < face.ring.size(); ++n) {
            const std::uint32_t r = face.ring[n], s = face.ring[n + 1 < face.ring.size() ? n + 1 : 0];
            if (r == i || r == j || s == i || s == j) continue;  // what overlaps along these, the middle sees
            const Point3 &a = points_[r], &b = points_[s];
            const int a_side = Probe{a, a}.side(p, q, face), b_side = Probe{b, b}.side(p, q, face);
            const int p_side = Probe{p, p}.side(a, b, face), q_side = Probe{q, q}.side(a, b, face);
            if (a_side * b_side < 0 && p_side * q_side < 0) {
                const Int128 from_p = Probe::area(a, b, p, face), from_q = Probe::area(a, b, q, face);
                return Probe{p, q, from_p < 0 ? -from_p : from_p, from_q < 0 ? -from_q : from_q}.place();
            }
            // A corner of the face between the ends of the edge is none of them.
            if (a_side == 0 && is_between(p, q, a)) return place_of(a);
            if (b_side == 0 && is_between(p, q, b)) return place_of(b);
        }
        const Probe middle{p, q};
        if (locate(middle, face, points_) != Where::Outside) return middle.place();
        return std::nullopt;
    }

    /// Whether c, on the line pq, lies strictly within the segment.
    static bool is_between(const Point3& p, const Point3& q, const Point3& c) {
        if (c == p || c == q) return false;
        for (std::size_t i = 0; i < 3; ++i)
            if (c[i] < std::min(p[i], q[i]) || c[i] > std::max(p[i], q[i])) return false;
        return true;
    }

    /// In one plane, with borders that meet in shared vertices and edges alone: no edge runs inside the other face, so
    /// they lie apart unless they are the same.
    [[nodiscard]] std::optional<Place> lie_on_each_other() const {
        if (faces_[0]->sorted != faces_[1]->sorted) return std::nullopt;
        const auto& ring = faces_[0]->ring;
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (!faces_[1]->has_edge(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0])) return std::nullopt;
        return place_of(points_[ring[0]]);
    }

    /// In two planes, with borders that reach the other face in shared vertices alone: the faces may still cut through
    /// each other from one shared vertex to the next, along the line of both planes.
    [[nodiscard]] std::optional<Place> cross_between_shared() const {
        std::vector<std::uint32_t> shared;
        std::set_intersection(faces_[0]->sorted.begin(), faces_[0]->sorted.end(), faces_[1]->sorted.begin(),
                              faces_[1]->sorted.end(), std::back_inserter(shared));
        std::sort(shared.begin(), shared.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return points_[a] < points_[b]; });  // along the line
        for (std::size_t i = 0; i + 1 < shared.size(); ++i) {
            const Probe middle{points_[shared[i]], points_[shared[i + 1]]};
            if (faces_[0]->has_edge(shared[i], shared[i + 1])) continue;
            if (locate_in(0, middle) != Where::Outside && locate_in(1, middle) != Where::Outside) return middle.place();
        }
        return std::nullopt;
    }

    std::array<const FlatFace*, 2> faces_;
    const std::vector<Point3>& points_;
};

}  // namespace

FlatFace::FlatFace(std::span<const std::uint32_t> corners, const std::vector<Point3>& points)
    : ring(corners), sorted(corners.begin(), corners.end()) {
    std::sort(sorted.begin(), sorted.end());
    for (const std::uint32_t vertex : ring) box.add(points[vertex]);
    const auto plane = plane_corners(ring, points);
    if (!plane) return;
    has_extent = true;
    origin = points[(*plane)[0]];
    normal = normal_of(origin, points[(*plane)[1]], points[(*plane)[2]]);
    std::size_t steepest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[steepest])) steepest = i;
    u = (steepest + 1) % 3;
    v = (steepest + 2) % 3;
}

bool FlatFace::has(std::uint32_t vertex) const { return std::binary_search(sorted.begin(), sorted.end(), vertex); }

bool FlatFace::has_edge(std::uint32_t p, std::uint32_t q) const {
    if (!has(p) || !has(q)) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t r = ring[i], s = ring[i + 1 < ring.size() ? i + 1 : 0];
        if ((r == p && s == q) || (r == q && s == p)) return true;
    }
    return false;
}

std::optional<std::array<double, 3>> meeting_point(const FlatFace& a, const FlatFace& b,
                                                   const std::vector<Point3>& points) {
    return Meeting(a, b, points).find();
}

}  // namespace enfilade::modeler
