#include "modeler/catalogue/nearest_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace enfilade::modeler {
namespace {

using Point3 = std::array<double, 3>;

constexpr std::uint32_t leaf_size = 4;

Point3 minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point3 along(const Point3& a, const Point3& d, double t) { return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]}; }

double to_segment(const Point3& p, const Point3& a, const Point3& b) {
    const Point3 d = minus(b, a);
    const double length = dot(d, d);
    const double t = length > 0 ? std::clamp(dot(minus(p, a), d) / length, 0.0, 1.0) : 0;
    const Point3 to = minus(p, along(a, d, t));
    return dot(to, to);
}

Point3 vertex(const ObjectMesh& mesh, std::uint32_t v) {
    return {mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]};
}

}  // namespace

NearestSurface::NearestSurface(const ObjectMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::vector<std::array<float, 3>> centres;
    centres.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        std::array<float, 3> centre;
        for (std::size_t k = 0; k < 3; ++k) centre[k] = mesh.vertices[a][k] + mesh.vertices[b][k] + mesh.vertices[c][k];
        centres.push_back(centre);
    }
    nodes_.reserve(mesh.triangles.size());
    nodes_.push_back({});
    split(0, 0, static_cast<std::uint32_t>(order_.size()), centres);
}

void NearestSurface::split(std::uint32_t node, std::uint32_t first, std::uint32_t count,
                           const std::vector<std::array<float, 3>>& centres) {
    constexpr float far = std::numeric_limits<float>::infinity();
    Node box{{far, far, far}, {-far, -far, -far}, first, count};
    std::array<float, 3> low = box.low;
    std::array<float, 3> high = box.high;
    for (std::uint32_t k = first; k < first + count; ++k) {
        for (const std::uint32_t v : mesh_.triangles[order_[k]])
            for (std::size_t i = 0; i < 3; ++i) {
                box.low[i] = std::min(box.low[i], mesh_.vertices[v][i]);
                box.high[i] = std::max(box.high[i], mesh_.vertices[v][i]);
            }
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], centres[order_[k]][i]);
            high[i] = std::max(high[i], centres[order_[k]][i]);
        }
    }
    nodes_[node] = box;
    if (count <= leaf_size) return;
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    // By the median, so that depth is bounded whatever the triangles are.
    const std::uint32_t half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
    });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = children;
    nodes_[node].count = 0;
    split(children, first, half, centres);
    split(children + 1, first + half, count - half, centres);
}

double NearestSurface::to_triangle(std::uint32_t triangle, const Point3& p) const {
    const auto& corners = mesh_.triangles[triangle];
    const Point3 a = vertex(mesh_, corners[0]);
    const Point3 b = vertex(mesh_, corners[1]);
    const Point3 c = vertex(mesh_, corners[2]);
    const Point3 u = minus(b, a);
    const Point3 v = minus(c, a);
    const Point3 w = minus(p, a);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
    const double area = uu * vv - uv * uv;
    if (area > 0) {
        const double s = (wu * vv - wv * uv) / area;
        const double t = (wv * uu - wu * uv) / area;
        if (s >= 0 && t >= 0 && s + t <= 1) {
            const Point3 to = minus(w, along(along({0, 0, 0}, u, s), v, t));
            return dot(to, to);
        }
    }
    return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}

double NearestSurface::distance_squared(const Point3& p, double limit) const {
    const auto to_box = [&](const Node& node) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = std::max({node.low[k] - p[k], p[k] - node.high[k], 0.0});
            sum += d * d;
        }
        return sum;
    };
    if (mesh_.triangles.empty()) return limit;
    std::array<std::pair<double, std::uint32_t>, 128> open;  // depth is at most 32
    std::size_t size = 0;
    open[size++] = {to_box(nodes_[0]), 0};
    while (size > 0) {
        const auto [distance, at] = open[--size];
        if (distance >= limit) continue;
        const Node& node = nodes_[at];
        if (node.count > 0) {
            for (std::uint32_t k = 0; k < node.count; ++k)
                limit = std::min(limit, to_triangle(order_[node.first + k], p));
            continue;
        }
        std::pair<double, std::uint32_t> left = {to_box(nodes_[node.first]), node.first};
        std::pair<double, std::uint32_t> right = {to_box(nodes_[node.first + 1]), node.first + 1};
        if (right < left) std::swap(left, right);
        open[size++] = right;
        open[size++] = left;  // the nearer first
    }
    return limit;
}

double surface_distance(const ObjectMesh& whole, const ObjectMesh& reduced) {
    constexpr double far = std::numeric_limits<double>::infinity();
    double largest = 0;
    const NearestSurface of_whole(whole);
    const NearestSurface of_reduced(reduced);
    for (std::uint32_t v = 0; v < whole.vertices.size(); ++v)
        largest = std::max(largest, of_reduced.distance_squared(vertex(whole, v), far));
    for (const auto& corners : reduced.triangles) {
        Point3 middle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Point3 p = vertex(reduced, corners[k]);
            const Point3 q = vertex(reduced, corners[(k + 1) % 3]);
            middle = along(middle, p, 1.0 / 3);
            largest = std::max(largest, of_whole.distance_squared(p, far));
            largest = std::max(largest, of_whole.distance_squared(along(along({0, 0, 0}, p, 0.5), q, 0.5), far));
        }
        largest = std::max(largest, of_whole.distance_squared(middle, far));
    }
    return std::sqrt(largest);
}

}  // namespace enfilade::modeler
