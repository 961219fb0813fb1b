#include "tools/walked_rays.h"

#include <array>
#include <cmath>
#include <limits>

namespace enfilade::tools {
namespace {

using render::Vec3d;

constexpr double infinite = std::numeric_limits<double>::infinity();

RayStatus status_of(const accel::SceneView& scene, render::WalkStatus status, accel::SourceFaceId face) {
    switch (status) {
        case render::WalkStatus::Hit:
            return scene.source_faces[index(face)].surface == accel::Surface::Sky ? RayStatus::Sky : RayStatus::Hit;
        case render::WalkStatus::Reached: return RayStatus::Reached;
        case render::WalkStatus::Leak: return RayStatus::Leak;
        case render::WalkStatus::Refused: break;
    }
    return RayStatus::Refused;
}

/// Where a ray begins to walk, and how far it may.
struct Departure {
    Vec3d origin;
    double max_distance;
};
Departure departure(const PlacedRay& ray) {
    if (ray.start != Start::Site) return {ray.origin, ray.max_distance};
    const Vec3d step = (ray.advance / render::length(ray.direction)) * ray.direction;
    return {ray.origin + step, ray.max_distance - ray.advance};
}

/// The rays that walk, as columns of floats.
struct Columns {
    explicit Columns(std::size_t count) : cell(count), face(count), last_cell(count), status(count) {
        for (std::vector<float>& column : numbers) column.resize(count);
        distance.resize(count);
    }
    std::array<std::vector<float>, 7> numbers;  ///< origin, direction, maximal distance
    std::vector<accel::CellId> cell;
    std::vector<float> distance;
    std::vector<accel::SourceFaceId> face;
    std::vector<accel::CellId> last_cell;
    std::vector<render::WalkStatus> status;
};

void walk_in_float(const accel::SceneView& scene, std::span<const PlacedRay> rays,
                   std::span<const std::uint32_t> walking, render::Tracer tracer, std::vector<WalkedRay>& walked) {
    Columns columns(walking.size());
    std::size_t changes = 0;
    bool is_limited = false;
    for (std::size_t k = 0; k < walking.size(); ++k) {
        const PlacedRay& ray = rays[walking[k]];
        const Departure from = departure(ray);
        const std::array<double, 7> row = {from.origin.x,   from.origin.y,   from.origin.z,    ray.direction.x,
                                           ray.direction.y, ray.direction.z, from.max_distance};
        for (std::size_t c = 0; c < row.size(); ++c) columns.numbers[c][k] = float(row[c]);
        columns.cell[k] = ray.cell;
        changes += k > 0 && columns.cell[k] != columns.cell[k - 1];
        is_limited = is_limited || from.max_distance < infinite;
    }
    const auto& n = columns.numbers;
    render::StreamOptions options;
    options.tracer = tracer;
    // Where every other ray starts elsewhere, sorting them pays.
    options.order = 2 * changes > walking.size() ? render::StreamOrder::Any : render::StreamOrder::Coherent;
    render::nearest(scene,
                    {n[0], n[1], n[2], n[3], n[4], n[5], columns.cell,
                     is_limited ? std::span<const float>(n[6]) : std::span<const float>()},
                    {columns.distance, columns.face, columns.last_cell, columns.status}, options);
    for (std::size_t k = 0; k < walking.size(); ++k) {
        WalkedRay& to = walked[walking[k]];
        to.status = status_of(scene, columns.status[k], columns.face[k]);
        to.face = columns.face[k];
        to.cell = columns.last_cell[k];
        to.distance = columns.distance[k];
    }
}

void walk_in_double(const accel::SceneView& scene, std::span<const PlacedRay> rays,
                    std::span<const std::uint32_t> walking, std::vector<WalkedRay>& walked) {
    std::vector<render::RayQuery> queries;
    queries.reserve(walking.size());
    for (const std::uint32_t i : walking) {
        const Departure from = departure(rays[i]);
        queries.push_back({from.origin, rays[i].direction, rays[i].cell, from.max_distance});
    }
    std::vector<render::RayHit> hits(queries.size());
    render::trace_rays(scene, queries, hits, render::Precision::Double);
    for (std::size_t k = 0; k < walking.size(); ++k) {
        const bool is_hit = hits[k].status == render::WalkStatus::Hit;
        WalkedRay& to = walked[walking[k]];
        to.status = status_of(scene, hits[k].status, hits[k].source_face);
        to.face = is_hit ? hits[k].source_face : none<accel::SourceFaceId>;
        to.cell = hits[k].cell;
        to.distance = hits[k].distance;
    }
}

}  // namespace

void walk_rays(const accel::SceneView& scene, std::span<const PlacedRay> rays, render::Tracer tracer,
               render::Precision precision, std::vector<WalkedRay>& walked) {
    walked.assign(rays.size(), {std::nan(""), none<accel::SourceFaceId>, none<accel::CellId>, RayStatus::Refused});
    std::vector<std::uint32_t> walking;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const PlacedRay& ray = rays[i];
        const bool is_short = ray.start == Start::Site && ray.max_distance <= ray.advance;
        if (ray.start == Start::Wall) {
            walked[i].status = RayStatus::Wall;
        } else if (ray.start == Start::Nowhere || is_short) {
            walked[i].status = ray.max_distance < infinite ? RayStatus::Reached : RayStatus::Sky;
            walked[i].distance = ray.max_distance;
        } else if (ray.start != Start::Refused) {
            walking.push_back(std::uint32_t(i));
        }
    }
    if (precision == render::Precision::Double) walk_in_double(scene, rays, walking, walked);
    else walk_in_float(scene, rays, walking, tracer, walked);
    for (const std::uint32_t i : walking) {
        if (walked[i].status == RayStatus::Reached) walked[i].distance = rays[i].max_distance;
        else if (rays[i].start == Start::Site) walked[i].distance += rays[i].advance;
    }
}

}  // namespace enfilade::tools
