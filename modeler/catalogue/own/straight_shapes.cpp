#include <algorithm>

#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {
namespace {

/// How a level ring shrinks and sinks over a rounded edge: (inset, how far from the face), outermost first.
std::vector<std::pair<double, double>> edge_profile(double radius, int steps) {
    std::vector<std::pair<double, double>> profile;
    for (int k = 0; k <= steps; ++k) {
        const double angle = pi / 2 * k / steps;
        profile.emplace_back(radius * (1 - std::cos(angle)), radius * (1 - std::sin(angle)));
    }
    return profile;
}

/// Wide edges are seen to be round even in plain pieces, narrow ones never.
int edge_steps(const Shaper& shaper, double radius) {
    if (radius < 0.0012) return 1;
    return radius > 0.015 ? std::min(shaper.detail() + 2, 6) : std::min(shaper.detail(), 4);
}

}  // namespace

void post(Shaper& shaper, Vec from, Vec to, Vec half_from, Vec half_to, const Paint& paint, double radius) {
    const double most = 0.98 * std::min({half_from.x, half_from.y, half_to.x, half_to.y});
    radius = std::min({radius, most, 0.49 * std::abs(to.z - from.z)});
    const int steps = edge_steps(shaper, radius);
    std::vector<Ring> rings;
    const auto ring = [&](Vec centre, Vec half, double inset) {
        rings.push_back(rounded_rectangle(centre, half.x - inset, half.y - inset, radius - inset, steps));
    };
    const double sign = to.z > from.z ? 1 : -1;
    if (radius <= 0) {
        ring(from, half_from, 0), ring(to, half_to, 0);
    } else {
        const auto profile = edge_profile(radius, steps);
        for (auto step = profile.rbegin(); step != profile.rend(); ++step) {
            ring(from + Vec{0, 0, sign * step->second}, half_from, step->first);
        }
        for (const auto& [inset, depth] : profile) ring(to - Vec{0, 0, sign * depth}, half_to, inset);
    }
    shaper.skin(rings, paint);
}

void block(Shaper& shaper, Vec low, Vec high, const Paint& paint, double radius) {
    const Vec half = 0.5 * (high - low), middle = 0.5 * (low + high);
    post(shaper, {middle.x, middle.y, low.z}, {middle.x, middle.y, high.z}, half, half, paint, radius);
}

void rod(Shaper& shaper, Vec from, Vec to, double radius_from, double radius_to, const Paint& paint, int plain) {
    const Vec along = unit(to - from);
    const double edge = std::min({0.25 * radius_from, 0.25 * radius_to, 0.2 * length(to - from)});
    const int steps = shaper.detail() < 2 ? 0 : std::min(shaper.detail() - 1, 4);
    std::vector<Vec> path;
    std::vector<double> radii;
    const auto add = [&](Vec p, double radius) { path.push_back(p), radii.push_back(radius); };
    if (steps == 0) {
        add(from, radius_from), add(to, radius_to);
    } else {
        const auto profile = edge_profile(edge, steps);
        for (auto step = profile.rbegin(); step != profile.rend(); ++step) {
            add(from + step->second * along, radius_from - step->first);
        }
        for (const auto& [inset, depth] : profile) add(to - depth * along, radius_to - inset);
    }
    tube(shaper, path, radii, paint, plain);
}

void slat(Shaper& shaper, Vec left, Vec right, double bow, double half_height, double half_thickness,
          const Paint& paint) {
    const int parts = std::max(2, shaper.fine(8)), steps = std::min(shaper.detail(), 4);
    const double radius = 0.8 * std::min(half_height, half_thickness);
    std::vector<Ring> rings;
    for (int k = 0; k <= parts; ++k) {
        const double t = static_cast<double>(k) / parts;
        const Vec centre = mix(left, right, t) + Vec{0, 4 * bow * t * (1 - t), 0};
        Ring& ring = rings.emplace_back();
        for (const Vec& p : rounded_rectangle({}, half_thickness, half_height, radius, steps)) {
            ring.push_back(centre + Vec{0, p.x, p.y});
        }
    }
    shaper.skin(rings, paint);
}

void plate(Shaper& shaper, std::span<const Vec> outline, double low, double high, const Paint& paint, double bevel) {
    const std::size_t count = outline.size();
    double area = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec a = outline[k], b = outline[(k + 1) % count];
        area += a.x * b.y - a.y * b.x;
    }
    const double side = area < 0 ? -1 : 1;
    const auto ring = [&](double z, double inset) {
        Ring points;
        for (std::size_t k = 0; k < count; ++k) {
            const Vec a = outline[(k + count - 1) % count], b = outline[k], c = outline[(k + 1) % count];
            const Vec before = unit({b.x - a.x, b.y - a.y, 0}), after = unit({c.x - b.x, c.y - b.y, 0});
            Vec inward = side * Vec{-(before.y + after.y), before.x + after.x, 0};
            const double turn = std::max(0.3, 1 + dot(before, after));
            inward = (inset / turn) * inward;
            points.push_back({b.x + inward.x, b.y + inward.y, z});
        }
        return points;
    };
    std::vector<Ring> rings;
    if (bevel > 0) {
        const int steps = std::min(shaper.detail(), 3);
        const auto profile = edge_profile(std::min(bevel, 0.49 * (high - low)), steps);
        for (auto step = profile.rbegin(); step != profile.rend(); ++step) {
            rings.push_back(ring(low + step->second, step->first));
        }
        for (const auto& [inset, depth] : profile) rings.push_back(ring(high - depth, inset));
    } else {
        rings = {ring(low, 0), ring(high, 0)};
    }
    shaper.skin(rings, paint);
}

}  // namespace enfilade::modeler::own
