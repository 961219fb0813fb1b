#include "modeler/meshes/piece_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modeler/meshes/point_index.h"

namespace enfilade::modeler {
namespace {

MeshPoint minus(const MeshPoint& a, const MeshPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const MeshPoint& a, const MeshPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
MeshPoint cross(const MeshPoint& a, const MeshPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Whether the triangle comes within the distance of the origin.
bool touches_origin(const MeshPoint& a, const MeshPoint& b, const MeshPoint& c, double distance) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::min({a[i], b[i], c[i]}) > distance || std::max({a[i], b[i], c[i]}) < -distance) return false;
    const MeshPoint normal = cross(minus(b, a), minus(c, a));
    const double size = std::sqrt(dot(normal, normal));
    if (size == 0 || std::abs(dot(a, normal)) > distance * size) return false;
    const MeshPoint* corner[] = {&a, &b, &c};
    for (std::size_t k = 0; k < 3; ++k) {
        const MeshPoint &p = *corner[k], along = minus(*corner[(k + 1) % 3], p);
        // How far the origin lies beyond this side, times the length of normal and side.
        const double beyond = dot(cross(along, normal), {-p[0], -p[1], -p[2]});
        if (beyond > distance * size * std::sqrt(dot(along, along))) return false;
    }
    return true;
}

}  // namespace

bool PieceShape::has_volume() const {
    const double size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    return std::abs(volume) > 1e-12 * area * size;  // less is what rounding leaves of 0
}

PieceShapes::PieceShapes(const Mesh& mesh, const MeshTriangles& triangles, const MeshPieces& pieces)
    : mesh_(mesh),
      triangles_(triangles),
      pieces_(pieces),
      first_(pieces.pieces.size() + 1, 0),
      touching_(touching_distance(mesh)) {
    for (const std::uint32_t f : triangles.face) ++first_[pieces.piece[f] + 1];
    for (std::size_t p = 0; p < pieces.pieces.size(); ++p) first_[p + 1] += first_[p];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    items_.resize(triangles.face.size());
    for (std::uint32_t t = 0; t < items_.size(); ++t) items_[next[pieces.piece[triangles.face[t]]]++] = t;
    shapes_.resize(pieces.pieces.size());
    for (std::uint32_t p = 0; p < shapes_.size(); ++p) shapes_[p].whole = pieces.pieces[p].closed;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        if (triangles.missing[f] && pieces.piece[f] != UINT32_MAX) shapes_[pieces.piece[f]].whole = false;
    for (std::uint32_t p = 0; p < shapes_.size(); ++p) measure(p);
}

void PieceShapes::measure(std::uint32_t piece) {
    PieceShape& shape = shapes_[piece];
    const auto own = triangles_of(piece);
    if (own.empty()) {
        shape.whole = false;
        return;
    }
    const MeshPoint origin = mesh_.points[triangles_.corners[own.front()][0]];
    shape.low = shape.high = origin;
    std::uint32_t faces[2] = {0, 0};  // not turned, turned
    std::uint32_t before = UINT32_MAX;
    for (const std::uint32_t t : own) {
        MeshPoint corner[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const MeshPoint& p = mesh_.points[triangles_.corners[t][k]];
            for (std::size_t i = 0; i < 3; ++i) {
                shape.low[i] = std::min(shape.low[i], p[i]);
                shape.high[i] = std::max(shape.high[i], p[i]);
            }
            corner[k] = minus(p, origin);
        }
        const MeshPoint normal = cross(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
        const bool turned = pieces_.turned[triangles_.face[t]];
        shape.area += std::sqrt(dot(normal, normal)) / 2;
        shape.volume += (turned ? -1 : 1) * dot(corner[0], normal) / 6;
        if (triangles_.face[t] != before) ++faces[turned ? 1 : 0];
        before = triangles_.face[t];
    }
    shape.outward = faces[shape.volume < 0 ? 1 : 0];
    shape.inward = faces[shape.volume < 0 ? 0 : 1];
}

bool PieceShapes::faces_outward(std::uint32_t face) const {
    return pieces_.turned[face] == (shapes_[pieces_.piece[face]].volume < 0);
}

PieceShapes::Side PieceShapes::side(std::uint32_t piece, const MeshPoint& point) const {
    // Solid angles after van Oosterom and Strackee (1983).
    double sum = 0;
    for (const std::uint32_t t : triangles_of(piece)) {
        const auto [i, j, k] = triangles_.corners[t];
        const MeshPoint a = minus(mesh_.points[i], point), b = minus(mesh_.points[j], point),
                        c = minus(mesh_.points[k], point);
        if (touches_origin(a, b, c, touching_)) return Side::On;
        const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
        const double over = dot(a, cross(b, c));
        const double under = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        sum += (pieces_.turned[triangles_.face[t]] ? -2 : 2) * std::atan2(over, under);
    }
    return std::abs(sum) > 2 * std::numbers::pi ? Side::Inside : Side::Outside;
}

}  // namespace enfilade::modeler
