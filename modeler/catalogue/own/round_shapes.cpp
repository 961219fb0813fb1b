#include <algorithm>

#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {

void lathe(Shaper& shaper, std::span<const Vec> profile, const Paint& paint, int plain) {
    const int sides = shaper.fine(plain);
    std::vector<Ring> rings;
    for (const Vec& p : profile) rings.push_back(ellipse({0, 0, p.z}, p.x, p.x, sides));
    shaper.skin(rings, paint);
}

void ball(Shaper& shaper, Vec centre, Vec radii, const Paint& paint, int plain) {
    const int sides = shaper.fine(plain), rows = std::max(3, sides / 2);
    std::vector<Ring> rings;
    for (int k = 0; k <= rows; ++k) {
        const double angle = pi * k / rows;
        const double around = k == 0 || k == rows ? 0 : std::sin(angle);
        rings.push_back(
            ellipse(centre - Vec{0, 0, radii.z * std::cos(angle)}, radii.x * around, radii.y * around, sides));
    }
    shaper.skin(rings, paint);
}

void drum(Shaper& shaper, Vec bottom, double radius, double height, const Paint& paint, double edge, int plain) {
    const int steps = std::min(shaper.detail(), 4), sides = shaper.fine(plain);
    edge = std::min({edge, 0.49 * height, 0.9 * radius});
    std::vector<Ring> rings;
    for (int k = 0; k <= steps; ++k) {
        const double angle = pi / 2 * (1 - static_cast<double>(k) / steps);
        const double r = radius - edge * (1 - std::cos(angle));
        rings.push_back(ellipse(bottom + Vec{0, 0, edge * (1 - std::sin(angle))}, r, r, sides));
    }
    for (int k = 0; k <= steps; ++k) {
        const double angle = pi / 2 * k / steps, r = radius - edge * (1 - std::cos(angle));
        rings.push_back(ellipse(bottom + Vec{0, 0, height - edge * (1 - std::sin(angle))}, r, r, sides));
    }
    shaper.skin(rings, paint);
}

void tube(Shaper& shaper, std::span<const Vec> path, std::span<const double> radii, const Paint& paint, int plain,
          Ends ends) {
    const int sides = shaper.fine(plain);
    const std::size_t count = path.size();
    const bool is_looped = ends == Ends::Looped;
    std::vector<Ring> rings;
    Vec across;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec before = path[k > 0 ? k - 1 : (is_looped ? count - 1 : 0)];
        const Vec after = path[k + 1 < count ? k + 1 : (is_looped ? 0 : count - 1)];
        const Vec along = unit(after - before);
        // Carried along the path, so that the tube does not twist.
        if (k == 0) across = std::abs(along.z) < 0.9 ? Vec{0, 0, 1} : Vec{1, 0, 0};
        across = unit(across - dot(across, along) * along);
        const Vec side = cross(along, across);
        const double radius = radii[std::min(k, radii.size() - 1)];
        Ring& ring = rings.emplace_back();
        for (int s = 0; s < sides; ++s) {
            const double angle = 2 * pi * s / sides;
            ring.push_back(path[k] + (radius * std::cos(angle)) * across + (radius * std::sin(angle)) * side);
        }
    }
    shaper.skin(rings, paint, ends);
}

void tube(Shaper& shaper, std::span<const Vec> path, double radius, const Paint& paint, int plain, Ends ends) {
    tube(shaper, path, std::span(&radius, 1), paint, plain, ends);
}

void vessel(Shaper& shaper, const Vessel& v, const Paint& paint) {
    const int quarter = std::max(2, shaper.fine(v.plain) / 4), rows = shaper.fine(5);
    std::vector<Ring> rings;
    const auto ring = [&](double hx, double hy, double z) {
        rings.push_back(rounded_rectangle({0, 0, z}, hx, hy, v.corner * std::min(hx, hy), quarter, 2));
    };
    const auto oval = [&](double hx, double hy, double z) {
        if (v.corner < 1) return ring(hx, hy, z);
        rings.push_back(ellipse({0, 0, z}, hx, hy, 4 * quarter));
    };
    const double height = v.rim - v.bottom, lip = 0.5 * v.wall;
    for (int k = 0; k <= rows; ++k) {  // outside, bulging out
        const double t = static_cast<double>(k) / rows, bulge = std::sin(t * pi / 2);
        oval(mix(v.half_bottom.x, v.half_rim.x, bulge), mix(v.half_bottom.y, v.half_rim.y, bulge),
             v.bottom + t * (height - lip));
    }
    const int lip_steps = shaper.fine(3);
    for (int k = 1; k <= lip_steps; ++k) {  // over the rim
        const double angle = pi * k / lip_steps;
        const double inset = 0.5 * v.wall * (1 - std::cos(angle));
        oval(v.half_rim.x - inset, v.half_rim.y - inset, v.rim - lip + lip * std::sin(angle));
    }
    const Vec rim{v.half_rim.x - v.wall, v.half_rim.y - v.wall, 0};
    const double floor = v.bottom + v.floor;
    for (int k = 1; k <= 2 * rows; ++k) {  // down the hollow, round at its foot, to the middle
        const double t = static_cast<double>(k) / (2 * rows), angle = t * pi / 2;
        const double share = k == 2 * rows ? 0 : std::pow(std::cos(angle), 0.45 / std::max(v.slope, 0.1));
        const double z = mix(v.rim - lip, floor, std::pow(std::sin(angle), 0.75));
        oval(rim.x * share, rim.y * share, z);
    }
    shaper.skin(rings, paint);
}

}  // namespace enfilade::modeler::own
