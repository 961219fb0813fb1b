#include "tests/support/degenerate_rays.h"

#include <cmath>
#include <limits>
#include <random>

#include "accel/locate.h"
#include "tests/render/walk_paths.h"
#include "tests/support/rounded_to_float.h"

namespace enfilade::test {

using render::RayQuery;
using render::Vec3d;

namespace {

class Maker {
public:
    Maker(const accel::SceneView& scene, std::uint64_t seed) : scene_(scene), random_(seed) {}

    RayQuery next(Degenerate family) {
        switch (family) {
            case Degenerate::Vertical: return with({zero(), zero(), sign()});
            case Degenerate::NearVertical:
                return with({sign() * std::ldexp(1.0, -10 - below(41)),
                             coin() ? 0 : sign() * std::ldexp(1.0, -10 - below(41)), sign()});
            case Degenerate::SignedZeros: {
                double d[3] = {zero(), zero(), zero()};
                d[below(3)] = sign();
                if (coin()) d[below(3)] = sign();
                return with({d[0], d[1], d[2]});
            }
            case Degenerate::TinyLength: return with(1e-18 * random_direction(random_));
            case Degenerate::HugeLength: return with(1e18 * random_direction(random_));
            case Degenerate::DenormalLength: return with(1e-42 * random_direction(random_));
            case Degenerate::DenormalPart: {
                double d[3] = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
                d[below(3)] = sign() * 1e-42;
                return with({d[0], d[1], d[2]});
            }
            case Degenerate::OnFaces: return from_a_face();
            case Degenerate::OnCorners: return from_a_corner();
            case Degenerate::Limited: return limited();
            case Degenerate::NoRay: return no_ray();
        }
        return with({1, 0, 0});
    }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    bool coin() { return below(2) == 0; }
    double sign() { return coin() ? 1 : -1; }
    double zero() { return coin() ? 0.0 : -0.0; }

    RayQuery with(Vec3d direction) {
        const auto cell = static_cast<std::uint32_t>(random_() % scene_.cells.size());
        const Vec3d d = rounded_to_float(direction);
        return {random_point(scene_, cell, random_), d, static_cast<accel::CellId>(cell)};
    }

    RayQuery from_a_face() {
        const RayQuery first = with(random_direction(random_));
        const render::RayHit hit = render::trace_ray(scene_, first);
        Vec3d p = rounded_to_float(first.origin + hit.distance * normalized(first.direction));
        const accel::Cell& cell = scene_.cells[index(hit.cell)];
        if (hit.exit == render::Exit::Floor) p.z = cell.z_floor;
        if (hit.exit == render::Exit::Ceiling) p.z = cell.z_ceiling;
        Vec3d d = random_direction(random_);
        if (below(4) == 0) d.z = 0;
        if (below(8) == 0) d = first.direction - 2 * d.z * Vec3d{0, 0, 1};
        return {p, rounded_to_float(d), hit.cell};
    }

    RayQuery from_a_corner() {
        for (;;) {
            const accel::Cell& cell = scene_.cells[random_() % scene_.cells.size()];
            const std::uint32_t s = cell.first_section + static_cast<std::uint32_t>(below(cell.section_count));
            const double heights[3] = {
                cell.z_floor, rounded_to_float(0.5 * (double{cell.z_floor} + double{cell.z_ceiling})), cell.z_ceiling};
            const Vec3d p = {scene_.section_x[s], scene_.section_y[s], heights[below(3)]};
            const auto start = accel::locate(scene_, {p.x, p.y, p.z});
            if (!start) continue;
            Vec3d d = random_direction(random_);
            if (coin()) d.z = 0;
            return {p, rounded_to_float(d), *start};
        }
    }

    RayQuery limited() {
        RayQuery ray = with(uniform(0.1, 10) * random_direction(random_));
        const double distance = render::trace_ray(scene_, ray).distance;
        const double factors[7] = {0, 0.5, 1 - 1e-4, 1, 1 + 1e-4, 2, 1e6};
        ray.max_distance = rounded_to_float(factors[below(7)] * distance);
        if (below(16) == 0) ray.max_distance = std::numeric_limits<double>::infinity();
        return ray;
    }

    RayQuery no_ray() {
        RayQuery ray = with(random_direction(random_));
        constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
        const double bad = below(3) == 0 ? nan : coin() ? inf : -inf;
        double* const numbers[6] = {&ray.origin.x,    &ray.origin.y,    &ray.origin.z,
                                    &ray.direction.x, &ray.direction.y, &ray.direction.z};
        const int which = below(9);
        if (which < 6) *numbers[which] = bad;
        if (which == 6) ray.direction = {zero(), zero(), zero()};
        if (which == 7) ray.max_distance = nan;  // the others are proper rays between them
        return ray;
    }

    const accel::SceneView& scene_;
    std::mt19937_64 random_;
};

}  // namespace

const char* name_of(Degenerate family) {
    switch (family) {
        case Degenerate::Vertical: return "vertical";
        case Degenerate::NearVertical: return "nearly vertical";
        case Degenerate::SignedZeros: return "zeros of either sign";
        case Degenerate::TinyLength: return "1e-18 long";
        case Degenerate::HugeLength: return "1e+18 long";
        case Degenerate::DenormalLength: return "denormal";
        case Degenerate::DenormalPart: return "one part denormal";
        case Degenerate::OnFaces: return "from faces";
        case Degenerate::OnCorners: return "from corners";
        case Degenerate::Limited: return "limited";
        case Degenerate::NoRay: return "no rays";
    }
    return "?";
}

std::vector<RayQuery> degenerate_rays(const accel::SceneView& scene, Degenerate family, std::size_t count,
                                      std::uint64_t seed) {
    Maker maker(scene, seed);
    std::vector<RayQuery> rays;
    rays.reserve(count);
    while (rays.size() < count) rays.push_back(maker.next(family));
    return rays;
}

}  // namespace enfilade::test
