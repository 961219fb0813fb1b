#include "tools/gpu/ray_batch.h"

#include <algorithm>
#include <cmath>

#include "plans/random.h"

namespace enfilade::tools::gpu {

namespace {

using render::Vec3f;

constexpr std::size_t piece = 4096;  ///< rays that one thread takes at once

/// A place on a surface, and the unit normal on the side that was seen.
struct SeenPlace {
    Vec3f point, normal;
    accel::CellId cell;
    bool is_any = false;
};

Vec3f face_normal(const accel::SceneView& scene, accel::SourceFaceId face) {
    const std::uint32_t first = scene.source_faces[index(face)].first_vertex;
    const std::uint32_t end = scene.source_faces[index(face) + 1].first_vertex;
    Vec3f sum = {0, 0, 0};  // Newell: twice the ring's area along its normal
    for (std::uint32_t v = first; v < end; ++v) {
        const accel::Vertex &a = scene.vertices[v], &b = scene.vertices[v + 1 == end ? first : v + 1];
        sum = sum + Vec3f{(a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y)};
    }
    return normalized(sum);
}

Vec3f triangle_normal(const accel::SceneView& scene, accel::ObjectId object, std::uint32_t triangle) {
    const accel::PlacedObject& placed = scene.objects[index(object)];
    const accel::ObjectMesh& mesh = scene.meshes[index(placed.mesh)];
    const accel::MeshTriangle& corners = scene.mesh_triangles[mesh.first_triangle + triangle];
    std::array<Vec3f, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
        const accel::Vertex& v = scene.mesh_vertices[mesh.first_vertex + corners.corners[k]];
        const auto& m = placed.scene_from_object.rows;
        p[k] = {m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3], m[4] * v.x + m[5] * v.y + m[6] * v.z + m[7],
                m[8] * v.x + m[9] * v.y + m[10] * v.z + m[11]};
    }
    return normalized(cross(p[1] - p[0], p[2] - p[0]));
}

SeenPlace seen_place(const accel::SceneView& scene, const render::RayQuery& ray, const render::RayHit& hit) {
    SeenPlace place;
    const bool is_object = hit.status == render::WalkStatus::Object;
    if (!is_object && (hit.status != render::WalkStatus::Hit ||
                       scene.source_faces[index(hit.source_face)].surface == accel::Surface::Sky))
        return place;
    const render::Vec3d along = render::normalized(ray.direction);
    place.normal = is_object ? triangle_normal(scene, hit.object, hit.triangle) : face_normal(scene, hit.source_face);
    if (dot(place.normal, render::vec_cast<float>(along)) > 0) place.normal = -place.normal;
    place.point = render::vec_cast<float>(ray.origin + hit.distance * along);
    // Off a triangle: nothing but the walk itself knows which one a ray started on.
    if (is_object) place.point = place.point + 1e-3f * place.normal;
    place.cell = hit.cell;
    place.is_any = std::isfinite(place.normal.x) && std::isfinite(place.point.x);
    return place;
}

/// What all rays of a batch see, in its order, without those that see the sky.
std::vector<SeenPlace> seen_places(const accel::SceneView& scene, const RayBatch& rays,
                                   const render::ObjectTracer* objects, const accel::Executor& executor) {
    std::vector<SeenPlace> places(rays.size());
    accel::parallel_for(executor, rays.size(), piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const render::RayQuery query = rays.query(i);
            places[i] = seen_place(scene, query, trace_ray(scene, query, render::Precision::Float, objects));
        }
    });
    std::erase_if(places, [](const SeenPlace& place) { return !place.is_any; });
    return places;
}

/// Spread as the cosine to the normal.
Vec3f cosine_direction(Vec3f normal, plans::Random& random) {
    for (;;) {
        Vec3f inside;
        do {
            inside = {static_cast<float>(random.uniform(-1, 1)), static_cast<float>(random.uniform(-1, 1)),
                      static_cast<float>(random.uniform(-1, 1))};
        } while (!(dot(inside, inside) <= 1) || !(dot(inside, inside) > 1e-4f));
        const Vec3f direction = normal + normalized(inside);
        if (dot(direction, normal) > 1e-3f) return normalized(direction);
    }
}

