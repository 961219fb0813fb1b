// Whether answers are right: every triangle of the mesh in double, for those of which there may be a doubt.

#include <algorithm>
#include <cmath>
#include <random>

#include "tools/bench_octree.h"

namespace enfilade::tools {

namespace {

using render::no_triangle;

/// Floats of rays that start 3 from the middle of a box of 2: a ray that passes an edge nearer than that may be said to
/// pass on either side of it.
constexpr double band = 4e-6;

/// What a ray finds in the plane of a triangle.
struct Crossing {
    double along = 0;       ///< parameter
    double inside = -1;     ///< how far within its edges; below 0: outside
    double blur = 0;        ///< what `inside` may err by: the more the flatter the ray
    double far_blur = 0;    ///< what the distance may err by: more where the triangle is a needle, too
    bool is_there = false;  ///< false: the ray lies in the plane, or as good as
};

double share_of_unlike(const MeshAnswer& a, const MeshAnswer& b) {
    if ((a.triangle == no_triangle) != (b.triangle == no_triangle)) return INFINITY;
    if (a.triangle == no_triangle) return 0;
    return std::abs(double{a.distance} - double{b.distance});
}

}  // namespace

MeshJudge::MeshJudge(const BenchMesh& mesh) {
    const accel::SceneView& view = mesh.view();
    for (const accel::MeshTriangle& triangle : view.mesh_triangles) {
        const auto corner = [&](std::size_t k) {
            const accel::Vertex& v = view.mesh_vertices[triangle.corners[k]];
            return Corner{v.x, v.y, v.z};
        };
        triangles_.push_back({corner(0), corner(1), corner(2)});
    }
}

bool MeshJudge::allows(const BenchRay& ray, const MeshAnswer& answer) const {
    const double o[3] = {ray.origin[0], ray.origin[1], ray.origin[2]};
    const double d[3] = {ray.direction[0], ray.direction[1], ray.direction[2]};
    const double speed = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const auto crossing_of = [&](const std::array<Corner, 3>& t) {
        const double a[3] = {t[0].x, t[0].y, t[0].z};
        const double e[3] = {t[1].x - a[0], t[1].y - a[1], t[1].z - a[2]};
        const double f[3] = {t[2].x - a[0], t[2].y - a[1], t[2].z - a[2]};
        const double n[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
        const double twice = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        const double facing = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
        Crossing crossing;
        if (!(std::abs(facing) > 1e-6 * twice * speed)) return crossing;
        crossing.is_there = true;
        crossing.along = (n[0] * (a[0] - o[0]) + n[1] * (a[1] - o[1]) + n[2] * (a[2] - o[2])) / facing;
        crossing.blur = band * twice * speed / std::abs(facing);
        double p[3];
        for (int k = 0; k < 3; ++k) p[k] = o[k] + crossing.along * d[k];
        crossing.inside = INFINITY;
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner& from = t[i];
            const Corner& to = t[(i + 1) % 3];
            const double g[3] = {to.x - from.x, to.y - from.y, to.z - from.z};
            const double q[3] = {p[0] - from.x, p[1] - from.y, p[2] - from.z};
            const double over = n[0] * (g[1] * q[2] - g[2] * q[1]) + n[1] * (g[2] * q[0] - g[0] * q[2]) +
                                n[2] * (g[0] * q[1] - g[1] * q[0]);
            const double length = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
            crossing.inside = std::min(crossing.inside, over / (twice * length));
            longest = std::max(longest, length);
        }
        crossing.far_blur = crossing.blur * (1 + longest * longest / (4 * twice));
        return crossing;
    };
    double end = 1e30;
    if (answer.triangle != no_triangle) {
        if (answer.triangle >= triangles_.size()) return false;
        const Crossing own = crossing_of(triangles_[answer.triangle]);
        // A ray in the plane may be said to meet it anywhere between its corners: others must not be nearer.
        if (own.is_there &&
            (own.inside < -own.blur || std::abs(own.along - double{answer.distance}) * speed > own.far_blur + band))
            return false;
        end = double{answer.distance};
    }
    return std::none_of(triangles_.begin(), triangles_.end(), [&](const std::array<Corner, 3>& triangle) {
        const Crossing other = crossing_of(triangle);
        const double slack = (other.far_blur + band) / speed;
        return other.is_there && other.inside > other.blur && other.along > slack && other.along < end - slack;
    });
}

Verdict judged(const BenchMesh& mesh, const render::ObjectTracer& octree, const render::ObjectTracer& embree,
               const RayStream& coherent, const RayStream& apart, std::size_t tests) {
    const MeshJudge judge(mesh);
    std::mt19937_64 random(3);
    std::size_t left = std::max<std::size_t>(16, tests / std::max<std::size_t>(1, mesh.triangle_count()));
    const std::size_t sample = left / 4;
    Verdict verdict;
    for (const bool is_apart : {false, true}) {
        const RayStream& stream = is_apart ? apart : coherent;
        const RayCase one = is_apart ? RayCase::OneApart : RayCase::OneCoherent;
        const RayCase sixteen = is_apart ? RayCase::SixteenApart : RayCase::SixteenCoherent;
        const std::vector<MeshAnswer> ours = answers_of(octree, one, stream),
                                      packed = answers_of(octree, sixteen, stream);
        const std::vector<MeshAnswer> blocked = answers_of(octree, RayCase::AnyApart, stream);
        const std::vector<MeshAnswer> theirs = answers_of(embree, one, stream);
        const auto look_at = [&](std::size_t i) {
            ++verdict.judged;
            --left;
            verdict.wrong += judge.allows(stream.rays[i], ours[i]) ? 0 : 1;
        };
        for (std::size_t i = 0; i < stream.size(); ++i) {
            ++verdict.rays;
            const bool is_same = ours[i].triangle == packed[i].triangle && ours[i].distance == packed[i].distance &&
                                 (ours[i].triangle == no_triangle) == (blocked[i].triangle == no_triangle);
            verdict.disagree += is_same ? 0 : 1;
            if (share_of_unlike(ours[i], theirs[i]) <= band) continue;
            ++verdict.unlike;
            if (left > (is_apart ? 0 : sample)) look_at(i);
        }
        for (std::size_t k = 0; k < sample / 2 && left > 0; ++k) look_at(std::size_t(random() % stream.size()));
    }
    return verdict;
}

}  // namespace enfilade::tools
