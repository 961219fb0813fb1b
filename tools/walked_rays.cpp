#include "tools/walked_rays.h"

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
        case render::WalkStatus::Object: return RayStatus::Hit;
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

}  // namespace

void RayWalker::walk_in_float(std::span<const PlacedRay> rays) {
    const std::size_t count = walking_.size();
    for (std::vector<float>& column : numbers_) column.resize(count);
    distance_.resize(count);
    cell_.resize(count);
    last_cell_.resize(count);
    face_.resize(count);
    object_.assign(objects_ != nullptr ? count : 0, none<accel::ObjectId>);
    triangle_.assign(object_.size(), render::no_triangle);
    status_.resize(count);
    std::size_t changes = 0;
    bool is_limited = false;
    for (std::size_t k = 0; k < count; ++k) {
        const PlacedRay& ray = rays[walking_[k]];
        const Departure from = departure(ray);
        const std::array<double, 7> row = {from.origin.x,   from.origin.y,   from.origin.z,    ray.direction.x,
                                           ray.direction.y, ray.direction.z, from.max_distance};
        for (std::size_t c = 0; c < row.size(); ++c) numbers_[c][k] = float(row[c]);
        cell_[k] = ray.cell;
        changes += k > 0 && cell_[k] != cell_[k - 1];
        is_limited = is_limited || from.max_distance < infinite;
    }
    const auto& n = numbers_;
    render::StreamOptions options;
    options.tracer = tracer_;
    options.objects = objects_;
    // Where every other ray starts elsewhere, sorting them pays.
    options.order = 2 * changes > count ? render::StreamOrder::Any : render::StreamOrder::Coherent;
    render::nearest(*scene_,
                    {n[0], n[1], n[2], n[3], n[4], n[5], cell_,
                     is_limited ? std::span<const float>(n[6]) : std::span<const float>()},
                    {distance_, face_, last_cell_, status_, object_, triangle_}, options);
    for (std::size_t k = 0; k < count; ++k)
        walked_[walking_[k]] = {distance_[k],
                                face_[k],
                                last_cell_[k],
                                objects_ != nullptr ? object_[k] : none<accel::ObjectId>,
                                objects_ != nullptr ? triangle_[k] : render::no_triangle,
                                status_of(*scene_, status_[k], face_[k])};
}

void RayWalker::walk_in_double(std::span<const PlacedRay> rays) {
    queries_.clear();
    for (const std::uint32_t i : walking_) {
        const Departure from = departure(rays[i]);
        queries_.push_back({from.origin, rays[i].direction, rays[i].cell, from.max_distance});
    }
    hits_.resize(queries_.size());
    render::trace_rays(*scene_, queries_, hits_, render::Precision::Double, nullptr, objects_);
    for (std::size_t k = 0; k < walking_.size(); ++k) {
        const render::RayHit& hit = hits_[k];
        const bool is_hit = hit.status == render::WalkStatus::Hit;
        const bool is_object = hit.status == render::WalkStatus::Object;
        walked_[walking_[k]] = {hit.distance,
                                is_hit ? hit.source_face : none<accel::SourceFaceId>,
                                hit.cell,
                                is_object ? hit.object : none<accel::ObjectId>,
                                is_object ? hit.triangle : render::no_triangle,
                                status_of(*scene_, hit.status, hit.source_face)};
    }
}

std::span<const WalkedRay> RayWalker::walk(std::span<const PlacedRay> rays) {
    walked_.assign(rays.size(), {std::nan(""), none<accel::SourceFaceId>, none<accel::CellId>, none<accel::ObjectId>,
                                 render::no_triangle, RayStatus::Refused});
    walking_.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const PlacedRay& ray = rays[i];
        const bool is_short = ray.start == Start::Site && ray.max_distance <= ray.advance;
        if (ray.start == Start::Wall) {
            walked_[i].status = RayStatus::Wall;
        } else if (ray.start == Start::Nowhere || is_short) {
            walked_[i].status = ray.max_distance < infinite ? RayStatus::Reached : RayStatus::Sky;
            walked_[i].distance = ray.max_distance;
        } else if (ray.start != Start::Refused) {
            walking_.push_back(std::uint32_t(i));
        }
    }
    if (precision_ == render::Precision::Double) walk_in_double(rays);
    else walk_in_float(rays);
    for (const std::uint32_t i : walking_) {
        if (walked_[i].status == RayStatus::Reached) walked_[i].distance = rays[i].max_distance;
        else if (rays[i].start == Start::Site) walked_[i].distance += rays[i].advance;
    }
    return walked_;
}

}  // namespace enfilade::tools
