#include "tests/support/octree_rays.h"

#include <cmath>
#include <limits>

namespace enfilade::test {
namespace {

using render::ObjectRay;
using render::Vec3d;
constexpr float endless = 1e30f;

double& part(Vec3d& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

OctreeRays::OctreeRays(const TriedMesh& mesh, const accel::OctreeFrame& frame, std::uint64_t seed)
    : mesh_(mesh), frame_(frame), numbers_(seed) {
    for (int k = 0; k < 3; ++k) part(middle_, k) = 0.5 * (double{mesh.low(k)} + mesh.high(k));
}

/// In the box of the mesh, made so much wider about its middle.
Vec3d OctreeRays::in_box(double wider) {
    Vec3d p;
    for (int k = 0; k < 3; ++k)
        part(p, k) = part(middle_, k) + 0.5 * wider * (double{mesh_.high(k)} - mesh_.low(k)) * numbers_.next();
    return p;
}

Vec3d OctreeRays::corner() {
    return mesh_.corner(mesh_.used()[below(static_cast<std::uint32_t>(mesh_.used().size()))], below(3));
}

/// The float that the walk takes for the plane exactly, where there is one.
double OctreeRays::lattice_place(int axis, std::uint32_t plane) const {
    const auto k = static_cast<std::size_t>(axis);
    float place = static_cast<float>(double{frame_.low[k]} + plane / double{frame_.cells_a_unit[k]});
    for (int tries = 0; tries < 3; ++tries) {
        const float cell = (place - frame_.low[k]) * frame_.cells_a_unit[k];
        if (cell == static_cast<float>(plane)) break;
        place = std::nextafter(place, cell < static_cast<float>(plane) ? std::numeric_limits<float>::max()
                                                                       : -std::numeric_limits<float>::max());
    }
    return place;
}

/// Those of high levels more often: there leaves meet.
std::uint32_t OctreeRays::lattice_plane() {
    const std::uint32_t level = below(frame_.depth + 1);
    return below((1u << level) + 1) << (frame_.depth - level);
}

ObjectRay OctreeRays::outside() {
    const Vec3d from = middle_ + numbers_.point(2 * mesh_.size()), to = in_box();
    return object_ray(from, to - from, 0, endless);
}

ObjectRay OctreeRays::at_edges(bool corners) {
    const std::uint32_t t = mesh_.used()[below(static_cast<std::uint32_t>(mesh_.used().size()))];
    const std::uint32_t k = below(3);
    const Vec3d a = mesh_.corner(t, k), b = mesh_.corner(t, (k + 1) % 3);
    const Vec3d to = corners ? a : a + 0.25 * static_cast<double>(1 + below(3)) * (b - a);
    const Vec3d from = below(2) == 0 ? in_box() : middle_ + numbers_.point(2 * mesh_.size());
    return object_ray(from, to - from, 0, endless);
}

ObjectRay OctreeRays::from_triangles() {
    const std::uint32_t t = mesh_.used()[below(static_cast<std::uint32_t>(mesh_.used().size()))];
    const Vec3d a = mesh_.corner(t, 0), b = mesh_.corner(t, 1), c = mesh_.corner(t, 2);
    const Vec3d starts[4] = {a, 0.5 * (a + b), (1.0 / 3) * (a + b + c), 0.25 * a + 0.75 * c};
    Vec3d direction = numbers_.point(1);
    if (below(4) == 0) direction = b - a;
    return object_ray(starts[below(4)], direction, below(2) == 0 ? 0 : 1e-4f, endless);
}

ObjectRay OctreeRays::along_axes() {
    const int axis = static_cast<int>(below(3));
    Vec3d direction = below(2) == 0 ? Vec3d{0, 0, 0} : Vec3d{-0.0, -0.0, -0.0};
    Vec3d from = below(2) == 0 ? corner() : in_box(1.1);
    const double way = below(2) == 0 ? 1 : -1;
    part(direction, axis) = way * mesh_.size();
    const std::uint32_t start = below(4);
    if (start > 0) part(from, axis) = part(middle_, axis) - way * mesh_.size() * (start == 3 ? 0.5 : 2);
    return object_ray(from, direction, 0, endless);
}

ObjectRay OctreeRays::nearly_along_axes() {
    ObjectRay ray = along_axes();
    constexpr float little[] = {1e-3f, 1e-6f, 1e-9f, 1e-20f, 1e-30f, 1e-37f, 1e-40f, 1e-45f};
    for (float* d : {&ray.direction_x, &ray.direction_y, &ray.direction_z})
        if (*d == 0) *d = (below(2) == 0 ? 1.0f : -1.0f) * little[below(8)] * static_cast<float>(mesh_.size());
    return ray;
}

ObjectRay OctreeRays::in_lattice(int planes) {
    Vec3d from = in_box(1.2), direction = numbers_.point(mesh_.size());
    const std::uint32_t first = below(3);
    for (int i = 0; i < planes; ++i) {
        const int axis = static_cast<int>((first + static_cast<std::uint32_t>(i)) % 3);
        part(from, axis) = lattice_place(axis, lattice_plane());
        if (planes == 2 || below(2) == 0) part(direction, axis) = below(2) == 0 ? 0.0 : -0.0;
    }
    return object_ray(from, direction, 0, endless);
}

ObjectRay OctreeRays::from_lattice_corners() {
    Vec3d from, to;
    for (int k = 0; k < 3; ++k) {
        part(from, k) = lattice_place(k, lattice_plane());
        part(to, k) = lattice_place(k, lattice_plane());
    }
    const double size = mesh_.size();
    const Vec3d diagonal = {below(2) == 0 ? size : -size, below(2) == 0 ? size : -size, below(2) == 0 ? size : -size};
    Vec3d direction = below(3) == 0 ? to - from : diagonal;
    if (below(4) == 0) part(direction, static_cast<int>(below(3))) = 0;
    if (direction == Vec3d{0, 0, 0}) direction = diagonal;
    if (below(2) == 0) from = from - 2.0 * direction;
    return object_ray(from, direction, 0, endless);
}

ObjectRay OctreeRays::parts() {
    ObjectRay ray = outside();
    const ObjectRay met = mesh_.nearest(ray);
    const bool is_hit = met.triangle != render::no_triangle;
    const float at = is_hit ? met.far : 1;
    switch (below(8)) {
        case 0: ray.far = at; break;
        case 1: ray.near = at; break;
        case 2: ray.near = ray.far = at; break;
        case 3: ray.far = std::nextafter(at, 0.0f); break;
        case 4: ray.near = std::nextafter(at, endless); break;
        case 5: ray.near = at * 1.5f, ray.far = at * 0.5f; break;
        case 6: ray.near = static_cast<float>(share()), ray.far = ray.near + static_cast<float>(share()); break;
        default: ray.near = -static_cast<float>(share()), ray.far = static_cast<float>(share()); break;
    }
    return ray;
}

ObjectRay OctreeRays::take(OctreeRayFamily family) {
    switch (family) {
        case OctreeRayFamily::Outside: return outside();
        case OctreeRayFamily::Inside: {
            const Vec3d from = in_box();
            return object_ray(from, numbers_.point(1), 0, endless);
        }
        case OctreeRayFamily::Far: {
            constexpr double distances[] = {10, 1e3, 1e5, 1e6};
            const Vec3d to = in_box();
            const Vec3d from = to + distances[below(4)] * mesh_.size() * normalized(numbers_.point(1));
            return object_ray(from, (below(2) == 0 ? 1.0 : 1e-3) * (to - from), 0, endless);
        }
        case OctreeRayFamily::AtCorners: return at_edges(true);
        case OctreeRayFamily::AtEdges: return at_edges(false);
        case OctreeRayFamily::FromTriangles: return from_triangles();
        case OctreeRayFamily::AlongAxes: return along_axes();
        case OctreeRayFamily::NearlyAlongAxes: return nearly_along_axes();
        case OctreeRayFamily::InLatticePlanes: return in_lattice(1);
        case OctreeRayFamily::AlongLatticeEdges: return in_lattice(2);
        case OctreeRayFamily::FromLatticeCorners: return from_lattice_corners();
        case OctreeRayFamily::Scaled: {
            ObjectRay ray = below(2) == 0 ? outside() : along_axes();
            const float scale = below(2) == 0 ? 1e-18f : 1e18f;
            ray.direction_x *= scale;
            ray.direction_y *= scale;
            ray.direction_z *= scale;
            return ray;
        }
        case OctreeRayFamily::Parts: return parts();
    }
    return outside();
}

}  // namespace enfilade::test
