// Rays through single meshes, and asking them.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "tools/bench_octree.h"

namespace enfilade::tools {

namespace {

using render::no_triangle;

constexpr int view_count = 8;
constexpr double eye_distance = 3;
constexpr double half_width = 0.36;  ///< of a picture, over the distance
constexpr double chord_radius = 1.2;
constexpr float skin_of_bounces = 1e-3f;
constexpr accel::MeshId the_mesh{0};

using Place = std::array<double, 3>;

Place cross_of(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot_of(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place unit_of(const Place& a) {
    const double length = std::sqrt(dot_of(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

class Random {
public:
    double number() { return double(random_() >> 11) * 0x1p-53; }
    /// Evenly over the unit sphere.
    Place direction() {
        const double z = 2 * number() - 1, turn = 2 * std::numbers::pi * number(), r = std::sqrt(1 - z * z);
        return {r * std::cos(turn), r * std::sin(turn), z};
    }
    std::size_t below(std::size_t count) { return std::size_t(random_() % count); }

private:
    std::mt19937_64 random_{11};
};

BenchRay ray_from(const Place& origin, const Place& direction) {
    BenchRay ray;
    for (std::size_t k = 0; k < 3; ++k) {
        ray.origin[k] = float(origin[k]);
        ray.direction[k] = float(direction[k]);
    }
    return ray;
}

/// Diffuse light from where the ray ends; nothing where it ends nowhere.
std::optional<BenchRay> bounce_of(const BenchRay& ray, const render::ObjectTracer& tracer, Random& random) {
    render::ObjectRay asked = object_ray(ray);
    tracer.nearest(tracer.state, the_mesh, asked);
    if (asked.triangle == no_triangle) return std::nullopt;
    Place normal = unit_of({asked.normal_x, asked.normal_y, asked.normal_z});
    const Place towards = {ray.direction[0], ray.direction[1], ray.direction[2]};
    if (dot_of(normal, towards) > 0)
        for (double& x : normal) x = -x;
    // A direction on the unit sphere that touches the surface: spread as the cosine.
    Place direction = random.direction();
    for (std::size_t k = 0; k < 3; ++k) direction[k] += normal[k];
    if (!(dot_of(direction, direction) > 1e-6) || !std::isfinite(direction[0])) return std::nullopt;
    Place origin;
    for (std::size_t k = 0; k < 3; ++k)
        origin[k] = double{ray.origin[k]} + double{asked.far} * towards[k] + skin_of_bounces * normal[k];
    return ray_from(origin, unit_of(direction));
}

}  // namespace

const char* name_of(RayCase what) {
    switch (what) {
        case RayCase::OneCoherent: return "one ray, coherent";
        case RayCase::OneApart: return "one ray, incoherent";
        case RayCase::AnyApart: return "any hit, incoherent";
        case RayCase::SixteenCoherent: return "16 rays, coherent";
        case RayCase::SixteenApart: return "16 rays, incoherent";
    }
    return "one ray, coherent";
}

render::ObjectRay object_ray(const BenchRay& ray) {
    const auto& [o, d] = ray;
    return {o[0], o[1], o[2], 0, d[0], d[1], d[2], 0, 1e30f, ~0u, 0, 0, 0, 0, 0, 0, 0, no_triangle, ~0u, ~0u};
}

RayStream::RayStream(std::vector<BenchRay> rays_) : rays(std::move(rays_)) {
    packs.resize(rays.size() / 16);
    for (std::size_t i = 0; i < packs.size(); ++i) {
        render::ObjectRays& pack = packs[i];
        for (std::size_t k = 0; k < 16; ++k) {
            const auto& [o, d] = rays[16 * i + k];
            pack.origin_x[k] = o[0], pack.origin_y[k] = o[1], pack.origin_z[k] = o[2];
            pack.direction_x[k] = d[0], pack.direction_y[k] = d[1], pack.direction_z[k] = d[2];
            pack.near[k] = pack.time[k] = 0;
            pack.far[k] = 1e30f;
            pack.mask[k] = ~0u;
            pack.id[k] = pack.flags[k] = 0;
            pack.normal_x[k] = pack.normal_y[k] = pack.normal_z[k] = pack.u[k] = pack.v[k] = 0;
            pack.triangle[k] = no_triangle;
            pack.geometry[k] = pack.instance[k] = ~0u;
        }
    }
}

std::vector<BenchRay> view_rays(int side) {
    std::vector<BenchRay> rays;
    for (int view = 0; view < view_count; ++view) {
        const double turn = 2 * std::numbers::pi * (view + 0.1) / view_count, up = view % 2 == 0 ? -0.2 : 0.5;
        const Place forward = {-std::cos(turn) * std::cos(up), -std::sin(turn) * std::cos(up), -std::sin(up)};
        const Place eye = {-eye_distance * forward[0], -eye_distance * forward[1], -eye_distance * forward[2]};
        const Place right = unit_of(cross_of(forward, {0, 0, 1})), above = cross_of(right, forward);
        for (int tile = 0; tile < side * side / 16; ++tile)
            for (int pixel = 0; pixel < 16; ++pixel) {
                const int x = tile % (side / 4) * 4 + pixel % 4, y = tile / (side / 4) * 4 + pixel / 4;
                const double px = (2 * (x + 0.5) / side - 1) * half_width, py = (1 - 2 * (y + 0.5) / side) * half_width;
                Place direction;
                for (std::size_t k = 0; k < 3; ++k) direction[k] = forward[k] + px * right[k] + py * above[k];
                rays.push_back(ray_from(eye, direction));
            }
    }
    return rays;
}

std::vector<BenchRay> apart_rays(const std::vector<BenchRay>& views, const render::ObjectTracer& tracer,
                                 std::size_t count) {
    Random random;
    std::vector<BenchRay> rays;
    // Thin things are missed often: some more tries than rays are enough for all that is worth measuring.
    for (std::size_t tries = 0; rays.size() < count / 2 && tries < 20 * count; ++tries)
        if (const auto ray = bounce_of(views[random.below(views.size())], tracer, random)) rays.push_back(*ray);
    while (rays.size() < count) {
        const Place from = random.direction(), to = random.direction();
        Place origin, direction;
        for (std::size_t k = 0; k < 3; ++k) {
            origin[k] = chord_radius * from[k];
            direction[k] = chord_radius * (to[k] - from[k]);
        }
        if (dot_of(direction, direction) > 1e-4) rays.push_back(ray_from(origin, direction));
    }
    for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[random.below(i)]);
    return rays;
}

std::size_t ask(const render::ObjectTracer& tracer, RayCase what, const RayStream& stream) {
    alignas(64) static constexpr std::int32_t all[16] = {-1, -1, -1, -1, -1, -1, -1, -1,
                                                         -1, -1, -1, -1, -1, -1, -1, -1};
    std::size_t hits = 0;
    if (what == RayCase::OneCoherent || what == RayCase::OneApart) {
        for (const BenchRay& ray : stream.rays) {
            render::ObjectRay asked = object_ray(ray);
            tracer.nearest(tracer.state, the_mesh, asked);
            hits += asked.triangle != no_triangle ? 1 : 0;
        }
    } else if (what == RayCase::AnyApart) {
        for (const BenchRay& ray : stream.rays) hits += tracer.blocked(tracer.state, the_mesh, object_ray(ray)) ? 1 : 0;
    } else {
        const auto sixteen = what == RayCase::SixteenCoherent ? tracer.nearest16 : tracer.nearest16_apart;
        for (const render::ObjectRays& pack : stream.packs) {
            render::ObjectRays asked = pack;
            sixteen(tracer.state, the_mesh, all, asked);
            hits += asked.triangle[0] != no_triangle ? 1 : 0;
        }
    }
    return hits;
}

std::vector<MeshAnswer> answers_of(const render::ObjectTracer& tracer, RayCase what, const RayStream& stream) {
    alignas(64) static constexpr std::int32_t all[16] = {-1, -1, -1, -1, -1, -1, -1, -1,
                                                         -1, -1, -1, -1, -1, -1, -1, -1};
    std::vector<MeshAnswer> answers;
    answers.reserve(stream.size());
    if (what == RayCase::SixteenCoherent || what == RayCase::SixteenApart) {
        const auto sixteen = what == RayCase::SixteenCoherent ? tracer.nearest16 : tracer.nearest16_apart;
        for (const render::ObjectRays& pack : stream.packs) {
            render::ObjectRays asked = pack;
            sixteen(tracer.state, the_mesh, all, asked);
            for (std::size_t k = 0; k < 16; ++k) answers.push_back({asked.far[k], asked.triangle[k]});
        }
        return answers;
    }
    for (const BenchRay& ray : stream.rays) {
        render::ObjectRay asked = object_ray(ray);
        if (what == RayCase::AnyApart) {
            const bool is_blocked = tracer.blocked(tracer.state, the_mesh, asked);
            answers.push_back({asked.far, is_blocked ? 0 : no_triangle});
        } else {
            tracer.nearest(tracer.state, the_mesh, asked);
            answers.push_back({asked.far, asked.triangle});
        }
    }
    return answers;
}

}  // namespace enfilade::tools
