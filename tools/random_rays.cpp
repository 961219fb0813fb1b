#include "tools/random_rays.h"

#include <cmath>
#include <numbers>

#include "accel/locate.h"

namespace enfilade::tools {

using render::Vec3d;

namespace {
/// To what float holds, so that every tracer is asked for the same ray. Through memory: the vectoriser of GCC 12 drops
/// the way to float and back where it meets two of them side by side.
Vec3d rounded(Vec3d v) {
    const volatile float x = static_cast<float>(v.x), y = static_cast<float>(v.y), z = static_cast<float>(v.z);
    return {x, y, z};
}

/// How much of a cell's width random points keep from its sides.
constexpr double keep = 0.01;
}  // namespace

const char* name_of(RayFamily family) {
    switch (family) {
        case RayFamily::Random: return "random";
        case RayFamily::AxisParallel: return "axis-parallel";
        case RayFamily::TowardsVertex: return "towards vertices";
        case RayFamily::AlongWall: return "along walls";
        case RayFamily::Level: return "level with edges";
    }
    return "random";
}

double RandomRays::uniform(double low, double high) { return low + (high - low) * (double(random_() >> 11) * 0x1p-53); }

/// In a triangle of the fan around the mean of the corners, which lies inside also where corners are in line: not
/// evenly spread, but everywhere.
Vec3d RandomRays::point_in(const accel::Cell& cell) {
    const std::uint32_t first = cell.first_section;
    Vec3d mean = {0, 0, 0};
    for (std::uint32_t s = first; s < first + cell.section_count; ++s)
        mean = mean + (1.0 / cell.section_count) * Vec3d{scene_->section_x[s], scene_->section_y[s], 0};
    const auto k = std::uint32_t(below(cell.section_count));
    const std::uint32_t p = first + k;
    const std::uint32_t q = first + (k + 1u == cell.section_count ? 0 : k + 1);
    const double r = (1 - keep) * std::sqrt(uniform(0, 1));
    const double s = uniform(0, 1);
    const double height = double(cell.z_ceiling) - cell.z_floor;
    return {mean.x + r * ((1 - s) * scene_->section_x[p] + s * scene_->section_x[q] - mean.x),
            mean.y + r * ((1 - s) * scene_->section_y[p] + s * scene_->section_y[q] - mean.y),
            uniform(cell.z_floor + keep * height, cell.z_ceiling - keep * height)};
}

Vec3d RandomRays::direction(RayFamily family, const accel::Cell& cell, Vec3d& origin) {
    switch (family) {
        case RayFamily::AxisParallel: {
            constexpr std::array axes = {Vec3d{1, 0, 0},  Vec3d{-1, 0, 0}, Vec3d{0, 1, 0},
                                         Vec3d{0, -1, 0}, Vec3d{0, 0, 1},  Vec3d{0, 0, -1}};
            return axes[below(axes.size())];
        }
        case RayFamily::TowardsVertex: {
            const accel::Vertex& v = scene_->vertices[below(scene_->vertices.size())];
            return Vec3d{v.x, v.y, v.z} - origin;
        }
        case RayFamily::AlongWall: {
            const auto k = std::uint32_t(below(cell.section_count));
            const std::uint32_t p = cell.first_section + k;
            const std::uint32_t q = cell.first_section + (k + 1u == cell.section_count ? 0 : k + 1);
            const Vec3d along = {double(scene_->section_x[q]) - scene_->section_x[p],
                                 double(scene_->section_y[q]) - scene_->section_y[p], 0};
            const double t = uniform(0.1, 0.9);
            // Up to a grid unit inside the wall's plane.
            const double off = below(2) == 0 ? 0 : scene_->unit * uniform(0, 1);
            const double length = std::max(std::hypot(along.x, along.y), scene_->unit);
            origin.x = scene_->section_x[p] + t * along.x - off * along.y / length;
            origin.y = scene_->section_y[p] + t * along.y + off * along.x / length;
            return {along.x, along.y, below(2) == 0 ? 0 : uniform(-1, 1)};
        }
        case RayFamily::Level: {
            const double angle = uniform(0, 2 * std::numbers::pi);
            const accel::Cell& other = scene_->cells[below(scene_->cells.size())];
            const double level = below(2) == 0 ? other.z_floor : other.z_ceiling;
            if (level > cell.z_floor && level < cell.z_ceiling) origin.z = level;
            return {std::cos(angle), std::sin(angle), 0};
        }
        case RayFamily::Random: break;
    }
    const double z = uniform(-1, 1);
    const double angle = uniform(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

render::RayQuery RandomRays::next(RayFamily family) {
    for (;;) {
        const accel::Cell& cell = scene_->cells[below(scene_->cells.size())];
        Vec3d origin = point_in(cell);
        const Vec3d along = rounded(direction(family, cell, origin));
        origin = rounded(origin);
        if (along == Vec3d{0, 0, 0}) continue;
        // Rounding, or a place on the border, may have left the cell: whichever holds the point is where the ray
        // starts.
        const std::optional<accel::CellId> start = accel::locate(*scene_, {origin.x, origin.y, origin.z});
        if (start) return {origin, along, *start};
    }
}

std::vector<render::RayQuery> RandomRays::take(std::size_t count, RayFamily family) {
    std::vector<render::RayQuery> rays;
    rays.reserve(count);
    for (std::size_t i = 0; i < count; ++i) rays.push_back(next(family));
    return rays;
}

}  // namespace enfilade::tools
