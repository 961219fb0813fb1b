#pragma once
// Where the pictures of a building's views end, and rays that go on from there: as columns, in the order of the image.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/ray_stream.h"
#include "tools/floor_views.h"

namespace enfilade::tools {

/// Points that own their columns. Metres, scene frame.
struct PointColumns {
    std::vector<float> x, y, z;
    std::vector<accel::CellId> cell;  ///< on whose border they lie
};

/// Points on surfaces, as the pixels of views see them, with the unit normal on the side of light.
struct SurfacePoints {
    PointColumns points;
    std::vector<float> normal_x, normal_y, normal_z;
};

/// What every `tile_step`-th tile of 64 x 64 pixels of each view sees, in blocks of 4 x 4 pixels: whoever traces 16
/// rays at once finds neighbours together. Sky is left out. side: pixels, a multiple of 64. objects: if given, what
/// stands in rooms is seen, too; points on objects lie a millimetre before them, on the side that is seen
[[nodiscard]] SurfacePoints seen_points(const accel::SceneView& scene, const std::vector<PreparedView>& views, int side,
                                        int tile_step, const render::ObjectTracer* objects = nullptr);

/// Rays that own their columns.
struct OwnedRays {
    PointColumns origins;
    std::vector<float> direction_x, direction_y, direction_z;  ///< of length 1

    [[nodiscard]] std::size_t size() const { return direction_x.size(); }
    [[nodiscard]] render::RayColumns view() const {
        return {origins.x, origins.y, origins.z, direction_x, direction_y, direction_z, origins.cell, {}};
    }
};

/// The first of some rays, at most `count`: enough to find Embree's fastest way.
[[nodiscard]] render::RayColumns first_of(const render::RayColumns& rays, std::size_t count);

/// Embree's rays must be kept off the faces that they leave: metres.
inline constexpr float skin = 1e-3f;

/// One ray from each point, in directions spread as the cosine to the normal, the same on every machine.
[[nodiscard]] OwnedRays bounces(const SurfacePoints& points);
/// The same rays in random order.
[[nodiscard]] OwnedRays shuffled(const OwnedRays& rays);

}  // namespace enfilade::tools
