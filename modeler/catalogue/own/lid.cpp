#include "modeler/catalogue/own/lid.h"

#include <algorithm>

namespace enfilade::modeler::own {
namespace {

struct Flat {
    double x;
    double y;
};

double turn(Flat a, Flat b, Flat c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }
double square(Flat a, Flat b) { return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y); }

/// The ring in a plane of its own, counter-clockwise (Newell's normal).
std::vector<Flat> flattened(std::span<const Vec> ring) {
    Vec normal;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        normal = normal + cross(ring[k] - ring[0], ring[(k + 1) % ring.size()] - ring[0]);
    }
    if (length(normal) == 0) return {};
    normal = unit(normal);
    const Vec side = std::abs(normal.x) < 0.7 ? Vec{1, 0, 0} : Vec{0, 1, 0};
    const Vec u = unit(cross(side, normal)), v = cross(normal, u);
    std::vector<Flat> flat;
    for (const Vec& p : ring) flat.push_back({dot(p - ring[0], u), dot(p - ring[0], v)});
    return flat;
}

/// How good the ear at `b` is: its height over its longest side, or less than zero where it is none.
double ear_quality(std::span<const Flat> points, std::span<const std::uint32_t> left, std::size_t at) {
    const std::size_t count = left.size();
    const std::uint32_t ia = left[(at + count - 1) % count], ib = left[at], ic = left[(at + 1) % count];
    const Flat a = points[ia], b = points[ib], c = points[ic];
    const double area = turn(a, b, c);
    const double longest = std::max({square(a, b), square(b, c), square(c, a)});
    if (area <= 1e-9 * longest) return -1;
    for (const std::uint32_t k : left) {
        if (k == ia || k == ib || k == ic) continue;
        const Flat p = points[k];
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return -1;
    }
    return area / longest;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> lid(std::span<const Vec> ring) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::vector<Flat> points = flattened(ring);
    if (points.size() < 3) return triangles;
    std::vector<std::uint32_t> left(points.size());
    for (std::uint32_t k = 0; k < left.size(); ++k) left[k] = k;
    std::vector<double> quality(left.size());
    for (std::size_t k = 0; k < left.size(); ++k) quality[k] = ear_quality(points, left, k);
    while (left.size() > 3) {
        const std::size_t count = left.size();
        // Round-off may leave no ear: then the least bad one.
        const auto best = static_cast<std::size_t>(std::ranges::max_element(quality) - quality.begin());
        triangles.push_back({left[(best + count - 1) % count], left[best], left[(best + 1) % count]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
        quality.erase(quality.begin() + static_cast<std::ptrdiff_t>(best));
        for (const std::size_t near : {best % left.size(), (best + left.size() - 1) % left.size()}) {
            quality[near] = ear_quality(points, left, near);
        }
        // An ear that was blocked by the corner that is gone.
        if (*std::ranges::max_element(quality) < 0) {
            for (std::size_t k = 0; k < left.size(); ++k) quality[k] = ear_quality(points, left, k);
        }
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

}  // namespace enfilade::modeler::own
