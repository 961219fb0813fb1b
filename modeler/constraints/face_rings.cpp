#include "modeler/constraints/face_rings.h"

#include <algorithm>
#include <cstdlib>

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t no_index = UINT32_MAX;

bool is_level(std::span<const std::uint32_t> ring, const std::vector<Point3>& points) {
    const std::int32_t z = points[ring[0]][2];
    return std::all_of(ring.begin(), ring.end(), [&](std::uint32_t v) { return points[v][2] == z; });
}

bool is_upright(std::span<const std::uint32_t> ring, const std::vector<Point3>& points) {
    const auto foot = [&](std::uint32_t v) { return plans::GridPoint{points[v][0], points[v][1]}; };
    const plans::GridPoint a = foot(ring[0]);
    plans::GridPoint b = a;
    for (const std::uint32_t v : ring) {
        const plans::GridPoint c = foot(v);
        if (c == a || c == b) continue;
        if (b == a) b = c;
        else if (orientation(a, b, c) != 0) return false;
    }
    return true;
}

bool is_flat(std::span<const std::uint32_t> ring, const std::vector<Point3>& points) {
    const Point3& a = points[ring[0]];
    Point3 b = a;
    std::array<std::int64_t, 3> normal = {};
    for (const std::uint32_t v : ring) {
        const Point3& c = points[v];
        if (b == a) b = c;
        else if (normal == std::array<std::int64_t, 3>{}) normal = normal_of(a, b, c);
        else if (height_over(a, normal, c) != 0) return false;
    }
    return true;
}

}  // namespace

Lie lie_of(std::span<const std::uint32_t> ring, const std::vector<Point3>& points) {
    if (ring.empty()) return Lie::NoRing;
    if (is_level(ring, points)) return Lie::Level;
    if (is_upright(ring, points)) return Lie::Upright;
    return is_flat(ring, points) ? Lie::Tilted : Lie::Bent;
}

std::optional<std::array<std::uint32_t, 3>> plane_corners(std::span<const std::uint32_t> ring,
                                                          const std::vector<Point3>& points, std::uint32_t without) {
    std::uint32_t a = no_index, b = no_index;
    for (const std::uint32_t v : ring) {
        if (v == without) continue;
        if (a == no_index) a = v;
        else if (b == no_index) b = points[v] == points[a] ? no_index : v;
        else if (normal_of(points[a], points[b], points[v]) != std::array<std::int64_t, 3>{})
            return std::array{a, b, v};
    }
    return std::nullopt;
}

FaceRings::FaceRings(const gmap::Map& map, const std::vector<Point3>& vertices) : vertices_(&vertices) {
    const gmap::MapArrays& arrays = map.arrays();
    const std::size_t faces = arrays.cell_bound[2];
    first_.assign(faces, 0);
    count_.assign(faces, 0);
    lie_.assign(faces, Lie::NoRing);
    volumes_.assign(faces, {no_index, no_index});
    ring_.reserve(arrays.alpha[0].size() / 4);
    walk_faces(arrays);
    sort_into_volumes(arrays.cell_bound[3]);
}

void FaceRings::walk_faces(const gmap::MapArrays& arrays) {
    const auto& [alpha0, alpha1, alpha2, alpha3] = arrays.alpha;
    const auto& [vertex, edge, face, volume] = arrays.cell_id;
    std::vector<bool> seen(alpha0.size(), false), begun(lie_.size(), false);
    for (std::uint32_t d = 0; d < alpha0.size(); ++d) {
        if (alpha0[d] == no_index || begun[face[d]]) continue;
        const std::uint32_t f = face[d];
        begun[f] = true;
        first_[f] = std::uint32_t(ring_.size());
        bool closes = face[alpha3[d]] == f;
        std::uint32_t at = d;
        while (closes) {
            seen[at] = true;
            ring_.push_back(vertex[at]);
            const std::uint32_t across = alpha0[at];
            closes = face[across] == f && vertex[across] < vertices_->size();
            if (!closes) break;
            at = alpha1[across];
            closes = face[at] == f && vertex[at] == vertex[across];
            if (at == d) break;
            closes = closes && !seen[at];
        }
        if (!closes) {
            ring_.resize(first_[f]);
            continue;
        }
        count_[f] = std::uint32_t(ring_.size()) - first_[f];
        volumes_[f] = {volume[d], volume[alpha3[d]]};
        lie_[f] = lie_of(ring(f), *vertices_);
    }
}

void FaceRings::sort_into_volumes(std::size_t volumes) {
    first_face_.assign(volumes + 1, 0);
    const auto each = [&](auto visit) {
        for (std::uint32_t f = 0; f < size(); ++f) {
            if (count_[f] == 0) continue;
            visit(f, volumes_[f][0]);
            if (volumes_[f][1] != volumes_[f][0]) visit(f, volumes_[f][1]);
        }
    };
    each([&](std::uint32_t, std::uint32_t v) { ++first_face_[v + 1]; });
    for (std::size_t v = 0; v < volumes; ++v) first_face_[v + 1] += first_face_[v];
    of_volume_.resize(first_face_.back());
    std::vector<std::uint32_t> fill(first_face_.begin(), first_face_.end() - 1);
    each([&](std::uint32_t f, std::uint32_t v) { of_volume_[fill[v]++] = f; });
}

void FaceRings::flatten(std::uint32_t face, std::vector<plans::GridPoint>& flat) const {
    const auto corners = ring(face);
    std::size_t u = 0, w = 1;
    if (lie_[face] == Lie::Upright) {
        Point3 low = point(corners[0]), high = low;
        for (const std::uint32_t v : corners)
            for (std::size_t i = 0; i < 2; ++i) {
                low[i] = std::min(low[i], point(v)[i]);
                high[i] = std::max(high[i], point(v)[i]);
            }
        u = std::int64_t(high[0]) - low[0] >= std::int64_t(high[1]) - low[1] ? 0 : 1;
        w = 2;
    } else if (lie_[face] != Lie::Level) {
        std::size_t steepest = 0;
        if (const auto plane = plane_corners(corners, *vertices_)) {
            const auto normal = normal_of(point((*plane)[0]), point((*plane)[1]), point((*plane)[2]));
            for (std::size_t i = 1; i < 3; ++i)
                if (std::abs(normal[i]) > std::abs(normal[steepest])) steepest = i;
        }
        u = steepest == 0 ? 1 : 0;
        w = steepest == 2 ? 1 : 2;
    }
    flat.clear();
    for (const std::uint32_t v : corners) flat.push_back({point(v)[u], point(v)[w]});
}

VertexStars::VertexStars(const FaceRings& rings) : first_(rings.points().size() + 1, 0) {
    for (std::uint32_t f = 0; f < rings.size(); ++f)
        for (const std::uint32_t v : rings.ring(f)) ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    faces_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t f = 0; f < rings.size(); ++f)
        for (const std::uint32_t v : rings.ring(f)) faces_[fill[v]++] = f;
}

}  // namespace enfilade::modeler
