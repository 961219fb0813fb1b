#include "tests/support/face_oracle.h"

#include <algorithm>

namespace enfilade::testing {
namespace {

using plans::GridPoint;
using Int128 = __int128;
using Vector = std::array<Int128, 3>;

Vector minus(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
    return {Int128(a[0]) - b[0], Int128(a[1]) - b[1], Int128(a[2]) - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Int128 dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Whether q lies on the closed segment ab.
bool lies_on(GridPoint q, GridPoint a, GridPoint b) {
    return orientation(a, b, q) == 0 && std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
}

bool cross_or_touch(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
    if (lies_on(a, c, d) || lies_on(b, c, d) || lies_on(c, a, b) || lies_on(d, a, b)) return true;
    return (orientation(a, b, c) > 0) != (orientation(a, b, d) > 0) &&
           (orientation(c, d, a) > 0) != (orientation(c, d, b) > 0);
}

/// A normal of the ring from any three corners that span a plane.
Vector normal(const modeler::Building& building, const std::vector<std::uint32_t>& ring) {
    for (std::size_t i = 1; i < ring.size(); ++i)
        for (std::size_t j = i + 1; j < ring.size(); ++j) {
            const auto& o = building.vertices[ring[0]];
            const Vector n = cross(minus(building.vertices[ring[i]], o), minus(building.vertices[ring[j]], o));
            if (n != Vector{}) return n;
        }
    return {};
}

}  // namespace

bool is_simple_ring(const std::vector<GridPoint>& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            const GridPoint a = ring[i], b = ring[(i + 1) % n], c = ring[j], d = ring[(j + 1) % n];
            if (a == b || c == d) return false;
            const bool follows = j == i + 1, precedes = (j + 1) % n == i;
            if (follows && precedes) return false;
            if (follows    ? lies_on(d, a, b) || lies_on(a, c, d)
                : precedes ? lies_on(c, a, b) || lies_on(b, c, d)
                           : cross_or_touch(a, b, c, d))
                return false;
        }
    return n >= 3;
}

FaceOracle::FaceOracle(const modeler::Building& building)
    : building_(building), faces_(building.map.cell_bound<2>()), at_(building.vertices.size()) {
    const gmap::MapArrays& arrays = building.map.arrays();
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d) {
        OracleFace& face = faces_[arrays.cell_id[2][d]];
        if (!face.ring.empty()) continue;
        face.volumes = {arrays.cell_id[3][d], arrays.cell_id[3][arrays.alpha[3][d]]};
        std::uint32_t at = d;
        do {
            face.ring.push_back(arrays.cell_id[0][at]);
            at = arrays.alpha[1][arrays.alpha[0][at]];
        } while (at != d);
        for (const std::uint32_t v : face.ring) at_[v].push_back(arrays.cell_id[2][d]);
    }
}

bool FaceOracle::is_flat(std::uint32_t face) const {
    const auto& ring = faces_[face].ring;
    const Vector n = normal(building_, ring);
    return std::all_of(ring.begin(), ring.end(), [&](std::uint32_t v) {
        return dot(n, minus(building_.vertices[v], building_.vertices[ring[0]])) == 0;
    });
}

bool FaceOracle::is_level(std::uint32_t face) const {
    const Vector n = normal(building_, faces_[face].ring);
    return is_flat(face) && n[0] == 0 && n[1] == 0;
}

bool FaceOracle::is_upright(std::uint32_t face) const {
    return is_flat(face) && normal(building_, faces_[face].ring)[2] == 0;
}

bool FaceOracle::is_simple(std::uint32_t face) const {
    const Vector n = normal(building_, faces_[face].ring);
    const auto size = [](Int128 x) { return x < 0 ? -x : x; };
    std::size_t steepest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (size(n[i]) > size(n[steepest])) steepest = i;
    if (n == Vector{}) return false;
    std::vector<GridPoint> flat;
    for (const std::uint32_t v : faces_[face].ring) {
        const auto& p = building_.vertices[v];
        flat.push_back({p[steepest == 0 ? 1 : 0], p[steepest == 2 ? 1 : 2]});
    }
    return is_simple_ring(flat);
}

bool FaceOracle::is_alone(std::uint32_t vertex) const {
    return std::count(building_.vertices.begin(), building_.vertices.end(), building_.vertices[vertex]) == 1;
}

std::array<double, 3> FaceOracle::world(std::uint32_t vertex) const {
    const auto& p = building_.vertices[vertex];
    const plans::GridFrame& frame = building_.frame;
    return {frame.world_x(p[0]), frame.world_y(p[1]), frame.world_z(p[2])};
}

}  // namespace enfilade::testing