/// A permutation of [0, count) whose every entry is computed alone: a Feistel network over the next power of four,
/// walked on until it comes to a number below `count`.
class RandomOrder {
public:
    RandomOrder(std::size_t count, std::uint64_t seed) : count_(count), seed_(seed) {
        while ((std::uint64_t{1} << (2 * half_)) < count) ++half_;
    }
    [[nodiscard]] std::size_t place_of(std::size_t i) const {
        std::uint64_t place = i;
        do {
            place = mixed(place);
        } while (place >= count_);
        return static_cast<std::size_t>(place);
    }

private:
    [[nodiscard]] std::uint64_t mixed(std::uint64_t number) const {
        const std::uint64_t mask = (std::uint64_t{1} << half_) - 1;
        std::uint64_t left = number >> half_, right = number & mask;
        for (std::uint64_t round = 0; round < 4; ++round) {
            const std::uint64_t turned = left ^ (plans::Random{seed_, round, right}.next() & mask);
            left = right;
            right = turned;
        }
        return left << half_ | right;
    }

    std::uint64_t count_, seed_;
    unsigned half_ = 1;
};

}  // namespace

RayBatch::RayBatch(std::string name_, std::size_t count) : name(std::move(name_)), cell(count) {
    for (int k = 0; k < 3; ++k) {
        origin[static_cast<std::size_t>(k)].resize(count);
        direction[static_cast<std::size_t>(k)].resize(count);
    }
}

render::RayQuery RayBatch::query(std::size_t i) const {
    return {{origin[0][i], origin[1][i], origin[2][i]}, {direction[0][i], direction[1][i], direction[2][i]}, cell[i]};
}

void RayBatch::set(std::size_t i, Vec3f from, Vec3f along, accel::CellId in) {
    origin[0][i] = from.x, origin[1][i] = from.y, origin[2][i] = from.z;
    direction[0][i] = along.x, direction[1][i] = along.y, direction[2][i] = along.z;
    cell[i] = in;
}

RayBatch primary_rays(const TriedScene& scene, std::size_t count, const accel::Executor& executor) {
    const std::size_t each = count / scene.views.size();
    const int side = std::max(8, static_cast<int>(std::sqrt(static_cast<double>(each))) / 8 * 8);
    const std::size_t pixels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    RayBatch rays("primary", pixels * scene.views.size());
    for (std::size_t v = 0; v < scene.views.size(); ++v) {
        const render::CameraFrame frame = scene.views[v].frame(side);
        accel::parallel_for(executor, pixels, piece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t tile = i / 32, columns = static_cast<std::size_t>(side) / 8;
                const std::size_t x = tile % columns * 8 + i % 8, y = tile / columns * 4 + i % 32 / 8;
                rays.set(v * pixels + i, frame.origin,
                         frame.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f),
                         scene.views[v].start);
            }
        });
    }
    return rays;
}

RayBatch diffuse_rays(const TriedScene& scene, const RayBatch& primary, const render::ObjectTracer* objects,
                      const accel::Executor& executor) {
    const std::vector<SeenPlace> places = seen_places(scene.view(), primary, objects, executor);
    RayBatch rays("diffuse", places.size());
    accel::parallel_for(executor, places.size(), piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            plans::Random random{27, i};
            rays.set(i, places[i].point, cosine_direction(places[i].normal, random), places[i].cell);
        }
    });
    return rays;
}

RayBatch shuffled(const RayBatch& rays, std::uint64_t seed, const accel::Executor& executor) {
    const RandomOrder order(rays.size(), seed);
    RayBatch mixed(rays.name + ", shuffled", rays.size());
    accel::parallel_for(executor, rays.size(), piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t from = order.place_of(i);
            mixed.set(i, {rays.origin[0][from], rays.origin[1][from], rays.origin[2][from]},
                      {rays.direction[0][from], rays.direction[1][from], rays.direction[2][from]}, rays.cell[from]);
        }
    });
    return mixed;
}

