#include "modeler/objects/sun_paths.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {
namespace {

constexpr double level = 1e-6;  ///< of the cosine between light and a face that it grazes

double turn(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

}  // namespace

SunPaths::SunPaths(const accel::SceneView& scene, const std::array<double, 3>& sun, double margin)
    : scene_(scene), margin_(margin), is_on_path_(scene.cells.size()) {
    const double length = std::hypot(sun[0], sun[1], sun[2]);
    for (std::size_t k = 0; k < 3; ++k) sun_[k] = sun[k] / length;
    // u level, unless the sun stands overhead; v across both.
    const double flat = std::hypot(sun_[0], sun_[1]);
    if (flat > 0) u_ = {-sun_[1] / flat, sun_[0] / flat, 0};
    else u_ = {1, 0, 0};
    v_ = {sun_[1] * u_[2] - sun_[2] * u_[1], sun_[2] * u_[0] - sun_[0] * u_[2], sun_[0] * u_[1] - sun_[1] * u_[0]};
}

SunPaths::Spot SunPaths::seen_at(double x, double y, double z) const {
    return {u_[0] * x + u_[1] * y + u_[2] * z, v_[0] * x + v_[1] * y + v_[2] * z};
}

SunPaths::Polygon SunPaths::hull(Polygon spots) {
    std::sort(spots.begin(), spots.end(),
              [](const Spot& a, const Spot& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
    spots.erase(std::unique(spots.begin(), spots.end()), spots.end());
    if (spots.size() < 3) return spots;
    Polygon ring;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t first = ring.size();
        for (const Spot& p : spots) {
            while (ring.size() >= first + 2) {
                const Spot &a = ring[ring.size() - 2], &b = ring.back();
                if (turn(b.u - a.u, b.v - a.v, p.u - b.u, p.v - b.v) > 0) break;
                ring.pop_back();
            }
            ring.push_back(p);
        }
        ring.pop_back();
        std::reverse(spots.begin(), spots.end());
    }
    return ring;
}

SunPaths::Polygon SunPaths::common(const Polygon& light, const Polygon& gate) const {
    Polygon kept = light, next;
    const auto cut = [&](double nu, double nv, double most) {  // keeps n . p <= most
        next.clear();
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const Spot &a = kept[i], &b = kept[i + 1 == kept.size() ? 0 : i + 1];
            const double at_a = most - nu * a.u - nv * a.v, at_b = most - nu * b.u - nv * b.v;
            if (at_a >= 0) next.push_back(a);
            if ((at_a < 0) == (at_b < 0)) continue;
            const double t = at_a / (at_a - at_b);
            next.push_back({a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)});
        }
        kept.swap(next);
    };
    // The box of the gate cuts what its sides leave beyond sharp corners, and beyond the ends of gates without area.
    double low_u = INFINITY, high_u = -INFINITY, low_v = INFINITY, high_v = -INFINITY;
    for (const Spot& p : gate) {
        low_u = std::min(low_u, p.u), high_u = std::max(high_u, p.u);
        low_v = std::min(low_v, p.v), high_v = std::max(high_v, p.v);
    }
    cut(1, 0, high_u + margin_);
    cut(-1, 0, margin_ - low_u);
    cut(0, 1, high_v + margin_);
    cut(0, -1, margin_ - low_v);
    for (std::size_t i = 0; i < gate.size() && gate.size() > 1 && !kept.empty(); ++i) {
        const Spot &a = gate[i], &b = gate[i + 1 == gate.size() ? 0 : i + 1];
        const double du = b.u - a.u, dv = b.v - a.v, length = std::hypot(du, dv);
        if (length > 0) cut(dv / length, -du / length, (dv * a.u - du * a.v) / length + margin_);
    }
    return kept;
}

void SunPaths::mark(const accel::BeamSource& region, std::vector<char>& is_crossed) {
    is_crossed_ = &is_crossed;
    Polygon light;
    for (const accel::PlanPoint& p : region.corners)
        for (const std::int64_t z : {region.z_low, region.z_high})
            light.push_back(seen_at(double(p.x) * scene_.unit, double(p.y) * scene_.unit, double(z) * scene_.unit));
    follow(static_cast<std::uint32_t>(region.cell), hull(std::move(light)));
}

bool SunPaths::follow(std::uint32_t c, const Polygon& light) {
    if (is_on_path_[c] != 0) return false;  // rounding may lead back; a line enters no convex cell twice
    is_on_path_[c] = 1;
    const accel::Cell& cell = scene_.cells[c];
    bool is_sunlit = false;
    for (std::uint32_t i = 0; i < cell.section_count; ++i)
        is_sunlit |= follow_side(c, cell.first_section + i,
                                 cell.first_section + (i + 1u == cell.section_count ? 0 : i + 1), light);
    if (sun_[2] > -level) is_sunlit |= follow_level(c, cell.ceiling, double{cell.z_ceiling}, light);
    if (sun_[2] < level) is_sunlit |= follow_level(c, cell.floor, double{cell.z_floor}, light);
    is_on_path_[c] = 0;
    if (is_sunlit) (*is_crossed_)[c] = 1;
    return is_sunlit;
}

bool SunPaths::follow_side(std::uint32_t c, std::uint32_t section, std::uint32_t next, const Polygon& light) {
    const double ax = double{scene_.section_x[section]}, ay = double{scene_.section_y[section]};
    const double bx = double{scene_.section_x[next]}, by = double{scene_.section_y[next]};
    // Cells run counter-clockwise: what is outside lies on the right.
    const double outward = (by - ay) * sun_[0] - (bx - ax) * sun_[1];
    if (outward < -level * std::hypot(bx - ax, by - ay)) return false;
    bool is_sunlit = false;
    double bottom = double{scene_.cells[c].z_floor};
    for (std::uint32_t f = scene_.section_tails[section].first_face; f < scene_.section_tails[section + 1].first_face;
         ++f) {
        const accel::SideFace& face = scene_.side_faces[f];
        const double top = double{face.z_top};
        const Polygon gate =
            hull({seen_at(ax, ay, bottom), seen_at(bx, by, bottom), seen_at(bx, by, top), seen_at(ax, ay, top)});
        is_sunlit |= pass(face.target, common(light, gate));
        bottom = top;
    }
    return is_sunlit;
}

bool SunPaths::follow_level(std::uint32_t c, accel::Target target, double z, const Polygon& light) {
    const accel::Cell& cell = scene_.cells[c];
    Polygon gate;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s)
        gate.push_back(seen_at(double{scene_.section_x[s]}, double{scene_.section_y[s]}, z));
    return pass(target, common(light, hull(std::move(gate))));
}

bool SunPaths::pass(accel::Target target, const Polygon& light) {
    if (light.empty()) return false;
    if (target.is_portal()) return follow(static_cast<std::uint32_t>(target.neighbour()), light);
    return scene_.source_faces[static_cast<std::uint32_t>(target.source_face())].surface == accel::Surface::Sky;
}

}  // namespace enfilade::modeler
