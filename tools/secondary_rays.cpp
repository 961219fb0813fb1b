#include "tools/secondary_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "render/oracle.h"

namespace enfilade::tools {

using render::Vec3d;
using render::Vec3f;

namespace {

constexpr int tile_side = 64;
constexpr int block_side = 4;

/// Primary rays of the chosen tiles, block by block.
OwnedRays camera_rays(const std::vector<PreparedView>& views, int side, int tile_step) {
    OwnedRays rays;
    const int tiles = side / tile_side, blocks = tile_side / block_side;
    for (const PreparedView& view : views)
        for (int tile = 0; tile < tiles * tiles; tile += tile_step)
            for (int block = 0; block < blocks * blocks; ++block)
                for (int k = 0; k < block_side * block_side; ++k) {
                    const int x = tile % tiles * tile_side + block % blocks * block_side + k % block_side;
                    const int y = tile / tiles * tile_side + block / blocks * block_side + k / block_side;
                    const Vec3f d = view.frame.direction(float(x) + 0.5f, float(y) + 0.5f);
                    rays.origins.x.push_back(view.frame.origin.x);
                    rays.origins.y.push_back(view.frame.origin.y);
                    rays.origins.z.push_back(view.frame.origin.z);
                    rays.origins.cell.push_back(view.start);
                    rays.direction_x.push_back(d.x);
                    rays.direction_y.push_back(d.y);
                    rays.direction_z.push_back(d.z);
                }
    return rays;
}

void append(PointColumns& points, Vec3f p, accel::CellId cell) {
    points.x.push_back(p.x);
    points.y.push_back(p.y);
    points.z.push_back(p.z);
    points.cell.push_back(cell);
}

/// The unit normal of an object's triangle, on either side.
Vec3d object_normal(const accel::SceneView& scene, accel::ObjectId id, std::uint32_t triangle) {
    const accel::PlacedObject& object = scene.objects[index(id)];
    const accel::ObjectMesh& mesh = scene.meshes[index(object.mesh)];
    const auto corner = [&](std::size_t k) {
        const std::uint32_t vertex = scene.mesh_triangles[mesh.first_triangle + triangle].corners[k];
        const accel::Vertex& v = scene.mesh_vertices[mesh.first_vertex + vertex];
        const auto row = [&](std::size_t r) {
            const float* m = object.scene_from_object.rows.data() + 4 * r;
            return double(m[0]) * v.x + double(m[1]) * v.y + double(m[2]) * v.z;
        };
        return Vec3d{row(0), row(1), row(2)};
    };
    return normalized(cross(corner(1) - corner(0), corner(2) - corner(0)));
}

}  // namespace

render::RayColumns first_of(const render::RayColumns& rays, std::size_t count) {
    const auto cut = [&](auto column) { return column.first(std::min(column.size(), count)); };
    return {cut(rays.origin_x),    cut(rays.origin_y),    cut(rays.origin_z), cut(rays.direction_x),
            cut(rays.direction_y), cut(rays.direction_z), cut(rays.cell),     {}};
}

SurfacePoints seen_points(const accel::SceneView& scene, const std::vector<PreparedView>& views, int side,
                          int tile_step, const render::ObjectTracer* objects) {
    const OwnedRays rays = camera_rays(views, side, tile_step);
    std::vector<float> distance(rays.size());
    std::vector<accel::SourceFaceId> face(rays.size());
    std::vector<accel::CellId> cell(rays.size());
    std::vector<render::WalkStatus> status(rays.size());
    std::vector<accel::ObjectId> object(rays.size());
    std::vector<std::uint32_t> triangle(rays.size());
    render::nearest(scene, rays.view(), {distance, face, cell, status, object, triangle},
                    {.tracer = render::Tracer::Scalar, .objects = objects});
    const render::Oracle oracle(scene);
    SurfacePoints seen;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool is_object = status[i] == render::WalkStatus::Object;
        if (!is_object &&
            (status[i] != render::WalkStatus::Hit || scene.source_faces[index(face[i])].surface == accel::Surface::Sky))
            continue;
        const Vec3d direction = {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]};
        const Vec3d origin = {rays.origins.x[i], rays.origins.y[i], rays.origins.z[i]};
        Vec3d normal = is_object ? object_normal(scene, object[i], triangle[i]) : oracle.normal(face[i]);
        Vec3d there = origin + double(distance[i]) / length(direction) * direction;
        if (is_object) {
            if (dot(normal, direction) > 0) normal = -1.0 * normal;
            there = there + 1e-3 * normal;
        }
        Vec3f point = render::vec_cast<float>(there);
        const accel::Cell& end = scene.cells[index(cell[i])];
        point.z = std::clamp(point.z, end.z_floor, end.z_ceiling);
        append(seen.points, point, cell[i]);
        seen.normal_x.push_back(float(normal.x));
        seen.normal_y.push_back(float(normal.y));
        seen.normal_z.push_back(float(normal.z));
    }
    return seen;
}

OwnedRays bounces(const SurfacePoints& points) {
    OwnedRays rays;
    rays.origins = points.points;
    std::mt19937_64 random(20);
    const auto uniform = [&] { return double(random() >> 11) * 0x1p-53; };
    for (std::size_t i = 0; i < points.normal_x.size(); ++i) {
        const Vec3d normal = {points.normal_x[i], points.normal_y[i], points.normal_z[i]};
        const Vec3d aside = std::abs(normal.z) < 0.5 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
        const Vec3d u = normalized(cross(aside, normal));
        const double square = uniform(), angle = 2 * std::numbers::pi * uniform(), radius = std::sqrt(square);
        const Vec3d direction =
            std::sqrt(1 - square) * normal + radius * std::cos(angle) * u + radius * std::sin(angle) * cross(normal, u);
        rays.direction_x.push_back(float(direction.x));
        rays.direction_y.push_back(float(direction.y));
        rays.direction_z.push_back(float(direction.z));
    }
    return rays;
}

OwnedRays shuffled(const OwnedRays& rays) {
    std::vector<std::uint32_t> order(rays.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::mt19937_64 random(21);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    OwnedRays mixed;
    for (const std::uint32_t i : order) {
        append(mixed.origins, {rays.origins.x[i], rays.origins.y[i], rays.origins.z[i]}, rays.origins.cell[i]);
        mixed.direction_x.push_back(rays.direction_x[i]);
        mixed.direction_y.push_back(rays.direction_y[i]);
        mixed.direction_z.push_back(rays.direction_z[i]);
    }
    return mixed;
}

}  // namespace enfilade::tools
