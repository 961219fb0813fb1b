#pragma once
// Lamps for benchmarks of shadow rays, and which of them a place may see.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "tools/secondary_rays.h"

namespace enfilade::tools {

struct RoomLamps {
    PointColumns places;
    std::vector<std::vector<std::uint32_t>> seen_from;  ///< [cell] lamps of which a sampled ray enters it, ascending
};

/// A lamp under the middle of the ceiling of every room, and the cells that `rays_a_lamp` rays in all directions find.
[[nodiscard]] RoomLamps room_lamps(const accel::SceneView& scene, std::size_t rays_a_lamp);

/// Segments that own their columns.
struct OwnedSegments {
    PointColumns from, to;

    [[nodiscard]] std::size_t size() const { return from.x.size(); }
    [[nodiscard]] render::SegmentColumns view() const {
        return {from.x, from.y, from.z, to.x, to.y, to.z, from.cell, to.cell};
    }
};

/// From each point to each lamp that its cell may see: sixteen neighbours to one lamp, then to the next.
[[nodiscard]] OwnedSegments shadow_rays(const PointColumns& points, const RoomLamps& lamps);

}  // namespace enfilade::tools