SegmentBatch shadow_segments(const TriedScene& scene, const RayBatch& primary, const accel::LightTreesView& trees,
                             const render::ObjectTracer* objects, std::size_t count, const accel::Executor& executor) {
    const accel::SceneView view = scene.view();
    const std::vector<SeenPlace> places = seen_places(view, primary, objects, executor);
    SegmentBatch all;
    all.name = "shadow";
    const auto add = [&](const SeenPlace& place, const accel::Light& lamp) {
        const std::array<float, 3> from = {place.point.x, place.point.y, place.point.z};
        for (std::size_t k = 0; k < 3; ++k) {
            all.from[k].push_back(from[k]);
            all.to[k].push_back(lamp.position[k]);
        }
        all.from_cell.push_back(place.cell);
        all.to_cell.push_back(lamp.cell);
    };
    for (std::size_t begin = 0; begin < places.size() && all.size() < count;) {
        std::size_t end = begin + 1;  // neighbours of one cell, a warp of them at most
        while (end < places.size() && end < begin + 32 && places[end].cell == places[begin].cell) ++end;
        const std::size_t cell = index(places[begin].cell);
        std::size_t last = index(none<accel::LightId>);
        for (std::uint32_t k = trees.cell_offsets[cell]; k < trees.cell_offsets[cell + 1]; ++k) {
            const std::size_t lamp = index(trees.cell_lights[k].light);
            if (lamp == last) continue;
            last = lamp;
            for (std::size_t p = begin; p < end; ++p) add(places[p], view.lights[lamp]);
        }
        begin = end;
    }
    return all;
}

std::vector<render::RayHit> expected_hits(const accel::SceneView& scene, const RayBatch& rays,
                                          const render::ObjectTracer* objects, const accel::Executor& executor) {
    std::vector<render::RayHit> hits(rays.size());
    accel::parallel_for(executor, rays.size(), piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            hits[i] = trace_ray(scene, rays.query(i), render::Precision::Float, objects);
    });
    return hits;
}

RaysOnDevice::RaysOnDevice(render::cuda::Device& device, const RayBatch& rays)
    : cell(device, std::span<const accel::CellId>(rays.cell)),
      distance(device, rays.size()),
      face(device, rays.size()),
      object(device, rays.size()),
      triangle(device, rays.size()) {
    for (std::size_t k = 0; k < 3; ++k) {
        origin[k] = {device, std::span<const float>(rays.origin[k])};
        direction[k] = {device, std::span<const float>(rays.direction[k])};
    }
}

render::cuda::DeviceRays RaysOnDevice::rays() const {
    return {{origin[0].data(), origin[1].data(), origin[2].data()},
            {direction[0].data(), direction[1].data(), direction[2].data()},
            cell.data(),
            nullptr,
            cell.size()};
}

render::cuda::DeviceHits RaysOnDevice::hits(bool with_objects) const {
    render::cuda::DeviceHits to;
    to.distance = distance.data();
    to.source_face = face.data();
    if (with_objects) {
        to.object = object.data();
        to.triangle = triangle.data();
    }
    return to;
}

SegmentsOnDevice::SegmentsOnDevice(render::cuda::Device& device, const SegmentBatch& segments)
    : from_cell(device, std::span<const accel::CellId>(segments.from_cell)),
      to_cell(device, std::span<const accel::CellId>(segments.to_cell)),
      visible(device, segments.size()) {
    for (std::size_t k = 0; k < 3; ++k) {
        from[k] = {device, std::span<const float>(segments.from[k])};
        to[k] = {device, std::span<const float>(segments.to[k])};
    }
}

render::cuda::DeviceSegments SegmentsOnDevice::segments() const {
    return {{from[0].data(), from[1].data(), from[2].data()},
            {to[0].data(), to[1].data(), to[2].data()},
            from_cell.data(),
            to_cell.data(),
            from_cell.size()};
}

}  // namespace enfilade::tools::gpu
