#pragma once
// Whether either of two answers is right for a ray.

#include <algorithm>
#include <cmath>

#include "render/oracle.h"
#include "render/trace_rays.h"

namespace enfilade::test {

/// How far along a ray an edge may lie that decides between `hit` and what lies beside it: across a face by the band
/// is along the ray by the band over the sine of the angle at which the ray grazes it.
inline double reach_of(const render::Oracle& oracle, render::Vec3d direction, const render::RayHit& hit, double band) {
    constexpr double least_sine = 1e-5;
    if (hit.status != render::WalkStatus::Hit) return std::isfinite(hit.distance) ? hit.distance + band : band;
    const double sine = std::abs(dot(oracle.normal(hit.source_face), normalized(direction)));
    return hit.distance + band / std::max(sine, least_sine);
}

/// Whether the ray passes an edge, or starts at the plane of the face hit, within the band.
inline bool is_doubtful(const render::Oracle& oracle, render::Vec3d origin, render::Vec3d direction,
                        const render::RayHit& hit, double band) {
    if (hit.status == render::WalkStatus::Hit && oracle.plane_distance(origin, hit.source_face) <= band) return true;
    return oracle.edge_distance(origin, direction, reach_of(oracle, direction, hit, band)) <= band;
}

}  // namespace enfilade::test
