#pragma once
// Rays and answers as columns that a test owns.

#include <cstddef>
#include <vector>

#include "render/ray_stream.h"
#include "render/trace_rays.h"

namespace enfilade::test {

/// Rays for `nearest`, and room for its answers.
struct RayTable {
    std::vector<float> origin[3], direction[3], max_distance;
    std::vector<accel::CellId> start;
    std::vector<float> distance;
    std::vector<accel::SourceFaceId> source_face;
    std::vector<accel::CellId> cell;
    std::vector<render::WalkStatus> status;

    /// rays: at numbers that float holds. Limits are a column only where there is one.
    explicit RayTable(const std::vector<render::RayQuery>& rays) {
        bool is_limited = false;
        for (const render::RayQuery& ray : rays) {
            is_limited = is_limited || !(ray.max_distance >= 1e30);
            const render::Vec3d o = ray.origin, d = ray.direction;
            const double at[3] = {o.x, o.y, o.z}, along[3] = {d.x, d.y, d.z};
            for (int k = 0; k < 3; ++k) {
                origin[k].push_back(static_cast<float>(at[k]));
                direction[k].push_back(static_cast<float>(along[k]));
            }
            start.push_back(ray.cell);
        }
        if (is_limited)
            for (const render::RayQuery& ray : rays) max_distance.push_back(static_cast<float>(ray.max_distance));
    }

    [[nodiscard]] std::size_t size() const { return start.size(); }

    /// Answers are overwritten; whatever is not answered shows.
    void trace(const accel::SceneView& scene, const render::StreamOptions& options) {
        distance.assign(size(), -77);
        source_face.assign(size(), static_cast<accel::SourceFaceId>(77777777));
        cell.assign(size(), static_cast<accel::CellId>(77777777));
        status.assign(size(), static_cast<render::WalkStatus>(77));
        render::nearest(scene, columns(), {distance, source_face, cell, status}, options);
    }

    [[nodiscard]] render::RayColumns columns() const {
        return {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], start, max_distance};
    }
};

}  // namespace enfilade::test
